# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many gores a body needs: by a law at first, then by what its balloon turns out to be.

A flat gore of half width w on a body that bends by k along its meridian is wrong by about k w^2 on average:
its film cannot bend both ways. So n gores of half widths pi r / n are LAW pi^2 / n^2 times the mean over the
area of k r^2 away from the body of revolution: of its diagonal 16 %/n^2 for a sphere, 3.6 %/n^2 for one twice
as long as wide. At a disc of radius R the corners of the gores fold in, which is DISC_LAW pi R / n on about
R^2 of film.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_fit import ENOUGH, RisingPressure, body_size, fit_gores
from BalloonWorkbench.core.bodies.gores import FEWEST, gores_of
from BalloonWorkbench.core.bodies.profile import DISC, Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import turn
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Progress, no_progress, part_of
from BalloonWorkbench.core.units import length_text, number_text, percent_text

#: Measured with corrected gores of spheres, spheroids, airships, pears and eggs: 0.076 to 0.084.
LAW = 0.084
#: Measured with corrected gores of cones, drums and bottles: 0.008 to 0.015.
DISC_LAW = 0.015
_PARTS = 80  # of a profile, whose bends the law adds up
#: More gores are not tried for an accuracy; balloons in a row at most.
MOST_TRIED, TRIES = 60, 4


def expected_error(profile: Profile, count: int) -> float:
    """Mean distance from the body of revolution with so many gores, by the law, in parts of its diagonal."""
    bent, discs = _law(profile)
    return max(bent / count**2 + discs / count, ENOUGH)  # where the correction ends


def gores_needed(profile: Profile, accuracy: float) -> int:
    """As many gores as a mean distance of so many parts of the diagonal takes by the law. InputError."""
    if not 0.0 < accuracy < 1.0:
        raise InputError("The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.")
    return int(np.clip(_count(profile, accuracy), FEWEST, MOST_TRIED))


def _law(profile: Profile) -> tuple[float, float]:
    """What the square of the number of gores, and what their number divides, in parts of the diagonal."""
    whole = line_lengths(profile.points)
    line = point_on(profile.points, whole, np.linspace(0.0, whole[-1], _PARTS + 1))  # noise is no bend
    steps = np.diff(line, axis=0)
    lengths, radii = np.linalg.norm(steps, axis=1), 0.5 * (line[1:, 0] + line[:-1, 0])
    bent = float(np.abs(turn(steps[:-1], steps[1:])) @ line[1:-1, 0] ** 3)
    rims = [profile.points[end, 0] for end, kind in ((0, profile.lower), (-1, profile.upper)) if kind == DISC]
    film = float(lengths @ radii) * body_size(profile)
    return LAW * np.pi**2 * bent / film, DISC_LAW * np.pi * sum(float(rim) ** 3 for rim in rims) / film


def _count(profile: Profile, accuracy: float) -> int:
    """The fewest gores that have an accuracy by the law."""
    bent, discs = _law(profile)
    return int(np.ceil((discs + np.sqrt(discs**2 + 4.0 * bent * accuracy)) / (2.0 * accuracy) - 1e-9))


def _more(profile: Profile, count: int, error: float, accuracy: float) -> int:
    """How many gores an accuracy takes where so many have an error: by the law, made to fit that."""
    law = expected_error(profile, count)
    return max(count + 1, _count(profile, accuracy * law / error))


def fit_to_accuracy(
    profile: Profile,
    accuracy: float,
    film: Film,
    pressure: float | RisingPressure,
    *,
    mesh_size: float | None = None,
    backend: str | None = None,
    model: Model | None = None,
    progress: Progress = no_progress,
) -> BagDesign:
    """The balloon of as few gores as an accuracy takes: as many as the law says, more where they do not do.

    accuracy  mean distance from the body of revolution, in parts of its diagonal
    Raises what gores_needed and fit_gores raise.
    """
    count, passes, seconds = gores_needed(profile, accuracy), 0, 0.0
    for number in range(TRIES):
        part = part_of(progress, 1.0 - 0.4**number, 1.0 - 0.4 ** (number + 1))
        design = fit_gores(
            profile, count, film, pressure, mesh_size=mesh_size, backend=backend, model=model, progress=part
        )
        passes, seconds = passes + design.passes, seconds + design.seconds
        assert design.residual is not None
        error = design.residual.mean / design.size
        if error <= accuracy or count >= MOST_TRIED:
            break
        count = min(_more(profile, count, error, accuracy), MOST_TRIED)
    return judged(replace(design, passes=passes, seconds=seconds), accuracy)


def judged(design: BagDesign, accuracy: float) -> BagDesign:
    """The design of a body of gores with whether it is as near to its profile as was asked for."""
    assert isinstance(design.source, Profile) and design.residual is not None
    error = design.residual.mean / design.size
    count = gores_of(design.bag, design.source)
    if error <= accuracy:
        return design
    needed = _more(design.source, count, error, accuracy)
    hint = f"Take {needed} gores." if needed <= MOST_TRIED else "More gores hardly help: change the profile."
    warning = (
        f"The balloon of {number_text(count)} gores is {percent_text(error)} of its diagonal away from the"
        f" profile on average, and {percent_text(accuracy)} was asked for: its seams stand out by up to"
        f" {length_text(design.apart, 3)} over the middle of the gores. {hint}"
    )
    return replace(design, reached=False, warnings=(*design.warnings, warning))
