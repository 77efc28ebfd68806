# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many panels an accuracy takes: foretold by a coarse balloon at first, then by corrected ones.

The mean distance falls with a power of the number of panels: with the square for gores of a sphere, hardly
where thin or sharp parts decide. So the power is that between the two numbers that enclose what is asked.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.divide_flat import divide_flat
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.target_design.fit_target import TargetMode, fit_target
from BalloonWorkbench.core.target_design.panel_curve import NO_BALLOON, curve_point
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Progress, no_progress, part_of
from BalloonWorkbench.core.units import number_text, percent_text

#: So many panels are tried; the first guess is made from a coarse balloon of GUESS; balloons at most.
FEWEST, MOST, GUESS, TRIES = 4, 60, 12, 4
#: The power of the number of panels by which the mean distance falls, where it is not known better.
_POWER, _LEAST, _HIGHEST = 1.0, 0.3, 2.0
#: Fewer panels are not tried where they would save less than this part.
_WORTH = 0.1


@dataclass
class CountSearch:
    """Looks for the fewest panels that an accuracy takes.

    errors  the mean distances that numbers of panels gave, in parts of the diagonal
    """

    accuracy: float
    errors: dict[int, float] = field(default_factory=dict)

    @property
    def reaching(self) -> int | None:
        """The fewest panels that came near enough."""
        return min((count for count, error in self.errors.items() if error <= self.accuracy), default=None)

    @property
    def failing(self) -> int:
        """The most panels, fewer than those, that did not."""
        most = self.reaching or MOST + 1
        return max(
            (count for count, error in self.errors.items() if error > self.accuracy and count < most),
            default=FEWEST - 1,
        )

    def next(self) -> int | None:
        """The number to try next; None where no other is worth it."""
        low, high = self.failing, self.reaching
        if high is None:
            return None if low >= MOST else int(np.clip(self.foretold(low), low + 1, MOST))
        if high - low <= max(1.0, _WORTH * high):
            return None
        start = high if low not in self.errors else low
        return int(np.clip(self.foretold(start), low + 1, high - 1))

    def foretold(self, count: int) -> float:
        """How many panels it takes by the power law through a number that was tried, and another one."""
        known = {each: error for each, error in self.errors.items() if np.isfinite(error)}
        if count not in known:
            return 1.5 * count
        power = _POWER
        if len(known) > 1:
            other = min((each for each in known if each != count), key=lambda each: abs(each - count))
            slope = np.log(known[other] / known[count]) / np.log(count / other)
            power = float(np.clip(slope, _LEAST, _HIGHEST))
        return float(np.ceil(count * (known[count] / self.accuracy) ** (1.0 / power) - 1e-9))


def fit_body_to_accuracy(
    target: Target,
    accuracy: float,
    film: Film,
    pressure: float,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of the fewest panels that come so near to a body; the best one where none does.

    accuracy       mean distance, the larger of both ways, in parts of the diagonal
    pressure [Pa]; mesh_size [m] as in fit_target. Raises what divide_flat and fit_target raise.
    """
    if not 0.0 < accuracy < 1.0:
        raise InputError("The accuracy must be above 0 and below 1: 0.003 is within 0.3 % of the diagonal.")
    coarse = curve_point(
        target, GUESS, film, pressure, backend=backend, model=model, progress=part_of(progress, 0.0, 0.1)
    )
    guess = CountSearch(accuracy, {GUESS: coarse.error})
    count: int | None = int(np.clip(guess.foretold(GUESS), FEWEST, MOST))
    search, designs = CountSearch(accuracy), dict[int, BagDesign]()
    failed: BalloonError | None = None
    for number in range(TRIES):
        if count is None:
            break
        begin, end = (1.0 - 0.9 * 0.5**k for k in (number, number + 1))
        try:
            design = fit_target(
                divide_flat(target, count),
                film,
                pressure,
                mode=TargetMode(accuracy=accuracy),
                mesh_size=mesh_size,
                backend=backend,
                model=model,
                progress=part_of(progress, begin, end),
            )
        except NO_BALLOON as error:
            failed, search.errors[count] = error, float("inf")
        else:
            assert design.residual is not None
            designs[count], search.errors[count] = design, design.residual.mean / design.size
        count = search.next()
    if not designs:
        assert failed is not None
        raise failed
    best = search.reaching or min(designs, key=lambda each: (search.errors[each], each))
    return _judged(designs, best, search)


def _judged(designs: dict[int, BagDesign], best: int, search: CountSearch) -> BagDesign:
    """The best of the designs, with the work of all of them, and a sentence where it is not near enough."""
    design, warnings = designs[best], designs[best].warnings
    if search.reaching is None:
        tried = ", ".join(number_text(count) for count in sorted(search.errors))
        warnings = (
            *warnings,
            f"No balloon came within {percent_text(search.accuracy)} of the body's diagonal: tried were"
            f" {tried} panels. This is the nearest one, {percent_text(search.errors[best])}."
            " Ask for less, or divide the body yourself where the film stays far from it.",
        )
    return replace(
        design,
        passes=sum(each.passes for each in designs.values()),
        seconds=sum(each.seconds for each in designs.values()),
        warnings=warnings,
    )
