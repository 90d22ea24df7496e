# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a benchmark folder, as `b4p bench` records them (runs.jsonl, experiment.json)."""

import json
from dataclasses import dataclass
from enum import Enum
from math import inf, isfinite, nan
from pathlib import Path

from b4p_files.errors import FileError, reading

SCHEMA = 1


class Budget(Enum):
    """What a run may use up. One run can be judged by both."""

    SECONDS = "seconds"
    WORK = "work"  # configurations checked


@dataclass
class Improvement:
    """A placement better than those before it."""

    time_s: float  # since planning began
    cpu_s: float  # processor time since then
    objective_m: float
    recomputed_m: float  # the objective as the verifier has it
    arm: str
    verified: bool


@dataclass
class Placements:
    """What a run on a placement scene found."""

    objective: str
    object: str
    improvements: list[Improvement]


@dataclass
class Record:
    scene: str
    label: str
    planner: str
    threads: int
    run: int
    verified: bool  # an exact path that passed the verifier; nothing else counts as solved
    crashed: bool
    time_s: float
    cpu_s: float
    checks: int
    time_limit_s: float
    check_limit: int | None
    build: dict[str, str]
    tcp_path_m: float | None = None  # None: no path, or a folder that does not say
    joint_path: float | None = None
    placement: Placements | None = None  # of placement scenes

    @property
    def group(self) -> str:
        """The label without the thread count that `b4p bench` appends to it."""
        return self.label.removesuffix(f"_{self.threads}")

    def used(self, budget: Budget) -> float:
        """What the run took of the budget, as a share."""
        if budget is Budget.SECONDS:
            return self.time_s / self.time_limit_s
        return self.checks / self.check_limit if self.check_limit else inf

    def solved(self, budget: Budget) -> bool:
        return self.verified and self.used(budget) <= 1.0

    def seconds(self, budget: Budget) -> float:
        """Time to the path; under the work budget, the seconds that this work would have taken where that budget
        comes from. Infinite when not solved within the budget."""
        return self.used(budget) * self.time_limit_s if self.solved(budget) else inf

    def undecided(self, budget: Budget) -> bool:
        """Ended without a path before the budget was used up."""
        return not self.verified and not self.crashed and self.used(budget) < 1.0


def read_records(folder: Path) -> list[Record]:
    """Raises FileError unless the folder holds at least one run. A last line that was cut off is left out."""
    file = folder / "runs.jsonl"
    with reading(file, "file of benchmark runs"):
        lines = file.read_text().split("\n")[:-1]
        records = [_record(json.loads(line)) for line in lines]
    if not records:
        raise FileError(file, "holds no run")
    keys = [(record.scene, record.label, record.run) for record in records]
    if len(set(keys)) < len(keys):
        raise FileError(file, "holds a run twice")
    return records


def _record(line: dict) -> Record:
    if line["schema"] != SCHEMA:
        raise ValueError(f"schema: {line['schema']} is not {SCHEMA}")
    record = Record(
        scene=line["scene"],
        label=line["label"],
        planner=line["planner"],
        threads=int(line["threads"]),
        run=int(line["run"]),
        verified=line["solved"] is True and line["verified"] is True,
        crashed=bool(line["crashed"]),
        time_s=float(line["time_s"]),
        cpu_s=float(line["cpu_s"]),
        checks=int(line["checks"]),
        time_limit_s=float(line["time_limit_s"]),
        check_limit=None if line["check_limit"] is None else int(line["check_limit"]),
        build=dict(line["build"]),
        tcp_path_m=_column(line, "tcp path length REAL"),
        joint_path=_column(line, "solution length REAL"),
        placement=_placements(line["placement"]) if "placement" in line else None,
    )
    if not record.time_limit_s > 0 or (record.check_limit is not None and record.check_limit < 1):
        raise ValueError("a limit that is not positive")
    return record


def _placements(part: dict) -> Placements:
    improvements = [Improvement(**one) for one in part["improvements"]]
    if not all(isfinite(one.time_s) and isfinite(one.objective_m) for one in improvements):
        raise ValueError("an improvement's time or objective is not finite")
    return Placements(part["objective"], part["object"], improvements)


def _column(line: dict, name: str) -> float | None:
    """A finite number that OMPL or b4p recorded."""
    value = float(line.get("ompl", {}).get("columns", {}).get(name) or nan)
    return value if isfinite(value) else None


def planned_runs(folder: Path) -> dict[str, int]:
    """Runs per scene that the experiment wants, by label."""
    file = folder / "experiment.json"
    with reading(file, "settings file of a benchmark"):
        planners = json.loads(file.read_text())["planners"]
        return {label: int(planner["runs"]) for label, planner in planners.items()}
