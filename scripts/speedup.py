#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plots how much faster B4P is with more workers, from files that `b4p simulate` wrote, one panel a file."""

import argparse
from pathlib import Path

from b4p_files.errors import run
from b4p_files.output import replacing
from b4p_files.speed_runs import read_study
from b4p_files.speedup import markdown
from b4p_figures.speedup import plot_speedup


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "files", metavar="FILE", type=Path, nargs="+", help="JSON lines that `b4p simulate` wrote"
    )
    parser.add_argument("-o", "--out", metavar="PNG", type=Path, required=True, help="the plot")
    parser.add_argument("--markdown", metavar="FILE", type=Path, help="tables of the figures [none]")
    arguments = parser.parse_args()
    studies = [read_study(file) for file in arguments.files]
    plot_speedup(studies, arguments.out)
    print(arguments.out)
    if arguments.markdown is not None:
        with replacing(arguments.markdown) as temporary:
            temporary.write_text(markdown(studies))
        print(arguments.markdown)


if __name__ == "__main__":
    run(main)
