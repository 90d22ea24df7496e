#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes one HTML page of a solution: robot, scene and object in 3-D with play and scrub, without any network.

A result without a path, and a scene alone, become a page that stands still: the scene with its robot at rest,
and a title that says so."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.subject import add_subject, read_subject


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    add_subject(parser)
    parser.add_argument("-o", "--out", metavar="HTML", type=Path, required=True, help="page to write")
    parser.add_argument("--png", metavar="PNG", type=Path, help="also write a still picture of the scene")
    arguments = parser.parse_args()
    scene, result = read_subject(arguments.subject)
    # They take seconds to load.
    from b4p_figures.page import write_page
    from b4p_figures.spatial import draw_spatial

    write_page(scene, result, arguments.out)
    print(arguments.out)
    if arguments.png:
        draw_spatial(scene, result, arguments.png)
        print(arguments.png)


if __name__ == "__main__":
    run(main)
