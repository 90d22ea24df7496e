# SPDX-License-Identifier: BSD-3-Clause
"""The option --processor-s of scripts that judge runs by processor time."""

import argparse
from math import inf

from b4p_files.errors import FileError


def add_processor_limit(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--processor-s",
        metavar="SECONDS",
        type=float,
        help="judge runs by processor time instead, within this limit (s)",
    )


def processor_limit(arguments: argparse.Namespace) -> float | None:
    """The limit (s); None when runs are judged by elapsed time.

    Raises:
        FileError: not a positive number of seconds.
    """
    limit_s = arguments.processor_s
    if limit_s is not None and not 0.0 < limit_s < inf:
        raise FileError("--processor-s", f"{limit_s} is not a positive number of seconds")
    return limit_s
