#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sets the runs of a benchmark beside published figures: tables in Markdown, time and speed-up over threads."""

import argparse
from pathlib import Path

from b4p_files.comparison import comparison
from b4p_files.errors import run
from b4p_files.output import make_folder, replacing
from b4p_files.published import read_published
from b4p_files.records import Budget, planned_runs, read_records
from b4p_figures.threads import plot_threads

PUBLISHED = Path(__file__).resolve().parents[1] / "experiments" / "paper" / "published.yaml"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="folder that `b4p bench` wrote")
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where files go")
    parser.add_argument(
        "--published",
        metavar="FILE",
        type=Path,
        default=PUBLISHED,
        help="published figures (YAML) [the B4P paper's]",
    )
    arguments = parser.parse_args()
    published = read_published(arguments.published)
    records = read_records(arguments.folder)
    text = comparison(records, planned_runs(arguments.folder), published)
    make_folder(arguments.out)
    with replacing(arguments.out / "tables.md") as temporary:
        temporary.write_text(text)
    print(arguments.out / "tables.md")
    for budget in Budget:
        if budget is Budget.SECONDS or all(record.check_limit is not None for record in records):
            file = arguments.out / f"threads_{budget.value}.png"
            plot_threads(records, published, budget, file)
            print(file)


if __name__ == "__main__":
    run(main)
