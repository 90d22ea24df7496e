# SPDX-License-Identifier: BSD-3-Clause
"""Speed-up against the number of workers."""

from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from b4p_files.speed_runs import THREADS, VIRTUAL_TIME, Study
from b4p_files.speedup import PAPER_MACHINE, PAPER_MEANS_S, Point, points
from b4p_files.statistics import CONFIDENCE
from b4p_figures.style import PALETTE, panels, save

LOOKS = {
    VIRTUAL_TIME: {"color": PALETTE[0], "marker": "o", "linestyle": "-"},
    THREADS: {"color": PALETTE[1], "marker": "s", "linestyle": "none"},
}
PAPER_LOOK = {"color": PALETTE[2], "marker": "x", "linestyle": "--"}
IDEAL_LOOK = {"color": "#888888", "linestyle": ":"}
LABELS = {
    VIRTUAL_TIME: f"virtual time (bars: {CONFIDENCE} bootstrap)",
    THREADS: "measured, threads",
}
PAPER_LABEL = f"{PAPER_MACHINE} (means of solved runs)"
MOST_TICKS = 7


def draw_speedup(axes: Axes, study: Study) -> None:
    shown = {1}
    for kind in (VIRTUAL_TIME, THREADS):
        known = [point for point in points(study, kind) if point.speedup and point.speedup.bound != "?"]
        shown.update(point.workers for point in known)
        _draw_points(axes, known, kind)
    paper = PAPER_MEANS_S.get(study.scene, {})
    if paper:
        speedups = [paper[1] / mean_s for mean_s in paper.values()]
        axes.plot(list(paper), speedups, label=PAPER_LABEL, **PAPER_LOOK)
        shown.update(paper)
    ends = (1, max(shown) if max(shown) > 1 else 2)
    axes.plot(ends, ends, label="ideal", **IDEAL_LOOK)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    ticks = [2**power for power in range(MOST_TICKS) if 2**power <= ends[1]]
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("workers")
    axes.set_ylabel("speed-up")
    axes.set_title(f"{study.name} (limit {study.time_limit_s:g} s)")


def _draw_points(axes: Axes, known: list[Point], kind: str) -> None:
    if not known:
        return
    values = [point.speedup.value for point in known]
    below = [max(0.0, point.speedup.value - point.speedup.low) for point in known]
    above = [max(0.0, point.speedup.high - point.speedup.value) for point in known]
    workers = [point.workers for point in known]
    axes.errorbar(workers, values, yerr=(below, above), capsize=3, label=LABELS[kind], **LOOKS[kind])
    for point in known:
        if point.speedup.bound:
            at = (point.workers, point.speedup.value)
            axes.annotate(point.speedup.bound, at, (4, 4), textcoords="offset points")


def plot_speedup(studies: list[Study], file: Path) -> None:
    figure, axes = panels(1, len(studies))
    drawn = {}
    for column, study in enumerate(studies):
        draw_speedup(axes[0][column], study)
        handles, labels = axes[0][column].get_legend_handles_labels()
        drawn |= dict(zip(labels, handles))
    columns = min(len(studies) + 1, len(drawn))
    figure.legend(drawn.values(), drawn.keys(), loc="outside lower center", ncols=columns)
    save(figure, file)
