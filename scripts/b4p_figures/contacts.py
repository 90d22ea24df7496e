# SPDX-License-Identifier: BSD-3-Clause
"""Contact regions of placement scenes, and below each the object with the faces that it can stand on."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_figures.canvas import Canvas
from b4p_figures.sight import around
from b4p_figures.spatial import OBSTACLE, OBSTACLE_OPACITY, diagonal
from b4p_figures.style import DOTS_PER_INCH, PALETTE, plt, save
from b4p_figures.surfaces import union
from b4p_files.shapes import Box
from b4p_files.surfaces import Region, Surfaces

PANEL_IN, SCENE_IN, OBJECT_IN = 3.9, 3.3, 2.4
SHEET_M = 0.004  # regions are drawn this thick
FACE_M = 0.0015
APART = 0.12  # of the object's size: faces are drawn this far off it
BODY, BODY_OPACITY = "#8a8f96", 0.85
VOLUME = "#000000"


def draw_contacts(tasks: list[Surfaces], file: Path) -> None:
    size = (PANEL_IN * len(tasks), SCENE_IN + OBJECT_IN)
    figure, rows = plt.subplots(
        2,
        len(tasks),
        figsize=size,
        squeeze=False,
        layout="constrained",
        gridspec_kw={"height_ratios": (SCENE_IN, OBJECT_IN)},
    )
    for task, above, below in zip(tasks, *rows):
        _show(above, _regions_picture(task), f"{task.scene}: {len(task.regions)} regions")
        _show(below, _faces_picture(task), f"{task.object_name}: {len(task.faces)} placement faces")
    save(figure, file)


def _show(axes: Axes, image: np.ndarray, title: str) -> None:
    axes.imshow(image, interpolation="antialiased")
    axes.set_axis_off()
    axes.set_title(title, fontsize=9)


def _color(index: int) -> str:
    return PALETTE[index % (len(PALETTE) - 1)]  # black is kept for the volume


def _regions_picture(task: Surfaces) -> np.ndarray:
    canvas = Canvas((PANEL_IN * DOTS_PER_INCH, SCENE_IN * DOTS_PER_INCH))
    volume = Box(task.max_m - task.min_m).points() + (task.min_m + task.max_m) / 2
    canvas.add_edges(union([volume]), VOLUME)
    for points in task.obstacles.values():
        if np.any(points.min(axis=0) > task.max_m) or np.any(points.max(axis=0) < task.min_m):
            continue
        canvas.add_screen(union([points]), OBSTACLE, OBSTACLE_OPACITY)
        canvas.add_edges(union([points]), OBSTACLE)
    tops = []
    for index, region in enumerate(task.regions):
        sheet = _sheet(region, task.cell_m)
        canvas.add_solid(union(sheet), _color(index))
        tops.append(np.concatenate(sheet))
    return canvas.render(volume, np.concatenate(tops), around())


def _sheet(region: Region, cell_m: float) -> list[np.ndarray]:
    """Boxes over runs of cells side by side."""
    order = np.lexsort((region.cells_m[:, 0], region.cells_m[:, 1].round(6)))
    cells = region.cells_m[order]
    breaks = np.flatnonzero(np.abs(np.diff(cells, axis=0) - (cell_m, 0)).max(axis=1) > cell_m / 10) + 1
    sheet = []
    for run in np.split(cells, breaks):
        size = np.array([run[-1, 0] - run[0, 0] + cell_m, cell_m, SHEET_M])
        sheet.append(Box(size).points() + (*(run[0] + run[-1]) / 2, region.height_m))
    return sheet


def _faces_picture(task: Surfaces) -> np.ndarray:
    canvas = Canvas((PANEL_IN * DOTS_PER_INCH, OBJECT_IN * DOTS_PER_INCH))
    body = np.concatenate(task.shapes)
    canvas.add_screen(union(task.shapes), BODY, BODY_OPACITY)
    middle = (body.min(axis=0) + body.max(axis=0)) / 2
    shown = [body]
    for index, corners in enumerate(task.faces):
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[1])
        normal *= np.sign(normal @ (corners.mean(axis=0) - middle)) / np.linalg.norm(normal)
        plate = corners + APART * diagonal(body) * normal
        plate = np.concatenate([plate, plate + FACE_M * normal])
        canvas.add_solid(union([plate]), _color(index), 0.8)
        shown.append(plate)
    inside = np.concatenate(shown)
    return canvas.render(inside, inside, around())
