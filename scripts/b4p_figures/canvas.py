# SPDX-License-Identifier: BSD-3-Clause
"""Solids and lines in space, rendered without a display."""

import os

import numpy as np
from matplotlib.colors import to_rgb

from b4p_figures.sight import CAMERA_DISTANCE, Directions, Screens
from b4p_figures.surfaces import edges_of, smooth

# OSMesa needs neither a display nor a graphics card, and draws the same everywhere. VTK reads this once.
os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkOSOpenGLRenderWindow"

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the renderer)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkPolyLine
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

TUBE_SIDES = 16
EDGE_PIXELS = 1.5
SUPERSAMPLING = 2  # the picture is rendered this much larger, then averaged
BEHIND = 1.0  # depth offset, in the renderer's units
PEELS = 12  # translucent layers told apart
FRAME = 1.04  # size of the picture over what it shows
KEY_LIGHT = 0.95
AMBIENT = 0.25  # share of light from nowhere
BACKGROUND = (1.0, 1.0, 1.0)


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
        self._screens = Screens()
        self._ghosts = 0
        lights = vtkLightKit()
        lights.SetKeyLightIntensity(KEY_LIGHT)
        lights.AddLightsToRenderer(self._renderer)

    def add_solid(self, surface: vtkPolyData, color: str, opacity: float = 1.0) -> None:
        self._add(smooth(surface), color, opacity)

    def add_screen(self, surface: vtkPolyData, color: str, opacity: float) -> None:
        """A solid around which the camera tries to see."""
        self.add_solid(surface, color, opacity)
        self._screens.add(surface, opacity)

    def add_edges(self, surface: vtkPolyData, color: str) -> None:
        actor = self._add(edges_of(surface), color, 1.0)
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

    def render(self, inside: np.ndarray, wanted: np.ndarray, directions: Directions) -> np.ndarray:
        """An RGB image with all points `inside` in it, from where screens dim the points `wanted` least."""
        low, high = inside.min(axis=0), inside.max(axis=0)
        centre, distance = (low + high) / 2, CAMERA_DISTANCE * np.linalg.norm(high - low)
        direction = self._screens.clearest(directions, centre, distance, wanted)
        camera = self._renderer.GetActiveCamera()
        camera.SetViewUp(0, 0, 1)
        camera.SetPosition(*(centre + distance * direction))
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
