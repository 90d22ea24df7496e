#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) and a picture of a benchmark of reaching scenes: success over time, rates, lengths of paths.
Scenes whose names differ in a number at the end are taken together."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.output import make_folder, replacing
from b4p_files.processor_limit import add_processor_limit, processor_limit
from b4p_files.reaching import by_processor_time, reaching_tables
from b4p_files.records import read_records


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="folder that `b4p bench` wrote")
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where files go")
    add_processor_limit(parser)
    arguments = parser.parse_args()
    records = read_records(arguments.folder)
    if (limit_s := processor_limit(arguments)) is not None:
        records = by_processor_time(records, limit_s)
    make_folder(arguments.out)
    with replacing(arguments.out / "reaching.md") as temporary:
        temporary.write_text(reaching_tables(records))
    print(arguments.out / "reaching.md")
    # It takes a second to load.
    from b4p_figures.reaching import plot_reaching

    plot_reaching(records, arguments.out / "reaching.png")
    print(arguments.out / "reaching.png")


if __name__ == "__main__":
    run(main)
