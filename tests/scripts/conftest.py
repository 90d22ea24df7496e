# SPDX-License-Identifier: BSD-3-Clause
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
os.environ["PYTHONDONTWRITEBYTECODE"] = "1"

BAD_INPUT = 2
Script = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def script() -> Script:
    """Runs a script of scripts/ as a user would."""

    def run(name: str, *arguments: object) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, str(ROOT / "scripts" / name), *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)

    return run


@pytest.fixture
def refuses(script: Script) -> Callable[..., None]:
    """Bad input: exit code 2 and one line on stderr that holds `words`."""

    def check(words: str, name: str, *arguments: object) -> None:
        result = script(name, *arguments)
        assert result.returncode == BAD_INPUT, result
        assert result.stderr.count("\n") == 1, result.stderr
        assert words in result.stderr
        assert result.stdout == ""

    return check
