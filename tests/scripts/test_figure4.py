# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/figure4.py: scenes and sampled grasps become one picture; bad input becomes one line."""

import json

import numpy as np
import pytest
from conftest import ROOT
from matplotlib.image import imread
from scene_fixtures import planar_task, spatial_task

from b4p_files.picks import read_picks
from b4p_files.robot import read_robot


@pytest.fixture
def png(tmp_path):
    return tmp_path / "pictures" / "out.png"


def make(folder, task):
    folder.mkdir()
    return task(folder).folder / "forests.json"


def test_each_scene_has_a_column(script, tmp_path, png):
    files = make(tmp_path / "one", planar_task), make(tmp_path / "two", spatial_task)
    result = script("figure4.py", *files, "-o", png)
    assert result.returncode == 0, result.stderr
    assert result.stdout == f"{png}\n"
    both = imread(png)[:, :, :3]
    for half in np.array_split(both, 2, axis=1):
        assert np.mean(half.min(axis=2) < 0.95) > 0.05


def test_the_roots_of_the_trees_are_the_picks_and_placements(tmp_path):
    task = planar_task(tmp_path)
    picks = read_picks(tmp_path / "forests.json")
    assert len(picks.grasps) == len(picks.placements) == 1
    x, y, _ = task.forests["nodes"][0]["q"]
    assert picks.grasps[0].tcp[0][:2, 3] == pytest.approx([x + 0.1, y])
    # The robot has gone from the pick's root to the place's without turning, and the object with it.
    moved = np.subtract(task.forests["nodes"][2]["q"], task.forests["nodes"][0]["q"])[:2]
    start = task.scene["object"]["start"]["position_m"][:2]
    assert picks.placements[0][:2, 3] == pytest.approx(start + moved)


def test_the_hand_is_what_the_last_joint_carries():
    assert set(read_robot(ROOT / "robots" / "panda.yaml").hand_links) == {
        "panda_hand",
        "panda_leftfinger",
        "panda_rightfinger",
    }
    assert read_robot(ROOT / "robots" / "planar_gripper.yaml").hand_links == ["gripper"]


BAD_FORESTS = {
    "no scene": ({"scene": "nowhere"}, "forests.json: scene: nowhere: "),
    "no pick": ({"nodes": []}, "forests.json: nodes: no pick is among them"),
    "no opening": ({"openings_m": {}}, "openings_m: grasp 0 is missing"),
    "no file": (None, "forests.json: No such file"),
}


@pytest.mark.parametrize("change, words", BAD_FORESTS.values(), ids=BAD_FORESTS.keys())
def test_bad_forests_are_refused_and_nothing_written(refuses, tmp_path, png, change, words):
    file = tmp_path / "forests.json"
    task = planar_task(tmp_path)
    file.unlink()
    if change is not None:
        file.write_text(json.dumps(task.forests | change))
    refuses(words, "figure4.py", file, "-o", png)
    assert not png.exists()
