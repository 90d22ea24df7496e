# SPDX-License-Identifier: BSD-3-Clause
"""Files of runs that `b4p simulate` writes."""

import json
from dataclasses import dataclass
from math import inf
from pathlib import Path

from b4p_files.errors import FileError, reading

SCHEMA = 1
VIRTUAL_TIME, THREADS = "virtual time", "threads"


@dataclass
class SpeedRun:
    kind: str
    workers: int
    seed: int
    solved: bool  # with a verified path
    time_s: float  # infinite when not solved
    work_s: float
    steps: int


@dataclass
class Study:
    file: Path
    scene: str
    planner: str
    parameters: dict[str, str]
    time_limit_s: float
    runs: list[SpeedRun]

    @property
    def name(self) -> str:
        settings = "".join(f", {key}={value}" for key, value in self.parameters.items())
        return f"{self.scene}, {self.planner}{settings}"

    def workers(self, kind: str) -> list[int]:
        return sorted({run.workers for run in self.runs if run.kind == kind})

    def runs_of(self, kind: str, workers: int) -> list[SpeedRun]:
        return [run for run in self.runs if run.kind == kind and run.workers == workers]

    def times_s(self, kind: str, workers: int) -> list[float]:
        return [run.time_s for run in self.runs_of(kind, workers)]


def read_study(file: Path) -> Study:
    """Raises FileError when `file` is not a file of runs, or holds none."""
    with reading(file, "file of `b4p simulate`"):
        text = file.read_text()
        lines = text[: text.rfind("\n") + 1].splitlines()  # a last line may be cut off
        if not lines:
            raise ValueError("it is empty")
        header, *runs = (json.loads(line) for line in lines)
        if header["schema"] != SCHEMA:
            raise FileError(file, f"schema: {header['schema']} is not {SCHEMA}")
        if not runs:
            raise FileError(file, "holds no run")
        return Study(
            file=file,
            scene=Path(header["scene"]).stem,
            planner=header["planner"],
            parameters=dict(header["parameters"]),
            time_limit_s=float(header["time_limit_s"]),
            runs=[_run_from(run) for run in runs],
        )


def _run_from(run: dict) -> SpeedRun:
    if run["kind"] not in (VIRTUAL_TIME, THREADS):
        raise ValueError(f"kind: {run['kind']}")
    solved = bool(run["solved"]) and bool(run["verified"])
    return SpeedRun(
        kind=run["kind"],
        workers=int(run["workers"]),
        seed=int(run["seed"]),
        solved=solved,
        time_s=float(run["time_s"]) if solved else inf,
        work_s=float(run["work_s"]),
        steps=int(run["steps"]),
    )
