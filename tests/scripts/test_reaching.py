# SPDX-License-Identifier: BSD-3-Clause
"""Promises of reaching scenes in scripts: rates over all runs of a group of scenes, lengths of verified paths alone;
scenes and results can be drawn."""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

from b4p_files.motion import motion_title, replay, rest
from b4p_files.reaching import reaching_tables
from b4p_files.records import read_records
from b4p_files.result import read_result
from b4p_files.scene import find_scene, read_scene

SCENE = ROOT / "experiments" / "scenes" / "table" / "above_1.yaml"


def line(scene: str, number: int, time_s: float | None, verified: bool = True) -> dict:
    length = "nan" if time_s is None else "1.25"
    return {
        "schema": 1,
        "scene": scene,
        "label": "ik_rrt",
        "run": number,
        "planner": "ik-rrt",
        "threads": 1,
        "time_limit_s": 1.0,
        "check_limit": None,
        "solved": time_s is not None,
        "verified": time_s is not None and verified,
        "crashed": False,
        "time_s": time_s or 1.0,
        "cpu_s": 0.5,
        "checks": 10,
        "build": {"commit": "abc"},
        "ompl": {"columns": {"tcp path length REAL": length, "solution length REAL": length}},
    }


@pytest.fixture
def folder(tmp_path) -> Path:
    runs = [
        line("table_above_1", 1, 0.1),
        line("table_above_1", 2, 0.2),
        line("table_above_2", 1, 0.3),
        line("table_above_2", 2, None),
        line("table_under_1", 1, None),
        line("table_under_1", 2, 0.4, verified=False),
    ]
    (tmp_path / "runs.jsonl").write_text("".join(json.dumps(run) + "\n" for run in runs))
    return tmp_path


def test_scenes_of_one_name_are_one_group_and_every_run_counts(folder):
    above, under = reaching_tables(read_records(folder)).split("## ")[1:]
    assert above.startswith("table_above: table_above_1, table_above_2")
    assert "| ik_rrt | 3 of 4 | 0.750 (0.301 ... 0.954) | 0.25 (0.175 ... > 1) |" in above
    assert "| 1.25 (1.25 ... 1.25) | 1.25 (1.25 ... 1.25) |" in above
    assert "| ik_rrt | 0 of 2 | 0.000 (0.000 ... 0.658) | > 1 (> 1 ... > 1) | - | - |" in under


def test_the_script_writes_table_and_picture(script, folder, tmp_path):
    out = tmp_path / "out"
    result = script("reaching.py", folder, "-o", out)
    assert result.returncode == 0, result.stderr
    assert result.stdout.split() == [str(out / "reaching.md"), str(out / "reaching.png")]
    assert (out / "reaching.png").stat().st_size > 10_000


def test_a_folder_without_runs_is_refused(refuses, tmp_path):
    refuses("runs.jsonl", "reaching.py", tmp_path, "-o", tmp_path / "out")


def test_processor_time_may_be_the_measure(script, refuses, tmp_path):
    runs = [line("table_above_1", number, 0.9) | {"cpu_s": cpu_s} for number, cpu_s in ((1, 0.2), (2, 0.4), (3, 0.6))]
    (tmp_path / "runs.jsonl").write_text("".join(json.dumps(run) + "\n" for run in runs))
    out = tmp_path / "out"
    assert script("reaching.py", tmp_path, "-o", out, "--processor-s", 0.5).returncode == 0
    assert "| ik_rrt | 2 of 3 | 0.667 (0.208 ... 0.939) | 0.4 (0.3 ... > 0.5) |" in (out / "reaching.md").read_text()
    for bad in (0, -1, "nan"):
        refuses("--processor-s", "reaching.py", tmp_path, "-o", out, f"--processor-s={bad}")
    unfinished = line("table_above_1", 4, None) | {"cpu_s": 0.45}
    with (tmp_path / "runs.jsonl").open("a") as file:
        file.write(json.dumps(unfinished) + "\n")
    assert script("reaching.py", tmp_path, "-o", out, "--processor-s", 0.5).returncode == 0
    text = (out / "reaching.md").read_text()
    assert "| 2 of 4 |" in text and "ik_rrt: 1 runs ended before this limit" in text


def test_names_may_have_folders():
    assert find_scene("table/above_1", Path("elsewhere")) == SCENE
    assert find_scene("./table/above_1", Path("elsewhere")) == Path("elsewhere/table/above_1")


def test_the_robot_rests_at_the_start_with_an_open_hand():
    scene = read_scene(SCENE)
    motion = rest(scene)
    fingers = [motion.links[f"panda_{side}finger"][0][:3, 3] for side in ("left", "right")]
    assert np.linalg.norm(fingers[0] - fingers[1]) == pytest.approx(scene.robot.max_opening_m)
    assert motion_title(scene, None) == "table_above_1: panda and 1 grasp"
    assert scene.goals[0].shape.radius == 0.05


def test_poses_of_grasps_are_in_the_frame_of_the_robots_root(tmp_path):
    text = SCENE.read_text().replace("positions_m: [[0.7, 0, 0.6]]", "grasps: {file: poses.csv}")
    (tmp_path / "scene.yaml").write_text(text)
    (tmp_path / "poses.csv").write_text("1,0,0,0.5,0,1,0,0,0,0,1,0.25,0,0,0,1\n")
    (goal,) = read_scene(tmp_path / "scene.yaml").goals
    end = goal.X_BS @ [0, 0, goal.shape.size[2] / 2, 1]
    assert np.allclose(end, [0.5, 0, 0.26, 1])  # the base stands at 0.01


@pytest.mark.parametrize("name", ["view.py", "draw.py"])
def test_a_result_is_drawn(script, tmp_path, name):
    scene = read_scene(SCENE)
    path = np.array([scene.q_start, scene.q_start + 0.1])
    X_WT = scene.robot.tcp_poses(path, scene.X_WB)[-1]
    result = {
        "schema": 1,
        "scene": "table/above_1",
        "planner": "ik-rrt",
        "seed": 1,
        "threads": 1,
        "planning_time_s": 0.1,
        "status": "Exact solution",
        "solved": True,
        "grasp_id": 0,
        "X_WT_reached": {"position_m": X_WT[:3, 3].tolist(), "rotation": X_WT[:3, :3].tolist()},
        "joint_names": scene.robot.joint_names,
        "path": path.tolist(),
        "verification": {"passed": True},
    }
    file = tmp_path / "result.json"
    file.write_text(json.dumps(result))
    moved = replay(scene, read_result(file), 3)
    assert np.allclose(moved.tcp[-1], X_WT)
    out = tmp_path / ("out.html" if name == "view.py" else "out.png")
    drawn = script(name, file, "-o", out)
    assert drawn.returncode == 0, drawn.stderr
    assert out.stat().st_size > 10_000
