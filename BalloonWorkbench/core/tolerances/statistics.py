# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantiles with what a limited number of samples leaves open, and a bound on which people may act.

Free of any distribution: between which of the ordered values a quantile lies follows from the binomial
distribution alone (David and Nagaraja, Order statistics, 3rd ed. 2003, 7.1). Samples that are spread more
evenly than at random lie a little nearer than that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.types import Floats

QUANTILES = (0.05, 0.5, 0.95)
CONFIDENCE = 0.95
#: From so many samples on the smallest is below 95 % of all balloons with the confidence asked for: 59.
LEAST_SAMPLES = math.ceil(math.log(1.0 - CONFIDENCE) / math.log(1.0 - QUANTILES[0]))


@dataclass(frozen=True)
class Quantile:
    """A quantile of a share of all cases; low, high: between which it lies with CONFIDENCE.

    None where there are too few samples to say.
    """

    share: float
    value: float
    low: float | None
    high: float | None


def quantile(values: Floats, share: float) -> Quantile:
    """The quantile of values (n,), n > 0."""
    ordered = np.sort(values)
    below = _below(len(ordered), share)  # below[k]: chance that at most k values are under the quantile
    tail = 0.5 * (1.0 - CONFIDENCE)
    under = np.flatnonzero(below <= tail)  # the value after so many is surely below it
    over = np.flatnonzero(below >= 1.0 - tail)
    low = float(ordered[under[-1]]) if len(under) else None
    high = float(ordered[over[0]]) if len(over) and over[0] < len(ordered) else None
    return Quantile(share, float(np.quantile(ordered, share)), low, high)


def sure_minimum(values: Floats, failed: int = 0) -> float | None:
    """What at least 95 % of all balloons exceed, with CONFIDENCE; None where the samples are too few.

    failed  samples of which there is no value: they count as the worst
    """
    ordered = np.sort(np.concatenate([np.full(failed, -np.inf), values]))
    under = np.flatnonzero(_below(len(ordered), QUANTILES[0]) <= 1.0 - CONFIDENCE)
    if not len(under) or not math.isfinite(ordered[under[-1]]):
        return None
    return float(ordered[under[-1]])


def rank_correlation(one: Floats, other: Floats) -> float:
    """Spearman's correlation of values (n,) with others, 0 where one of them does not vary."""
    if len(one) < 3 or np.ptp(one) == 0.0 or np.ptp(other) == 0.0:
        return 0.0
    return float(np.corrcoef(_ranks(one), _ranks(other))[0, 1])


def _ranks(values: Floats) -> Floats:
    """Ranks (n,); equal values share the mean of theirs."""
    _, place, count = np.unique(values, return_inverse=True, return_counts=True)
    return np.asarray((np.cumsum(count) - 0.5 * (count - 1))[place.ravel()])


def _below(count: int, share: float) -> Floats:
    """Chances (count,) that at most 0, 1, ... of so many values are under the quantile of a share."""
    k = np.arange(count)
    steps = np.log(np.maximum(count - k, 1)) - np.log(k + 1.0) + math.log(share / (1.0 - share))
    logs = count * math.log(1.0 - share) + np.concatenate([[0.0], np.cumsum(steps[:-1])])
    return np.asarray(np.minimum(np.cumsum(np.exp(logs)), 1.0))
