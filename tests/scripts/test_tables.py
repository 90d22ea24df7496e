# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/tables.py: rates over all runs, under each budget, the paper's figures marked as its own."""

import json
from math import inf
from pathlib import Path

import pytest
from conftest import ROOT
from matplotlib.image import imread

from b4p_files.comparison import comparison
from b4p_files.errors import FileError
from b4p_files.published import read_published
from b4p_files.records import planned_runs, read_records
from b4p_files.statistics import median_ratio, quantile

PUBLISHED = ROOT / "experiments" / "paper" / "published.yaml"
BUILD = {"commit": "abc", "CPU": "a processor", "cores": "2"}


def record(number: int, path_s: float | None, **changes: object) -> dict:
    """A run that was solved after `path_s`, or not at all, of 120 s and 1000 checks."""
    solved = path_s is not None
    line = {
        "schema": 1,
        "scene": "maze",
        "label": "b4p_2",
        "run": number,
        "planner": "b4p",
        "threads": 2,
        "time_limit_s": 120.0,
        "check_limit": 1000,
        "solved": solved,
        "verified": solved,
        "crashed": False,
        "time_s": path_s or 130.0,
        "cpu_s": 240.0,
        "checks": 500 if solved else 1100,
        "build": BUILD,
    }
    return line | changes


@pytest.fixture
def folder(tmp_path):
    def make(*lines: dict, tail: str = "", planned: int = 3) -> Path:
        (tmp_path / "runs.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines) + tail)
        planners = {line["label"]: {"runs": planned} for line in lines}
        (tmp_path / "experiment.json").write_text(json.dumps({"planners": planners}))
        return tmp_path

    return make


def page(folder: Path) -> str:
    return comparison(read_records(folder), planned_runs(folder), read_published(PUBLISHED))


def tables(folder: Path) -> dict[str, list[list[str]]]:
    """The rows of all tables, by heading of their section."""
    return {
        section.splitlines()[0]: [
            [cell.strip() for cell in line.strip("|").split("|")]
            for line in section.splitlines()
            if line.startswith("| ")
        ][1:]
        for section in page(folder).split("\n## ")[1:]
    }


BY_TIME, BY_WORK = "Table I: maze, limited by time", "Table I: maze, limited by work"


def test_failures_stand_in_the_denominator(folder):
    row, *_ = tables(folder(record(1, 10.0), record(2, 20.0), record(3, None)))[BY_TIME]
    assert row[:4] == ["b4p", "2", "2 of 3", "67 % (21 ... 94 %)"]
    assert row[4] == "20 (15 ... > 120)"
    assert row[5] == "15 ± 7.1"


def test_neither_crashes_nor_unverified_paths_count_as_solved(folder):
    unverified = record(1, 10.0, verified=False)
    crashed = record(2, None, crashed=True, time_s=0.1, checks=0)
    row, *_ = tables(folder(unverified, crashed, record(3, 5.0)))[BY_TIME]
    assert row[2] == "1 of 3"
    assert row[5] == "5"


def test_a_run_is_judged_by_each_budget_of_its_own(folder):
    late_but_lean = record(1, 200.0, checks=500)
    early_but_busy = record(2, 60.0, checks=1500)
    sections = tables(folder(late_but_lean, early_but_busy, record(3, 119.0, checks=999)))
    assert sections[BY_TIME][0][2] == "2 of 3"
    assert sections[BY_WORK][0][2] == "2 of 3"
    assert sections[BY_TIME][0][5].startswith("89.5 ±")
    assert sections[BY_WORK][0][5].startswith("89.9 ±"), "(500 + 999) / 1000 of 120 s"


def test_the_same_rate_reads_the_same_whatever_the_number_of_runs(folder):
    few = [record(number, 1.0) for number in range(10)]
    many = [record(number, 1.0, label="b4p_paper_2", planner="b4p-paper") for number in range(20)]
    rows = tables(folder(*few, *many))[BY_TIME]
    assert [row[3].split()[0] for row in rows[:2]] == ["100", "100"]
    assert rows[0][2] == "10 of 10" and rows[1][2] == "20 of 20"


def test_without_a_work_limit_there_is_no_table_for_it(folder):
    assert list(tables(folder(record(1, 1.0, check_limit=None)))) == [BY_TIME]


def test_the_papers_figures_stand_beside_ours_and_are_marked(folder):
    place = folder(record(1, 1.0))
    rows = tables(place)[BY_TIME]
    assert rows[0][7:] == ["3 of 10", "30 % (11 ... 60 %)", "135 ± 33"]
    assert ["B4P", "4", "not run here", "-", "-", "-", "-", "10 of 10"] in [row[:8] for row in rows]
    assert not any(row[0] == "B4P" and row[1] == "2" for row in rows)
    text = page(place)
    assert "AMD Ryzen 9 5950X, 16 cores, MuJoCo. Not measured here." in text
    assert text.count("†") == 1 + 3 * 2


def test_what_is_incomplete_or_undecided_is_said(folder):
    gave_up = record(1, None, time_s=3.0, checks=10)
    text = page(folder(gave_up, record(2, 1.0), planned=10))
    assert "b4p_2: 2 of 10 planned runs so far" in text
    assert "b4p_2: 1 runs ended before this budget was used up" in text


def test_another_time_limit_than_the_papers_is_said(folder):
    assert "The paper's: 120 s" in page(folder(record(1, 1.0, time_limit_s=60.0)))


def test_the_script_writes_tables_and_both_plots(script, folder):
    one_thread = [record(number, 8.0 + number, label="b4p_1", threads=1) for number in range(5)]
    two_threads = [record(number, 3.0 + number) for number in range(5)]
    place = folder(*one_thread, *two_threads, record(9, None, scene="stick"))
    result = script("tables.py", place, "-o", place / "out")
    assert result.returncode == 0, result.stderr
    assert (place / "out" / "tables.md").read_text() == page(place)
    for name in ("threads_seconds.png", "threads_work.png"):
        assert imread(place / "out" / name).std() > 0.05


def test_a_line_that_was_cut_off_is_left_out(folder):
    place = folder(record(1, 1.0), tail=json.dumps(record(2, 1.0))[:50])
    assert [run.run for run in read_records(place)] == [1]


def test_quantiles_know_runs_without_an_end():
    assert quantile([3.0, 1.0, 2.0], 0.5) == 2.0
    assert quantile([1.0, 2.0], 0.25) == 1.25
    assert quantile([1.0, inf], 0.5) == inf
    assert quantile([1.0, 2.0, inf], 0.5) == 2.0


def test_speed_up_has_an_interval_around_it_and_none_without_solutions():
    ratio, (low, high) = median_ratio([10.0, 11.0, 12.0, 13.0] * 5, [5.0, 5.5, 6.0, 6.5] * 5)
    assert low < ratio < high
    assert ratio == pytest.approx(2.0)
    assert median_ratio([inf, inf, 1.0], [1.0, 1.0, 1.0]) is None


def test_published_figures_are_those_of_the_paper():
    published = read_published(PUBLISHED)
    maze = published.figure("maze", "b4p-paper", 2)
    assert (maze.solved, maze.trials, maze.mean_s, maze.sd_s) == (3, 10, 135.37, 32.56)
    assert published.figure("grocery", "rrt-individual", 30).solved == 5
    assert published.figure("stick", "rrtconnect", 1) is None
    assert {scene.budget_s for scene in published.scenes.values()} == {120.0, 180.0}
    assert all(len(column) == 6 for scene in published.scenes.values() for column in scene.columns.values())


BAD_LINES = {
    "no number": {"time_s": "fast"},
    "other schema": {"schema": 2},
    "no limit": {"time_limit_s": 0},
    "no build": {"build": None},
}


@pytest.mark.parametrize("changes", BAD_LINES.values(), ids=BAD_LINES.keys())
def test_a_bad_record_is_refused(folder, changes):
    with pytest.raises(FileError, match="runs.jsonl: not a file of benchmark runs"):
        read_records(folder(record(1, 1.0, **changes)))


def test_no_run_and_a_run_twice_are_refused(folder):
    with pytest.raises(FileError, match="runs.jsonl: holds no run"):
        read_records(folder())
    with pytest.raises(FileError, match="runs.jsonl: holds a run twice"):
        read_records(folder(record(1, 1.0), record(1, 1.0)))


def test_missing_files_are_refused_and_nothing_is_written(refuses, folder, tmp_path):
    refuses("runs.jsonl: No such file", "tables.py", tmp_path, "-o", tmp_path / "out")
    place = folder(record(1, 1.0))
    (place / "experiment.json").unlink()
    refuses("experiment.json: No such file", "tables.py", place, "-o", place / "out")
    assert not (place / "out").exists()


def test_a_published_rate_beyond_its_trials_is_refused(tmp_path):
    bad = tmp_path / "published.yaml"
    bad.write_text(PUBLISHED.read_text().replace("trials: 10", "trials: 9"))
    with pytest.raises(FileError, match="published.yaml: "):
        read_published(bad)
