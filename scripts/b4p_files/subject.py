# SPDX-License-Identifier: BSD-3-Clause
"""What a script is asked to show: a result in its scene, or a scene alone."""

from argparse import ArgumentParser
from dataclasses import replace
from pathlib import Path

from b4p_files.errors import FileError
from b4p_files.result import Result, read_result
from b4p_files.scene import Scene, find_scene, read_scene, read_scene_of


def add_subject(parser: ArgumentParser) -> None:
    parser.add_argument(
        "subject", metavar="RESULT.json|SCENE", help="result of `b4p plan` or `b4p place`, or a scene by name or path"
    )


def read_subject(subject: str) -> tuple[Scene, Result | None]:
    """Raises FileError when a file is at fault, or when the result is not one of its scene."""
    if not subject.endswith(".json"):
        return read_scene(find_scene(subject, Path())), None
    result = read_result(Path(subject))
    scene = read_scene_of(result.file, result.scene)
    if result.arm is not None:
        if result.arm not in scene.arms:
            raise FileError(result.file, f"arm: {result.arm} is no arm of {scene.file}")
        arm, scene = scene.arms[result.arm], scene.with_arm(result.arm)
        result = replace(result, X_OT=arm.X_OT, opening_m=arm.opening_m)
    if len(result.path) and result.joint_names != scene.robot.joint_names:
        raise FileError(result.file, f"joint_names are not those of {scene.robot.file}")
    return scene, result
