#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Turns OMPL benchmark logs into one SQLite database with OMPL's own converter."""

import argparse
import subprocess
import sys
from pathlib import Path

from b4p_files.errors import FileError, run
from b4p_files.output import replacing

# The converter is a console script of the pinned `ompl` package, next to this interpreter.
CONVERTER = Path(sys.executable).with_name("ompl_benchmark_statistics")


def check_log(log: Path) -> None:
    """The converter never returns from a block without an end."""
    try:
        text = log.read_text(errors="replace")
    except OSError as error:
        raise FileError(log, error.strerror or str(error)) from None
    if "Experiment " not in text or text.count("<<<|") != text.count("|>>>"):
        raise FileError(log, "not an OMPL benchmark log, or cut off")


def append_log(log: Path, database: Path) -> None:
    command = [str(CONVERTER), "--append", "--database", str(database), str(log)]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        reason = result.stderr.strip().splitlines()[-1:] or ["no reason given"]
        raise FileError(log, f"not an OMPL benchmark log, or cut off: {reason[0]}")


def convert(logs: list[Path], database: Path) -> None:
    if not CONVERTER.is_file():
        raise FileError(CONVERTER, "OMPL's converter is missing: run scripts/install.sh")
    for log in logs:
        check_log(log)
    with replacing(database) as temporary:
        for log in logs:
            append_log(log, temporary)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "logs", metavar="LOG", type=Path, nargs="+", help="benchmark log that `b4p bench` wrote"
    )
    parser.add_argument("-o", "--out", metavar="DATABASE", type=Path, required=True, help="file to write")
    arguments = parser.parse_args()
    convert(arguments.logs, arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    run(main)
