# SPDX-License-Identifier: BSD-3-Clause
"""Files that `b4p surfaces --out` writes: where an object can be put down in a placement scene, and on which faces."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from b4p_files.errors import FileError, reading

SCHEMA = 1


@dataclass
class Region:
    height_m: float
    cells_m: np.ndarray  # centres, n x 2


@dataclass
class Surfaces:
    scene: str
    object_name: str
    min_m: np.ndarray
    max_m: np.ndarray
    cell_m: float
    obstacles: dict[str, np.ndarray]  # points whose hull each is
    shapes: list[np.ndarray]  # of the object, in its frame
    regions: list[Region]
    faces: list[np.ndarray]  # corners, in the object's frame


def read_surfaces(file: Path) -> Surfaces:
    with reading(file, "surfaces file"):
        document = json.loads(file.read_text())
        if document["schema"] != SCHEMA:
            raise FileError(file, f"schema: {document['schema']} is not {SCHEMA}")
        return Surfaces(
            scene=document["scene"],
            object_name=document["object"],
            min_m=np.array(document["volume"]["min_m"]),
            max_m=np.array(document["volume"]["max_m"]),
            cell_m=document["cell_m"],
            obstacles={one["name"]: np.array(one["points_m"]) for one in document["obstacles"]},
            shapes=[np.array(points) for points in document["shapes"]],
            regions=[Region(one["height_m"], np.array(one["cells_m"])) for one in document["regions"]],
            faces=[np.array(corners) for corners in document["faces"]],
        )
