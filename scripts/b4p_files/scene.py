# SPDX-License-Identifier: BSD-3-Clause
"""Scene files (experiments/scenes/*.yaml), as far as pictures need them."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import yaml

from b4p_files.errors import FileError, reading
from b4p_files.poses import Pose, pose_from, vector
from b4p_files.robot import ROOT, Robot, find_robot, read_robot
from b4p_files.shapes import PlacedShape, shape_from

SCHEMA = 1


@dataclass
class Scene:
    file: Path
    name: str
    robot: Robot
    X_WB: Pose
    obstacles: dict[str, PlacedShape]
    object_name: str
    object: list[PlacedShape]
    X_WO_start: Pose
    region_min_m: np.ndarray
    region_max_m: np.ndarray


def is_path(name_or_path: str) -> bool:
    """A path has a YAML extension or begins with `/`, `.` or `..`; all else is a name."""
    first = name_or_path.partition("/")[0]
    return first in ("", ".", "..") or name_or_path.endswith((".yaml", ".yml"))


def find_scene(name_or_path: str, folder: Path) -> Path:
    """The file of a scene: a path (as given, or relative to `folder`), or the name of one that ships with b4p."""
    if not is_path(name_or_path):
        return ROOT / "experiments" / "scenes" / f"{name_or_path}.yaml"
    path = Path(name_or_path)
    return path if path.is_file() else folder / path


def read_scene(file: Path) -> Scene:
    with reading(file, "scene file"):
        document = yaml.safe_load(file.read_text())
        if document["schema"] != SCHEMA:
            raise FileError(file, f"schema: {document['schema']} is not {SCHEMA}")
        item = document["object"]
        region = document["placement"]["region"]
        return Scene(
            file=file,
            name=document["name"],
            robot=read_robot(find_robot(document["robot"], file.parent)),
            X_WB=pose_from(document.get("robot_base", {})),
            obstacles={one["name"]: shape_from(one, file.parent) for one in document["obstacles"]},
            object_name=item["name"],
            object=[shape_from(one, file.parent) for one in item["shapes"]],
            X_WO_start=pose_from(item["start"]),
            region_min_m=vector(region["min_m"]),
            region_max_m=vector(region["max_m"]),
        )


def read_scene_of(file: Path, scene: str) -> Scene:
    """The scene that `file` names."""
    scene_file = find_scene(scene, file.parent)
    if not scene_file.is_file():
        raise FileError(file, f"scene: {scene}: {scene_file}: No such file")
    return read_scene(scene_file)
