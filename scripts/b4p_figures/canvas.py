# SPDX-License-Identifier: BSD-3-Clause
"""Solids and lines in space, rendered without a display."""

import os

import numpy as np
from manifold3d import Manifold, Mesh, OpType
from matplotlib.colors import to_rgb

# OSMesa needs neither a display nor a graphics card, and draws the same everywhere. VTK reads this once.
os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkOSOpenGLRenderWindow"

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the renderer)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkPolyLine, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SHARP_EDGE_DEG = 35.0
SMALLEST_EDGE_M = 5e-4  # slivers left by the union would show as cracks
TUBE_SIDES = 16
EDGE_PIXELS = 1.5
SUPERSAMPLING = 2  # the picture is rendered this much larger, then averaged
BEHIND = 1.0  # depth offset, in the renderer's units
PEELS = 12  # translucent layers told apart
CAMERA_DISTANCE = 2.2  # in diagonals of what is shown
FRAME = 1.04  # size of the picture over what it shows
ELEVATIONS = (0.42, 0.25, 0.7)  # height of the camera over its distance on the ground, best first
AZIMUTHS_DEG = (-60, -35, -85, -120, 60, 35, 85, 120, -10, 10, 150, -150)  # best first
KEY_LIGHT = 0.95
AMBIENT = 0.25  # share of light from nowhere
BACKGROUND = (1.0, 1.0, 1.0)


def union(solids: list[np.ndarray]) -> vtkPolyData:
    """The surface of the union of the convex hulls of sets of points: translucent solids show no seams."""
    body = Manifold.batch_boolean([Manifold.hull_points(points) for points in solids], OpType.Add)
    return _poly_data(body.simplify(SMALLEST_EDGE_M).to_mesh())


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


class Canvas:
    def __init__(self, pixels: tuple[float, float]) -> None:
        self._renderer = vtkRenderer()
        self._renderer.SetBackground(*BACKGROUND)
        self._renderer.SetUseDepthPeeling(True)
        self._renderer.SetMaximumNumberOfPeels(PEELS)
        self._renderer.SetOcclusionRatio(0.0)
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(True)
        self._window.SetAlphaBitPlanes(True)
        self._window.SetMultiSamples(0)
        self._window.SetSize(*(SUPERSAMPLING * round(side) for side in pixels))
        self._window.AddRenderer(self._renderer)
        self._screens: list[tuple[vtkStaticCellLocator, float]] = []
        self._ghosts = 0
        lights = vtkLightKit()
        lights.SetKeyLightIntensity(KEY_LIGHT)
        lights.AddLightsToRenderer(self._renderer)

    def add_solid(self, surface: vtkPolyData, color: str, opacity: float = 1.0) -> None:
        normals = vtkPolyDataNormals()
        normals.SetInputData(surface)
        normals.SetFeatureAngle(SHARP_EDGE_DEG)
        self._add(normals, color, opacity)

    def add_screen(self, surface: vtkPolyData, color: str, opacity: float) -> None:
        """A solid around which the camera tries to see."""
        self.add_solid(surface, color, opacity)
        screen = vtkStaticCellLocator()
        screen.SetDataSet(surface)
        screen.BuildLocator()
        self._screens.append((screen, opacity))

    def add_edges(self, surface: vtkPolyData, color: str) -> None:
        edges = vtkFeatureEdges()
        edges.SetInputData(surface)
        edges.SetFeatureAngle(SHARP_EDGE_DEG)
        edges.ColoringOff()
        actor = self._add(edges, color, 1.0)
        actor.GetProperty().SetLineWidth(EDGE_PIXELS * SUPERSAMPLING)
        actor.GetProperty().LightingOff()

    def add_tube(self, line: np.ndarray, radius_m: float, color: str) -> None:
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(line), deep=True))
        path = vtkPolyLine()
        path.GetPointIds().SetNumberOfIds(len(line))
        for index in range(len(line)):
            path.GetPointIds().SetId(index, index)
        data = vtkPolyData()
        data.SetPoints(points)
        data.Allocate(1)
        data.InsertNextCell(path.GetCellType(), path.GetPointIds())
        tube = vtkTubeFilter()
        tube.SetInputData(data)
        tube.SetRadius(radius_m)
        tube.SetNumberOfSides(TUBE_SIDES)
        tube.CappingOn()
        self._add(tube, color, 1.0)

    def _add(self, source: object, color: str, opacity: float) -> vtkActor:
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.ScalarVisibilityOff()
        if opacity < 1.0:  # falls behind earlier and opaque surfaces at the same place
            mapper.SetResolveCoincidentTopologyToPolygonOffset()
            self._ghosts += 1
            behind = BEHIND * self._ghosts
            mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(behind, behind)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*to_rgb(color))
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetAmbient(AMBIENT)
        self._renderer.AddActor(actor)
        return actor

    def render(self, inside: np.ndarray, wanted: np.ndarray) -> np.ndarray:
        """An RGB image with all points `inside` in it, from where screens dim the points `wanted` least."""
        low, high = inside.min(axis=0), inside.max(axis=0)
        centre, distance = (low + high) / 2, CAMERA_DISTANCE * np.linalg.norm(high - low)
        eyes = [centre + distance * direction for direction in _directions()]
        dimming = [sum(self._dimming(point, eye) for point in wanted) for eye in eyes]
        camera = self._renderer.GetActiveCamera()
        camera.SetViewUp(0, 0, 1)
        camera.SetPosition(*eyes[int(np.argmin(dimming))])
        camera.SetFocalPoint(*centre)
        self._fit(inside)
        self._renderer.ResetCameraClippingRange()
        self._window.Render()
        return self._image()

    def _fit(self, points: np.ndarray) -> None:
        """Aims and zooms so that the points fill the picture."""
        camera = self._renderer.GetActiveCamera()
        width, height = self._window.GetSize()
        X_CW = camera.GetModelViewTransformMatrix()
        in_camera = np.array([X_CW.MultiplyPoint((*point, 1.0))[:3] for point in points])
        slopes = in_camera[:, :2] / -in_camera[:, 2:]
        low, high = slopes.min(axis=0), slopes.max(axis=0)
        half = FRAME * max((high[1] - low[1]) / 2, (high[0] - low[0]) / 2 * height / width)
        camera.SetViewAngle(2 * np.degrees(np.arctan(half)))
        # The window centre shifts the picture without turning the camera, in halves of its size.
        middle = (low + high) / 2
        camera.SetWindowCenter(middle[0] / (half * width / height), middle[1] / half)

    def _dimming(self, point: np.ndarray, eye: np.ndarray) -> float:
        """Summed opacity of the screens between them."""
        return sum(
            opacity for screen, opacity in self._screens if screen.IntersectWithLine(eye, point, None, None)
        )

    def _image(self) -> np.ndarray:
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self._window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        output = grabber.GetOutput()
        width, height, _ = output.GetDimensions()
        pixels = vtk_to_numpy(output.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
        fine = pixels.reshape(
            height // SUPERSAMPLING, SUPERSAMPLING, width // SUPERSAMPLING, SUPERSAMPLING, 3
        )
        return fine.mean(axis=(1, 3)) / 255.0


def _directions() -> list[np.ndarray]:
    azimuths = np.radians(AZIMUTHS_DEG)
    return [np.array([np.cos(a), np.sin(a), elevation]) for elevation in ELEVATIONS for a in azimuths]
