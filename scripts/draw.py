#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a scene, or the solution in a result file, as a PNG: seen from above for planar robots, else in 3-D."""

import argparse
from pathlib import Path

from b4p_files.errors import FileError, run
from b4p_files.result import Forests, Result, read_forests, read_result
from b4p_files.scene import Scene, find_scene, read_scene


def draw(scene: Scene, result: Result | None, forests: Forests | None, file: Path) -> None:
    if result is not None and len(result.path) and result.joint_names != scene.robot.joint_names:
        raise FileError(result.file, f"joint_names are not those of {scene.robot.file}")
    # Each takes a second or more to load.
    if scene.robot.is_planar:
        from b4p_figures.planar import draw_planar

        draw_planar(scene, result, forests, file)
    else:
        from b4p_figures.spatial import draw_spatial

        draw_spatial(scene, result, file)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "input", metavar="RESULT.json|SCENE", help="result of `b4p plan`, or a scene by name or path"
    )
    parser.add_argument("-o", "--out", metavar="PNG", type=Path, required=True, help="picture to write")
    parser.add_argument(
        "--forests", metavar="JSON", type=Path, help="`b4p plan --forests` file (planar scenes)"
    )
    arguments = parser.parse_args()
    result = read_result(Path(arguments.input)) if arguments.input.endswith(".json") else None
    name, folder = (result.scene, result.file.parent) if result else (arguments.input, Path())
    forests = read_forests(arguments.forests) if arguments.forests else None
    draw(read_scene(find_scene(name, folder)), result, forests, arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    run(main)
