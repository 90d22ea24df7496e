# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/draw.py: scenes and solutions become pictures; bad input becomes one line."""

import json

import numpy as np
import pytest
from conftest import ROOT
from matplotlib.colors import to_rgb
from matplotlib.image import imread
from scene_fixtures import planar_task, spatial_task

from b4p_figures.planar import GOAL, PICK_TREES, PLACE_TREES, START, WALL
from b4p_files.motion import resample
from b4p_files.robot import read_robot


def pixels(file, color, tolerance=0.02):
    """How many pixels of the picture, its legend included, have this colour."""
    return int(np.sum(np.all(np.abs(imread(file)[:, :, :3] - to_rgb(color)) < tolerance, axis=2)))


LEGEND_PIXELS = 700  # a patch of the legend has fewer


@pytest.fixture
def png(tmp_path):
    return tmp_path / "pictures" / "out.png"


def test_planar_solution_shows_object_at_pick_and_place_walls_and_forests(script, tmp_path, png):
    task = planar_task(tmp_path)
    plain = tmp_path / "plain.png"
    assert script("draw.py", task.folder / "result.json", "-o", plain).returncode == 0
    result = script(
        "draw.py", task.folder / "result.json", "--forests", task.folder / "forests.json", "-o", png
    )
    assert result.returncode == 0, result.stderr
    assert all(pixels(png, color) > LEGEND_PIXELS for color in (START, GOAL, WALL))
    for trees in (PICK_TREES, PLACE_TREES):
        assert pixels(png, trees) > pixels(plain, trees)


def test_planar_scene_alone_shows_no_goal(script, tmp_path, png):
    planar_task(tmp_path)
    assert script("draw.py", tmp_path / "scene.yaml", "-o", png).returncode == 0
    assert pixels(png, START) > LEGEND_PIXELS
    assert pixels(png, GOAL) == 0


def test_spatial_solution_is_rendered_without_a_display(script, tmp_path, png, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    spatial_task(tmp_path)
    assert script("draw.py", tmp_path / "scene.yaml", "-o", tmp_path / "scene.png").returncode == 0
    result = script("draw.py", tmp_path / "result.json", "-o", png)
    assert result.returncode == 0, result.stderr
    image, scene = imread(png), imread(tmp_path / "scene.png")
    for picture in (image, scene):
        assert np.mean(picture[:, :, :3].min(axis=2) < 0.95) > 0.1
    assert image.shape != scene.shape or not np.allclose(image, scene)


def test_an_unsolved_result_shows_the_scene(script, tmp_path, png):
    task = planar_task(tmp_path)
    task.result |= {"solved": False, "path": [], "joint_names": [], "status": "Timeout", "grasp_id": -1}
    task.write()
    assert script("draw.py", tmp_path / "result.json", "-o", png).returncode == 0
    assert pixels(png, GOAL) == 0


@pytest.mark.parametrize("name", ["maze", "grocery"])
def test_shipped_scenes_can_be_drawn_by_name(script, png, name):
    result = script("draw.py", name, "-o", png)
    assert result.returncode == 0, result.stderr
    assert imread(png).std() > 0.05


def test_forward_kinematics_match_the_published_pose_of_the_panda():
    robot = read_robot(ROOT / "robots" / "panda.yaml")
    q = np.array([[0, -0.785, 0, -2.356, 0, 1.571, 0.785]])
    (X_WT,) = robot.tcp_poses(q, np.eye(4))
    assert X_WT[:3, 3] == pytest.approx([0.30702, 0, 0.48687], abs=2e-4)
    assert not robot.is_planar
    assert read_robot(ROOT / "robots" / "planar_gripper.yaml").is_planar


def test_joints_that_are_not_planned_rest_where_the_robot_file_says():
    left = read_robot(ROOT / "robots" / "yumi_left.yaml")
    right = read_robot(ROOT / "robots" / "yumi_right.yaml")
    start = np.array([[0.69, -1.95, 0.0, 0.0, 0.0, 0.0, 0.0]])  # of the right arm, at which it rests for the left one
    resting = left.link_poses(np.zeros((1, 7)), 0.0, np.eye(4))["yumi_right_link6"]
    moved = right.link_poses(start, 0.0, np.eye(4))["yumi_right_link6"]
    np.testing.assert_allclose(resting, moved, atol=1e-12)


def test_resampling_keeps_both_ends_and_equal_distances():
    path = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 3.0]])
    points = resample(path, 5)
    assert points.tolist() == [[0, 0], [1, 0], [1, 1], [1, 2], [1, 3]]
    assert resample(path[:1], 3).tolist() == [[0, 0]] * 3


BAD_RESULTS = {
    "wrong schema": ({"schema": 2}, "schema: 2 is not 1"),
    "missing key": ({"grasp": None}, "not a result file"),
    "ragged path": ({"path": [[0, 0, 0], [1, 1]]}, "not a result file"),
    "not a number": ({"path": [[0, 0, "x"]]}, "not a result file"),
    "other joints": ({"joint_names": ["a", "b", "c"]}, "joint_names are not those of"),
    "unknown scene": ({"scene": "nowhere"}, "nowhere.yaml: No such file"),
}


@pytest.mark.parametrize("change, words", BAD_RESULTS.values(), ids=BAD_RESULTS.keys())
def test_a_bad_result_is_refused(refuses, tmp_path, png, change, words):
    task = planar_task(tmp_path)
    task.result |= change
    task.write()
    refuses(words, "draw.py", tmp_path / "result.json", "-o", png)
    assert not png.exists()


def test_a_result_cut_in_half_is_refused(refuses, tmp_path, png):
    planar_task(tmp_path)
    file = tmp_path / "result.json"
    file.write_text(file.read_text()[: file.stat().st_size // 2])
    refuses("result.json: not a result file", "draw.py", file, "-o", png)


BAD_SCENES = {
    "malformed": ("scene.yaml", "a: [", "scene.yaml: not a scene file"),
    "empty": ("scene.yaml", "", "scene.yaml: not a scene file"),
    "no robot file": ("robot.yaml", None, "robot.yaml: No such file"),
    "malformed robot": ("robot.urdf", "<robot>", "robot.urdf: not a URDF"),
    "unknown joint": ("robot.urdf", '<robot><link name="tcp"/></robot>', "is not in"),
}


@pytest.mark.parametrize("name, text, words", BAD_SCENES.values(), ids=BAD_SCENES.keys())
def test_a_bad_scene_is_refused(refuses, tmp_path, png, name, text, words):
    planar_task(tmp_path)
    (tmp_path / name).unlink()
    if text is not None:
        (tmp_path / name).write_text(text)
    refuses(words, "draw.py", tmp_path / "scene.yaml", "-o", png)


@pytest.mark.parametrize(
    "shape", [{"cone": {"radius_m": 1}}, {"box": {"size_m": [1, 1]}}, {"box": {"size": 1}}]
)
def test_a_bad_shape_is_refused(refuses, tmp_path, png, shape):
    task = planar_task(tmp_path)
    task.scene["obstacles"][0] = {"name": "wall", **shape}
    task.write()
    refuses("scene.yaml: ", "draw.py", tmp_path / "scene.yaml", "-o", png)


def test_forests_with_a_parent_that_is_not_there_are_refused(refuses, tmp_path, png):
    task = planar_task(tmp_path)
    task.forests["nodes"][1]["parent"] = 17
    task.write()
    arguments = tmp_path / "result.json", "--forests", tmp_path / "forests.json"
    refuses("forests.json: not a forest file", "draw.py", *arguments, "-o", png)


def test_missing_files_and_unwritable_places_are_refused(refuses, tmp_path, png):
    planar_task(tmp_path)
    refuses("none.json: No such file", "draw.py", tmp_path / "none.json", "-o", png)
    refuses("result.json: ", "draw.py", tmp_path / "result.json", "-o", tmp_path / "result.json" / "x.png")


def test_forests_without_a_node_are_drawn(script, tmp_path, png):
    task = planar_task(tmp_path)
    (tmp_path / "forests.json").write_text(json.dumps(task.forests | {"nodes": []}))
    result = script("draw.py", task.folder / "result.json", "--forests", tmp_path / "forests.json", "-o", png)
    assert result.returncode == 0, result.stderr
