# SPDX-License-Identifier: BSD-3-Clause
"""Scene files (experiments/scenes/*.yaml), as far as pictures need them."""

from dataclasses import dataclass, field, replace
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
    goal_opacity: float = 1.0  # over the usual one: what fills much of the scene is seen through


PICK_AND_PLACE = Words("pick", "place", "object", "placement region (object's origin)")
REACHING = Words("start", "grasp", "hand", "grasps (TCP)")
PLACEMENT = Words("start", "place", "object", "target volume", 0.25)


@dataclass
class Arm:
    """One that holds the object of a placement scene at the start."""

    robot: Robot
    X_WB: Pose
    X_OT: Pose
    opening_m: float
    q_start: np.ndarray


@dataclass
class Scene:
    """With its task, of pick and place, reaching or placement. Reaching has no object."""

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
    q_start: np.ndarray | None = None  # of reaching and placement
    opening_m: float = 0.0  # of the gripper at the start
    arms: dict[str, Arm] = field(default_factory=dict)  # of placement

    @property
    def reaching(self) -> bool:
        return not self.object

    def with_arm(self, name: str) -> "Scene":
        """A placement scene with one of its arms as its robot."""
        arm = self.arms[name]
        tcp = arm.robot.tcp_poses(arm.q_start[None], arm.X_WB)[0]
        return replace(
            self,
            robot=arm.robot,
            X_WB=arm.X_WB,
            q_start=arm.q_start,
            opening_m=arm.opening_m,
            X_WO_start=tcp @ np.linalg.inv(arm.X_OT),
        )


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
        robot = read_robot(find_robot(document["robot"], file.parent))
        if "reach" in document:
            task = _reaching(document["reach"], file, X_WB)
        elif "place" in document:
            task = _placement(document, file, robot, X_WB)
        else:
            task = _pick_and_place(document, file)
        scene = Scene(
            file=file,
            name=document["name"],
            robot=robot,
            X_WB=X_WB,
            obstacles={one["name"]: shape_from(one, file.parent) for one in document["obstacles"]},
            **task,
        )
        return scene.with_arm(next(iter(scene.arms))) if scene.arms else scene


def _pick_and_place(document: dict, file: Path) -> dict:
    return {
        "words": PICK_AND_PLACE,
        "X_WO_start": pose_from(document["object"]["start"]),
        **_object(document["object"], file),
        **_region(document["placement"]["region"]),
    }


def _object(item: dict, file: Path) -> dict:
    return {"object_name": item["name"], "object": [shape_from(one, file.parent) for one in item["shapes"]]}


def _region(region: dict) -> dict:
    low, high = vector(region["min_m"]), vector(region["max_m"])
    box = PlacedShape(Box(np.maximum(high - low, SMALLEST_REGION_M)), pose((low + high) / 2))
    return {"goals": [box], "region_min_m": low, "region_max_m": high}


def _placement(document: dict, file: Path, robot: Robot, X_WB: Pose) -> dict:
    place = document["place"]
    arms = {}
    for one in place["arms"]:
        grasp = one["grasp"]
        arms[one["name"]] = Arm(
            robot=read_robot(find_robot(one["robot"], file.parent)) if "robot" in one else robot,
            X_WB=pose_from(one["robot_base"]) if "robot_base" in one else X_WB,
            X_OT=pose_from(grasp),
            opening_m=float(grasp["opening_m"]),
            q_start=np.array(one["start"], float),
        )
    return {"words": PLACEMENT, "arms": arms, **_object(document["object"], file), **_region(place["volume"])}


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
