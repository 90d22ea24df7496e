# SPDX-License-Identifier: BSD-3-Clause
"""Small inputs for the scripts, written by the tests themselves."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

STATUS_SOLVED, STATUS_TIMEOUT = 6, 1
HEADER = """OMPL version 1.5.2
Experiment {name}
Running on host
Starting at 2026-Nov-24 10:00:00
<<<|
setup
|>>>
<<<|
cpu
|>>>
1 is the random seed
{limit} seconds per run
1000000 MB per run
{runs} runs per planner
1.0 seconds spent to collect the data
1 enum type
status|Unknown|Timeout|a|b|c|d|Exact solution|
{planners} planners
"""
PROPERTIES = (
    "time REAL",
    "solved BOOLEAN",
    "approximate solution BOOLEAN",
    "status ENUM",
    "verified BOOLEAN",
    "time to verified path REAL",
    "grasp id INTEGER",
    "repairs tried INTEGER",
    "repairs succeeded INTEGER",
    "validity checks INTEGER",
    "edge checks INTEGER",
    "seed INTEGER",
    "threads INTEGER",
)


@dataclass
class PlannerLog:
    """`times`: seconds to the path of each run, None when unsolved; `verified` holds for all solved runs."""

    name: str
    times: Sequence[float | None]
    verified: bool = True
    progress: Sequence[Sequence[tuple[float, int]]] = field(default_factory=list)

    def text(self, limit_s: float) -> str:
        rows = [self._row(seed, time, limit_s) for seed, time in enumerate(self.times)]
        properties = [f"{len(PROPERTIES)} properties for each run", *PROPERTIES]
        lines = [self.name, "1 common properties", "range = 0.5", *properties, f"{len(rows)} runs", *rows]
        if self.progress:
            lines += ["2 progress properties for each run", "time REAL", "iterations INTEGER"]
            lines += [f"{len(self.progress)} runs"]
            lines += ["".join(f"{time},{value},;" for time, value in run) for run in self.progress]
        return "\n".join([*lines, ".", ""])

    def _row(self, seed: int, time: float | None, limit_s: float) -> str:
        solved = time is not None
        status = STATUS_SOLVED if solved else STATUS_TIMEOUT
        verified_time = time if solved and self.verified else "nan"
        passed = int(solved and self.verified)
        values = (time or limit_s, int(solved), 0, status, passed, verified_time, 3, 5, 1, 1000, 90, seed, 2)
        return "".join(f"{value}; " for value in values)


def write_log(file: Path, name: str, limit_s: float, planners: Sequence[PlannerLog]) -> Path:
    runs = max((len(planner.times) for planner in planners), default=0)
    header = HEADER.format(name=name, limit=limit_s, runs=runs, planners=len(planners))
    file.write_text(header + "".join(planner.text(limit_s) for planner in planners))
    return file
