# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of scenes in space, rendered off-screen by VTK's software renderer."""

from pathlib import Path

import numpy as np
from matplotlib.patches import Patch

from b4p_figures.canvas import Canvas
from b4p_figures.sight import FROM_ABOVE, Directions, around
from b4p_figures.style import DOTS_PER_INCH, plt, save
from b4p_figures.surfaces import union
from b4p_files.motion import (
    Motion,
    goal_points,
    motion_title,
    object_points,
    obstacle_points,
    replay,
    rest,
    robot_points,
)
from b4p_files.result import Result
from b4p_files.scene import Scene

WIDTH_IN, HEIGHT_IN = 7.6, 6.9
PIXELS = (WIDTH_IN * DOTS_PER_INCH, 5.6 * DOTS_PER_INCH)
OBSTACLE, REGION = "#8c96a3", "#009E73"
START, MIDDLE, GOAL, TRACE = "#0072B2", "#8a8f96", "#D55E00", "#CC79A7"
PICK_OPACITY, MIDDLE_OPACITY, PLACE_OPACITY = 0.25, 0.15, 0.40  # of the robot
WAY_OPACITY, OBSTACLE_OPACITY, REGION_OPACITY = 0.35, 0.18, 0.4
MOMENTS = 61  # of the motion; odd, so that one is its middle
GHOSTS = 5  # faint objects between start and goal
TRACE_POINTS = 600
TRACE_RADIUS = 0.003  # over the size of what is shown


def draw_spatial(scene: Scene, result: Result | None, file: Path) -> None:
    canvas = Canvas(PIXELS)
    add_task(canvas, scene)
    legend = [
        Patch(color=OBSTACLE, alpha=0.5, label="obstacles"),
        Patch(color=REGION, alpha=0.4, label=scene.words.goal),
    ]
    if scene.object:
        legend.append(Patch(color=START, label=f"object at the {scene.words.first}"))
    if result is not None and len(result.path):
        motion = replay(scene, result, MOMENTS)
        shown = subject(scene, motion, (0, MOMENTS // 2, MOMENTS - 1))
        legend += _add_motion(canvas, scene, motion)
        trace = replay(scene, result, TRACE_POINTS).object[:, :3, 3]
        canvas.add_tube(trace, TRACE_RADIUS * diagonal(shown[0]), TRACE)
    else:
        motion = rest(scene)
        canvas.add_screen(union(robot_points(scene, motion, 0)), MIDDLE, 1.0)
        shown = subject(scene, motion, (0,))
    _compose(canvas.render(*shown, directions(scene)), motion_title(scene, result), legend, file)


def add_task(canvas: Canvas, scene: Scene) -> None:
    """Obstacles, goal, and the object at its start where there is one."""
    for solid in obstacle_points(scene):
        canvas.add_screen(union([solid]), OBSTACLE, OBSTACLE_OPACITY)
        canvas.add_edges(union([solid]), OBSTACLE)
    canvas.add_solid(union(goal_points(scene)), REGION, REGION_OPACITY * scene.words.goal_opacity)
    if scene.object:
        canvas.add_solid(union(object_points(scene, scene.X_WO_start)), START)


def directions(scene: Scene) -> Directions:
    """From where to look at it."""
    return FROM_ABOVE if scene.robot.is_planar else around()


def _add_motion(canvas: Canvas, scene: Scene, motion: Motion) -> list[Patch]:
    last = MOMENTS - 1
    canvas.add_screen(union(robot_points(scene, motion, last)), GOAL, PLACE_OPACITY)
    for moment, color, opacity in ((0, START, PICK_OPACITY), (last // 2, MIDDLE, MIDDLE_OPACITY)):
        if moved := robot_points(scene, motion, moment, unless_as_at=last):
            canvas.add_screen(union(moved), color, opacity)
    if scene.object:
        for moment in np.linspace(0, last, GHOSTS + 2).round().astype(int)[1:-1]:
            canvas.add_solid(union(object_points(scene, motion.object[moment])), TRACE, WAY_OPACITY)
        canvas.add_solid(union(object_points(scene, motion.object[last])), GOAL)
    at_goal = [Patch(color=GOAL, label="object at the place")] if scene.object else []
    return [
        *at_goal,
        Patch(color=TRACE, label=f"{scene.words.subject} on its way"),
        Patch(color=START, alpha=PICK_OPACITY, label=f"robot at the {scene.words.first}"),
        Patch(color=MIDDLE, alpha=0.4, label="robot midway"),
        Patch(color=GOAL, alpha=PLACE_OPACITY, label=f"robot at the {scene.words.last}"),
    ]


def subject(scene: Scene, motion: Motion, moments: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """What has to be inside the picture, and what of it should not hide behind obstacles."""
    ends = [*object_points(scene, motion.object[0]), *object_points(scene, motion.object[-1])]
    way = np.concatenate([motion.object[:, :3, 3], *goal_points(scene), *ends])
    robot = [points for moment in moments for points in robot_points(scene, motion, moment)]
    moving = np.concatenate([*robot, way])
    # A floor is there to be seen, not to be seen whole.
    obstacles = [points for points in obstacle_points(scene) if diagonal(points) < diagonal(moving)]
    return np.concatenate([*obstacles, moving]), way


def diagonal(points: np.ndarray) -> float:
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def _compose(image: np.ndarray, title: str, legend: list[Patch], file: Path) -> None:
    figure, axes = plt.subplots(figsize=(WIDTH_IN, HEIGHT_IN), layout="constrained")
    axes.imshow(image, interpolation="antialiased")
    axes.set_axis_off()
    figure.suptitle(title)
    figure.legend(handles=legend, loc="outside lower center", ncols=3)
    save(figure, file)
