# SPDX-License-Identifier: BSD-3-Clause
"""How cost grows with the work: runs on scenes named AXIS_SERIES_INSTANCE_AMOUNT; cost by the size of a tree."""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from b4p_files.errors import reading
from b4p_files.reaching import by_processor_time, seconds
from b4p_files.records import Record
from b4p_files.statistics import quantile

AXES = {"grasps": "grasps offered", "obstacles": "obstacles"}
NAME = re.compile(r"(?P<axis>[a-z]+)_(?P<series>.+)_\d+_(?P<amount>\d+)")
NEAREST = re.compile(r"query/tree/(?P<joints>\d+)/(?P<points>\d+)/(?P<leaf>\d+)(/|$)")
STEP = re.compile(r"(?P<scene>[a-z]+)/step/(?P<nodes>\d+)(/|$)")
ARM_JOINTS, LEAF, SMALL_LEAF = 7, 512, 128  # docs/nearest.md: up to a leaf of points there is one leaf
MILLISECONDS, MICROSECONDS = 1e3, 1e6
NANOSECONDS_IN = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}


@dataclass
class Point:
    amount: int
    runs: int
    solved: int
    quartiles_s: tuple[float, float, float]  # infinite where not solved


Curve = list[Point]
Curves = dict[str, Curve]  # by series


def curves(records: list[Record]) -> dict[str, Curves]:
    """By axis and series, from processor time to a verified path."""
    groups: dict[tuple[str, str, int], list[Record]] = {}
    for record in records:
        if match := NAME.fullmatch(record.scene):
            series = match["series"].replace("_", ", ")
            groups.setdefault((match["axis"], series, int(match["amount"])), []).append(record)
    found: dict[str, dict[str, Curve]] = {}
    for (axis, series, amount), runs in sorted(groups.items()):
        times = seconds(by_processor_time(runs, runs[0].time_limit_s))
        point = Point(
            amount=amount,
            runs=len(times),
            solved=sum(map(isfinite, times)),
            quartiles_s=tuple(quantile(times, share) for share in (0.25, 0.5, 0.75)),
        )
        found.setdefault(axis, {}).setdefault(series, []).append(point)
    return found


@dataclass
class Cost:
    """Of one operation, by the number of nodes (s)."""

    nodes: int
    time_s: float


def benchmark_times(file: Path) -> dict[str, float]:
    """Processor time (s) of each benchmark in a JSON file of Google Benchmark, the median of repetitions."""
    with reading(file, "file of Google Benchmark"):
        times = {}
        for one in json.loads(file.read_text())["benchmarks"]:
            if one.get("run_type") != "aggregate" or one["aggregate_name"] == "median":
                times[one["run_name"]] = float(one["cpu_time"]) * NANOSECONDS_IN[one["time_unit"]] * 1e-9
        return times


def _costs(
    times: dict[str, float], pattern: re.Pattern, series: Callable[[re.Match], str | None], size: str
) -> dict:
    found: dict[str, list[Cost]] = {}
    for name, time_s in times.items():
        match = pattern.match(name)
        if match and (label := series(match)):
            found.setdefault(label, []).append(Cost(int(match[size]), time_s))
    return {label: sorted(costs, key=lambda cost: cost.nodes) for label, costs in found.items()}


def nearest_costs(times: dict[str, float]) -> dict[str, list[Cost]]:
    """Of asking for the nearest of so many nodes, an arm's joints."""

    def label(match: re.Match) -> str | None:
        leaf, points = int(match["leaf"]), int(match["points"])
        if int(match["joints"]) != ARM_JOINTS:
            return None
        if leaf == LEAF or (leaf == SMALL_LEAF and points <= SMALL_LEAF):
            return "nearest node"
        return "nearest node, OMPL's GNAT" if leaf == 0 else None

    return _costs(times, NEAREST, label, "points")


def step_costs(times: dict[str, float]) -> dict[str, list[Cost]]:
    """Of a worker's step in forests of so many nodes."""
    return _costs(times, STEP, lambda match: f"a step, {match['scene']}", "nodes")


def _cell(point: Point | None) -> str:
    if point is None:
        return ""
    low, middle, high = (
        f"{MILLISECONDS * value:.3g}" if isfinite(value) else "-" for value in point.quartiles_s
    )
    missed = f", {point.solved} of {point.runs} solved" if point.solved < point.runs else ""
    return f"{middle} ({low} ... {high}){missed}"


def _table(heading: str, rows: dict[str, dict[int, str]]) -> str:
    amounts = sorted({amount for cells in rows.values() for amount in cells})
    lines = [
        f"| {heading} | " + " | ".join(f"{amount:,}".replace(",", " ") for amount in amounts) + " |",
        "|---" * (len(amounts) + 1) + "|",
    ]
    lines += [
        f"| {series} | " + " | ".join(cells.get(amount, "") for amount in amounts) + " |"
        for series, cells in rows.items()
    ]
    return "\n".join(lines) + "\n"


def markdown(found: dict[str, Curves], costs: dict[str, list[Cost]]) -> str:
    text = ""
    for axis, title in AXES.items():
        if axis in found:
            rows = {
                name: {point.amount: _cell(point) for point in curve} for name, curve in found[axis].items()
            }
            text += _table(title, rows) + "\n"
    if costs:
        rows = {
            name: {one.nodes: f"{MICROSECONDS * one.time_s:.3g}" for one in curve}
            for name, curve in costs.items()
        }
        text += _table("nodes", rows) + "\n"
    return (
        text
        + "Grasps and obstacles: processor time to a verified path in ms, median (quartiles); runs without one count as "
        "longer than the limit. Nodes: processor time of one operation in µs.\n"
    )
