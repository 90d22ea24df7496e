# SPDX-License-Identifier: BSD-3-Clause
"""A solution replayed in its scene."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from b4p_files.poses import transform
from b4p_files.result import Result
from b4p_files.scene import Scene


@dataclass
class Motion:
    """Row i of every array belongs to the same moment."""

    links: dict[str, np.ndarray]  # X_WL
    tcp: np.ndarray  # X_WT
    object: np.ndarray  # X_WO


def resample(path: np.ndarray, count: int) -> np.ndarray:
    """`count` configurations along `path` at equal distances in joint space, both ends included."""
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    travelled = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0.0, travelled[-1], count)
    return np.column_stack([np.interp(wanted, travelled, column) for column in path.T])


def replay(scene: Scene, result: Result, count: int) -> Motion:
    opening_m = scene.robot.max_opening_m if result.opening_m is None else result.opening_m
    links = scene.robot.link_poses(resample(result.path, count), opening_m, scene.X_WB)
    tcp = links[scene.robot.tcp_link]
    return Motion(links, tcp, tcp @ np.linalg.inv(result.X_OT))


def rest(scene: Scene) -> Motion:
    """One moment: the robot at its start, with an open hand or with the object; where the scene states no start, in
    the middle of its joint limits."""
    q = scene.robot.middle if scene.q_start is None else scene.q_start
    opening_m = scene.robot.max_opening_m if scene.reaching else scene.opening_m
    links = scene.robot.link_poses(q[None], opening_m, scene.X_WB)
    tcp = links[scene.robot.tcp_link]
    return Motion(links, tcp, tcp if scene.reaching else scene.X_WO_start[None])


def robot_points(
    scene: Scene, motion: Motion, moment: int, unless_as_at: int | None = None
) -> list[np.ndarray]:
    """Points in the world whose convex hulls are the robot's solids; without links that are where they are at the
    moment `unless_as_at`."""
    moved = [
        link
        for link, X_WL in motion.links.items()
        if unless_as_at is None or not np.allclose(X_WL[moment], X_WL[unless_as_at])
    ]
    return link_points(scene, motion, moment, moved)


def link_points(scene: Scene, motion: Motion, moment: int, links: Iterable[str]) -> list[np.ndarray]:
    """As robot_points(), of these links."""
    return [
        transform(motion.links[link][moment] @ placed.X_BS, placed.shape.points())
        for link in links
        for placed in scene.robot.shapes[link]
    ]


def object_points(scene: Scene, X_WO: np.ndarray) -> list[np.ndarray]:
    return [transform(X_WO @ placed.X_BS, placed.shape.points()) for placed in scene.object]


def goal_points(scene: Scene) -> list[np.ndarray]:
    return [transform(placed.X_BS, placed.shape.points()) for placed in scene.goals]


def obstacle_points(scene: Scene) -> list[np.ndarray]:
    return [transform(placed.X_BS, placed.shape.points()) for placed in scene.obstacles.values()]


def motion_title(scene: Scene, result: Result | None) -> str:
    if result is None:
        subject = scene.object_name or f"{len(scene.goals)} grasp{'s' * (len(scene.goals) != 1)}"
        return f"{scene.name}: {scene.robot.file.stem} and {subject}"
    threads = f"{result.threads} thread{'s' * (result.threads != 1)}"
    query = f"{scene.name}: {result.planner}, seed {result.seed}, {threads}"
    if len(result.path) == 0:
        return f"{query}\n{result.status} after {result.planning_time_s:.3g} s, no path"
    if result.objective:
        query += f", {result.objective}"
    verdict = "verified" if result.verified else "not verified"
    outcome = f"{result.status} in {result.planning_time_s:.3g} s, {verdict}"
    return f"{query}\n{outcome}, {f'arm {result.arm}' if result.arm else f'grasp {result.grasp_id}'}"
