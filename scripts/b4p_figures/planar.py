# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of scenes in the plane, seen from above."""

from pathlib import Path

import numpy as np
from manifold3d import CrossSection, OpType
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from b4p_figures.style import plt, save
from b4p_files.motion import Motion, motion_title, object_points, obstacle_points, replay, robot_points
from b4p_files.result import Forests, Result
from b4p_files.scene import Scene

SNAPSHOTS = 40
TRACE_POINTS = 600
WIDTH_IN = 7.2
TALLEST = 1.6  # height over width
MARGIN_M = 0.05
LEGEND_COLUMNS = 3
WALL, REGION, START, GOAL = "#4a4a4a", "#009E73", "#0072B2", "#D55E00"
PICK_TREES, PLACE_TREES = "#56B4E9", "#E69F00"
PICK_TO_PLACE = START, "#8f86c4", "#c96fa0", GOAL
GRADIENT = LinearSegmentedColormap.from_list("pick to place", PICK_TO_PLACE)


def outlines(solids: list[np.ndarray]) -> list[np.ndarray]:
    """Outlines of the union of the convex hulls of sets of points, seen from above."""
    hulls = [CrossSection.hull_points(np.ascontiguousarray(points[:, :2])) for points in solids]
    return [np.asarray(polygon) for polygon in CrossSection.batch_boolean(hulls, OpType.Add).to_polygons()]


def draw_planar(scene: Scene, result: Result | None, forests: Forests | None, file: Path) -> None:
    walls = [outline for solid in obstacle_points(scene) for outline in outlines([solid])]
    low, high = _limits(scene, result, walls)
    figure, axes = plt.subplots(
        figsize=(WIDTH_IN, WIDTH_IN * min(_aspect(low, high), TALLEST)), layout="constrained"
    )
    axes.add_collection(PolyCollection(walls, facecolors=WALL, edgecolors=WALL, linewidths=0.5, zorder=2))
    legend = [Patch(color=WALL, label="obstacles")]
    legend += _draw_region(axes, scene)
    if forests is not None:
        legend += _draw_forests(axes, scene, forests)
    if result is not None and len(result.path):
        legend += _draw_motion(axes, scene, result)
    legend += _draw_object(axes, scene, scene.X_WO_start, START, "object at the pick")
    if result is not None and result.solved:
        legend += _draw_object(axes, scene, result.X_WO_place, GOAL, "object at the place")
    _finish(axes, low, high, motion_title(scene, result))
    figure.legend(handles=legend, loc="outside lower center", ncols=LEGEND_COLUMNS, fontsize="small")
    save(figure, file)


def _limits(scene: Scene, result: Result | None, walls: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    region = np.array([scene.region_min_m, scene.region_max_m])
    shown = [*object_points(scene, scene.X_WO_start), region]
    if result is not None and len(result.path):
        shown.append(replay(scene, result, TRACE_POINTS).tcp[:, :3, 3])
        shown += object_points(scene, result.X_WO_place)
    corners = np.concatenate([*walls, *(points[:, :2] for points in shown)])
    return corners.min(axis=0) - MARGIN_M, corners.max(axis=0) + MARGIN_M


def _aspect(low: np.ndarray, high: np.ndarray) -> float:
    return float((high[1] - low[1]) / (high[0] - low[0]))


def _draw_region(axes: Axes, scene: Scene) -> list[Patch]:
    size = scene.region_max_m - scene.region_min_m
    region = Rectangle(
        scene.region_min_m[:2],
        size[0],
        size[1],
        facecolor=(REGION, 0.2),
        edgecolor=REGION,
        linestyle="--",
        linewidth=1.2,
        zorder=1,
        label="region for the object's origin",
    )
    axes.add_patch(region)
    return [region]


def _draw_forests(axes: Axes, scene: Scene, forests: Forests) -> list[Line2D]:
    legend = []
    names = (PICK_TREES, "pick trees (TCP)"), (PLACE_TREES, "place trees (TCP)")
    tcp = scene.robot.tcp_poses(forests.q, scene.X_WB)[:, :2, 3] if len(forests.q) else np.zeros((0, 2))
    for side, (color, label) in enumerate(names):
        child = np.flatnonzero((forests.side == side) & (forests.parent >= 0))
        edges = np.stack([tcp[forests.parent[child]], tcp[child]], axis=1)
        axes.add_collection(LineCollection(edges, colors=color, linewidths=0.5, alpha=0.6, zorder=3))
        legend.append(Line2D([], [], color=color, label=label))
    return legend


def _draw_motion(axes: Axes, scene: Scene, result: Result) -> list[Line2D]:
    snapshots = replay(scene, result, SNAPSHOTS)
    for moment in range(SNAPSHOTS):
        _draw_snapshot(axes, scene, snapshots, moment)
    trace = replay(scene, result, TRACE_POINTS).tcp[:, :2, 3]
    segments = np.stack([trace[:-1], trace[1:]], axis=1)
    axes.add_collection(LineCollection(segments, colors="white", linewidths=3.5, zorder=6))
    colors = GRADIENT(np.linspace(0, 1, len(segments)))
    axes.add_collection(LineCollection(segments, colors=colors, linewidths=2, zorder=7))
    return [
        Line2D([], [], color=GRADIENT(0.15), linewidth=2, label="TCP, robot and object: first"),
        Line2D([], [], color=GRADIENT(0.85), linewidth=2, label="TCP, robot and object: last"),
    ]


def _draw_snapshot(axes: Axes, scene: Scene, motion: Motion, moment: int) -> None:
    color = GRADIENT(moment / (SNAPSHOTS - 1))
    robot = outlines(robot_points(scene, motion, moment))
    held = outlines(object_points(scene, motion.object[moment]))
    axes.add_collection(
        PolyCollection(
            robot, facecolors=(*color[:3], 0.06), edgecolors=(*color[:3], 0.5), linewidths=0.6, zorder=4
        )
    )
    axes.add_collection(
        PolyCollection(
            held, facecolors=(*color[:3], 0.22), edgecolors=(*color[:3], 0.5), linewidths=0.4, zorder=5
        )
    )


def _draw_object(axes: Axes, scene: Scene, X_WO: np.ndarray, color: str, label: str) -> list[Patch]:
    pieces = outlines(object_points(scene, X_WO))
    axes.add_collection(
        PolyCollection(pieces, facecolors=color, edgecolors="black", linewidths=0.8, zorder=8)
    )
    return [Patch(color=color, label=label)]


def _finish(axes: Axes, low: np.ndarray, high: np.ndarray, title: str) -> None:
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_aspect("equal")
    axes.grid(visible=False)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_title(title)
