# SPDX-License-Identifier: BSD-3-Clause
"""From where to look at a scene."""

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator

ELEVATIONS = (0.42, 0.25, 0.7)  # height of the camera over its distance on the ground, best first
AZIMUTHS_DEG = (-60, -35, -85, -120, 60, 35, 85, 120, -10, 10, 150, -150)  # best first
CAMERA_DISTANCE = 2.2  # in diagonals of what is shown
FROM_ABOVE = (np.array([0.0, -0.45, 1.0]),)  # at what lies in the plane, y away from the camera

Directions = Sequence[np.ndarray]  # from what is looked at to the camera, of any length


def around() -> Directions:
    azimuths = np.radians(AZIMUTHS_DEG)
    return [np.array([np.cos(a), np.sin(a), elevation]) for elevation in ELEVATIONS for a in azimuths]


class Screens:
    """Surfaces around which a camera tries to see."""

    def __init__(self) -> None:
        self._screens: list[tuple[vtkStaticCellLocator, float]] = []

    def add(self, surface: vtkPolyData, opacity: float) -> None:
        screen = vtkStaticCellLocator()
        screen.SetDataSet(surface)
        screen.BuildLocator()
        self._screens.append((screen, opacity))

    def clearest(
        self, directions: Directions, centre: np.ndarray, distance: float, wanted: np.ndarray
    ) -> np.ndarray:
        """The first of the directions from where the screens dim the points `wanted` least."""
        if len(directions) == 1:
            return directions[0]
        dimming = [
            sum(self._dimming(point, centre + distance * direction) for point in wanted)
            for direction in directions
        ]
        return directions[int(np.argmin(dimming))]

    def _dimming(self, point: np.ndarray, eye: np.ndarray) -> float:
        """Summed opacity of the screens between them."""
        return sum(
            opacity for screen, opacity in self._screens if screen.IntersectWithLine(eye, point, None, None)
        )


def fitting_distance(
    points: np.ndarray, centre: np.ndarray, direction: np.ndarray, slope: np.ndarray
) -> float:
    """How far along `direction` from `centre` a camera that stays upright has all points in its picture, which
    opens by `slope` (half its width and height over the distance)."""
    towards = direction / np.linalg.norm(direction)
    right = np.cross((0.0, 0.0, 1.0), towards)
    right /= np.linalg.norm(right)
    aside = np.abs((points - centre) @ np.column_stack([right, np.cross(towards, right)]))
    return float(np.max((points - centre) @ towards + np.max(aside / slope, axis=1)))
