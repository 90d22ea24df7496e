# SPDX-License-Identifier: BSD-3-Clause
"""Figures that describe a set of runs."""

from math import sqrt

CONFIDENCE = "95%"
NORMAL_QUANTILE = 1.959964  # two-sided, at CONFIDENCE


def wilson_interval(successes: int, trials: int) -> tuple[float, float]:
    """Wilson score interval of a success rate, as two shares in [0, 1]."""
    if trials == 0:
        return 0.0, 1.0
    share, z2 = successes / trials, NORMAL_QUANTILE**2
    centre = (share + z2 / (2 * trials)) / (1 + z2 / trials)
    half = NORMAL_QUANTILE * sqrt(share * (1 - share) / trials + z2 / (4 * trials**2)) / (1 + z2 / trials)
    return max(0.0, centre - half), min(1.0, centre + half)
