# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/placement_scenes.py and scripts/placement_regions.py: the placement scenes that ship are what
the script writes; surfaces files become one picture; bad input becomes one line."""

import json

import numpy as np
import pytest
from conftest import ROOT
from matplotlib.image import imread

SHIPPED = ROOT / "experiments" / "scenes" / "placement"


def test_the_scenes_that_ship_are_those_the_script_writes(script, tmp_path):
    result = script("placement_scenes.py", "--out", tmp_path / "made")
    assert result.returncode == 0, result.stderr
    made = {file.name: file.read_text() for file in (tmp_path / "made").iterdir()}
    assert made == {file.name: file.read_text() for file in SHIPPED.glob("*.yaml")}


def cube(low, high):
    return [[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]


def surfaces():
    cells = [[0.0025 + 0.005 * i, 0.0025 + 0.005 * j] for i in range(20) for j in range(10)]
    return {
        "schema": 1,
        "scene": "slab",
        "object": "cube",
        "volume": {"min_m": [-0.05, -0.05, 0], "max_m": [0.15, 0.1, 0.1]},
        "cell_m": 0.005,
        "obstacles": [{"name": "slab", "points_m": cube((0, 0, 0), (0.1, 0.05, 0.01))}],
        "shapes": [cube((-0.02, -0.02, -0.02), (0.02, 0.02, 0.02))],
        "regions": [{"height_m": 0.0125, "cells_m": cells}],
        "faces": [[[-0.02, -0.02, -0.02], [-0.02, 0.02, -0.02], [0.02, 0.02, -0.02], [0.02, -0.02, -0.02]]],
    }


def write(file, document):
    file.write_text(json.dumps(document))
    return file


def test_each_file_has_a_column_with_coloured_regions_and_faces(script, tmp_path):
    file = write(tmp_path / "slab.json", surfaces())
    png = tmp_path / "out.png"
    result = script("placement_regions.py", file, file, "-o", png)
    assert result.returncode == 0, result.stderr
    assert result.stdout == f"{png}\n"
    picture = imread(png)[:, :, :3]
    for column in np.array_split(picture, 2, axis=1):
        for part in np.array_split(column, [int(0.57 * len(column))], axis=0):
            blue = (part[:, :, 2] - part[:, :, 0] > 0.25).mean()  # the first colour of the palette
            assert blue > 0.005


@pytest.mark.parametrize(
    "change, expected",
    [
        (lambda d: d.pop("regions"), "'regions' is missing"),
        (lambda d: d.update(schema=7), "schema: 7 is not 1"),
        (lambda d: d.update(volume=3), "not a surfaces file"),
    ],
)
def test_a_malformed_file_is_refused_in_one_line(refuses, tmp_path, change, expected):
    document = surfaces()
    change(document)
    file = write(tmp_path / "bad.json", document)
    refuses(f"{file}: ", "placement_regions.py", file, "-o", tmp_path / "out.png")
    refuses(expected, "placement_regions.py", file, "-o", tmp_path / "out.png")
    assert not (tmp_path / "out.png").exists()
