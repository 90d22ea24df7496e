# SPDX-License-Identifier: BSD-3-Clause
"""Planners side by side on families of scenes, as a table in Markdown."""

from math import isfinite

from b4p_files.errors import FileError
from b4p_files.reaching import by_processor_time, grouped_scenes, seconds
from b4p_files.records import Record
from b4p_files.statistics import CONFIDENCE, median_ratio, quantile, wilson_interval


def _milliseconds(value_s: float, limit_s: float) -> str:
    return f"{1e3 * value_s:.3g}" if isfinite(value_s) else f"> {1e3 * limit_s:g}"


def _ratio(times: list[float], reference: list[float], limit_s: float) -> str:
    if ratio := median_ratio(times, reference):
        value, (low, high) = ratio
        return f"{value:.3g} ({low:.3g} ... {high:.3g})"
    base = quantile(reference, 0.5)
    return f"> {limit_s / base:.3g}" if isfinite(base) and not isfinite(quantile(times, 0.5)) else "-"


def peers_table(records: list[Record], against: str) -> str:
    """
    Args:
        against: label of the planner whose median is the others' unit.
    """
    text = ""
    for family, contenders in grouped_scenes(records).items():
        if against not in contenders:
            raise FileError("--against", f"no runs of {against} on {family} (there are {', '.join(contenders)})")
        limit_s = contenders[against][0].time_limit_s
        times = {
            label: seconds(by_processor_time(runs, runs[0].time_limit_s * runs[0].threads))
            for label, runs in contenders.items()
        }
        instances = len({run.scene for run in contenders[against]})
        text += (
            f"## {family}, {instances} instances\n\n"
            f"| planner | solved | rate, % ({CONFIDENCE}) | median, ms | 95th percentile, ms | median over {against}'s |\n"
            "|---|---|---|---|---|---|\n"
        )
        for label, taken in times.items():
            solved = sum(map(isfinite, taken))
            low, high = wilson_interval(solved, len(taken))
            text += (
                f"| {label} | {solved} of {len(taken)} | {100 * solved / len(taken):.0f} ({100 * low:.0f} ... {100 * high:.0f}) "
                f"| {_milliseconds(quantile(taken, 0.5), limit_s)} | {_milliseconds(quantile(taken, 0.95), limit_s)} "
                f"| {_ratio(taken, times[against], limit_s)} |\n"
            )
        text += "\n"
    return (
        text + "Processor time to a path that passed the verifier; runs without one within the limit count as longer than the "
        "limit. Ratios have bootstrap intervals; `>` where a median is beyond the limit.\n"
    )
