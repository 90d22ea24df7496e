# SPDX-License-Identifier: BSD-3-Clause
"""Rigid motions as 4 x 4 matrices. X_AB is the pose of frame B in frame A."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

Pose = np.ndarray


def vector(numbers: Sequence[float]) -> np.ndarray:
    """Three numbers; raises ValueError for any other count."""
    return np.array(numbers, float).reshape(3)


def axis_angles(axis: Sequence[float], angles_rad: np.ndarray) -> np.ndarray:
    """One rotation matrix for each angle."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angles = np.asarray(angles_rad, float)[:, None, None]
    return np.eye(3) + np.sin(angles) * skew + (1 - np.cos(angles)) * (skew @ skew)


def axis_angle(axis: Sequence[float], angle_rad: float) -> np.ndarray:
    return axis_angles(axis, np.array([angle_rad]))[0]


def rpy(angles_rad: Sequence[float]) -> np.ndarray:
    """URDF's convention: about fixed x, then y, then z."""
    roll, pitch, yaw = angles_rad
    return axis_angle((0, 0, 1), yaw) @ axis_angle((0, 1, 0), pitch) @ axis_angle((1, 0, 0), roll)


def quaternion(wxyz: Sequence[float]) -> np.ndarray:
    w, vector = wxyz[0], np.asarray(wxyz[1:], float)
    length = np.linalg.norm(vector)
    return np.eye(3) if length == 0 else axis_angle(vector, 2 * np.arctan2(length, w))


def pose(position: Sequence[float], rotation: np.ndarray | None = None) -> Pose:
    X = np.eye(4)
    X[:3, 3] = vector(position)
    if rotation is not None:
        X[:3, :3] = rotation
    return X


def pose_from(mapping: Mapping[str, Any]) -> Pose:
    """From the keys position_m and one of rpy_rad, quaternion_wxyz and rotation (rows), all optional."""
    rotation = None
    if "rotation" in mapping:
        rotation = np.array(mapping["rotation"], float).reshape(3, 3)
    elif "rpy_rad" in mapping:
        rotation = rpy(mapping["rpy_rad"])
    elif "quaternion_wxyz" in mapping:
        rotation = quaternion(mapping["quaternion_wxyz"])
    return pose(mapping.get("position_m", (0, 0, 0)), rotation)


def transform(X_AB: Pose, points_B: np.ndarray) -> np.ndarray:
    """Points, one a row."""
    return points_B @ X_AB[:3, :3].T + X_AB[:3, 3]
