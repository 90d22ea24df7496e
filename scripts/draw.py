#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a scene, or the solution in a result file, as a PNG: seen from above for planar robots, else in 3-D."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.result import Forests, Result, read_forests
from b4p_files.scene import Scene
from b4p_files.subject import add_subject, read_subject


def draw(scene: Scene, result: Result | None, forests: Forests | None, file: Path) -> None:
    # Each takes a second or more to load.
    if scene.robot.is_planar:
        from b4p_figures.planar import draw_planar

        draw_planar(scene, result, forests, file)
    else:
        from b4p_figures.spatial import draw_spatial

        draw_spatial(scene, result, file)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    add_subject(parser)
    parser.add_argument("-o", "--out", metavar="PNG", type=Path, required=True, help="picture to write")
    parser.add_argument(
        "--forests", metavar="JSON", type=Path, help="`b4p plan --forests` file (planar scenes)"
    )
    arguments = parser.parse_args()
    scene, result = read_subject(arguments.subject)
    forests = read_forests(arguments.forests) if arguments.forests else None
    draw(scene, result, forests, arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    run(main)
