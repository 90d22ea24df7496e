# SPDX-License-Identifier: BSD-3-Clause
"""Runs of reaching scenes, grouped: rates, times and lengths of paths, as a table in Markdown."""

import re
from collections.abc import Callable
from dataclasses import replace
from math import isfinite

from b4p_files.records import Budget, Record
from b4p_files.statistics import CONFIDENCE, quantile, wilson_interval

Runs = dict[str, list[Record]]  # label -> runs


def group_of(scene: str) -> str:
    """Scenes that differ in a number at the end are one group."""
    return re.sub(r"_\d+$", "", scene)


def grouped_scenes(records: list[Record]) -> dict[str, Runs]:
    groups: dict[str, Runs] = {}
    for record in records:
        groups.setdefault(group_of(record.scene), {}).setdefault(record.label, []).append(record)
    return groups


def seconds(runs: list[Record]) -> list[float]:
    """Infinite where not solved, or not verified, within the limit."""
    return [run.seconds(Budget.SECONDS) for run in runs]


def by_processor_time(records: list[Record], limit_s: float) -> list[Record]:
    """The same runs with processor time in place of elapsed time: what else the machine does matters less."""
    return [replace(record, time_s=record.cpu_s, time_limit_s=limit_s) for record in records]


def _spread(values: list[float], limit: float | None = None) -> str:
    def text(value: float) -> str:
        return f"{value:.3g}" if isfinite(value) else f"> {limit:g}"

    if not values:
        return "-"
    low, middle, high = (text(quantile(values, fraction)) for fraction in (0.25, 0.5, 0.75))
    return f"{middle} ({low} ... {high})"


def _lengths(runs: list[Record], length: Callable[[Record], float | None]) -> list[float]:
    return [value for run in runs if run.verified and (value := length(run)) is not None]


def reaching_tables(records: list[Record]) -> str:
    text = ""
    for group, contenders in grouped_scenes(records).items():
        scenes = sorted({record.scene for runs in contenders.values() for record in runs})
        text += f"## {group}: {', '.join(scenes)}\n\n"
        text += (
            f"| planner | solved | rate ({CONFIDENCE}) | time, s | TCP path, m | joint path, rad |\n"
            "|---|---|---|---|---|---|\n"
        )
        for label, runs in contenders.items():
            times = seconds(runs)
            solved = sum(map(isfinite, times))
            low, high = wilson_interval(solved, len(runs))
            text += (
                f"| {label} | {solved} of {len(runs)} | {solved / len(runs):.3f} ({low:.3f} ... {high:.3f}) "
                f"| {_spread(times, runs[0].time_limit_s)} | {_spread(_lengths(runs, lambda run: run.tcp_path_m))} "
                f"| {_spread(_lengths(runs, lambda run: run.joint_path))} |\n"
            )
        for label, runs in contenders.items():
            if early := sum(run.undecided(Budget.SECONDS) for run in runs):
                text += f"\n{label}: {early} runs ended before this limit without a path (not solved).\n"
        text += "\n"
    return (
        text + "Medians (quartiles). Solved: runs whose path passed the verifier within the limit; all others count as "
        "longer than the limit. Lengths are of verified paths, as first found.\n"
    )
