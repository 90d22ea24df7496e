# SPDX-License-Identifier: BSD-3-Clause
"""Convex solids, in metres, each in a frame of its own with the axis of round ones along z."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from b4p_files.poses import Pose, pose_from, vector

SEGMENTS = 48  # of a circle


@dataclass
class Box:
    size: np.ndarray

    def points(self) -> np.ndarray:
        return np.array(np.meshgrid(*[(-0.5, 0.5)] * 3)).reshape(3, -1).T * self.size


@dataclass
class Capsule:
    """Also a sphere, at length 0."""

    radius: float
    length: float  # between the centres of the two end spheres

    def points(self) -> np.ndarray:
        height = np.linspace(-1, 1, SEGMENTS // 2 + 1)
        rings = [_ring(self.radius * np.sqrt(1 - h * h), self.radius * h) for h in height]
        ends = [np.concatenate(rings) + (0, 0, side * self.length / 2) for side in (-1, 1)]
        return np.concatenate(ends)


@dataclass
class Cylinder:
    radius: float
    length: float

    def points(self) -> np.ndarray:
        return np.concatenate([_ring(self.radius, side * self.length / 2) for side in (-1, 1)])


@dataclass
class Prism:
    polygon: np.ndarray
    height: float

    def points(self) -> np.ndarray:
        z = np.ones((len(self.polygon), 1)) * self.height / 2
        return np.concatenate([np.hstack([self.polygon, side * z]) for side in (-1, 1)])


@dataclass
class Cloud:
    """Stands for the convex hull of its points."""

    cloud: np.ndarray

    def points(self) -> np.ndarray:
        return self.cloud


Shape = Box | Capsule | Cylinder | Prism | Cloud


@dataclass
class PlacedShape:
    shape: Shape
    X_BS: Pose  # in the frame of the body it belongs to


def _ring(radius: float, z: float) -> np.ndarray:
    angle = np.linspace(0, 2 * np.pi, SEGMENTS, endpoint=False)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(SEGMENTS, z)])


def read_mesh(file: Path, scale: Sequence[float]) -> Cloud:
    # VTK takes a second to load and only scenes with mesh files need it here.
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader

    readers = {".stl": vtkSTLReader, ".obj": vtkOBJReader}
    if file.suffix.lower() not in readers:
        raise ValueError(f"mesh {file.name}: only STL and OBJ can be drawn")
    if not file.is_file():
        raise ValueError(f"no such mesh file: {file}")
    reader = readers[file.suffix.lower()]()
    reader.SetFileName(str(file))
    reader.Update()
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
    return Cloud(points * vector(scale))


def shape_from(mapping: Mapping[str, Any], folder: Path) -> PlacedShape:
    """The shape of one item of a scene file, mesh files being relative to `folder`."""
    return PlacedShape(_bare_shape(mapping, folder), pose_from(mapping))


def _bare_shape(mapping: Mapping[str, Any], folder: Path) -> Shape:
    if box := mapping.get("box"):
        return Box(vector(box["size_m"]))
    if sphere := mapping.get("sphere"):
        return Capsule(float(sphere["radius_m"]), 0.0)
    if capsule := mapping.get("capsule"):
        return Capsule(float(capsule["radius_m"]), float(capsule["length_m"]))
    if cylinder := mapping.get("cylinder"):
        return Cylinder(float(cylinder["radius_m"]), float(cylinder["length_m"]))
    if prism := mapping.get("prism"):
        return Prism(np.array(prism["polygon_m"], float).reshape(-1, 2), float(prism["height_m"]))
    if mesh := mapping.get("mesh"):
        return read_mesh(folder / mesh["file"], mesh.get("scale", (1, 1, 1)))
    raise ValueError(f"no known shape among {', '.join(mapping)}")
