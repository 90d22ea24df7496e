# SPDX-License-Identifier: BSD-3-Clause
"""Figures that a paper states (experiments/paper/published.yaml)."""

from dataclasses import dataclass
from pathlib import Path

import yaml

from b4p_files.errors import FileError, reading

SCHEMA = 1


@dataclass
class Figure:
    """A cell of a published table."""

    solved: int
    trials: int
    mean_s: float | None  # over the solved ones
    sd_s: float | None


@dataclass
class PublishedScene:
    table: str
    budget_s: float
    columns: dict[str, dict[int, Figure]]  # planner as the paper calls it -> threads -> figure


@dataclass
class Published:
    source: str
    machine: str
    columns: dict[str, str]  # planner of ours -> planner as the paper calls it
    scenes: dict[str, PublishedScene]

    def figure(self, scene: str, planner: str, threads: int) -> Figure | None:
        """What is published about a planner of ours."""
        if scene not in self.scenes or planner not in self.columns:
            return None
        return self.scenes[scene].columns[self.columns[planner]].get(threads)


def read_published(file: Path) -> Published:
    with reading(file, "file of published figures"):
        document = yaml.safe_load(file.read_text())
        if document["schema"] != SCHEMA:
            raise FileError(file, f"schema: {document['schema']} is not {SCHEMA}")
        trials = int(document["trials"])
        scenes = {name: _scene(scene, trials) for name, scene in document["scenes"].items()}
        published = Published(document["source"], document["machine"], document["columns"], scenes)
        for scene in scenes.values():
            unknown = set(published.columns.values()) - set(scene.columns)
            if unknown:
                raise ValueError(f"table {scene.table} has no column {', '.join(sorted(unknown))}")
        return published


def _scene(scene: dict, trials: int) -> PublishedScene:
    columns = {
        name: {int(threads): _figure(cell, trials) for threads, cell in column.items()}
        for name, column in scene["columns"].items()
    }
    return PublishedScene(str(scene["table"]), float(scene["budget_s"]), columns)


def _figure(cell: dict, trials: int) -> Figure:
    unknown = set(cell) - {"solved", "mean_s", "sd_s"}
    solved = int(cell["solved"])
    if unknown or not 0 <= solved <= trials or (solved > 0) != ("mean_s" in cell):
        raise ValueError(f"{cell} is no cell of a table")
    return Figure(solved, trials, cell.get("mean_s"), cell.get("sd_s"))
