# SPDX-License-Identifier: BSD-3-Clause
"""How good placements are after how long: a row per objective, a column per surroundings, a line per way of searching."""

from math import sqrt
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_files.placements import Run, Task
from b4p_figures.style import LINE_STYLES, PALETTE, Look, add_legend, panels, save

GRID_POINTS = 400
NOTE = "mean over objects and runs, with its standard error"


def curve(runs: list[Run], times_s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean of the runs' values at these times, and its standard error (0 for a single run)."""
    values = np.array([run.at(times_s) for run in runs])
    if len(runs) < 2:
        return values.mean(axis=0), np.zeros(len(times_s))
    return values.mean(axis=0), values.std(axis=0, ddof=1) / sqrt(len(runs))


def looks_of(tasks: list[Task]) -> dict[str, Look]:
    labels = list(dict.fromkeys(label for task in tasks for label in task.variants))
    return {
        label: {
            "color": PALETTE[index % len(PALETTE)],
            "linestyle": LINE_STYLES[index // len(PALETTE) % len(LINE_STYLES)],
        }
        for index, label in enumerate(labels)
    }


def draw_task(axes: Axes, task: Task, looks: dict[str, Look]) -> None:
    times_s = np.linspace(0.0, task.limit_s, GRID_POINTS)
    for label, runs in task.variants.items():
        mean, error = curve(runs, times_s)
        axes.plot(times_s, mean, **looks[label])
        axes.fill_between(times_s, mean - error, mean + error, color=looks[label]["color"], alpha=0.2, linewidth=0)
    axes.set_xlim(0.0, task.limit_s)
    axes.set_ylim(0.0, 1.02)
    axes.set_title(task.name)
    axes.set_xlabel("time (s)")


def plot_placements(tasks: list[Task], file: Path) -> None:
    surroundings = list(dict.fromkeys(task.surroundings for task in tasks))
    objectives = list(dict.fromkeys(task.objective for task in tasks))
    looks = looks_of(tasks)
    figure, axes = panels(len(objectives), len(surroundings))
    drawn = {(task.objective, task.surroundings): task for task in tasks}
    for row, objective in enumerate(objectives):
        for column, name in enumerate(surroundings):
            if (objective, name) in drawn:
                draw_task(axes[row][column], drawn[objective, name], looks)
            else:
                axes[row][column].set_axis_off()
        axes[row][0].set_ylabel("normalised objective")
    add_legend(figure, looks, NOTE)
    save(figure, file)
