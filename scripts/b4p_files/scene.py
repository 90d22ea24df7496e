# SPDX-License-Identifier: BSD-3-Clause
"""Scene files (experiments/scenes/*.yaml), as far as pictures need them."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import yaml

from b4p_files.errors import FileError, reading
from b4p_files.poses import Pose, pose, pose_from, vector
from b4p_files.robot import ROOT, Robot, find_robot, read_robot
from b4p_files.shapes import Box, Capsule, PlacedShape, shape_from

SCHEMA = 1
SMALLEST_REGION_M = 0.004  # a flat region is drawn this thick
NEEDLE_M, NEEDLE_RADIUS_M = 0.04, 0.001  # a grasp is drawn as one
POSITION_TOLERANCE_M = 0.05  # of positions that state none


@dataclass
class Words:
    """What a task calls its ends and what is drawn of its goal."""

    first: str
    last: str
    subject: str
    goal: str


PICK_AND_PLACE = Words("pick", "place", "object", "placement region (object's origin)")
REACHING = Words("start", "grasp", "hand", "grasps (TCP)")


@dataclass
class Scene:
    """With its task, of pick and place or of reaching. Reaching has no object."""

    file: Path
    name: str
    robot: Robot
    X_WB: Pose
    obstacles: dict[str, PlacedShape]
    words: Words
    goals: list[PlacedShape]  # in the world: the placement region, or where the TCP may end
    object_name: str = ""
    object: list[PlacedShape] = field(default_factory=list)
    X_WO_start: Pose | None = None
    region_min_m: np.ndarray | None = None
    region_max_m: np.ndarray | None = None
    q_start: np.ndarray | None = None  # of reaching

    @property
    def reaching(self) -> bool:
        return self.q_start is not None


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
        X_WB = pose_from(document.get("robot_base", {}))
        task = _reaching(document["reach"], file, X_WB) if "reach" in document else _pick_and_place(document, file)
        return Scene(
            file=file,
            name=document["name"],
            robot=read_robot(find_robot(document["robot"], file.parent)),
            X_WB=X_WB,
            obstacles={one["name"]: shape_from(one, file.parent) for one in document["obstacles"]},
            **task,
        )


def _pick_and_place(document: dict, file: Path) -> dict:
    item = document["object"]
    region = document["placement"]["region"]
    low, high = vector(region["min_m"]), vector(region["max_m"])
    return {
        "words": PICK_AND_PLACE,
        "goals": [PlacedShape(Box(np.maximum(high - low, SMALLEST_REGION_M)), pose((low + high) / 2))],
        "object_name": item["name"],
        "object": [shape_from(one, file.parent) for one in item["shapes"]],
        "X_WO_start": pose_from(item["start"]),
        "region_min_m": low,
        "region_max_m": high,
    }


def _reaching(reach: dict, file: Path, X_WB: Pose) -> dict:
    if "grasps" in reach:
        table = file.parent / reach["grasps"]["file"]
        with reading(table, "file of grasps"):
            rows = np.loadtxt(table, delimiter=",", ndmin=2).reshape(-1, 4, 4)
        # From the hand's side to the TCP, along the approach axis z.
        # Few corners: a picture joins hundreds of them.
        size = np.array([2 * NEEDLE_RADIUS_M, 2 * NEEDLE_RADIUS_M, NEEDLE_M])
        needle = PlacedShape(Box(size), pose((0, 0, -NEEDLE_M / 2)))
        goals = [PlacedShape(needle.shape, X_WB @ X_BT @ needle.X_BS) for X_BT in rows]
    else:
        radius = reach.get("tolerance", {}).get("position_m", POSITION_TOLERANCE_M)
        goals = [PlacedShape(Capsule(radius, 0.0), pose(position)) for position in reach["positions_m"]]
    return {"words": REACHING, "goals": goals, "q_start": np.array(reach["start"], float)}


def read_scene_of(file: Path, scene: str) -> Scene:
    """The scene that `file` names."""
    scene_file = find_scene(scene, file.parent)
    if not scene_file.is_file():
        raise FileError(file, f"scene: {scene}: {scene_file}: No such file")
    return read_scene(scene_file)
