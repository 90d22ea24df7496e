# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/plot.py and of the figures it shows."""

import sqlite3
from pathlib import Path

import pytest
from fixtures import PlannerLog, write_log
from matplotlib.image import imread

from b4p_files.database import read_database
from b4p_files.statistics import wilson_interval

FIGURES = {"overview.png", "success.png", "times.png", "progress.png"}


@pytest.fixture
def database_of(script, tmp_path):
    def make(*experiments: tuple[str, list[PlannerLog]]) -> Path:
        logs = [
            write_log(tmp_path / f"{i}.log", name, 10, planners)
            for i, (name, planners) in enumerate(experiments)
        ]
        assert script("database.py", *logs, "-o", tmp_path / "all.db").returncode == 0
        return tmp_path / "all.db"

    return make


def figures(folder: Path) -> set[str]:
    """Names of the pictures in which something is drawn."""
    return {file.name for file in folder.iterdir() if imread(file).std() > 0.05}


def test_several_experiments_and_planners_without_a_solution_are_plotted(script, tmp_path, database_of):
    progress = [[(0.1, 10), (0.2, 20), (0.4, 30)], [(0.1, 12)], []]
    solving = PlannerLog("b4p_2", [0.5, 1.5, None], progress=progress)
    database = database_of(
        ("maze", [solving, PlannerLog("rrtconnect_1", [None] * 3)]), ("grocery", [solving])
    )
    assert script("plot.py", database, "-o", tmp_path / "plots").returncode == 0
    assert figures(tmp_path / "plots") == FIGURES


def test_nothing_solved_is_plotted(script, tmp_path, database_of):
    result = script("plot.py", database_of(("maze", [PlannerLog("rrt", [None])])), "-o", tmp_path / "plots")
    assert result.returncode == 0
    assert figures(tmp_path / "plots") == FIGURES - {"progress.png"}
    assert "no progress" in result.stdout


def test_runs_that_failed_verification_do_not_count(database_of):
    liar, honest = PlannerLog("liar", [1.0, 2.0], verified=False), PlannerLog("honest", [1.0, None])
    (experiment,) = read_database(database_of(("maze", [liar, honest])))
    assert [planner.solved_times_s for planner in experiment.planners] == [[], [1.0]]
    assert all(run.claimed for run in experiment.planners[0].runs)


def test_planners_of_one_name_with_other_settings_are_told_apart(database_of):
    planner = PlannerLog("b4p", [1.0])
    text = PlannerLog.text
    other = PlannerLog("b4p", [2.0])
    other.text = lambda limit_s: text(other, limit_s).replace("range = 0.5", "range = 0.7")
    (experiment,) = read_database(database_of(("maze", [planner, other])))
    assert [planner.name for planner in experiment.planners] == ["b4p", "b4p (2)"]


def test_wilson_interval_matches_published_values():
    assert wilson_interval(20, 20) == pytest.approx((0.8389, 1.0), abs=1e-4)
    assert wilson_interval(0, 10) == pytest.approx((0.0, 0.2775), abs=1e-4)
    assert wilson_interval(5, 10) == pytest.approx((0.2366, 0.7634), abs=1e-4)


def test_a_database_without_runs_is_refused(refuses, tmp_path, database_of):
    refuses("all.db: holds no run", "plot.py", database_of(("maze", [])), "-o", tmp_path / "plots")
    assert not (tmp_path / "plots").exists()


def test_what_is_no_database_is_refused(refuses, tmp_path):
    text = tmp_path / "text.db"
    text.write_text("not a database, however long this line may be " * 10)
    refuses("text.db: not an OMPL benchmark database", "plot.py", text, "-o", tmp_path / "plots")


def test_a_database_of_something_else_is_refused(refuses, tmp_path):
    database = tmp_path / "other.db"
    with sqlite3.connect(database) as connection:
        connection.execute("CREATE TABLE birds (name TEXT)")
    refuses("other.db: not an OMPL benchmark database", "plot.py", database, "-o", tmp_path / "plots")


def test_a_missing_database_is_refused_and_not_made(refuses, tmp_path):
    refuses("none.db: no such file", "plot.py", tmp_path / "none.db", "-o", tmp_path / "plots")
    assert not (tmp_path / "none.db").exists()


def test_an_unwritable_folder_is_refused(refuses, tmp_path, database_of):
    database = database_of(("maze", [PlannerLog("b4p", [1.0])]))
    refuses("all.db", "plot.py", database, "-o", database / "plots")
