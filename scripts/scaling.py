#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plot and tables of how cost grows with the work: grasps, obstacles, threads and nodes."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.output import make_folder, replacing
from b4p_files.records import read_records
from b4p_files.scaling import benchmark_times, curves, markdown, nearest_costs, step_costs
from b4p_files.speed_runs import read_study
from b4p_files.speedup import markdown as speedup_markdown


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "folders",
        metavar="FOLDER",
        type=Path,
        nargs="+",
        help="`b4p bench` on scenes that scaling_scenes.py wrote",
    )
    parser.add_argument(
        "--speedup", metavar="FILE", type=Path, nargs="*", default=[], help="of `b4p simulate`"
    )
    parser.add_argument(
        "--nodes",
        metavar="FILE",
        type=Path,
        nargs="*",
        default=[],
        help="of nearest_benchmark, worker_benchmark (JSON)",
    )
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where files go")
    arguments = parser.parse_args()
    found = curves([record for folder in arguments.folders for record in read_records(folder)])
    studies = [read_study(file) for file in arguments.speedup]
    times = {name: time_s for file in arguments.nodes for name, time_s in benchmark_times(file).items()}
    costs = nearest_costs(times) | step_costs(times)
    make_folder(arguments.out)
    with replacing(arguments.out / "scaling.md") as temporary:
        temporary.write_text(markdown(found, costs) + ("\n" + speedup_markdown(studies) if studies else ""))
    print(arguments.out / "scaling.md")
    # It takes a second to load.
    from b4p_figures.scaling import plot_scaling

    plot_scaling(found, studies, costs, arguments.out / "scaling.png")
    print(arguments.out / "scaling.png")


if __name__ == "__main__":
    run(main)
