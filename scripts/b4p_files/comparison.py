# SPDX-License-Identifier: BSD-3-Clause
"""Tables of benchmark runs in Markdown, with published figures beside them."""

from collections.abc import Iterable
from math import isfinite
from statistics import mean, median, stdev

from b4p_files.published import Figure, Published
from b4p_files.records import Budget, Record
from b4p_files.statistics import CONFIDENCE, quantile, wilson_interval

Group = tuple[str, int]  # label without thread count, threads

NOTHING = "-"
HEADINGS = (
    "planner",
    "threads",
    "solved",
    f"rate ({CONFIDENCE})",
    "median (quartiles), s",
    "mean ± sd of solved, s",
    "CPU s a run",
)
PUBLISHED_HEADINGS = ("solved †", f"rate ({CONFIDENCE}) †", "mean ± sd of solved, s †")


def grouped(records: Iterable[Record]) -> dict[Group, list[Record]]:
    """By planner in the order of their first runs, then by threads."""
    groups: dict[Group, list[Record]] = {}
    for record in records:
        groups.setdefault((record.group, record.threads), []).append(record)
    order = list(dict.fromkeys(label for label, _ in groups))
    return {key: groups[key] for key in sorted(groups, key=lambda key: (order.index(key[0]), key[1]))}


def scenes_of(records: Iterable[Record], published: Published) -> list[str]:
    """Those that the paper has first, in its order."""
    here = list(dict.fromkeys(record.scene for record in records))
    return [scene for scene in published.scenes if scene in here] + [
        scene for scene in here if scene not in published.scenes
    ]


def rate_text(solved: int, trials: int) -> str:
    low, high = wilson_interval(solved, trials)
    return f"{100 * solved / trials:.0f} % ({100 * low:.0f} ... {100 * high:.0f} %)"


def _seconds_text(value: float, budget_s: float) -> str:
    return f"{value:.3g}" if isfinite(value) else f"> {budget_s:g}"


def _spread_text(center: float | None, deviation: float | None) -> str:
    if center is None:
        return NOTHING
    return f"{center:.3g}" if deviation is None else f"{center:.3g} ± {deviation:.2g}"


def _own_cells(runs: list[Record], budget: Budget) -> list[str]:
    times = [run.seconds(budget) for run in runs]
    solved = [time for time in times if isfinite(time)]
    low, middle, high = (
        _seconds_text(quantile(times, fraction), runs[0].time_limit_s) for fraction in (0.25, 0.5, 0.75)
    )
    deviation = stdev(solved) if len(solved) > 1 else None
    return [
        f"{len(solved)} of {len(runs)}",
        rate_text(len(solved), len(runs)),
        f"{middle} ({low} ... {high})",
        _spread_text(mean(solved) if solved else None, deviation),
        f"{median(run.cpu_s for run in runs):.3g}",
    ]


def _published_cells(figure: Figure | None) -> list[str]:
    if figure is None:
        return [NOTHING] * len(PUBLISHED_HEADINGS)
    return [
        f"{figure.solved} of {figure.trials}",
        rate_text(figure.solved, figure.trials),
        _spread_text(figure.mean_s, figure.sd_s),
    ]


def _row(cells: Iterable[object]) -> str:
    return "| " + " | ".join(map(str, cells)) + " |\n"


def _rows_not_run(scene: str, runs: list[Record], published: Published) -> Iterable[str]:
    """Published figures for which there is no run here."""
    if scene not in published.scenes:
        return
    here = {(published.columns.get(run.planner), run.threads) for run in runs}
    for name, column in published.scenes[scene].columns.items():
        for threads, figure in column.items():
            if (name, threads) not in here:
                cells = ["not run here", *[NOTHING] * 4, *_published_cells(figure)]
                yield _row([name, threads, *cells])


def scene_table(scene: str, runs: list[Record], budget: Budget, published: Published) -> str:
    text = _row([*HEADINGS, *PUBLISHED_HEADINGS])
    text += "|" + "---|" * (len(HEADINGS) + len(PUBLISHED_HEADINGS)) + "\n"
    for (label, threads), group in grouped(runs).items():
        figure = published.figure(scene, group[0].planner, threads)
        text += _row([label, threads, *_own_cells(group, budget), *_published_cells(figure)])
    return text + "".join(_rows_not_run(scene, runs, published))


def _notes(runs: list[Record], budget: Budget, planned: dict[str, int]) -> str:
    """What keeps a table from saying all."""
    notes = []
    for group in grouped(runs).values():
        label, wanted = group[0].label, planned.get(group[0].label, len(group))
        if len(group) < wanted:
            notes.append(f"- {label}: {len(group)} of {wanted} planned runs so far.\n")
        undecided = sum(run.undecided(budget) for run in group)
        if undecided:
            notes.append(f"- {label}: {undecided} runs ended before this budget was used up (not solved).\n")
        crashed = sum(run.crashed for run in group)
        if crashed:
            notes.append(f"- {label}: {crashed} runs crashed (not solved).\n")
    return "\n" + "".join(notes) if notes else ""


def _heading(scene: str, runs: list[Record], budget: Budget, published: Published) -> str:
    known = published.scenes.get(scene)
    title = f"Table {known.table}: {scene}" if known else scene
    limit_s = runs[0].time_limit_s
    if budget is Budget.WORK:
        limits = {run.threads: run.check_limit for run in runs}
        of_threads = (f"{checks:.3g} at {threads}" for threads, checks in sorted(limits.items()))
        return f"## {title}, limited by work\n\nChecks by threads: {', '.join(of_threads)}.\n\n"
    text = f"## {title}, limited by time\n\nLimit: {limit_s:g} s."
    if known and known.budget_s != limit_s:
        text += f" **The paper's: {known.budget_s:g} s**; rates do not compare."
    return text + "\n\n"


def comparison(records: list[Record], planned: dict[str, int], published: Published) -> str:
    """The whole page. Each scene has a table under every budget that all its runs state."""
    text = f"# Beside the paper\n\n† {published.source}: {published.machine}. Not measured here.\n\n"
    builds = sorted(
        {f"{run.build['CPU']}, {run.build['cores']} cores, commit {run.build['commit']}" for run in records}
    )
    text += f"All else was measured on: {'; '.join(builds)}.\n\n"
    text += (
        "Solved: runs whose path passed the independent verifier within the budget; all others count as failures, in the "
        f"rate (Wilson {CONFIDENCE} interval) and, as longer than the budget, in median and quartiles. Means are over "
        "solved runs alone, as in the paper. CPU s: median processor time of all threads over all runs, "
        "each to its own end, which may lie beyond the budget.\n\n"
        "Limited by work, a run may make as many configuration checks as the paper's machine makes in its seconds "
        "(seconds x threads / cost of a check there), and times are the seconds its checks would have taken there.\n\n"
    )
    for scene in scenes_of(records, published):
        runs = [run for run in records if run.scene == scene]
        for budget in Budget:
            if budget is Budget.WORK and any(run.check_limit is None for run in runs):
                continue
            text += _heading(scene, runs, budget, published)
            text += scene_table(scene, runs, budget, published) + _notes(runs, budget, planned) + "\n"
    return text
