# SPDX-License-Identifier: BSD-3-Clause
"""A planar and a spatial robot with a scene and a result each, written by the tests themselves."""

import json
from pathlib import Path

import numpy as np
import yaml

PLANAR_URDF = """<robot name="slider">
  <link name="world"/>
  <joint name="x" type="prismatic"><parent link="world"/><child link="sx"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="2" velocity="1" effort="1"/></joint>
  <link name="sx"/>
  <joint name="y" type="prismatic"><parent link="sx"/><child link="sy"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="2" velocity="1" effort="1"/></joint>
  <link name="sy"/>
  <joint name="turn" type="revolute"><parent link="sy"/><child link="body"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <link name="body"><collision><geometry><box size="0.2 0.2 0.1"/></geometry></collision></link>
  <joint name="tip" type="fixed"><parent link="body"/><child link="tcp"/><origin xyz="0.1 0 0"/></joint>
  <link name="tcp"/>
</robot>"""
ARM_URDF = """<robot name="arm">
  <link name="base"><collision><geometry><cylinder radius="0.1" length="0.1"/></geometry></collision></link>
  <joint name="pan" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <origin xyz="0 0 0.1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <link name="upper"><collision><origin xyz="0.2 0 0"/>
    <geometry><box size="0.4 0.08 0.08"/></geometry></collision></link>
  <joint name="lift" type="revolute"><parent link="upper"/><child link="tcp"/><axis xyz="0 1 0"/>
    <origin xyz="0.4 0 0"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <link name="tcp"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
</robot>"""


def identity_at(*position: float) -> dict:
    return {"position_m": list(position), "rotation": np.eye(3).tolist()}


class Task:
    """A robot, a scene and a result in a folder; tests change the documents and write them again."""

    def __init__(self, folder: Path, urdf: str, joints: list[str], obstacles: list[dict], path: list) -> None:
        self.folder = folder
        (folder / "robot.urdf").write_text(urdf)
        self.robot = {
            "schema": 1,
            "urdf": "robot.urdf",
            "tcp_link": "tcp",
            "joints": joints,
            "gripper": {"finger_joints": [], "finger_links": [], "max_opening_m": 0},
        }
        self.scene = {
            "schema": 1,
            "name": "task",
            "robot": "./robot.yaml",
            "obstacles": obstacles,
            "object": {
                "name": "brick",
                "shapes": [{"box": {"size_m": [0.2, 0.1, 0.1]}}],
                "start": {"position_m": [0.5, 0.4, 0.1]},
            },
            "placement": {"region": {"min_m": [1.2, 1.2, 0.1], "max_m": [1.6, 1.6, 0.1]}},
        }
        self.result = {
            "schema": 1,
            "scene": str(folder / "scene.yaml"),
            "planner": "b4p",
            "seed": 1,
            "threads": 2,
            "planning_time_s": 1.5,
            "status": "Exact solution",
            "solved": True,
            "grasp_id": 0,
            "grasp": {"X_OT": identity_at(-0.1, 0, 0), "opening_m": 0},
            "X_WO_place": identity_at(1.4, 1.4, 0.1),
            "joint_names": joints,
            "path": path,
            "verification": {"passed": True},
        }
        self.forests = {
            "schema": 1,
            "scene": str(folder / "scene.yaml"),
            "openings_m": {"0": 0},
            "nodes": [
                {"side": 0, "grasp": 0, "parent": -1, "q": path[0]},
                {"side": 0, "grasp": 0, "parent": 0, "q": path[1]},
                {"side": 1, "grasp": 0, "parent": -1, "q": path[-1]},
                {"side": 1, "grasp": 0, "parent": 2, "q": path[1]},
            ],
        }

    def write(self) -> "Task":
        for name in ("robot", "scene"):
            (self.folder / f"{name}.yaml").write_text(yaml.safe_dump(getattr(self, name)))
        for name in ("result", "forests"):
            (self.folder / f"{name}.json").write_text(json.dumps(getattr(self, name)))
        return self


def placement_task(folder: Path) -> Task:
    """Two arms with a brick in the hand, the second one turned round; a result with two improvements by that one."""
    task = spatial_task(folder)
    grasp = {"position_m": [0, 0, 0.05], "opening_m": 0}
    del task.scene["placement"], task.scene["object"]["start"]
    task.scene["place"] = {
        "volume": {"min_m": [-0.6, -0.6, 0], "max_m": [0, 0.6, 0.3]},
        "objective": "max_clearance",
        "arms": [
            {"name": "left", "grasp": grasp, "start": [0.5, 0.0]},
            {"name": "right", "robot_base": {"rpy_rad": [0, 0, np.pi]}, "grasp": grasp, "start": [-1.0, 0.1]},
        ],
    }
    improvements = [
        {
            "time_s": time_s,
            "objective_m": objective_m,
            "arm": "right",
            "X_WO_place": identity_at(*position),
            "path": task.result["path"][:count],
            "verification": {"passed": True},
        }
        for time_s, objective_m, position, count in ((0.25, 0.05, (0, 0.4, 0), 2), (0.5, 0.125, (-0.2, 0.3, 0), 3))
    ]
    task.result = {
        "schema": 1,
        "scene": str(folder / "scene.yaml"),
        "objective": "max_clearance",
        "sampling": "tree",
        "seed": 7,
        "planning_time_s": 2.0,
        "status": "Exact solution",
        "arms": [{"name": name, "joint_names": ["pan", "lift"]} for name in ("left", "right")],
        "improvements": improvements,
    }
    return task.write()


def planar_task(folder: Path) -> Task:
    walls = [
        {"name": "wall", "box": {"size_m": [0.1, 1, 0.2]}, "position_m": [1, 0.5, 0]},
        {"name": "pillar", "cylinder": {"radius_m": 0.1, "length_m": 0.2}, "position_m": [0.3, 1.6, 0]},
        {"name": "wedge", "prism": {"polygon_m": [[0, 0], [0.2, 0], [0, 0.2]], "height_m": 0.2}},
    ]
    path = [[0.2, 0.4, 0], [0.8, 1.4, 0], [1.2, 1.4, 0]]
    return Task(folder, PLANAR_URDF, ["x", "y", "turn"], walls, path).write()


def spatial_task(folder: Path) -> Task:
    obstacles = [
        {
            "name": "table",
            "box": {"size_m": [1, 1, 0.05]},
            "position_m": [0.5, 0, -0.1],
            "rpy_rad": [0, 0, 0.3],
        },
        {"name": "ball", "sphere": {"radius_m": 0.1}, "position_m": [0.5, 0.5, 0.2]},
        {"name": "post", "capsule": {"radius_m": 0.05, "length_m": 0.3}, "quaternion_wxyz": [1, 0, 0, 0]},
    ]
    path = [[-1.0, 0.1], [0.0, -0.4], [1.0, 0.0]]
    return Task(folder, ARM_URDF, ["pan", "lift"], obstacles, path).write()
