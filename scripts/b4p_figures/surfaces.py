# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of solids, as VTK's data and as plain arrays."""

import numpy as np
from manifold3d import Manifold, Mesh, OpType
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals

SHARP_EDGE_DEG = 35.0
SMALLEST_EDGE_M = 5e-4  # slivers left by the union would show as cracks


def union(solids: list[np.ndarray]) -> vtkPolyData:
    """The surface of the union of the convex hulls of sets of points: translucent solids show no seams."""
    body = Manifold.batch_boolean([Manifold.hull_points(points) for points in solids], OpType.Add)
    return _poly_data(body.simplify(SMALLEST_EDGE_M).to_mesh())


def smooth(surface: vtkPolyData) -> vtkPolyDataNormals:
    """With normals; points on sharp edges are there once for each side, so that these stay sharp."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SetFeatureAngle(SHARP_EDGE_DEG)
    return normals


def edges_of(surface: vtkPolyData) -> vtkFeatureEdges:
    """The sharp edges."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.SetFeatureAngle(SHARP_EDGE_DEG)
    edges.ColoringOff()
    return edges


def triangles(surface: vtkPolyData, inset_m: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Points and, as indices of these, the corners of triangles; both one a row, with sharp edges. The points lie
    this far inside the surface."""
    normals = smooth(surface)
    normals.Update()
    data = normals.GetOutput()
    points, corners = _arrays(data, data.GetPolys(), 3)
    if inset_m and len(points):
        points -= inset_m * vtk_to_numpy(data.GetPointData().GetNormals())
    return points, corners


def segments(surface: vtkPolyData) -> np.ndarray:
    """The sharp edges: segments x 2 ends x 3 coordinates."""
    edges = edges_of(surface)
    edges.Update()
    points, ends = _arrays(edges.GetOutput(), edges.GetOutput().GetLines(), 2)
    return points[ends]


def _arrays(data: vtkPolyData, cells: vtkCellArray, corners: int) -> tuple[np.ndarray, np.ndarray]:
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3)), np.zeros((0, corners), int)
    indices = vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, corners)
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float), indices


def _poly_data(mesh: Mesh) -> vtkPolyData:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.vert_properties[:, :3], float), deep=True))
    corners = np.asarray(mesh.tri_verts, np.int64)
    cells = vtkCellArray()
    cells.ImportLegacyFormat(
        numpy_to_vtkIdTypeArray(np.column_stack([np.full(len(corners), 3), corners]).ravel(), deep=True)
    )
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data
