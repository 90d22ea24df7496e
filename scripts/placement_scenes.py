#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the placement scenes that ship with b4p: every robot x surroundings x object below, one file each.

Surroundings and objects are those of Haustein et al. (Object Placement Planning and Optimization for Robot
Manipulators, IROS 2019), with boxes and cylinders for the objects' meshes.
"""

import argparse
import math
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "experiments" / "scenes" / "placement"
YUMI_REACH = 0.127  # from the gripper base to the TCP (robots/urdf/yumi.urdf)
EDGE_STEP_M = 0.004  # less than a grid cell: an object is held at least half a cell above what it is put on


def number(value: float) -> str:
    text = f"{value:.5f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(values) -> str:
    return "[" + ", ".join(number(value) for value in values) + "]"


def pose(position, rpy=None, quaternion=None) -> str:
    text = f"position_m: {numbers(position)}"
    if rpy is not None:
        text += f", rpy_rad: {numbers(rpy)}"
    if quaternion is not None:
        text += f", quaternion_wxyz: {numbers(quaternion)}"
    return text


def box(size, centre, yaw: float = 0.0) -> str:
    return f"box: {{size_m: {numbers(size)}}}, " + pose(centre, rpy=(0, 0, yaw) if yaw else None)


def between(low, high) -> str:
    return box([b - a for a, b in zip(low, high)], [(a + b) / 2 for a, b in zip(low, high)])


def cylinder(radius: float, length: float, centre) -> str:
    return f"cylinder: {{radius_m: {number(radius)}, length_m: {number(length)}}}, " + pose(centre)


@dataclass
class Surroundings:
    about: str
    low: tuple
    high: tuple
    obstacles: dict


@dataclass
class Grasp:
    """Pose of the TCP in the object's frame; z approaches, y closes."""

    position: tuple
    quaternion: tuple
    opening: float


@dataclass
class Arm:
    """`robot`: the robot file, unless it has the robot's name; `rest_opening`: of the empty hand (m)."""

    name: str
    start: tuple
    robot: str | None = None
    rest_opening: float | None = None


@dataclass
class Robot:
    """`bases`, `pedestals` and `grasps` by the names of surroundings and objects; the same starts everywhere, and the
    same grasp for all arms."""

    name: str
    bases: dict
    pedestals: dict
    grasps: dict
    arms: list


CABINET = {
    "floor": box((2.4, 2.4, 0.05), (0, 0.2, -0.5)),
    "cabinet_block": between((-0.412, 0.486, -0.46), (0.489, 0.931, 0.256)),
    "cabinet_bottom": between((-0.412, 0.486, 0.256), (0.489, 0.931, 0.276)),
    "cabinet_left": between((-0.411, 0.486, 0.276), (-0.391, 0.931, 0.608)),
    "cabinet_right": between((0.469, 0.486, 0.276), (0.489, 0.931, 0.608)),
    "cabinet_back": between((-0.412, 0.914, 0.277), (0.489, 0.934, 0.617)),
    "cabinet_top": between((-0.412, 0.563, 0.596), (0.489, 0.931, 0.616)),
    "cabinet_divider": between((-0.138, 0.619, 0.271), (-0.125, 0.913, 0.613)),
    "shelf_lower": between((-0.392, 0.619, 0.350), (-0.138, 0.913, 0.363)),
    "shelf_upper": between((-0.392, 0.619, 0.478), (-0.138, 0.913, 0.491)),
}

CABINET_VOLUME = ((-0.40, 0.45, 0.25), (0.53, 0.87, 0.54))

SURROUNDINGS = {
    "cabinet_cluttered": Surroundings(
        "A cabinet with a divider, two small shelves and many groceries.",
        *CABINET_VOLUME,
        CABINET
        | {
            "cracker_box": box((0.072, 0.216, 0.167), (0.333, 0.750, 0.364)),
            "bowl": cylinder(0.0805, 0.055, (0.078, 0.797, 0.304)),
            "mustard": box((0.060, 0.098, 0.191), (0.162, 0.619, 0.376)),
            "soup_can": cylinder(0.034, 0.102, (-0.269, 0.575, 0.328)),
            "tuna": cylinder(0.043, 0.034, (-0.197, 0.669, 0.381)),
            "chocolate": box((0.036, 0.202, 0.033), (-0.022, 0.610, 0.293), 0.79),
        },
    ),
    "table_cluttered": Surroundings(
        "A table full of groceries.",
        (-0.40, 0.29, 0.0),
        (0.40, 0.78, 0.2),
        {
            "floor": box((2.4, 2.4, 0.05), (0, 0.2, -0.5)),
            "table": box((0.9, 0.55, 0.5), (-0.024, 0.54, -0.15)),
            "chocolate": box((0.042, 0.202, 0.034), (0.330, 0.441, 0.117)),
            "spam": box((0.058, 0.102, 0.084), (-0.223, 0.587, 0.142)),
            "bottle": cylinder(0.034, 0.227, (0.167, 0.627, 0.214)),
            "cracker_box": box((0.072, 0.213, 0.164), (0.082, 0.420, 0.184), -0.663),
            "bowl": cylinder(0.0805, 0.055, (-0.072, 0.595, 0.129)),
            "mustard": box((0.060, 0.098, 0.191), (0.304, 0.711, 0.197)),
            "soup_can": cylinder(0.034, 0.102, (-0.343, 0.560, 0.154)),
            "tuna": cylinder(0.043, 0.034, (-0.272, 0.719, 0.117)),
            "sugar_box": box((0.097, 0.063, 0.176), (-0.252, 0.387, 0.189)),
        },
    ),
    "cabinet_sparse": Surroundings(
        "The cabinet with three groceries.",
        *CABINET_VOLUME,
        CABINET
        | {
            "chocolate": box((0.043, 0.203, 0.033), (0.369, 0.708, 0.292)),
            "spam": box((0.058, 0.102, 0.084), (-0.223, 0.680, 0.405)),
            "bottle": cylinder(0.034, 0.227, (0.177, 0.627, 0.389)),
        },
    ),
}


def slices(*cuts) -> list:
    """Cylinders (bottom, top, radius) on one axis."""
    return [cylinder(radius, top - bottom, (0, 0, (bottom + top) / 2)) for bottom, top, radius in cuts]


# Shapes of each object and, where it is not that of the shapes at one density, its centre of mass.
OBJECTS = {
    "large_crayons": ([box((0.144, 0.124, 0.036), (0, 0, 0))], None),
    "small_crayons": ([box((0.094, 0.021, 0.071), (0, 0, 0))], None),
    "wine_glass": (
        slices(
            (0, 0.003, 0.0287),
            (0.003, 0.072, 0.0042),
            (0.072, 0.086, 0.0225),
            (0.086, 0.100, 0.0320),
            (0.100, 0.125, 0.0420),
            (0.125, 0.137, 0.0380),
            (0.137, 0.145, 0.0320),
        ),
        (0, 0, 0.050),
    ),
    "toy_table": (
        [box((0.110, 0.070, 0.006), (0, 0, 0.043))]
        + [box((0.010, 0.010, 0.067), (x, y, 0.0065)) for x in (-0.05, 0.05) for y in (-0.03, 0.03)],
        None,
    ),
}


def side_grasp(tcp, tilt: float, opening: float) -> Grasp:
    """From the object's -x side, tilted down by `tilt`, closing along y."""
    half = (math.pi / 2 + tilt) / 2
    return Grasp(tcp, (math.cos(half), 0, math.sin(half), 0), opening)


def times(a, b):
    """Product of two quaternions (w, x, y, z)."""
    (aw, ax, ay, az), (bw, bx, by, bz) = a, b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def quarter_turn(axis: str, sign: int = 1) -> tuple:
    half = math.sqrt(0.5)
    return (half, *(sign * half if name == axis else 0.0 for name in "xyz"))


def from_gripper_base(position, quaternion, finger: float, reach: float, sign: int = 1) -> Grasp:
    """A published grasp, the pose of the YuMi's gripper base, which approaches along z and closes along x, for a hand
    whose TCP lies `reach` before that base. Closing along y is a quarter turn about z, either way."""
    w, x, y, z = quaternion
    approach = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))
    tcp = tuple(p + reach * a for p, a in zip(position, approach))
    return Grasp(tcp, times(quaternion, quarter_turn("z", sign)), 2 * finger)


# Position and quaternion of the gripper base in the object's frame, half the opening.
PUBLISHED = {
    "large_crayons": ((-0.1654, 0.0250, -0.0056), (0.7200, 0.1240, 0.6775, -0.0842), 0.0185),
    "small_crayons": ((-0.1333, -0.0018, 0.0911), (-0.2810, 0.6733, -0.6158, 0.2974), 0.0109),
    "wine_glass": ((-0.0608, -0.0583, -0.1054), (-0.0015, 0.2566, -0.0201, 0.9663), 0.0031),
    "toy_table": ((-0.0084, -0.1378, 0.0526), (0.4888, -0.4925, 0.5422, 0.4738), 0.0030),
}


def published_glass():
    """The published glass stands along y with its middle in the origin, this one along z with its foot there; and
    between its fingers is a stem of 8.4 mm."""
    (x, y, z), quaternion, _ = PUBLISHED["wine_glass"]
    return (x, -z, y + 0.145 / 2), times(quarter_turn("x"), quaternion), 0.0042


def panda() -> Robot:
    cabinet, table = (0.05, -0.02, 0.0), (0.0, -0.10, 0.0)
    bases = {"cabinet_cluttered": cabinet, "table_cluttered": table, "cabinet_sparse": cabinet}
    return Robot(
        "panda",
        bases,
        {place: panda_pedestal(base) for place, base in bases.items()},
        {
            # The tips are 8.8 mm before the TCP; those of the large box reach 18 mm less far than the YuMi's.
            "large_crayons": from_gripper_base(*PUBLISHED["large_crayons"], 0.135 - 0.0088 - 0.018, -1),
            "small_crayons": from_gripper_base(*PUBLISHED["small_crayons"], 0.135 - 0.0088, -1),
            "wine_glass": side_grasp((-0.003, 0.0, 0.032), 0.3, 0.010),
            "toy_table": side_grasp((-0.030, 0.0, 0.038), 0.5, 0.072),
        },
        [Arm("panda", (0, -0.785, 0, -2.356, 0, 1.571, 0.785))],
    )


def panda_pedestal(base) -> str:
    """What carries the robot; it ends below the lowest point of its first link's shapes."""
    x, y, z = base
    return between((x - 0.12, y - 0.12, -0.475), (x + 0.12, y + 0.12, z - 0.08))


def yumi() -> Robot:
    """As published, but for two hands that would touch what they hold with the cylinder around their base."""
    base = (0.0, 0.12, 0.10)
    size, at_cabinet, at_table = (0.9, 0.55, 0.5), (0, -0.0375, -0.255), (-0.13, -0.0375, -0.27)
    grasps = PUBLISHED | {"wine_glass": published_glass()}
    back = {"large_crayons": 0.010, "wine_glass": 0.001}
    rest_opening = 0.04
    return Robot(
        "yumi",
        {place: base for place in SURROUNDINGS},
        {
            "cabinet_cluttered": box(size, at_cabinet),
            "table_cluttered": box(size, at_table),
            "cabinet_sparse": box(size, at_cabinet),
        },
        {item: from_gripper_base(*grasp, YUMI_REACH - back.get(item, 0)) for item, grasp in grasps.items()},
        [
            Arm("left", (-0.93, -1.55, 0, 0, 0, 0, 0), "yumi_left", rest_opening),
            Arm("right", (0.69, -1.95, 0, 0, 0, 0, 0), "yumi_right", rest_opening),
        ],
    )


def scene(robot: Robot, place: str, item: str) -> str:
    surroundings = SURROUNDINGS[place]
    shapes, com = OBJECTS[item]
    base = robot.bases[place]
    grasp = robot.grasps[item]
    lines = [
        "# SPDX-License-Identifier: BSD-3-Clause",
        f"# {surroundings.about} Written by scripts/placement_scenes.py.",
        "schema: 1",
        f"name: placement_{robot.name}_{place}_{item}",
        f"robot: {robot.arms[0].robot or robot.name}",
        f"robot_base: {{{pose(base, rpy=(0, 0, math.pi / 2))}}}",
        f"edge_step_m: {number(EDGE_STEP_M)}",
        "budget_s: 120",
        "obstacles:",
        f"  - {{name: pedestal, {robot.pedestals[place]}}}",
    ]
    lines += [f"  - {{name: {name}, {shape}}}" for name, shape in surroundings.obstacles.items()]
    lines += ["object:", f"  name: {item}", "  shapes:"]
    lines += [f"    - {{{shape}}}" for shape in shapes]
    lines += ["place:", f"  volume: {{min_m: {numbers(surroundings.low)}, max_m: {numbers(surroundings.high)}}}"]
    lines += ["  objective: max_clearance"]
    if com:
        lines += [f"  centre_of_mass_m: {numbers(com)}"]
    held = pose(grasp.position, quaternion=grasp.quaternion)
    lines += ["  arms:"]
    for arm in robot.arms:
        lines += [f"    - name: {arm.name}"]
        lines += [f"      robot: {arm.robot}"] if arm.robot else []
        lines += [f"      grasp: {{{held}, opening_m: {number(grasp.opening)}}}"]
        lines += [f"      start: {numbers(arm.start)}"]
        lines += [f"      rest_opening_m: {number(arm.rest_opening)}"] if arm.rest_opening is not None else []
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=FOLDER, help="folder to write to")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for robot in (panda(), yumi()):
        for place in SURROUNDINGS:
            for item in OBJECTS:
                (out / f"{robot.name}_{place}_{item}.yaml").write_text(scene(robot, place, item))


if __name__ == "__main__":
    main()
