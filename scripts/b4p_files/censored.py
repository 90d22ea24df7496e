# SPDX-License-Identifier: BSD-3-Clause
"""Medians of times of which some are only known to be longer than a limit (infinite here)."""

from dataclasses import dataclass

import numpy as np

RESAMPLES = 4000
PERCENTILES = (2.5, 97.5)
SEED = 1  # figures drawn twice are the same


@dataclass
class Median:
    """Of times in seconds, with a bootstrap interval. `above` a value: more than half of the runs exceed it."""

    value: float  # the limit where the median lies above it
    low: float
    high: float
    above: bool


@dataclass
class Ratio:
    """Of two medians, with a bootstrap interval. Not known (`bound` is neither) when both lie above the limit."""

    value: float
    low: float
    high: float
    bound: str  # "" exact, ">" or "<" where one median is only known to exceed its limit, "?" for both


def _resampled_medians(times: list[float], generator: np.random.Generator) -> np.ndarray:
    sample = np.asarray(times, float)
    return np.median(sample[generator.integers(len(sample), size=(RESAMPLES, len(sample)))], axis=1)


def median(times: list[float], limit: float) -> Median:
    """`times`: at least one, infinite where unsolved within `limit`."""
    value = float(np.median(times))
    medians = np.minimum(_resampled_medians(times, np.random.default_rng(SEED)), limit)
    low, high = np.percentile(medians, PERCENTILES)
    return Median(min(value, limit), float(low), float(high), value > limit)


def ratio(over: list[float], under: list[float], limit: float) -> Ratio:
    """The median of `over` by that of `under`. Where a median lies above the limit, the limit stands for it."""
    generator = np.random.default_rng(SEED)
    top, bottom = (np.minimum(_resampled_medians(times, generator), limit) for times in (over, under))
    low, high = np.percentile(top / bottom, PERCENTILES)
    first, second = median(over, limit), median(under, limit)
    bound = {(False, False): "", (True, False): ">", (False, True): "<", (True, True): "?"}
    return Ratio(first.value / second.value, float(low), float(high), bound[(first.above, second.above)])
