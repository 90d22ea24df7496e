# SPDX-License-Identifier: BSD-3-Clause
"""Scenes side by side, and below each the object with grasps to pick it."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from b4p_figures.canvas import Canvas
from b4p_figures.spatial import GOAL, MIDDLE, REGION, REGION_OPACITY, START, TRACE_RADIUS
from b4p_figures.spatial import add_task, diagonal, directions, subject
from b4p_figures.style import DOTS_PER_INCH, plt, save
from b4p_figures.surfaces import union
from b4p_files.motion import Motion, link_points, object_points, robot_points
from b4p_files.picks import Picks

PANEL_IN = 3.5  # width
SCENE_IN, GRASPS_IN = 3.3, 2.4  # heights
LEGEND_IN = 0.9
GOAL_OPACITY, ROBOT_OPACITY = 0.5, 0.9
HANDS = 3  # grasps that are shown with the hand, as different from each other as can be
HAND_COLORS = ("#E69F00", "#56B4E9", "#CC79A7")
HAND_OPACITY = 0.95
TURN_WEIGHT_M = 0.1  # how far apart two grasps count that differ by 1 in their approach
STEM = 0.3  # of the line along which a grasp is approached, over the size of the object


def draw_gallery(tasks: list[Picks], file: Path) -> None:
    size = (PANEL_IN * len(tasks), SCENE_IN + GRASPS_IN + LEGEND_IN)
    ratios = {"height_ratios": (SCENE_IN, GRASPS_IN)}
    figure, rows = plt.subplots(
        2, len(tasks), figsize=size, squeeze=False, layout="constrained", gridspec_kw=ratios
    )
    for task, scene_axes, grasp_axes in zip(tasks, *rows):
        _show(scene_axes, _scene_picture(task), task.scene.name)
        _show(
            grasp_axes, _grasp_picture(task), f"{task.scene.object_name}: {len(task.grasps)} sampled grasps"
        )
    legend = [
        Patch(color=START, label="object at the start"),
        Patch(color=REGION, alpha=REGION_OPACITY, label="placement region (object's origin)"),
        Patch(color=GOAL, alpha=GOAL_OPACITY, label="object at a sampled placement"),
        Patch(color=MIDDLE, label="robot at a sampled pick; approaches of grasps"),
    ]
    figure.legend(handles=legend, loc="outside lower center", ncols=4 if len(tasks) > 2 else 2)
    save(figure, file)


def _show(axes: Axes, image: np.ndarray, title: str) -> None:
    axes.imshow(image, interpolation="antialiased")
    axes.set_axis_off()
    axes.set_title(title)


def _canvas(height_in: float) -> Canvas:
    return Canvas((PANEL_IN * DOTS_PER_INCH, height_in * DOTS_PER_INCH))


def _scene_picture(task: Picks) -> np.ndarray:
    scene, pick = task.scene, task.grasps[0]
    canvas = _canvas(SCENE_IN)
    add_task(canvas, scene)
    canvas.add_screen(union(robot_points(scene, pick, 0)), MIDDLE, ROBOT_OPACITY)
    ends = object_points(scene, scene.X_WO_start)
    if task.placements:
        placed = object_points(scene, task.placements[0])
        canvas.add_solid(union(placed), GOAL, GOAL_OPACITY)
        ends += placed
    inside, wanted = subject(scene, pick, (0,))
    return canvas.render(np.concatenate([inside, *ends]), np.concatenate([wanted, *ends]), directions(scene))


def _grasp_picture(task: Picks) -> np.ndarray:
    scene = task.scene
    canvas = _canvas(GRASPS_IN)
    solids = object_points(scene, scene.X_WO_start)
    canvas.add_screen(union(solids), START, 1.0)
    size = diagonal(np.concatenate(solids))
    hands = _different(task.grasps, HANDS)
    shown = list(solids)
    for index, motion in enumerate(task.grasps):
        approach = _approach(motion, STEM * size)
        color = HAND_COLORS[hands.index(index)] if index in hands else MIDDLE
        canvas.add_tube(approach, TRACE_RADIUS * 2 * size, color)
        shown.append(approach)
    for color, index in zip(HAND_COLORS, hands):
        hand = link_points(scene, task.grasps[index], 0, scene.robot.hand_links)
        canvas.add_screen(union(hand), color, HAND_OPACITY)
        shown += hand
    inside = np.concatenate(shown)
    return canvas.render(inside, inside, directions(scene))


def _approach(motion: Motion, length_m: float) -> np.ndarray:
    """Ends where the fingers close, along the approach."""
    X_WT = motion.tcp[0]
    return np.stack([X_WT[:3, 3] - length_m * X_WT[:3, 2], X_WT[:3, 3]])


def _different(grasps: list[Motion], count: int) -> list[int]:
    """Indices of grasps that are far apart, chosen one after the other."""
    features = np.array(
        [np.concatenate([one.tcp[0][:3, 3], TURN_WEIGHT_M * one.tcp[0][:3, 2]]) for one in grasps]
    )
    chosen = [0]
    while len(chosen) < min(count, len(grasps)):
        gaps = np.linalg.norm(features[:, None] - features[None, chosen], axis=2).min(axis=1)
        chosen.append(int(np.argmax(gaps)))
    return chosen
