# SPDX-License-Identifier: BSD-3-Clause
"""Share of runs solved by a time."""

from pathlib import Path

from matplotlib.axes import Axes

from b4p_files.database import Experiment, Planner
from b4p_files.statistics import CONFIDENCE, wilson_interval
from b4p_figures.style import Look, add_legend, looks, panels, save, set_seconds_axis

NOTE = f"runs solved and verified; bands: Wilson {CONFIDENCE} intervals"
BAND_OPACITY = 0.15
SHORTEST_AXIS_S = 1e-4


def earliest_time_s(experiment: Experiment) -> float:
    """Left end of a logarithmic time axis that shows every solved run."""
    times = [planner.solved_times_s[0] for planner in experiment.planners if planner.solved_times_s]
    earliest = min(times, default=experiment.time_limit_s / 10)
    return max(earliest / 2, SHORTEST_AXIS_S)


def latest_time_s(experiment: Experiment) -> float:
    times = [planner.solved_times_s[-1] for planner in experiment.planners if planner.solved_times_s]
    return max([experiment.time_limit_s, *times])


def draw_success(axes: Axes, experiment: Experiment, planner_looks: dict[str, Look]) -> None:
    begin, end = earliest_time_s(experiment), latest_time_s(experiment)
    for planner in experiment.planners:
        _draw_curve(axes, planner, planner_looks[planner.name], begin, end)
    axes.set_xscale("log")
    axes.set_xlim(begin, end)
    set_seconds_axis(axes.xaxis, begin, end)
    axes.set_ylim(-2, 102)
    axes.set_xlabel("time (s)")
    axes.set_ylabel("solved (%)")
    axes.set_title(f"{experiment.name} (budget {experiment.time_limit_s:g} s)")


def _draw_curve(axes: Axes, planner: Planner, look: Look, begin: float, end: float) -> None:
    trials, times = len(planner.runs), planner.solved_times_s
    steps = [begin, *times, end]
    counts = [*range(len(times) + 1), len(times)]
    bounds = [wilson_interval(count, trials) for count in counts]
    axes.step(steps, [100 * count / trials for count in counts], where="post", linewidth=2, **look)
    low, high = ([100 * bound[side] for bound in bounds] for side in (0, 1))
    axes.fill_between(steps, low, high, step="post", color=look["color"], alpha=BAND_OPACITY, linewidth=0)


def plot_success(experiments: list[Experiment], file: Path) -> None:
    planner_looks = looks(experiments)
    figure, axes = panels(1, len(experiments))
    for column, experiment in enumerate(experiments):
        draw_success(axes[0][column], experiment, planner_looks)
    add_legend(figure, planner_looks, NOTE)
    save(figure, file)
