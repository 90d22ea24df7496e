# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/scaling_scenes.py (scenes that differ in the amount alone) and scripts/scaling.py (quartiles of
processor time by amount)."""

import json
from math import hypot, inf
from pathlib import Path

import numpy as np
import pytest
import yaml
from matplotlib.image import imread

from b4p_files.records import read_records
from b4p_files.scaling import benchmark_times, curves, markdown, nearest_costs, step_costs
from b4p_files.scaling_scenes import offered, with_boxes

POSE = {"position_m": [0.1, 0.2, 0.3], "rotation": [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]}
SCENE = {
    "schema": 1,
    "name": "grocery_7",
    "obstacles": [
        {"name": "floor", "box": {"size_m": [2.0, 2.0, 0.05]}, "position_m": [0.0, 0.0, -0.1]},
        {"name": "turned", "box": {"size_m": [1.0, 1.0, 1.0]}, "position_m": [0, 0, 5], "rpy_rad": [0, 0, 1]},
        {"name": "post", "cylinder": {"radius_m": 0.03, "length_m": 0.3}, "position_m": [0.4, 0.0, 0.1]},
    ],
    "grasps": {"box": {"size_m": [0.1, 0.06, 0.08], "finger_depth_m": 0.02, "pad_clearance_m": 0.002}},
}


@pytest.fixture
def instance(tmp_path: Path) -> Path:
    (tmp_path / "grocery_7.yaml").write_text(yaml.safe_dump(SCENE))
    grasps = [{"X_OT": {**POSE, "position_m": [float(i), 0.0, 0.0]}, "opening_m": 0.05} for i in range(100)]
    (tmp_path / "q.jsonl").write_text(json.dumps({"grasps": grasps}) + "\n")
    (tmp_path / "r.json").write_text(
        json.dumps({"solved": True, "grasp": {"X_OT": POSE, "opening_m": 0.064}})
    )
    return tmp_path


def write_scenes(script, folder: Path, *more: object):
    files = ("--queries", folder / "q.jsonl", "--result", folder / "r.json", "--instance", 7)
    return script("scaling_scenes.py", folder / "grocery_7.yaml", *files, "-o", folder / "out", *more)


def test_lists_of_grasps_are_nested_and_hold_the_one_that_works(script, instance):
    result = write_scenes(script, instance, "--most", 100)
    assert result.returncode == 0, result.stderr
    lists = []
    for amount in (1, 10, 100):
        scene = yaml.safe_load((instance / "out" / f"grasps_grocery_7_{amount}.yaml").read_text())
        rows = np.loadtxt(instance / "out" / scene["grasps"]["file"], delimiter=",", ndmin=2)
        assert rows.shape == (amount, 17)
        lists.append({tuple(row) for row in rows})
        assert scene["obstacles"] == SCENE["obstacles"]
    assert lists[0] < lists[1] < lists[2]
    (works,) = lists[0]
    assert works == (0, -1, 0, 0.1, 1, 0, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1, 0.064)


def test_obstacles_are_added_to_the_amount_and_change_nothing_else(script, instance):
    result = write_scenes(script, instance, "--most", 100)
    names = [Path(line).stem for line in result.stdout.splitlines()]
    for series, own in (("grocery", 3), ("open", 1)):
        for where in ("far", "near"):
            amounts = [
                int(name.split("_")[-1]) for name in names if name.startswith(f"obstacles_{series}_{where}")
            ]
            assert amounts == [amount for amount in sorted({own, 10, 100, *([1] if own == 1 else [])})]
            scene = yaml.safe_load((instance / "out" / f"obstacles_{series}_{where}_7_100.yaml").read_text())
            assert len({one["name"] for one in scene["obstacles"]}) == len(scene["obstacles"]) == 100
            assert scene["obstacles"][:own] == SCENE["obstacles"][:own]
            assert scene["grasps"] == SCENE["grasps"]


def test_near_boxes_lie_inside_upright_boxes_of_the_scene():
    scene = with_boxes(SCENE, "s", 500, "near", 3)
    floor = SCENE["obstacles"][0]
    for one in scene["obstacles"][3:]:
        for axis in range(3):
            outside = (
                abs(one["position_m"][axis] - floor["position_m"][axis]) + one["box"]["size_m"][axis] / 2
            )
            assert outside <= floor["box"]["size_m"][axis] / 2
            assert one["box"]["size_m"][axis] > 0


def test_far_boxes_are_out_of_reach():
    scene = with_boxes(SCENE, "s", 500, "far", 3)
    for one in scene["obstacles"][3:]:
        assert hypot(*one["position_m"][:2]) - hypot(*one["box"]["size_m"]) > 1.5


def test_too_few_grasps_and_unsolved_results_are_refused(script, refuses, instance):
    with pytest.raises(ValueError, match="too few"):
        offered([0.0], [[1.0]], 3, 1)
    (instance / "r.json").write_text(json.dumps({"solved": False}))
    result = write_scenes(script, instance)
    assert result.returncode == 2 and result.stderr.count("\n") == 1
    assert "has no path" in result.stderr


def run_line(scene: str, number: int, cpu_s: float | None) -> dict:
    solved = cpu_s is not None
    return {
        "schema": 1,
        "scene": scene,
        "label": "b4p",
        "run": number,
        "planner": "b4p",
        "threads": 1,
        "time_limit_s": 10.0,
        "check_limit": None,
        "solved": solved,
        "verified": solved,
        "crashed": False,
        "time_s": 9.0,
        "cpu_s": cpu_s or 9.0,
        "checks": 10,
        "build": {"commit": "abc"},
    }


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    runs = tmp_path / "runs"
    runs.mkdir()
    lines = [
        run_line(f"grasps_grocery_{seed}_10", 1, cpu_s) for seed, cpu_s in ((7, 0.1), (8, 0.2), (9, 0.3))
    ]
    lines += [
        run_line(f"grasps_grocery_{seed}_1", 1, cpu_s) for seed, cpu_s in ((7, None), (8, None), (9, 0.3))
    ]
    lines += [run_line("obstacles_open_near_7_1000", number, 0.02) for number in (1, 2)]
    (runs / "runs.jsonl").write_text("".join(json.dumps(one) + "\n" for one in lines))
    return runs


def benchmark_file(file: Path) -> Path:
    entries = [
        {"run_name": name, "run_type": "iteration", "cpu_time": time, "time_unit": unit}
        for name, time, unit in (
            ("query/tree/7/1000/512", 500.0, "ns"),
            ("query/tree/7/10/128", 0.08, "us"),
            ("query/tree/7/1000/128", 900.0, "ns"),
            ("query/tree/7/1000/0", 8000.0, "ns"),
            ("query/tree/3/1000/512", 200.0, "ns"),
            ("query/uniform/7/1000/512", 200.0, "ns"),
            ("maze/step/1000", 20000.0, "ns"),
            ("maze/pick", 3.0, "ms"),
        )
    ]
    file.write_text(json.dumps({"benchmarks": entries}))
    return file


def test_instances_are_taken_together_and_failures_are_beyond_the_limit(folder):
    found = curves(read_records(folder))
    one, ten = found["grasps"]["grocery"]
    assert (one.amount, one.runs, one.solved) == (1, 3, 1) and one.quartiles_s[1] == inf
    assert ten.amount == 10 and ten.quartiles_s == pytest.approx((0.15, 0.2, 0.25))
    assert list(found["obstacles"]) == ["open, near"]


def test_times_of_benchmarks_are_read_in_their_units(tmp_path):
    times = benchmark_times(benchmark_file(tmp_path / "b.json"))
    nearest = nearest_costs(times)
    assert [(cost.nodes, cost.time_s) for cost in nearest["nearest node"]] == [
        (10, pytest.approx(8e-8)),
        (1000, pytest.approx(5e-7)),
    ]
    assert [cost.time_s for cost in nearest["nearest node, OMPL's GNAT"]] == [pytest.approx(8e-6)]
    assert {name: costs[0].nodes for name, costs in step_costs(times).items()} == {"a step, maze": 1000}


def test_a_table_has_a_column_for_each_amount(folder, tmp_path):
    costs = nearest_costs(benchmark_times(benchmark_file(tmp_path / "b.json")))
    lines = markdown(curves(read_records(folder)), costs).splitlines()
    assert lines[0] == "| grasps offered | 1 | 10 |"
    assert lines[2] == "| grocery | - (- ... -), 1 of 3 solved | 200 (150 ... 250) |"
    assert "| open, near | 20 (20 ... 20) |" in lines
    assert "| nearest node | 0.08 | 0.5 |" in lines


def test_the_plot_has_a_panel_for_each_kind_of_work(script, folder, tmp_path):
    header = {"schema": 1, "scene": "grocery", "planner": "b4p", "parameters": {}, "time_limit_s": 10.0}
    run = {"kind": "virtual time", "seed": 1, "solved": True, "verified": True, "work_s": 1.0, "steps": 5}
    lines = [header, *({**run, "workers": workers, "time_s": 1 / workers} for workers in (1, 2))]
    (tmp_path / "w.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    benchmark = benchmark_file(tmp_path / "b.json")
    out = tmp_path / "out"
    result = script("scaling.py", folder, "--speedup", tmp_path / "w.jsonl", "--nodes", benchmark, "-o", out)
    assert result.returncode == 0, result.stderr
    assert imread(out / "scaling.png").std() > 0.05
    assert "| virtual time | 2 | 1 of 1 |" in (out / "scaling.md").read_text()


def test_what_cannot_be_read_is_refused(refuses, folder, tmp_path):
    refuses("runs.jsonl", "scaling.py", tmp_path, "-o", tmp_path / "out")
    (tmp_path / "b.json").write_text("[]")
    refuses("b.json", "scaling.py", folder, "--nodes", tmp_path / "b.json", "-o", tmp_path / "out")
    assert not (tmp_path / "out").exists()
