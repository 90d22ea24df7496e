# SPDX-License-Identifier: BSD-3-Clause
"""What planners report about themselves while they run."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_files.database import Experiment, Planner, Series
from b4p_figures.style import Look, add_legend, looks, panels, save

NOTE = "thin: each run, to its end; thick: median, where a run that has ended keeps its last value"
GRID_POINTS = 200


def progress_columns(experiments: list[Experiment]) -> list[str]:
    runs = (run for experiment in experiments for planner in experiment.planners for run in planner.runs)
    return sorted({column for run in runs for column in run.progress})


def _median_curve(series: list[Series]) -> tuple[np.ndarray, np.ndarray]:
    grid = np.linspace(max(one[0][0] for one in series), max(one[-1][0] for one in series), GRID_POINTS)
    return grid, np.median([np.interp(grid, *np.transpose(one)) for one in series], axis=0)


def _draw_planner(axes: Axes, planner: Planner, column: str, look: Look) -> None:
    series = [run.progress[column] for run in planner.runs if run.progress.get(column)]
    for one in series:
        axes.plot(*np.transpose(one), linewidth=0.7, alpha=0.5, color=look["color"])
    if series:
        axes.plot(*_median_curve(series), linewidth=2, **look)


def _draw_panel(axes: Axes, experiment: Experiment, column: str, planner_looks: dict[str, Look]) -> None:
    for planner in experiment.planners:
        _draw_planner(axes, planner, column, planner_looks[planner.name])
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("time (s)")
    axes.set_ylabel(column.replace("_", " "))
    axes.set_title(experiment.name)


def plot_progress(experiments: list[Experiment], file: Path) -> bool:
    """False, and no file, when the database holds no progress."""
    columns = progress_columns(experiments)
    if not columns:
        return False
    planner_looks = looks(experiments)
    figure, axes = panels(len(columns), len(experiments))
    for row, column in enumerate(columns):
        for index, experiment in enumerate(experiments):
            _draw_panel(axes[row][index], experiment, column, planner_looks)
    add_legend(figure, planner_looks, NOTE)
    save(figure, file)
    return True
