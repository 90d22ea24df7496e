# SPDX-License-Identifier: BSD-3-Clause
"""Promises of peers.py: instances of a family are taken together; failures count as longer than the limit; ratios are
of medians of processor time; unknown planners are refused in one line."""

import json
from pathlib import Path

import pytest

from b4p_files.errors import FileError
from b4p_files.peers import peers_table
from b4p_files.records import read_records


def line(scene: str, label: str, number: int, cpu_s: float | None) -> dict:
    solved = cpu_s is not None
    return {
        "schema": 1,
        "scene": scene,
        "label": label,
        "run": number,
        "planner": label,
        "threads": 1,
        "time_limit_s": 2.0,
        "check_limit": None,
        "solved": solved,
        "verified": solved,
        "crashed": False,
        "time_s": 1.9 if solved else 2.0,
        "cpu_s": cpu_s or 1.9,
        "checks": 10,
        "build": {"commit": "abc"},
        "ompl": {"columns": {}},
    }


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    lines = []
    for instance in (301, 302):
        for number in range(1, 11):
            lines.append(line(f"stick_{instance}", "b4p", number, 0.01))
            lines.append(line(f"stick_{instance}", "loop", number, 0.05))
            lines.append(line(f"stick_{instance}", "never", number, 0.5 if number == 1 else None))
    (tmp_path / "runs.jsonl").write_text("".join(json.dumps(one) + "\n" for one in lines))
    (tmp_path / "experiment.json").write_text("{}")
    return tmp_path


def row(table: str, label: str) -> list[str]:
    [found] = [text for text in table.splitlines() if text.startswith(f"| {label} |")]
    return [cell.strip() for cell in found.strip("|").split("|")]


def test_instances_are_taken_together_and_medians_compared(folder: Path):
    table = peers_table(read_records(folder), "b4p")
    assert "## stick, 2 instances" in table
    assert row(table, "b4p")[1:2] + row(table, "b4p")[3:5] == ["20 of 20", "10", "10"]
    assert row(table, "loop")[5] == "5 (5 ... 5)"


def test_failures_are_longer_than_the_limit(folder: Path):
    cells = row(peers_table(read_records(folder), "b4p"), "never")
    assert cells[1] == "2 of 20"
    assert cells[2].startswith("10 (")
    assert cells[3:] == ["> 2000", "> 2000", "> 200"]


def test_an_unknown_reference_is_refused(folder: Path):
    with pytest.raises(FileError, match="no runs of nobody on stick"):
        peers_table(read_records(folder), "nobody")
