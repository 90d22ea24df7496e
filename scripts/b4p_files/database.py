# SPDX-License-Identifier: BSD-3-Clause
"""Reads an OMPL benchmark database (SQLite, as scripts/database.py makes it)."""

import sqlite3
from collections import Counter
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import quote

from b4p_files.errors import FileError

Series = list[tuple[float, float]]


@dataclass
class Run:
    """One run of one planner. `time_s` is set when the run counts as solved."""

    time_s: float | None
    claimed: bool  # the planner reports an exact solution
    verified: bool | None  # None: the database does not say
    properties: dict[str, float | str | None]
    progress: dict[str, Series] = field(default_factory=dict)  # column -> (seconds, value)


@dataclass
class Planner:
    name: str
    runs: list[Run]

    @property
    def solved_times_s(self) -> list[float]:
        return sorted(run.time_s for run in self.runs if run.time_s is not None)


@dataclass
class Experiment:
    name: str
    time_limit_s: float
    planners: list[Planner]
    setup: dict[str, str | float | None]


def read_database(file: Path) -> list[Experiment]:
    """Raises FileError when `file` is not a benchmark database or holds no run."""
    if not file.is_file():
        raise FileError(file, "no such file")
    try:
        with closing(sqlite3.connect(f"file:{quote(str(file))}?mode=ro", uri=True)) as connection:
            connection.row_factory = sqlite3.Row
            experiments = _read_experiments(connection)
    except sqlite3.Error as error:
        raise FileError(file, f"not an OMPL benchmark database: {error}") from None
    if not any(planner.runs for experiment in experiments for planner in experiment.planners):
        raise FileError(file, "holds no run")
    return experiments


def _read_experiments(connection: sqlite3.Connection) -> list[Experiment]:
    progress = _read_progress(connection)
    runs: dict[int, dict[int, list[Run]]] = {}
    for row in connection.execute("SELECT * FROM runs ORDER BY id"):
        run = _read_run(dict(row))
        run.progress = progress.get(row["id"], {})
        runs.setdefault(row["experimentid"], {}).setdefault(row["plannerid"], []).append(run)
    configurations = connection.execute("SELECT id, name FROM plannerConfigs").fetchall()
    planner_names = {row["id"]: row["name"].removeprefix("geometric_") for row in configurations}
    rows = connection.execute("SELECT * FROM experiments ORDER BY id").fetchall()
    return [
        Experiment(name, row["timelimit"], _planners(runs.get(row["id"], {}), planner_names), dict(row))
        for name, row in zip(_distinct([row["name"] for row in rows]), rows)
    ]


def _planners(runs: dict[int, list[Run]], names: dict[int, str]) -> list[Planner]:
    """Planners of one name within an experiment differ in their settings."""
    distinct = _distinct([names[planner] for planner in runs])
    return [Planner(name, found) for name, found in zip(distinct, runs.values())]


def _distinct(names: list[str]) -> list[str]:
    seen: Counter[str] = Counter()
    result = []
    for name in names:
        seen[name] += 1
        result.append(name if seen[name] == 1 else f"{name} ({seen[name]})")
    return result


def _read_run(row: dict[str, float | str | None]) -> Run:
    claimed = bool(row.get("solved")) and not row.get("approximate_solution")
    verified = bool(row["verified"]) if "verified" in row else None
    time_s = row.get("time_to_verified_path")
    if time_s is None:
        time_s = row.get("time")
    counts = claimed and verified is not False and time_s is not None
    return Run(float(time_s) if counts else None, claimed, verified, row)


def _read_progress(connection: sqlite3.Connection) -> dict[int, dict[str, Series]]:
    exists = connection.execute(
        "SELECT 1 FROM sqlite_master WHERE type='table' AND name='progress'"
    ).fetchone()
    if not exists:
        return {}
    progress: dict[int, dict[str, Series]] = {}
    for row in connection.execute("SELECT * FROM progress ORDER BY runid, time"):
        run = progress.setdefault(row["runid"], {})
        for column in row.keys():
            if column not in ("runid", "time") and isinstance(row[column], (int, float)):
                run.setdefault(column, []).append((row["time"], float(row[column])))
    return progress
