# SPDX-License-Identifier: BSD-3-Clause
"""Speed-up of B4P with the number of its workers, as tables."""

from dataclasses import dataclass

import numpy as np

from b4p_files.censored import Median, Ratio, median, ratio
from b4p_files.speed_runs import THREADS, VIRTUAL_TIME, Study
from b4p_files.statistics import CONFIDENCE

# Mean times (s) of B4P's solved runs by number of threads: the paper's Tables II and III, on a Ryzen 9 5950X. Of
# the ten runs on the stick, 1, 2 and 6 were solved with 1, 2 and 4 threads; all others were.
PAPER_MACHINE = "paper, Ryzen 9 5950X"
PAPER_MEANS_S = {
    "stick": {1: 172.0, 2: 49.8, 4: 24.2, 8: 8.20, 16: 4.66, 30: 2.03},
    "grocery": {1: 4.50, 2: 1.93, 4: 0.924, 8: 0.484, 16: 0.237, 30: 0.124},
}
NOTE = (
    f"Speed-up: median time with one worker over the median with N, bootstrap {CONFIDENCE} intervals. Runs without "
    "a verified path count as longer than the limit; > and < mark ratios of which one median lies above it. "
    "Virtual time leaves out memory bandwidth, caches and locks."
)


@dataclass
class Point:
    workers: int
    runs: int
    solved: int
    time_s: Median
    work_s: float  # median
    speedup: Ratio | None  # None without runs of one worker


def points(study: Study, kind: str) -> list[Point]:
    """One per number of workers. Threads are compared with one thread, or else with one worker in virtual time."""
    limit, base = study.time_limit_s, study.times_s(kind, 1) or study.times_s(VIRTUAL_TIME, 1)
    found = []
    for workers in study.workers(kind):
        runs, times = study.runs_of(kind, workers), study.times_s(kind, workers)
        found.append(
            Point(
                workers=workers,
                runs=len(runs),
                solved=sum(run.solved for run in runs),
                time_s=median(times, limit),
                work_s=float(np.median([run.work_s for run in runs])),
                speedup=_speedup(base, times, limit),
            )
        )
    return found


def _speedup(base: list[float], times: list[float], limit: float) -> Ratio | None:
    if base == times:  # one worker by itself, of which nothing is uncertain
        return Ratio(1.0, 1.0, 1.0, "")
    return ratio(base, times, limit) if base else None


def threads_over_virtual_time(study: Study) -> list[tuple[int, Ratio, Ratio]]:
    """For each number of workers that ran both ways: elapsed time over virtual time, and the processor time of a
    thread over virtual time, which other programs on the machine disturb less."""
    compared = []
    for workers in study.workers(THREADS):
        simulated = study.times_s(VIRTUAL_TIME, workers)
        if not simulated:
            continue
        runs = study.runs_of(THREADS, workers)
        shares = [run.work_s / workers if run.solved else run.time_s for run in runs]
        elapsed = ratio([run.time_s for run in runs], simulated, study.time_limit_s)
        compared.append((workers, elapsed, ratio(shares, simulated, study.time_limit_s)))
    return compared


def _text(value: float) -> str:
    return f"{value:.3g}"


def ratio_text(found: Ratio | None) -> str:
    if found is None or found.bound == "?":
        return "-"
    return f"{found.bound}{_text(found.value)} [{_text(found.low)}, {_text(found.high)}]"


def _median_text(found: Median) -> str:
    bound = ">" if found.above else ""
    return f"{bound}{_text(found.value)} [{_text(found.low)}, {_text(found.high)}]"


def markdown(studies: list[Study]) -> str:
    return "\n".join([*(_section(study) for study in studies), NOTE, ""])


def _section(study: Study) -> str:
    lines = [
        f"## {study.name} (limit {study.time_limit_s:g} s)",
        "",
        "| | N | solved | median time (s) | speed-up | median work (s) |",
        "|---|---|---|---|---|---|",
    ]
    for kind in (VIRTUAL_TIME, THREADS):
        for point in points(study, kind):
            lines.append(
                f"| {kind} | {point.workers} | {point.solved} of {point.runs} | {_median_text(point.time_s)} "
                f"| {ratio_text(point.speedup)} | {_text(point.work_s)} |"
            )
    paper = PAPER_MEANS_S.get(study.scene, {})
    for threads, mean_s in paper.items():
        speedup = _text(paper[1] / mean_s)
        lines.append(f"| {PAPER_MACHINE} | {threads} | | mean {_text(mean_s)} | {speedup} | |")
    lines.append("")
    for workers, elapsed, share in threads_over_virtual_time(study):
        lines += [
            f"{workers} threads over {workers} workers in virtual time: elapsed time {ratio_text(elapsed)}, "
            f"processor time per thread {ratio_text(share)}.",
            "",
        ]
    return "\n".join(lines)
