#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) and a picture of a benchmark of placement scenes: how good placements are after how long, for each
surroundings and objective, all objects together (Figure 5 of Haustein et al., IROS 2019)."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.output import make_folder, replacing
from b4p_files.placements import AS_PRINTED, by_processor_time, nearly_best_table, placement_tables, placement_tasks
from b4p_files.processor_limit import add_processor_limit, processor_limit
from b4p_files.records import read_records


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="folder that `b4p bench` wrote")
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where files go")
    parser.add_argument("--reference", metavar="LABEL", help="whom times are compared with [the first planner]")
    parser.add_argument(
        "--against",
        metavar="LABEL",
        help=f"whose time to nearly the best is divided by the others', per scene [{AS_PRINTED}, else the first planner]",
    )
    add_processor_limit(parser)
    arguments = parser.parse_args()
    records = [record for record in read_records(arguments.folder) if record.placement is not None]
    if (limit_s := processor_limit(arguments)) is not None:
        records = by_processor_time(records, limit_s)
    tasks = placement_tasks(records)
    tables = placement_tables(tasks, arguments.reference) + "\n" + nearly_best_table(tasks, arguments.against)
    make_folder(arguments.out)
    with replacing(arguments.out / "placements.md") as temporary:
        temporary.write_text(tables)
    print(arguments.out / "placements.md")
    # It takes a second to load.
    from b4p_figures.placements import plot_placements

    plot_placements(tasks, arguments.out / "placements.png")
    print(arguments.out / "placements.png")


if __name__ == "__main__":
    run(main)
