# SPDX-License-Identifier: BSD-3-Clause
"""The whole benchmark in one figure: success over time above, time of every run below."""

from pathlib import Path

from b4p_files.database import Experiment
from b4p_files.statistics import CONFIDENCE
from b4p_figures.style import add_legend, looks, panels, save
from b4p_figures.success import draw_success
from b4p_figures.times import draw_times

NOTE = f"bands: Wilson {CONFIDENCE} intervals; crosses: runs not solved within the budget"


def plot_overview(experiments: list[Experiment], file: Path) -> None:
    planner_looks = looks(experiments)
    figure, axes = panels(2, len(experiments))
    for column, experiment in enumerate(experiments):
        draw_success(axes[0][column], experiment, planner_looks)
        draw_times(axes[1][column], experiment, planner_looks)
        axes[1][column].set_title("")
    add_legend(figure, planner_looks, NOTE)
    save(figure, file)
