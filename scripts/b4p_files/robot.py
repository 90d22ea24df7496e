# SPDX-License-Identifier: BSD-3-Clause
"""Robot files (robots/*.yaml) and the URDF they name: collision shapes and forward kinematics."""

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import yaml

from b4p_files.errors import FileError, reading
from b4p_files.poses import Pose, axis_angles, pose, rpy, vector
from b4p_files.shapes import Box, Capsule, Cylinder, PlacedShape, Shape, read_mesh

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = "package://"


@dataclass
class Joint:
    name: str
    kind: str
    parent: str
    child: str
    X_PJ: Pose
    axis: np.ndarray
    lower: float  # rad or m
    upper: float
    wanted_rest: float = 0.0  # as the robot file has it

    @property
    def rest(self) -> float:
        """Where the joint stays when it is not planned: the value inside the limits nearest to what is wanted."""
        return float(np.clip(self.wanted_rest, self.lower, self.upper))

    def motions(self, values: np.ndarray) -> np.ndarray:
        """One pose for each value (rad or m)."""
        X = np.tile(np.eye(4), (len(values), 1, 1))
        if self.kind == "prismatic":
            X[:, :3, 3] = np.outer(values, self.axis)
        elif self.kind in ("revolute", "continuous"):
            X[:, :3, :3] = axis_angles(self.axis, values)
        return X


@dataclass
class Robot:
    file: Path
    joint_names: list[str]
    tcp_link: str
    finger_joints: list[str]
    joints: list[Joint]
    shapes: dict[str, list[PlacedShape]]  # of each link
    root_link: str
    max_opening_m: float  # of the gripper

    @property
    def is_planar(self) -> bool:
        """Slides in x and y and turns about z, no more."""
        kinds = sorted(joint.kind for joint in self.planned)
        flat = all(abs(joint.axis[2]) == (joint.kind != "prismatic") for joint in self.planned)
        return kinds[:2] == ["prismatic"] * 2 and len(kinds) == 3 and flat

    @property
    def hand_links(self) -> list[str]:
        """What moves with the TCP link, fingers included, beyond the link that the last planned joint moves."""
        rigid = {joint.child: joint.parent for joint in self.joints if joint.name not in self.joint_names}
        wrist = self.tcp_link
        while wrist in rigid:
            wrist = rigid[wrist]
        carried = [wrist]
        for link in carried:
            carried += [child for child, parent in rigid.items() if parent == link]
        beyond = [link for link in carried[1:] if self.shapes[link]]
        return beyond or carried

    @property
    def planned(self) -> list[Joint]:
        by_name = {joint.name: joint for joint in self.joints}
        return [by_name[name] for name in self.joint_names]

    @property
    def middle(self) -> np.ndarray:
        return np.array([(joint.lower + joint.upper) / 2 for joint in self.planned])

    def link_poses(self, path: np.ndarray, opening_m: float, X_WB: Pose) -> dict[str, np.ndarray]:
        """X_WL of all links, the root at X_WB, for each row of `path` (values in the order of joint_names)."""
        if path.shape[1] != len(self.joint_names):
            raise FileError(self.file, f"has {len(self.joint_names)} joints, not {path.shape[1]}")
        values = dict(zip(self.joint_names, path.T))
        poses = {self.root_link: np.tile(X_WB, (len(path), 1, 1))}
        left = list(self.joints)
        while ready := [joint for joint in left if joint.parent in poses]:
            for joint in ready:
                rest = opening_m / 2 if joint.name in self.finger_joints else joint.rest
                moved = joint.motions(values.get(joint.name, np.full(len(path), rest)))
                poses[joint.child] = poses[joint.parent] @ joint.X_PJ @ moved
            left = [joint for joint in left if joint.child not in poses]
        return poses

    def tcp_poses(self, path: np.ndarray, X_WB: Pose) -> np.ndarray:
        return self.link_poses(path, 0.0, X_WB)[self.tcp_link]


def find_robot(name_or_path: str, folder: Path) -> Path:
    """A path relative to `folder`, or the name of a robot that ships with b4p."""
    is_path = "/" in name_or_path or name_or_path.endswith((".yaml", ".yml"))
    return folder / name_or_path if is_path else ROOT / "robots" / f"{name_or_path}.yaml"


def read_robot(file: Path) -> Robot:
    with reading(file, "robot file"):
        description = yaml.safe_load(file.read_text())
        urdf = file.parent / description["urdf"]
        gripper = description["gripper"]
        names = description["joints"], description["tcp_link"], gripper["finger_joints"]
        rest = {name: float(value) for name, value in description.get("rest", {}).items()}
    with reading(urdf, "URDF"):
        tree = ET.parse(urdf).getroot()
        joints = [_read_joint(element) for element in tree.findall("joint")]
        for joint in joints:
            joint.wanted_rest = rest.get(joint.name, 0.0)
        shapes = {link.attrib["name"]: _read_shapes(link, urdf) for link in tree.findall("link")}
        (root_link,) = set(shapes) - {joint.child for joint in joints}
        unknown = set(names[0]) - {joint.name for joint in joints}
        if unknown or names[1] not in shapes:
            raise FileError(file, f"{', '.join(unknown) or names[1]} is not in {urdf}")
    return Robot(file, *names, joints, shapes, root_link, float(gripper["max_opening_m"]))


def _numbers(element: ET.Element | None, attribute: str, default: Sequence[float]) -> np.ndarray:
    text = None if element is None else element.get(attribute)
    return np.array(default if text is None else text.split(), float)


def _origin(element: ET.Element) -> Pose:
    origin = element.find("origin")
    return pose(_numbers(origin, "xyz", (0, 0, 0)), rpy(_numbers(origin, "rpy", (0, 0, 0))))


def _read_joint(element: ET.Element) -> Joint:
    limit = element.find("limit")
    lower, upper = (float(_numbers(limit, side, (0,))[0]) for side in ("lower", "upper"))
    axis = _numbers(element.find("axis"), "xyz", (1, 0, 0))
    return Joint(
        name=element.attrib["name"],
        kind=element.attrib["type"],
        parent=element.find("parent").attrib["link"],
        child=element.find("child").attrib["link"],
        X_PJ=_origin(element),
        axis=axis / np.linalg.norm(axis),
        lower=lower,
        upper=upper,
    )


def _read_shapes(link: ET.Element, urdf: Path) -> list[PlacedShape]:
    return [
        PlacedShape(_read_shape(collision.find("geometry")[0], urdf), _origin(collision))
        for collision in link.findall("collision")
    ]


def _read_shape(element: ET.Element, urdf: Path) -> Shape:
    get = element.attrib
    if element.tag == "box":
        return Box(vector(_numbers(element, "size", ())))
    if element.tag == "sphere":
        return Capsule(float(get["radius"]), 0.0)
    if element.tag == "cylinder":
        return Cylinder(float(get["radius"]), float(get["length"]))
    if element.tag == "mesh":
        return read_mesh(_mesh_file(get["filename"], urdf), _numbers(element, "scale", (1, 1, 1)))
    raise ValueError(f"unknown shape {element.tag}")


def _mesh_file(name: str, urdf: Path) -> Path:
    """package://NAME/rest is looked up in the folders above the URDF."""
    if not name.startswith(PACKAGE):
        return urdf.parent / name.removeprefix("file://")
    relative = name.removeprefix(PACKAGE)
    for folder in urdf.resolve().parents:
        if (folder / relative).is_file():
            return folder / relative
    raise ValueError(f"mesh {name} not found above {urdf.parent}")
