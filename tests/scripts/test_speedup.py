# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/speedup.py: medians with unsolved runs counted as longer than the limit, and never mixed up."""

import json
from math import inf
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from b4p_files.censored import median, ratio
from b4p_files.speed_runs import THREADS, VIRTUAL_TIME, read_study
from b4p_files.speedup import markdown, points, threads_over_virtual_time

LIMIT_S = 100.0


def line(kind: str, workers: int, seed: int, time_s: float | None, verified: bool = True) -> str:
    solved = time_s is not None
    return json.dumps(
        {
            "kind": kind,
            "workers": workers,
            "seed": seed,
            "solved": solved,
            "verified": solved and verified,
            "time_s": time_s if solved else LIMIT_S,
            "work_s": workers * (time_s or LIMIT_S),
            "steps": 10,
        }
    )


@pytest.fixture
def study_file(tmp_path):
    def write(*lines: str, scene: str = "grocery", name: str = "s.json") -> Path:
        header = {"schema": 1, "scene": scene, "planner": "b4p", "parameters": {}, "time_limit_s": LIMIT_S}
        file = tmp_path / name
        file.write_text("".join(text + "\n" for text in (json.dumps(header), *lines)))
        return file

    return write


def runs(kind: str, workers: int, *times_s: float | None) -> list[str]:
    return [line(kind, workers, seed, time_s) for seed, time_s in enumerate(times_s)]


def test_speed_up_is_the_ratio_of_medians(study_file):
    study = read_study(study_file(*runs(VIRTUAL_TIME, 1, 8, 10, 50), *runs(VIRTUAL_TIME, 4, 1, 2, 90)))
    one, four = points(study, VIRTUAL_TIME)
    assert (one.speedup.low, one.speedup.value, one.speedup.high) == (1.0, 1.0, 1.0)
    assert four.speedup.value == 5.0
    assert four.speedup.low <= 5.0 <= four.speedup.high
    assert (four.time_s.value, four.time_s.above, four.solved, four.runs) == (2.0, False, 3, 3)
    assert four.work_s == 8.0


def test_unsolved_runs_count_as_longer_than_the_limit(study_file):
    study = read_study(study_file(*runs(VIRTUAL_TIME, 1, None, None, 50), *runs(VIRTUAL_TIME, 4, 1, 2, None)))
    one, four = points(study, VIRTUAL_TIME)
    assert one.time_s.above and one.solved == 1
    assert four.time_s.value == 2.0
    assert (four.speedup.value, four.speedup.bound) == (50.0, ">")
    text = markdown([study])
    assert "| virtual time | 1 | 1 of 3 | >100 " in text
    assert "| >50 [" in text


def test_paths_that_failed_verification_are_no_solutions(study_file):
    lines = [line(VIRTUAL_TIME, 1, seed, 3.0, verified=False) for seed in range(2)]
    (point,) = points(read_study(study_file(*lines)), VIRTUAL_TIME)
    assert point.solved == 0 and point.time_s.above


def test_threads_are_compared_with_virtual_time(study_file):
    lines = [*runs(VIRTUAL_TIME, 1, 10, 12), *runs(VIRTUAL_TIME, 2, 4, 4), *runs(THREADS, 2, 6, 6)]
    study = read_study(study_file(*lines))
    ((workers, elapsed, share),) = threads_over_virtual_time(study)
    assert (workers, elapsed.value, share.value) == (2, 1.5, 1.5)
    (measured,) = points(study, THREADS)
    assert measured.speedup.value == pytest.approx(11 / 6)
    assert "2 threads over 2 workers in virtual time: elapsed time 1.5 [1.5, 1.5]" in markdown([study])


def test_intervals_hold_the_truth_as_often_as_they_say():
    generator = np.random.default_rng(5)
    trials, truth = 200, np.log(2.0)
    hits = 0
    for _ in range(trials):
        found = median(list(generator.exponential(size=30)), inf)
        hits += found.low <= truth <= found.high
    assert 0.88 <= hits / trials <= 0.99


def test_a_ratio_of_two_unknown_medians_is_unknown():
    assert ratio([inf, inf], [inf, inf], 10.0).bound == "?"
    assert ratio([5.0], [inf, inf], 10.0).bound == "<"


def test_plots_and_tables_of_several_studies(script, tmp_path, study_file):
    known = [*runs(VIRTUAL_TIME, 1, 8, 10), *runs(VIRTUAL_TIME, 32, 0.1, 0.3), *runs(THREADS, 2, 5, 6)]
    files = [
        study_file(*known),
        study_file(*known, scene="/scenes/maze.yaml", name="maze.json"),
        study_file(*runs(VIRTUAL_TIME, 1, None), scene="stick", name="unsolved.json"),
    ]
    out, table = tmp_path / "plots" / "speedup.png", tmp_path / "speedup.md"
    result = script("speedup.py", *files, "-o", out, "--markdown", table)
    assert result.returncode == 0, result.stderr
    assert imread(out).std() > 0.05
    text = table.read_text()
    assert "## maze, b4p (limit 100 s)" in text
    assert text.count("| paper, Ryzen 9 5950X | 30 |") == 2  # the paper's grocery and stick


def test_a_file_that_was_cut_off_is_read_up_to_there(study_file):
    file = study_file(*runs(VIRTUAL_TIME, 1, 8, 10))
    file.write_text(file.read_text()[:-5])
    assert len(read_study(file).runs) == 1


def test_what_is_no_file_of_runs_is_refused(refuses, tmp_path, study_file):
    out = tmp_path / "p.png"
    refuses("none.json", "speedup.py", tmp_path / "none.json", "-o", out)
    refuses("holds no run", "speedup.py", study_file(), "-o", out)
    refuses("s.json: not a file", "speedup.py", study_file('{"kind": "threads"}'), "-o", out)
    refuses("kind: guess", "speedup.py", study_file(line("guess", 1, 1, 2.0)), "-o", out)
    assert not out.exists()
