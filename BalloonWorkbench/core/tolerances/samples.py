# SPDX-License-Identifier: LGPL-2.1-or-later
"""The samples of a tolerance study: what strays how far in each balloon that is looked at."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.tolerances.spread import ErrorSource, Spread, read_spread
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import number_text

SAMPLES, SEED = 200, 1
#: More than this many balloons by accident.
MOST_SAMPLES = 100_000
#: Shares of all cases between which a source is varied by itself.
LOW, HIGH = 0.05, 0.95
#: So many fields are laid along the seam by themselves, where one number cannot say what 5 % is.
FIELDS_ALONE = 40


@dataclass(frozen=True)
class Sample:
    """One balloon as it comes out of the workshop.

    name        "nominal", the number of the sample from 1, or which source strays by itself
    deviations  by source: from its nominal value, in SI units or as a share; of a seam's whole contour [m]
    fields      by source: the number of the field of errors along the seam
    alone       the only source that strays, None in the samples proper
    """

    name: str
    deviations: Mapping[ErrorSource, float] = field(default_factory=dict)
    fields: Mapping[ErrorSource, int] = field(default_factory=dict)
    alone: ErrorSource | None = None


@dataclass(frozen=True)
class Tolerances:
    """What strays how far; count: of samples; seed: of all that is random."""

    spreads: Mapping[ErrorSource, Spread]
    count: int = SAMPLES
    seed: int = SEED

    def samples(self) -> Iterator[Sample]:
        """The nominal balloon, the samples, then each source by itself between its 5 and 95 % points."""
        yield Sample("nominal")
        plain = [source for source, spread in self.spreads.items() if spread.along is None]
        along = [source for source in self.spreads if source not in plain]
        points = _points(self.count, len(plain), self.seed)
        for number, shares in enumerate(points, start=1):
            deviations = {
                source: self.spreads[source].at(float(share))
                for source, share in zip(plain, shares, strict=True)
            }
            yield Sample(str(number), deviations, dict.fromkeys(along, number))
        for source in plain:
            for share in (LOW, HIGH):
                name = f"{source.key} {number_text(100.0 * share)} %"
                yield Sample(name, {source: self.spreads[source].at(share)}, alone=source)
        for source in along:
            for number in range(1, min(self.count, FIELDS_ALONE) + 1):
                yield Sample(f"{source.key} {number}", fields={source: number}, alone=source)


def _points(count: int, sources: int, seed: int) -> Floats:
    """Points (count, sources) in the unit cube, evenly spread: Sobol's, shifted at random and wrapped round.

    More of them begin with the same ones (Cranley and Patterson, Randomization of number theoretic methods
    for multiple integration, SIAM Journal on Numerical Analysis 13, 1976, 904-914). None is 0 or 1.
    """
    if not sources:
        return np.zeros((count, 0))
    try:
        from scipy.stats import qmc
    except ImportError as error:
        raise without_scipy("Samples need scipy: install it with pip install scipy.") from error
    even = qmc.Sobol(sources, scramble=False).random_base2(int(np.ceil(np.log2(max(count, 2)))))[:count]
    shifted = (even + np.random.default_rng(seed).random(sources)) % 1.0
    return np.asarray(np.clip(shifted, 1e-9, 1.0 - 1e-9))


def read_tolerances(data: Any, count: Any = SAMPLES, seed: Any = SEED) -> Tolerances:
    """The tolerances that a study declares, by source; see `read_spread`. Raises InputError."""
    known = {source.key: source for source in ErrorSource}
    if not isinstance(data, Mapping) or not data:
        raise InputError('A study of tolerances says what strays, such as {"cut": {"normal": "0.2mm"}}.')
    if unknown := [key for key in data if key not in known]:
        raise InputError(f'Nothing strays that is called "{unknown[0]}": choose of {", ".join(known)}.')
    if not _is_whole(count) or not 1 <= count <= MOST_SAMPLES:
        raise InputError(
            f"A study of tolerances takes 1 to {MOST_SAMPLES} samples, not {count!r}: {SAMPLES} tell a lot."
        )
    if not _is_whole(seed) or seed < 0:
        raise InputError(f"The seed is a whole number from 0 up, not {seed!r}.")
    spreads = {source: read_spread(source, data[key]) for key, source in known.items() if key in data}
    return Tolerances(spreads, count, seed)


def _is_whole(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)
