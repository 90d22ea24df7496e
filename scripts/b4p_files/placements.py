# SPDX-License-Identifier: BSD-3-Clause
"""Runs of placement scenes: how good the placements of each way of searching are after how long, over all objects of a
surroundings.

Objectives are made comparable per scene, object and objective: 0 is the worst placement that any run found, 1 the best. A
run counts as 0 until its first placement, and holds each one until a better one comes."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf, isfinite

import numpy as np

from b4p_files.censored import median, ratio
from b4p_files.errors import FileError
from b4p_files.records import Record
from b4p_files.statistics import CONFIDENCE, mean_interval, median_ratio, quantile

NEARLY_BEST = 0.95
AS_PRINTED = "as_printed"  # label of the search as the paper has it, in figure5.yaml


@dataclass
class Run:
    """A run as a step function: worth `values[i]` from `times_s[i]` on, and 0 before."""

    object: str
    times_s: list[float]
    values: list[float]  # rising, in [0, 1]

    def at(self, times_s: np.ndarray) -> np.ndarray:
        return np.array([0.0, *self.values])[np.searchsorted(self.times_s, times_s, side="right")]

    def mean(self, limit_s: float) -> float:
        """Area under the curve up to the limit, over the limit."""
        spans = np.diff([min(time, limit_s) for time in (*self.times_s, limit_s)])
        return float(np.dot(spans, self.values)) / limit_s if self.values else 0.0

    def time_to(self, value: float) -> float:
        return next((time for time, reached in zip(self.times_s, self.values, strict=True) if reached >= value), inf)

    @property
    def first_s(self) -> float:
        return self.times_s[0] if self.times_s else inf


@dataclass
class Task:
    """All runs in one surroundings with one objective, by label."""

    surroundings: str
    objective: str
    limit_s: float
    variants: dict[str, list[Run]]

    @property
    def name(self) -> str:
        return f"{self.surroundings}, {self.objective}"


def surroundings_of(record: Record) -> str:
    """A scene's name without its folder, objective and object."""
    name = record.scene.removeprefix("placement_").removesuffix(f"-{record.placement.objective}")
    return name.removesuffix(f"_{record.placement.object}")


def by_processor_time(records: list[Record], limit_s: float) -> list[Record]:
    """The same runs with processor time in place of elapsed time. Every run has to have used as much."""
    short = sum(record.cpu_s < limit_s for record in records)
    if short:
        raise FileError("--processor-s", f"{short} runs used less than {limit_s:g} s of processor time")
    placements = [
        replace(
            record.placement, improvements=[replace(one, time_s=one.cpu_s) for one in record.placement.improvements]
        )
        for record in records
    ]
    pairs = zip(records, placements, strict=True)
    return [replace(record, time_limit_s=limit_s, placement=placement) for record, placement in pairs]


def _verified(record: Record) -> list[tuple[float, float]]:
    """Time and objective of each placement that was verified within the time limit."""
    improvements = record.placement.improvements
    return [(one.time_s, one.objective_m) for one in improvements if one.verified and one.time_s <= record.time_limit_s]


def _normalised(records: list[Record]) -> list[tuple[str, Run]]:
    """Label and run of all runs on one scene."""
    seen = [objective for record in records for _, objective in _verified(record)]
    low, high = (min(seen), max(seen)) if seen else (0.0, 0.0)
    runs = []
    for record in records:
        found = _verified(record)
        values = [(objective - low) / (high - low) if high > low else 1.0 for _, objective in found]
        runs.append((record.label, Run(record.placement.object, [time for time, _ in found], values)))
    return runs


def placement_tasks(records: list[Record]) -> list[Task]:
    """Raises FileError where there is no run on a placement scene, or runs have different limits."""
    records = [record for record in records if record.placement is not None]
    if not records:
        raise FileError("runs.jsonl", "holds no run on a placement scene")
    limits = sorted({record.time_limit_s for record in records})
    if len(limits) > 1:
        raise FileError("runs.jsonl", f"runs have different time limits, {limits[0]:g} to {limits[-1]:g} s")
    scenes: dict[str, list[Record]] = {}
    for record in records:
        scenes.setdefault(record.scene, []).append(record)
    tasks: dict[tuple[str, str], Task] = {}
    for runs in scenes.values():
        surroundings, objective = surroundings_of(runs[0]), runs[0].placement.objective
        task = tasks.setdefault((surroundings, objective), Task(surroundings, objective, limits[0], {}))
        for label, run in _normalised(runs):
            task.variants.setdefault(label, []).append(run)
    return list(tasks.values())


def _per_object(runs: list[Run], measure: Callable[[Run], float]) -> list[list[float]]:
    objects = dict.fromkeys(run.object for run in runs)
    return [[measure(run) for run in runs if run.object == object_name] for object_name in objects]


def _seconds(value: float, limit_s: float) -> str:
    return f"{value:.3g}" if isfinite(value) else f"> {limit_s:g}"


def _row(task: Task, label: str, reference: str) -> str:
    runs = task.variants[label]
    areas = _per_object(runs, lambda run: run.mean(task.limit_s))
    interval = mean_interval(areas)
    spread = f"{interval[0]:.3f} ... {interval[1]:.3f}" if interval else "-"
    nearly = [run.time_to(NEARLY_BEST) for run in runs]
    ratio = median_ratio(nearly, [run.time_to(NEARLY_BEST) for run in task.variants[reference]])
    ends = [run.values[-1] if run.values else 0.0 for run in runs]
    return (
        f"| {label} | {len(runs)} | {np.mean(np.concatenate(areas)):.3f} ({spread}) "
        f"| {np.mean(ends):.3f} | {_seconds(quantile([run.first_s for run in runs], 0.5), task.limit_s)} "
        f"| {_seconds(quantile(nearly, 0.5), task.limit_s)} | {sum(map(isfinite, nearly))} of {len(runs)} "
        f"| {f'{ratio[0]:.2f} ({ratio[1][0]:.2f} ... {ratio[1][1]:.2f})' if ratio else '-'} |\n"
    )


def placement_tables(tasks: list[Task], reference: str | None) -> str:
    """`reference` is the label that times are compared with; None: the first one."""
    labels = list(dict.fromkeys(label for task in tasks for label in task.variants))
    reference = reference or labels[0]
    text = ""
    for task in tasks:
        if reference not in task.variants:
            raise FileError("--reference", f"'{reference}' has no run on {task.name}; there are: {', '.join(labels)}")
        text += f"## {task.name}: {', '.join(dict.fromkeys(run.object for run in task.variants[reference]))}\n\n"
        text += (
            f"| variant | runs | area under the curve ({CONFIDENCE}) | at the end | first placement, s "
            f"| {NEARLY_BEST:.0%} of the best, s | reached | over {reference} ({CONFIDENCE}) |\n"
            "|---|---|---|---|---|---|---|---|\n"
        )
        text += "".join(_row(task, label, reference) for label in task.variants) + "\n"
    text += (
        f"Limit {tasks[0].limit_s:g} s. Values are 0 at the worst and 1 at the best placement seen of an object; the area is "
        "the mean of the value over the time to the limit. Times are medians over all runs; the last column is the ratio of "
        f"the times to {NEARLY_BEST:.0%}, above 1 where {reference} is faster.\n"
    )
    return text


def _scene_rows(surroundings: str, variants: dict[str, list[float]], against: str, limit_s: float) -> str:
    rows = ""
    for label, times in variants.items():
        middle = median(times, limit_s)
        faster = ratio(variants[against], times, limit_s)
        known = label != against and faster.bound != "?"
        bound = f"{faster.bound} " if faster.bound else ""
        rows += (
            f"| {surroundings} | {label} | {sum(map(isfinite, times))} of {len(times)} "
            f"| {'> ' if middle.above else ''}{middle.value:.3g} ({middle.low:.3g} ... {middle.high:.3g}) "
            f"| {f'{bound}{faster.value:.2f} ({faster.low:.2f} ... {faster.high:.2f})' if known else '-'} |\n"
        )
    return rows


def nearly_best_table(tasks: list[Task], against: str | None) -> str:
    """How long each variant takes to nearly the best placement, per surroundings: all objects and objectives together.
    `against` is the label whose time is divided by the others'; None: AS_PRINTED where it has runs, else the first one."""
    labels = list(dict.fromkeys(label for task in tasks for label in task.variants))
    against = against or (AS_PRINTED if AS_PRINTED in labels else labels[0])
    scenes: dict[str, dict[str, list[float]]] = {}
    for task in tasks:
        times = scenes.setdefault(task.surroundings, {})
        for label, runs in task.variants.items():
            times.setdefault(label, []).extend(run.time_to(NEARLY_BEST) for run in runs)
    limit_s = tasks[0].limit_s
    text = f"## Time to {NEARLY_BEST:.0%} of the best, all objects and objectives\n\n"
    text += (
        f"| scene | variant | reached | median, s ({CONFIDENCE}) | {against} over it ({CONFIDENCE}) |\n|---|---|---|---|---|\n"
    )
    for surroundings, variants in scenes.items():
        if against not in variants:
            raise FileError("--against", f"'{against}' has no run in {surroundings}; there are: {', '.join(labels)}")
        text += _scene_rows(surroundings, variants, against, limit_s)
    text += (
        f"\nRuns that never come so far count as longer than {limit_s:g} s, which stands for such a median in the ratio and "
        f"in intervals (bootstrap, over runs). The ratio is above 1 where a variant is faster than {against}.\n"
    )
    return text
