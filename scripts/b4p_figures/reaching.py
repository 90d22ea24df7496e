# SPDX-License-Identifier: BSD-3-Clause
"""Success over time and success rates of reaching planners, a column per group of scenes."""

from math import isfinite
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from b4p_files.reaching import Runs, grouped_scenes, seconds
from b4p_files.records import Record
from b4p_files.statistics import CONFIDENCE, wilson_interval
from b4p_figures.style import LINE_STYLES, PALETTE, Look, add_legend, panels, save, set_seconds_axis

CAP_POINTS = 3
FASTEST_S = 1e-4  # times below are drawn there


def looks_of(groups: dict[str, Runs]) -> dict[str, Look]:
    labels = list(dict.fromkeys(label for contenders in groups.values() for label in contenders))
    return {
        label: {
            "color": PALETTE[index % len(PALETTE)],
            "linestyle": LINE_STYLES[index // len(PALETTE) % len(LINE_STYLES)],
        }
        for index, label in enumerate(labels)
    }


def draw_success(axes: Axes, contenders: Runs, looks: dict[str, Look], limit_s: float) -> None:
    begin_s = limit_s
    for label, runs in contenders.items():
        times = sorted(max(time, FASTEST_S) for time in seconds(runs) if isfinite(time))
        shares = np.arange(1, len(times) + 1) / len(runs)
        if times:
            begin_s = min(begin_s, times[0])
            axes.step([*times, limit_s], [*shares, shares[-1]], where="post", **looks[label])
    axes.set_xscale("log")
    axes.set_xlim(begin_s, limit_s)
    axes.set_ylim(0.0, 1.02)
    set_seconds_axis(axes.xaxis, begin_s, limit_s)
    axes.set_xlabel("time to a verified path (s)")


def draw_rates(axes: Axes, contenders: Runs, looks: dict[str, Look]) -> None:
    for place, (label, runs) in enumerate(contenders.items()):
        solved = sum(map(isfinite, seconds(runs)))
        rate, bounds = solved / len(runs), wilson_interval(solved, len(runs))
        bars = [[rate - bounds[0]], [bounds[1] - rate]]
        axes.errorbar([rate], [place], xerr=np.abs(bars), marker="o", capsize=CAP_POINTS, color=looks[label]["color"])
    axes.set_yticks(range(len(contenders)), list(contenders))
    axes.invert_yaxis()
    axes.set_xlabel(f"success rate ({CONFIDENCE} interval)")


def plot_reaching(records: list[Record], file: Path) -> None:
    groups = grouped_scenes(records)
    looks = looks_of(groups)
    figure, axes = panels(2, len(groups))
    for column, (group, contenders) in enumerate(groups.items()):
        limit_s = max(run.time_limit_s for runs in contenders.values() for run in runs)
        upper, lower = axes[0][column], axes[1][column]
        draw_success(upper, contenders, looks, limit_s)
        draw_rates(lower, contenders, looks)
        upper.set_title(f"{group} (limit {limit_s:g} s)")
    axes[0][0].set_ylabel("share of runs solved")
    add_legend(figure, looks)
    save(figure, file)
