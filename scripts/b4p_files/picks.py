# SPDX-License-Identifier: BSD-3-Clause
"""Sampled picks and placements: the roots of a planner's trees."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from b4p_files.errors import FileError
from b4p_files.motion import Motion
from b4p_files.poses import Pose
from b4p_files.result import PICK, PLACE, Forests, read_forests
from b4p_files.scene import Scene, read_scene_of


@dataclass
class Picks:
    """Pick configurations with one motion of one moment for each, and where the object came to rest."""

    scene: Scene
    grasps: list[Motion]  # one for each grasp, the object at its start
    placements: list[Pose]  # X_WO


def read_picks(file: Path) -> Picks:
    """Raises FileError when a file is at fault or has no pick."""
    forests = read_forests(file)
    scene = read_scene_of(file, forests.scene)
    picks = {grasp: _motion(scene, forests, node) for node, grasp in _roots(forests, PICK)}
    if not picks:
        raise FileError(file, "nodes: no pick is among them")
    placements = []
    for node, grasp in _roots(forests, PLACE):
        if grasp in picks:
            X_TO = np.linalg.inv(picks[grasp].tcp[0]) @ scene.X_WO_start
            placements.append(_motion(scene, forests, node).tcp[0] @ X_TO)
    return Picks(scene, list(picks.values()), placements)


def _roots(forests: Forests, side: int) -> list[tuple[int, int]]:
    """Node and grasp of each."""
    nodes = np.flatnonzero((forests.side == side) & (forests.parent < 0))
    return [(int(node), int(forests.grasp[node])) for node in nodes]


def _motion(scene: Scene, forests: Forests, node: int) -> Motion:
    opening_m = forests.openings_m[int(forests.grasp[node])]
    links = scene.robot.link_poses(forests.q[node][None], opening_m, scene.X_WB)
    return Motion(links, links[scene.robot.tcp_link], scene.X_WO_start[None])
