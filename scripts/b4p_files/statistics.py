# SPDX-License-Identifier: BSD-3-Clause
"""Figures that describe a set of runs."""

from collections.abc import Sequence
from math import inf, isfinite, sqrt

import numpy as np

CONFIDENCE = "95%"
NORMAL_QUANTILE = 1.959964  # two-sided, at CONFIDENCE
TAILS = (0.025, 0.975)  # at CONFIDENCE
RESAMPLES = 2000
SEED = 1


def wilson_interval(successes: int, trials: int) -> tuple[float, float]:
    """Wilson score interval of a success rate, as two shares in [0, 1]."""
    if trials == 0:
        return 0.0, 1.0
    share, z2 = successes / trials, NORMAL_QUANTILE**2
    centre = (share + z2 / (2 * trials)) / (1 + z2 / trials)
    half = NORMAL_QUANTILE * sqrt(share * (1 - share) / trials + z2 / (4 * trials**2)) / (1 + z2 / trials)
    return max(0.0, centre - half), min(1.0, centre + half)


def quantile(values: Sequence[float], fraction: float) -> float:
    """Linear between neighbours; infinite as soon as an infinite one takes part."""
    ordered = sorted(values)
    position = fraction * (len(ordered) - 1)
    below = int(position)
    weight = position - below
    if weight == 0:
        return ordered[below]
    if not isfinite(ordered[below + 1]):
        return inf
    return ordered[below] + weight * (ordered[below + 1] - ordered[below])


def mean_interval(groups: Sequence[Sequence[float]]) -> tuple[float, float] | None:
    """Bootstrap interval at CONFIDENCE of the mean over all values, each group resampled by itself; None when a group
    has a single value, which says nothing of its spread."""
    if min(map(len, groups)) < 2:
        return None
    random = np.random.default_rng(SEED)
    resampled = [random.choice(group, (RESAMPLES, len(group))) for group in groups]
    low, high = np.quantile(np.hstack(resampled).mean(axis=1), TAILS)
    return float(low), float(high)


def median_ratio(above: Sequence[float], below: Sequence[float]) -> tuple[float, tuple[float, float]] | None:
    """Ratio of two medians with a bootstrap interval at CONFIDENCE. Values may be infinite (not solved); None when
    that leaves the ratio, or more than a tail of its resamples, undefined."""
    ratio = _ratio(quantile(above, 0.5), quantile(below, 0.5))
    random = np.random.default_rng(SEED)
    ratios = []
    for _ in range(RESAMPLES):
        medians = [quantile(random.choice(values, len(values)), 0.5) for values in (above, below)]
        ratios.append(_ratio(*medians))
    defined = [one for one in ratios if one is not None]
    if ratio is None or len(defined) < TAILS[1] * RESAMPLES:
        return None
    low, high = (quantile(defined, tail) for tail in TAILS)
    return ratio, (low, high)


def _ratio(above: float, below: float) -> float | None:
    return above / below if isfinite(above) and isfinite(below) else None
