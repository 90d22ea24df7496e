# SPDX-License-Identifier: BSD-3-Clause
"""How the scripts meet bad input: one line on stderr, exit code 2."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

BAD_INPUT = 2


class FileError(Exception):
    """Something a file holds, or its absence, stops a script. Reads "FILE: PROBLEM"."""

    def __init__(self, file: object, problem: str) -> None:
        super().__init__(f"{file}: {' '.join(problem.split())}")


def run(main: Callable[[], None]) -> None:
    try:
        main()
    except FileError as error:
        print(error, file=sys.stderr)
        sys.exit(BAD_INPUT)


@contextmanager
def reading(file: Path, kind: str) -> Iterator[None]:
    """Turns whatever goes wrong while `file` is taken apart into one FileError."""
    try:
        yield
    except FileError:
        raise
    except OSError as error:
        raise FileError(file, error.strerror or str(error)) from None
    except KeyError as error:
        raise FileError(file, f"not a {kind}: {error} is missing") from None
    except Exception as error:  # parsers have exceptions of their own
        raise FileError(file, f"not a {kind}: {error}") from None
