# SPDX-License-Identifier: BSD-3-Clause
"""One look for all plots: colours that colour-blind readers tell apart, legends outside the data."""

from collections.abc import Iterable
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from b4p_files.database import Experiment
from b4p_files.output import replacing

# Okabe and Ito's palette without its yellow, which is too pale for lines on white.
PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
LINE_STYLES = ("-", "--", ":", "-.")
PANEL_WIDTH_IN, PANEL_HEIGHT_IN = 4.6, 3.3
DOTS_PER_INCH = 130
LEGEND_COLUMNS = 4
MANY_DECADES = 200.0  # longest over shortest time

plt.rcParams.update(
    {
        "font.size": 10,
        "axes.titlesize": 11,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#e4e4e4",
        "axes.axisbelow": True,
        "legend.frameon": False,
    }
)

Look = dict[str, str]


def planner_names(experiments: Iterable[Experiment]) -> list[str]:
    return list(dict.fromkeys(planner.name for experiment in experiments for planner in experiment.planners))


def looks(experiments: Iterable[Experiment]) -> dict[str, Look]:
    """Colour and line style of each planner, the same in every panel and figure."""
    return {
        name: {
            "color": PALETTE[index % len(PALETTE)],
            "linestyle": LINE_STYLES[index // len(PALETTE) % len(LINE_STYLES)],
        }
        for index, name in enumerate(planner_names(experiments))
    }


def panels(rows: int, columns: int) -> tuple[Figure, list[list[Axes]]]:
    size = (columns * PANEL_WIDTH_IN, rows * PANEL_HEIGHT_IN)
    figure, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, layout="constrained")
    return figure, axes.tolist()


def set_seconds_axis(axis: Axis, begin_s: float, end_s: float) -> None:
    """Plain numbers on a logarithmic axis, fewer of them when it spans many decades."""
    subdivisions = (1.0, 2.0, 5.0) if end_s < MANY_DECADES * begin_s else (1.0,)
    axis.set_major_locator(LogLocator(subs=subdivisions))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def add_legend(figure: Figure, planner_looks: dict[str, Look], note: str = "") -> None:
    """Below all panels."""
    handles = [Line2D([], [], label=name, linewidth=2, **look) for name, look in planner_looks.items()]
    columns = min(len(handles), LEGEND_COLUMNS)
    figure.legend(handles=handles, loc="outside lower center", ncols=columns, title=note or None)


def save(figure: Figure, file: Path) -> None:
    with replacing(file) as temporary:
        figure.savefig(temporary, dpi=DOTS_PER_INCH, bbox_inches="tight")
    plt.close(figure)
