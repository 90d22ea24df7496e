# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that differ in the number of grasps offered, or of obstacles, and in nothing else.

Obstacles are added where the arm never comes (`far`), or inside boxes that stand in the scene already (`near`).
Either way the free space is the same, so that what differs is what a check costs.
"""

import json
import math
import random
from copy import deepcopy
from pathlib import Path

import yaml

from b4p_files.errors import reading
from b4p_files.output import replacing

Scene = dict  # as in its file
Row = list[float]  # of a file of grasps

AMOUNTS = (1, 10, 100, 1000, 10000)
FAR_M = (2.0, 4.0)  # from the origin; no arm that ships with b4p and stands there reaches so far
SIDES_M = (0.01, 0.1)
INSIDE = 0.2  # sides of boxes inside others, at most, as a share of theirs


def read_yaml(file: Path) -> Scene:
    with reading(file, "scene file"):
        return yaml.safe_load(file.read_text())


def write_yaml(file: Path, scene: Scene) -> None:
    dumper = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
    with replacing(file) as temporary:
        temporary.write_text(yaml.dump(scene, Dumper=dumper, sort_keys=False, default_flow_style=None))


def grasp_row(grasp: dict) -> Row:
    """17 numbers: the rows of the pose of the TCP in the object's frame, and the opening in m."""
    pose = grasp["X_OT"]
    rows = [[*row, position] for row, position in zip(pose["rotation"], pose["position_m"])]
    return [*(value for row in rows for value in row), 0.0, 0.0, 0.0, 1.0, grasp["opening_m"]]


def exported_grasps(file: Path) -> list[Row]:
    """Those of the first line that `b4p export` wrote."""
    with reading(file, "file of `b4p export`"):
        return [grasp_row(grasp) for grasp in json.loads(file.read_text().splitlines()[0])["grasps"]]


def solved_grasp(file: Path) -> Row:
    """The one of a result of `b4p plan`."""
    with reading(file, "result file"):
        document = json.loads(file.read_text())
        if not document["solved"]:
            raise ValueError("has no path")
        return grasp_row(document["grasp"])


def offered(compatible: Row, others: list[Row], amount: int, seed: int) -> list[Row]:
    """A grasp that is known to work and `amount` - 1 others, of which some may work too, in random order."""
    rows = [compatible, *others[: amount - 1]]
    if len(rows) < amount:
        raise ValueError(f"{len(others)} grasps are too few for a list of {amount}")
    random.Random(seed).shuffle(rows)
    return rows


def with_grasps(scene: Scene, name: str, table: str) -> Scene:
    changed = deepcopy(scene)
    changed["name"] = name
    changed["grasps"] = {"file": table}
    return changed


def table_text(rows: list[Row]) -> str:
    return "".join(",".join(repr(float(value)) for value in row) + "\n" for row in rows)


def far_box(draw: random.Random) -> dict:
    around, away = draw.uniform(-math.pi, math.pi), draw.uniform(*FAR_M)
    return {
        "box": {"size_m": [round(draw.uniform(*SIDES_M), 5) for _ in range(3)]},
        "position_m": [
            round(value, 5)
            for value in (away * math.cos(around), away * math.sin(around), draw.uniform(0, 2))
        ],
    }


def box_inside(draw: random.Random, boxes: list[dict]) -> dict:
    """Parallel to the box it is in."""
    outer = draw.choice(boxes)
    size = [
        share * side
        for share, side in zip((draw.uniform(0.05, INSIDE) for _ in range(3)), outer["box"]["size_m"])
    ]
    offset = [draw.uniform(-1, 1) * (a - b) / 2 for a, b in zip(outer["box"]["size_m"], size)]
    # Rounding outwards would leave the outer box.
    return {
        "box": {"size_m": [round(0.99 * side, 6) for side in size]},
        "position_m": [round(a + 0.99 * b, 6) for a, b in zip(outer["position_m"], offset)],
    }


def with_boxes(scene: Scene, name: str, amount: int, where: str, seed: int) -> Scene:
    """
    Args:
        amount: of obstacles in all.
        where: `far` or `near`.
    """
    changed = deepcopy(scene)
    changed["name"] = name
    draw = random.Random(seed)
    boxes = [one for one in scene["obstacles"] if "box" in one and not any(one.get("rpy_rad", [0]))]
    if where == "near" and not boxes:
        raise ValueError("has no upright box for others to be inside of")
    for number in range(len(scene["obstacles"]), amount):
        box = far_box(draw) if where == "far" else box_inside(draw, boxes)
        changed["obstacles"].append({"name": f"{where}_{number}", **box})
    return changed


def only_obstacles(scene: Scene, names: set[str]) -> Scene:
    changed = deepcopy(scene)
    changed["obstacles"] = [one for one in scene["obstacles"] if one["name"] in names]
    return changed
