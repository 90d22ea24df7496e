# SPDX-License-Identifier: BSD-3-Clause
"""Promises of placement_plots.py, on runs whose figures are worked out by hand: values per object between the worst and
the best placement of any run, areas, times, what is no placement."""

import json
from pathlib import Path

import numpy as np
import pytest

from b4p_figures.placements import curve
from b4p_files.placements import nearly_best_table, placement_tables, placement_tasks
from b4p_files.records import read_records

LIMIT_S = 10.0


def line(label: str, object_name: str, number: int, *found: tuple, objective: str = "max_clearance") -> dict:
    improvements = [
        {
            "time_s": time_s,
            "cpu_s": time_s / 2,
            "objective_m": value,
            "recomputed_m": value,
            "arm": "panda",
            "verified": not rejected,
        }
        for time_s, value, *rejected in found
    ]
    return {
        "schema": 1,
        "scene": f"placement_panda_shelf_{object_name}-{objective}",
        "label": label,
        "run": number,
        "planner": "placement",
        "threads": 1,
        "time_limit_s": LIMIT_S,
        "check_limit": None,
        "solved": bool(found),
        "verified": bool(found),
        "crashed": False,
        "time_s": found[0][0] if found else LIMIT_S,
        "cpu_s": LIMIT_S / 2,
        "checks": 10,
        "build": {"commit": "abc"},
        "placement": {"objective": objective, "object": object_name, "improvements": improvements},
    }


RUNS = [
    # cup: the worst is worth 0.1, the best 0.3; what failed verification counts for nothing
    line("one", "cup", 1, (1.0, 0.1), (3.0, 0.3)),
    line("two", "cup", 1, (2.0, 0.2), (5.0, 9.0, "rejected")),
    # box: between 0.1 and 0.5
    line("one", "box", 1, (2.0, 0.5)),
    line("two", "box", 1, (4.0, 0.1), (6.0, 0.5)),
]


def folder_of(folder: Path, runs: list[dict]) -> Path:
    (folder / "runs.jsonl").write_text("".join(json.dumps(run) + "\n" for run in runs))
    return folder


def rows(text: str) -> dict[str, list[str]]:
    cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in text.splitlines() if row.startswith("| ")]
    return {row[0]: row[1:] for row in cells}


def test_objects_are_taken_together_by_surroundings_and_objective(tmp_path):
    nearest = [line("one", "cup", 1, (1.0, -0.4), (2.0, -0.2), objective="min_clearance")]
    tasks = placement_tasks(read_records(folder_of(tmp_path, RUNS + nearest)))
    assert [task.name for task in tasks] == ["panda_shelf, max_clearance", "panda_shelf, min_clearance"]
    assert [run.object for run in tasks[0].variants["two"]] == ["cup", "box"]
    assert tasks[1].variants["one"][0].values == [0.0, 1.0]


def test_figures_are_those_worked_out_by_hand(tmp_path):
    tasks = placement_tasks(read_records(folder_of(tmp_path, RUNS)))
    table = rows(placement_tables(tasks, None))
    # one: cup 0 for 2 s, then 1 for 7 s; box 1 for 8 s. two: cup 0.5 for 8 s; box 0 for 2 s, then 1 for 4 s.
    assert table["one"][:2] == ["2", "0.750 (-)"]
    assert table["two"][:2] == ["2", "0.400 (-)"]
    assert [table[label][2] for label in ("one", "two")] == ["1.000", "0.750"], "value at the end"
    assert [table[label][3] for label in ("one", "two")] == ["1.5", "3"], "first placement"
    assert [table[label][4] for label in ("one", "two")] == ["2.5", "> 10"], "95 % of the best"
    assert [table[label][5] for label in ("one", "two")] == ["2 of 2", "1 of 2"]
    assert [table[label][6] for label in ("one", "two")] == ["1.00 (0.67 ... 1.50)", "-"]
    assert "above 1 where two is faster" in placement_tables(tasks, "two")


def test_the_ratio_is_that_of_median_times(tmp_path):
    runs = [line("fast", "cup", n, (0.1, 0.0), (1.0, 1.0)) for n in (1, 2, 3)]
    runs += [line("slow", "cup", n, (4.0, 1.0)) for n in (1, 2, 3)]
    table = rows(placement_tables(placement_tasks(read_records(folder_of(tmp_path, runs))), None))
    assert table["slow"][6] == "4.00 (4.00 ... 4.00)"
    assert table["slow"][1] == "0.600 (0.600 ... 0.600)"


def scene_rows(text: str) -> list[list[str]]:
    cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in text.splitlines() if row.startswith("| ")]
    return cells[1:]


def nearly_best(folder: Path, runs: list[dict], against: str | None = None) -> list[list[str]]:
    return scene_rows(nearly_best_table(placement_tasks(read_records(folder_of(folder, runs))), against))


def test_times_to_nearly_the_best_are_those_of_a_scene(tmp_path):
    # Objects and objectives are taken together; what only comes near to the best, or is none, counts as longer.
    runs = [line("ours", name, n, (0.5, 0.0), (2.0, 1.0)) for name in ("cup", "box") for n in (1, 2)]
    runs += [line("ours", "cup", 1, (2.0, 1.0), objective="min_clearance")]
    runs += [line("as_printed", name, n, (0.5, 0.0), (8.0, 0.96)) for name in ("cup", "box") for n in (1, 2)]
    runs += [line("as_printed", "cup", 1, (0.5, 0.0), (8.0, 0.96), objective="min_clearance")]
    runs += [line("never", "cup", 1, (0.1, 0.94)), line("never", "box", 1)]
    assert nearly_best(tmp_path, runs) == [
        ["panda_shelf", "ours", "5 of 5", "2 (2 ... 2)", "4.00 (4.00 ... 4.00)"],
        ["panda_shelf", "as_printed", "5 of 5", "8 (8 ... 8)", "-"],
        ["panda_shelf", "never", "0 of 2", "> 10 (10 ... 10)", "< 0.80 (0.80 ... 0.80)"],
    ]
    assert nearly_best(tmp_path, runs, "ours")[1][4] == "0.25 (0.25 ... 0.25)"


def test_a_time_beyond_the_limit_bounds_the_ratio(tmp_path):
    runs = [line("ours", "cup", 1, (2.0, 1.0)), line("as_printed", "cup", 1, (1.0, 0.0)), line("none", "cup", 1)]
    table = nearly_best(tmp_path, runs)
    assert [row[4] for row in table] == ["> 5.00 (5.00 ... 5.00)", "-", "-"]
    assert [row[3] for row in table] == ["2 (2 ... 2)", "> 10 (10 ... 10)", "> 10 (10 ... 10)"]


def test_curves_are_means_with_standard_errors(tmp_path):
    (task,) = placement_tasks(read_records(folder_of(tmp_path, RUNS)))
    times = np.array([0.0, 1.9, 2.0, 4.5, 10.0])
    mean, error = curve(task.variants["two"], times)
    assert mean == pytest.approx([0.0, 0.0, 0.25, 0.25, 0.75])
    assert error == pytest.approx([0.0, 0.0, 0.25, 0.25, 0.25])


def test_a_run_without_placement_counts_as_nothing(tmp_path):
    tasks = placement_tasks(read_records(folder_of(tmp_path, [*RUNS, line("one", "cup", 2)])))
    table = rows(placement_tables(tasks, None))
    assert table["one"][1].startswith("0.500 ")
    assert table["one"][3] == "2" and table["one"][5] == "2 of 3"


def test_processor_time_may_be_the_measure(script, refuses, tmp_path):
    folder_of(tmp_path, RUNS)
    out = tmp_path / "out"
    assert script("placement_plots.py", tmp_path, "-o", out, "--processor-s", 5).returncode == 0
    table = rows((out / "placements.md").read_text())
    assert table["one"][1].startswith("0.750 ") and table["one"][3] == "0.75"
    refuses("used less", "placement_plots.py", tmp_path, "-o", out, "--processor-s", 5.5)
    refuses("--processor-s", "placement_plots.py", tmp_path, "-o", out, "--processor-s=-1")


def test_the_script_writes_table_and_picture(script, tmp_path):
    folder_of(tmp_path, RUNS)
    out = tmp_path / "out"
    result = script("placement_plots.py", tmp_path, "-o", out, "--reference", "two")
    assert result.returncode == 0, result.stderr
    assert result.stdout.split() == [str(out / "placements.md"), str(out / "placements.png")]
    assert (out / "placements.png").stat().st_size > 10_000
    assert "## Time to 95% of the best" in (out / "placements.md").read_text()


def test_what_cannot_be_compared_is_refused(refuses, tmp_path):
    out = tmp_path / "out"
    refuses("runs.jsonl", "placement_plots.py", tmp_path, "-o", out)
    other = RUNS[1] | {"time_limit_s": 5.0}
    refuses("different time limits", "placement_plots.py", folder_of(tmp_path, [RUNS[0], other]), "-o", out)
    path = {key: value for key, value in RUNS[0].items() if key != "placement"}
    refuses("no run on a placement scene", "placement_plots.py", folder_of(tmp_path, [path]), "-o", out)
    refuses("'three'", "placement_plots.py", folder_of(tmp_path, RUNS), "-o", out, "--reference", "three")
    refuses("--against", "placement_plots.py", folder_of(tmp_path, RUNS), "-o", out, "--against", "three")
    broken = json.loads(json.dumps(RUNS[0]))
    broken["placement"]["improvements"][0]["objective_m"] = "far"
    refuses("runs.jsonl", "placement_plots.py", folder_of(tmp_path, [broken]), "-o", out)
    assert not out.exists()
