# SPDX-License-Identifier: BSD-3-Clause
"""Result files that `b4p plan` writes, and the forests beside them."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from b4p_files.errors import FileError, reading
from b4p_files.poses import Pose, pose_from

SCHEMA = 1


@dataclass
class Result:
    file: Path
    scene: str
    planner: str
    seed: int
    threads: int
    status: str
    solved: bool
    verified: bool
    planning_time_s: float
    grasp_id: int
    X_OT: Pose
    opening_m: float
    X_WO_place: Pose
    joint_names: list[str]
    path: np.ndarray  # one way-point a row


@dataclass
class Forests:
    side: np.ndarray  # 0: pick, 1: place
    parent: np.ndarray  # index of a node, -1 for roots
    q: np.ndarray  # one node a row


def _load(file: Path) -> dict:
    document = json.loads(file.read_text())
    if document["schema"] != SCHEMA:
        raise FileError(file, f"schema: {document['schema']} is not {SCHEMA}")
    return document


def read_result(file: Path) -> Result:
    with reading(file, "result file"):
        document = _load(file)
        grasp = document["grasp"]
        names = document["joint_names"]
        return Result(
            file=file,
            scene=document["scene"],
            planner=document["planner"],
            seed=int(document["seed"]),
            threads=int(document["threads"]),
            status=document["status"],
            solved=bool(document["solved"]),
            verified=bool(document["verification"]["passed"]),
            planning_time_s=float(document["planning_time_s"]),
            grasp_id=int(document["grasp_id"]),
            X_OT=pose_from(grasp["X_OT"]),
            opening_m=float(grasp["opening_m"]),
            X_WO_place=pose_from(document["X_WO_place"]),
            joint_names=names,
            path=np.array(document["path"], float).reshape(len(document["path"]), len(names)),
        )


def read_forests(file: Path) -> Forests:
    with reading(file, "forest file"):
        nodes = _load(file)["nodes"]
        side = np.array([node["side"] for node in nodes], int)
        parent = np.array([node["parent"] for node in nodes], int)
        if np.any(parent >= len(nodes)):
            raise ValueError("parent: index beyond the last node")
        q = np.array([node["q"] for node in nodes], float)
        return Forests(side, parent, q)
