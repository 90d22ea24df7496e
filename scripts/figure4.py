#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws scenes side by side as one PNG, as Figure 4 of the B4P paper does: start and placement region above, grasps
sampled at the pick below. They come from the planner's trees, so that any scene that a planner has begun on can be
shown: `b4p plan SCENE --forests SCENE_forests.json`."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.picks import read_picks


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "forests", metavar="FORESTS.json", type=Path, nargs="+", help="`b4p plan --forests` file of a scene"
    )
    parser.add_argument("-o", "--out", metavar="PNG", type=Path, required=True, help="picture to write")
    arguments = parser.parse_args()
    tasks = [read_picks(file) for file in arguments.forests]
    # It takes a second or more to load.
    from b4p_figures.gallery import draw_gallery

    draw_gallery(tasks, arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    run(main)
