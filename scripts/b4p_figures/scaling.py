# SPDX-License-Identifier: BSD-3-Clause
"""Cost against the amount of work, a panel for each kind."""

from math import isfinite
from pathlib import Path

from matplotlib.axes import Axes

from b4p_files.scaling import AXES, MICROSECONDS, MILLISECONDS, Cost, Curves
from b4p_files.speed_runs import Study
from b4p_figures.speedup import draw_speedup
from b4p_figures.style import LINE_STYLES, PALETTE, Look, panels, save

COLUMNS = 2
CAP_POINTS = 3
SMALL = 8  # points, of legends inside panels


def _look(number: int) -> Look:
    return {
        "color": PALETTE[number % len(PALETTE)],
        "linestyle": LINE_STYLES[number // len(PALETTE) % len(LINE_STYLES)],
        "marker": "os^Dv<>"[number % 7],
    }


def _finish(axes: Axes, across: str, up: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.legend(fontsize=SMALL)


def draw_curves(axes: Axes, axis: str, curves: Curves) -> None:
    """Medians with quartiles; points whose median is beyond the limit are left out."""
    for number, (series, curve) in enumerate(curves.items()):
        known = [point for point in curve if isfinite(point.quartiles_s[1])]
        medians = [MILLISECONDS * point.quartiles_s[1] for point in known]
        bars = [
            [MILLISECONDS * (point.quartiles_s[1] - point.quartiles_s[0]) for point in known],
            [
                (
                    MILLISECONDS * (point.quartiles_s[2] - point.quartiles_s[1])
                    if isfinite(point.quartiles_s[2])
                    else 0.0
                )
                for point in known
            ],
        ]
        amounts = [point.amount for point in known]
        axes.errorbar(amounts, medians, yerr=bars, capsize=CAP_POINTS, label=series, **_look(number))
    _finish(axes, AXES[axis], "processor time to a verified path (ms)")


def draw_costs(axes: Axes, costs: dict[str, list[Cost]]) -> None:
    for number, (series, curve) in enumerate(costs.items()):
        nodes, times = [one.nodes for one in curve], [MICROSECONDS * one.time_s for one in curve]
        axes.plot(nodes, times, label=series, **_look(number))
    _finish(axes, "nodes", "processor time (µs)")


def plot_scaling(
    found: dict[str, Curves], studies: list[Study], costs: dict[str, list[Cost]], file: Path
) -> None:
    drawings = [(draw_curves, axis, found[axis]) for axis in AXES if axis in found]
    drawings += [(draw_speedup, study) for study in studies]
    drawings += [(draw_costs, costs)] if costs else []
    columns = min(COLUMNS, len(drawings))
    figure, axes = panels(-(-len(drawings) // columns), columns)
    flat = [one for row in axes for one in row]
    for one, (draw, *what) in zip(flat, drawings):
        draw(one, *what)
        if draw is draw_speedup:
            one.legend(fontsize=SMALL)
    for unused in flat[len(drawings) :]:
        unused.set_visible(False)
    save(figure, file)
