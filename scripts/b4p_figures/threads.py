# SPDX-License-Identifier: BSD-3-Clause
"""Time to a solution and speed-up over the number of threads, with published figures beside them."""

from math import isfinite
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from b4p_files.comparison import grouped, scenes_of
from b4p_files.published import Figure, Published
from b4p_files.records import Budget, Record
from b4p_files.statistics import CONFIDENCE, median_ratio, quantile
from b4p_figures.style import LINE_STYLES, PALETTE, Look, add_legend, panels, save, set_seconds_axis

GREY = "#777777"
CAP_POINTS = 3
Runs = dict[int, list[float]]  # threads -> seconds of each run, infinite when not solved


def note(published: Published) -> str:
    return (
        "filled: medians and quartiles of all runs here, triangles: less than half solved within the budget; "
        f"speed-up: ratio of medians, {CONFIDENCE} bootstrap\n"
        f"hollow, grey: NOT measured here, means of the paper's solved runs ({published.machine}); line: linear"
    )


def group_looks(records: list[Record], published: Published) -> dict[str, Look]:
    names = list(dict.fromkeys(record.group for record in records))
    looks = {name: {"color": PALETTE[i % len(PALETTE)], "linestyle": "-"} for i, name in enumerate(names)}
    columns = list(dict.fromkeys(published.columns.values()))
    for i, name in enumerate(columns):
        looks[_published_name(name)] = {"color": GREY, "linestyle": LINE_STYLES[(i + 1) % len(LINE_STYLES)]}
    return looks


def _published_name(column: str) -> str:
    return f"paper: {column}"


def times_of(records: list[Record], budget: Budget) -> dict[str, Runs]:
    times: dict[str, Runs] = {}
    for (label, threads), runs in grouped(records).items():
        times.setdefault(label, {})[threads] = [run.seconds(budget) for run in runs]
    return times


def draw_times(axes: Axes, times: dict[str, Runs], looks: dict[str, Look], budget_s: float) -> None:
    for label, runs in times.items():
        middles = {threads: quantile(seconds, 0.5) for threads, seconds in runs.items()}
        solved = [threads for threads, middle in middles.items() if isfinite(middle)]
        failed = [threads for threads in middles if threads not in solved]
        axes.scatter(failed, [budget_s] * len(failed), marker="^", s=30, color=looks[label]["color"])
        if not solved:
            continue
        bars = [[], []]
        for threads in solved:
            low, high = (min(quantile(runs[threads], fraction), budget_s) for fraction in (0.25, 0.75))
            bars[0].append(middles[threads] - low)
            bars[1].append(max(0.0, high - middles[threads]))
        ours = [middles[threads] for threads in solved]
        axes.errorbar(solved, ours, yerr=bars, marker="o", capsize=CAP_POINTS, **looks[label])
    axes.axhline(budget_s, color=GREY, linewidth=1, linestyle="--")


def draw_speedup(axes: Axes, times: dict[str, Runs], looks: dict[str, Look]) -> None:
    for label, runs in times.items():
        if 1 not in runs:
            continue
        ratios = {threads: median_ratio(runs[1], seconds) for threads, seconds in runs.items() if threads > 1}
        points = {threads: ratio for threads, ratio in ratios.items() if ratio}
        if not points:
            continue
        middles = [ratio for ratio, _ in points.values()]
        low = [ratio - bounds[0] for ratio, bounds in points.values()]
        high = [bounds[1] - ratio for ratio, bounds in points.values()]
        bars = [[0.0, *low], [0.0, *high]]
        axes.errorbar(
            [1, *points], [1.0, *middles], yerr=bars, marker="o", capsize=CAP_POINTS, **looks[label]
        )


def draw_published(
    axes: Axes, columns: dict[str, dict[int, Figure]], looks: dict[str, Look], speedup: bool
) -> None:
    for name, column in columns.items():
        means = {threads: figure.mean_s for threads, figure in column.items() if figure.mean_s is not None}
        if speedup:
            means = {threads: means[1] / mean for threads, mean in means.items()} if 1 in means else {}
        if means:
            look = looks[_published_name(name)]
            axes.plot(list(means), list(means.values()), marker="o", markerfacecolor="white", **look)


def _finish(axes: Axes, threads: list[int]) -> None:
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.xaxis.set_major_locator(FixedLocator(threads))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    set_seconds_axis(axes.yaxis, *axes.get_ylim())
    axes.set_xlabel("threads")


def plot_threads(records: list[Record], published: Published, budget: Budget, file: Path) -> None:
    looks = group_looks(records, published)
    scenes = scenes_of(records, published)
    figure, axes = panels(2, len(scenes))
    for column, scene in enumerate(scenes):
        runs = [record for record in records if record.scene == scene]
        times = times_of(runs, budget)
        columns = published.scenes[scene].columns if scene in published.scenes else {}
        threads = sorted({run.threads for run in runs}.union(*columns.values()))
        upper, lower = axes[0][column], axes[1][column]
        draw_times(upper, times, looks, runs[0].time_limit_s)
        draw_speedup(lower, times, looks)
        lower.plot(threads, threads, color="#cccccc", linewidth=1)
        for panel, speedup in ((upper, False), (lower, True)):
            draw_published(panel, columns, looks, speedup)
            _finish(panel, threads)
        upper.set_title(f"{scene} (budget {runs[0].time_limit_s:g} s)")
        upper.set_ylabel(
            "time to a verified path (s)" if budget is Budget.SECONDS else "checks (as s of the paper)"
        )
        lower.set_ylabel("speed-up over 1 thread")
    add_legend(figure, looks, note(published))
    save(figure, file)
