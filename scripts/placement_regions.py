#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws as one PNG where objects can be put down: contact regions of placement scenes above, each object with the
faces that it can stand on below. Files come from `b4p surfaces SCENE --out SURFACES.json`."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.surfaces import read_surfaces


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surfaces", metavar="SURFACES.json", type=Path, nargs="+", help="`b4p surfaces` file")
    parser.add_argument("-o", "--out", metavar="PNG", type=Path, required=True, help="picture to write")
    arguments = parser.parse_args()
    tasks = [read_surfaces(file) for file in arguments.surfaces]
    # It takes a second or more to load.
    from b4p_figures.contacts import draw_contacts

    draw_contacts(tasks, arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    run(main)
