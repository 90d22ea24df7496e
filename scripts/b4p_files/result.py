# SPDX-License-Identifier: BSD-3-Clause
"""Result files that `b4p plan` and `b4p place` write, and the forests beside them."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from b4p_files.errors import FileError, reading
from b4p_files.poses import Pose, pose_from

SCHEMA = 1
PICK, PLACE = 0, 1  # sides of forests


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
    X_OT: Pose  # of an empty hand the identity: it carries the TCP itself
    opening_m: float | None  # None: as far as it goes
    X_WO_place: Pose
    joint_names: list[str]
    path: np.ndarray  # one way-point a row
    arm: str | None = None  # of placements; X_OT and opening_m are then those of the scene's arm
    objective: str = ""  # likewise: what was wanted, and how much of it there is


@dataclass
class Forests:
    scene: str
    openings_m: dict[int, float]  # of the gripper, for each grasp
    side: np.ndarray  # PICK or PLACE
    grasp: np.ndarray
    parent: np.ndarray  # index of a node, -1 for roots
    q: np.ndarray  # one node a row


def _load(file: Path) -> dict:
    document = json.loads(file.read_text())
    if document["schema"] != SCHEMA:
        raise FileError(file, f"schema: {document['schema']} is not {SCHEMA}")
    return document


def _finite(name: str, numbers: np.ndarray) -> np.ndarray:
    wrong = numbers[~np.isfinite(numbers)]
    if wrong.size:
        raise ValueError(f"{name}: {wrong[0]} is not a finite number")
    return numbers


def read_result(file: Path) -> Result:
    with reading(file, "result file"):
        document = _load(file)
        if "improvements" in document:
            return _best_placement(file, document)
        hand = _empty_hand(document) if "X_WT_reached" in document else _carrying_hand(document)
        names = document["joint_names"]
        path = np.array(document["path"], float)
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
            **hand,
            joint_names=names,
            path=_finite("path", path.reshape(len(path), len(names))),
        )


def _best_placement(file: Path, document: dict) -> Result:
    """The last improvement, or a result without a path where there is none."""
    best = document["improvements"][-1] if document["improvements"] else None
    joint_names = {arm["name"]: arm["joint_names"] for arm in document["arms"]}
    names = joint_names[best["arm"]] if best else []
    path = np.array(best["path"] if best else [], float)
    return Result(
        file=file,
        scene=document["scene"],
        planner=f"placement by {document['sampling']}",
        seed=int(document["seed"]),
        threads=1,
        status=document["status"],
        solved=best is not None,
        verified=best is not None and bool(best["verification"]["passed"]),
        planning_time_s=float(best["time_s"] if best else document["planning_time_s"]),
        grasp_id=-1,
        X_OT=np.eye(4),
        opening_m=None,
        X_WO_place=_finite("X_WO_place", pose_from(best["X_WO_place"])) if best else np.eye(4),
        joint_names=names,
        path=_finite("path", path.reshape(len(path), len(names))),
        arm=best["arm"] if best else None,
        objective=f"{document['objective']} {float(best['objective_m']):.4g} m" if best else document["objective"],
    )


def _carrying_hand(document: dict) -> dict:
    grasp = document["grasp"]
    return {
        "X_OT": _finite("grasp.X_OT", pose_from(grasp["X_OT"])),
        "opening_m": float(grasp["opening_m"]),
        "X_WO_place": _finite("X_WO_place", pose_from(document["X_WO_place"])),
    }


def _empty_hand(document: dict) -> dict:
    X_WT = _finite("X_WT_reached", pose_from(document["X_WT_reached"]))
    return {"X_OT": np.eye(4), "opening_m": None, "X_WO_place": X_WT}


def read_forests(file: Path) -> Forests:
    with reading(file, "forest file"):
        document = _load(file)
        nodes = document["nodes"]
        grasp = np.array([node["grasp"] for node in nodes], int)
        openings_m = {int(id): float(opening) for id, opening in document["openings_m"].items()}
        if unknown := set(grasp.tolist()) - set(openings_m):
            raise ValueError(f"openings_m: grasp {unknown.pop()} is missing")
        side = np.array([node["side"] for node in nodes], int)
        parent = np.array([node["parent"] for node in nodes], int)
        if np.any(parent >= len(nodes)):
            raise ValueError("parent: index beyond the last node")
        q = _finite("q", np.array([node["q"] for node in nodes], float))
        return Forests(document["scene"], openings_m, side, grasp, parent, q)
