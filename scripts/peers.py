#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Table (Markdown) of planners side by side on families of scenes: rates, processor time, ratios. Scenes whose names
differ in a number at the end are taken together."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.output import make_folder, replacing
from b4p_files.peers import peers_table
from b4p_files.records import read_records


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="folder that `b4p bench` wrote")
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where peers.md goes")
    parser.add_argument("--against", metavar="LABEL", default="b4p", help="whom the others are set against [b4p]")
    arguments = parser.parse_args()
    table = peers_table(read_records(arguments.folder), arguments.against)
    make_folder(arguments.out)
    with replacing(arguments.out / "peers.md") as temporary:
        temporary.write_text(table)
    print(arguments.out / "peers.md")


if __name__ == "__main__":
    run(main)
