# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/database.py: every run of every log arrives; a bad log leaves nothing behind."""

import sqlite3
from pathlib import Path

import pytest
from fixtures import PlannerLog, write_log

PROGRESS = [[(0.1, 10), (0.2, 20)], [(0.1, 12)]]


@pytest.fixture
def log(tmp_path: Path) -> Path:
    planners = [PlannerLog("b4p_2", [0.5, 1.5], progress=PROGRESS), PlannerLog("rrtconnect_1", [None, 3.0])]
    return write_log(tmp_path / "maze.log", "maze", 10, planners)


def count(database: Path, table: str) -> int:
    with sqlite3.connect(database) as connection:
        return connection.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0]


def test_all_runs_of_all_logs_arrive(script, tmp_path, log):
    other = write_log(tmp_path / "grocery.log", "grocery", 5, [PlannerLog("b4p_2", [1.0, None, 2.0])])
    database = tmp_path / "new folder" / "all.db"
    assert script("database.py", log, other, "-o", database).returncode == 0
    assert count(database, "experiments") == 2
    assert count(database, "runs") == 2 * 2 + 3
    assert count(database, "progress") == 3


def test_own_columns_arrive(script, tmp_path, log):
    database = tmp_path / "all.db"
    script("database.py", log, "-o", database)
    with sqlite3.connect(database) as connection:
        rows = connection.execute("SELECT grasp_id, verified, time_to_verified_path FROM runs").fetchall()
    assert rows == [(3, 1, 0.5), (3, 1, 1.5), (3, 0, None), (3, 1, 3.0)]


def test_an_existing_database_is_replaced(script, tmp_path, log):
    database = tmp_path / "all.db"
    for _ in range(2):
        assert script("database.py", log, "-o", database).returncode == 0
    assert count(database, "experiments") == 1


@pytest.mark.parametrize("kept", [0.02, 0.1, 0.3, 0.6, 0.8, 0.99])
def test_a_cut_log_is_refused_and_leaves_nothing(refuses, tmp_path, log, kept):
    text = log.read_text()
    log.write_text(text[: int(kept * len(text))])
    refuses("maze.log: not an OMPL benchmark log, or cut off", "database.py", log, "-o", tmp_path / "all.db")
    assert [file.name for file in tmp_path.iterdir()] == ["maze.log"]


def test_a_bad_log_keeps_the_old_database(script, refuses, tmp_path, log):
    database = tmp_path / "all.db"
    script("database.py", log, "-o", database)
    bad = tmp_path / "bad.log"
    bad.write_text("no log\n")
    refuses("bad.log: not an OMPL benchmark log", "database.py", log, bad, "-o", database)
    assert count(database, "runs") == 4


def test_a_missing_log_is_refused(refuses, tmp_path):
    refuses("none.log: No such file", "database.py", tmp_path / "none.log", "-o", tmp_path / "all.db")


def test_an_unwritable_place_is_refused(refuses, tmp_path, log):
    refuses("maze.log: ", "database.py", log, "-o", log / "all.db")
