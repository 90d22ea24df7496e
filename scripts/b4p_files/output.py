# SPDX-License-Identifier: BSD-3-Clause
"""Files that appear whole or not at all."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from b4p_files.errors import FileError

READABLE_BY_ALL = 0o644


def make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(folder, error.strerror or str(error)) from None


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """Gives a temporary path beside `file` that takes its place when the block ends without an error."""
    make_folder(file.parent)
    try:
        handle, name = tempfile.mkstemp(suffix=file.suffix, prefix=f".{file.stem}.", dir=file.parent)
        os.close(handle)
    except OSError as error:
        raise FileError(file, error.strerror or str(error)) from None
    temporary = Path(name)
    try:
        yield temporary
        temporary.chmod(READABLE_BY_ALL)
        temporary.replace(file)
    finally:
        temporary.unlink(missing_ok=True)
