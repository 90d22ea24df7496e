# SPDX-License-Identifier: BSD-3-Clause
"""Time of every run, per planner."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_files.database import Experiment, Planner
from b4p_figures.style import Look, add_legend, looks, panels, save, set_seconds_axis
from b4p_figures.success import earliest_time_s, latest_time_s

NOTE = "dots: solved and verified runs; crosses at the budget: the others; bars: quartiles and median of solved runs"
SPREAD = 0.22  # half width of a planner's column of dots
BAR_HALF_WIDTH = 0.3
ROOM_ABOVE_BUDGET = 3.0


def draw_times(axes: Axes, experiment: Experiment, planner_looks: dict[str, Look]) -> None:
    for position, planner in enumerate(experiment.planners):
        _draw_planner(axes, position, planner, planner_looks[planner.name]["color"], experiment.time_limit_s)
        solved = f"{len(planner.solved_times_s)} of {len(planner.runs)}"
        above = (position, experiment.time_limit_s)
        axes.annotate(solved, above, (0, 6), textcoords="offset points", ha="center", fontsize="small")
    axes.axhline(experiment.time_limit_s, color="#888888", linewidth=1, linestyle="--")
    axes.set_yscale("log")
    begin, end = earliest_time_s(experiment), latest_time_s(experiment) * ROOM_ABOVE_BUDGET
    axes.set_ylim(begin, end)
    set_seconds_axis(axes.yaxis, begin, end)
    axes.grid(visible=False, axis="x")
    axes.set_xticks(range(len(experiment.planners)), [planner.name for planner in experiment.planners])
    axes.tick_params(axis="x", rotation=20 if len(experiment.planners) > 3 else 0)
    axes.set_xlim(-0.6, len(experiment.planners) - 0.4)
    axes.set_ylabel("time to a verified path (s)")
    axes.set_title(f"{experiment.name} (budget {experiment.time_limit_s:g} s)")


def _draw_planner(axes: Axes, position: int, planner: Planner, color: str, budget_s: float) -> None:
    times = planner.solved_times_s
    unsolved = len(planner.runs) - len(times)
    axes.scatter(_columns(position, len(times)), times, s=16, color=color, alpha=0.8, linewidths=0)
    axes.scatter(
        _columns(position, unsolved), [budget_s] * unsolved, s=22, color=color, marker="x", linewidths=1.2
    )
    if times:
        low, median, high = np.percentile(times, (25, 50, 75))
        ends = (position - BAR_HALF_WIDTH, position + BAR_HALF_WIDTH)
        axes.fill_between(ends, low, high, color=color, alpha=0.18, linewidth=0)
        axes.hlines(median, *ends, color=color, linewidth=2)


def _columns(position: int, count: int) -> np.ndarray:
    """Spreads dots sideways by the golden ratio, so that neighbours in time lie apart."""
    golden = (5**0.5 - 1) / 2
    return position + SPREAD * (2 * ((np.arange(count) * golden + 0.5) % 1) - 1)


def plot_times(experiments: list[Experiment], file: Path) -> None:
    planner_looks = looks(experiments)
    figure, axes = panels(1, len(experiments))
    for column, experiment in enumerate(experiments):
        draw_times(axes[0][column], experiment, planner_looks)
    add_legend(figure, planner_looks, NOTE)
    save(figure, file)
