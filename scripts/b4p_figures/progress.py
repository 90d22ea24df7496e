# SPDX-License-Identifier: BSD-3-Clause
"""What planners report about themselves while they run."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_files.database import Experiment, Planner, Series
from b4p_figures.style import Look, add_legend, looks, panels, save

NOTE = "thin: each run, to its end; thick: median of the runs still going (at least half of them)"
GRID_POINTS = 200


def progress_columns(experiments: list[Experiment]) -> list[str]:
    runs = (run for experiment in experiments for planner in experiment.planners for run in planner.runs)
    return sorted({column for run in runs for column in run.progress})


def _median_curve(series: list[Series], runs: int) -> tuple[np.ndarray, np.ndarray]:
    """Median at each time of the runs not over by then, as long as they are at least half of `runs`."""
    ends = sorted((one[-1][0] for one in series), reverse=True)
    enough = -(-runs // 2)
    if len(ends) < enough:
        return np.array([]), np.array([])
    begin = max(one[0][0] for one in series)
    end = ends[enough - 1]
    if end <= begin:
        return np.array([]), np.array([])
    grid = np.linspace(begin, end, GRID_POINTS)
    values = [np.interp(grid, *np.transpose(one), right=np.nan) for one in series]
    return grid, np.nanmedian(values, axis=0)


def _draw_planner(axes: Axes, planner: Planner, column: str, look: Look) -> None:
    series = [run.progress[column] for run in planner.runs if run.progress.get(column)]
    for one in series:
        axes.plot(*np.transpose(one), linewidth=0.6, alpha=0.35, color=look["color"])
    if series:
        axes.plot(*_median_curve(series, len(series)), linewidth=2, **look)


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
