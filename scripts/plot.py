#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plots an OMPL benchmark database: success over time, time per planner, progress, and an overview of both."""

import argparse
from pathlib import Path

from b4p_files.database import read_database
from b4p_files.errors import run
from b4p_files.output import make_folder
from b4p_figures.overview import plot_overview
from b4p_figures.progress import plot_progress
from b4p_figures.success import plot_success
from b4p_figures.times import plot_times


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "database", metavar="DATABASE", type=Path, help="SQLite file that scripts/database.py made"
    )
    parser.add_argument(
        "-o", "--out", metavar="FOLDER", type=Path, required=True, help="where the PNG files go"
    )
    arguments = parser.parse_args()
    # Experiments cut short before their first run have nothing to show.
    experiments = [one for one in read_database(arguments.database) if one.planners]
    make_folder(arguments.out)
    for name, plot in (("overview", plot_overview), ("success", plot_success), ("times", plot_times)):
        plot(experiments, arguments.out / f"{name}.png")
        print(arguments.out / f"{name}.png")
    if plot_progress(experiments, arguments.out / "progress.png"):
        print(arguments.out / "progress.png")
    else:
        print("no progress in this database: no progress.png")


if __name__ == "__main__":
    run(main)
