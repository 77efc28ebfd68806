# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many gores a body needs: by a law at first, then by what its balloon turns out to be.

A flat gore of half width w on a body that bends by k along its meridian is wrong by about k w^2 on average:
its film cannot bend both ways. So n gores of half widths pi r / n are LAW pi^2 / n^2 times the mean over the
area of k r^2 away from the body of revolution: of its diagonal 16 %/n^2 for a sphere, 3.6 %/n^2 for one twice
as long as wide.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_fit import RisingPressure, body_size, fit_gores
from BalloonWorkbench.core.bodies.gores import FEWEST, GORE
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.vectors import turn
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Progress, no_progress, part_of
from BalloonWorkbench.core.units import length_text, number_text, percent_text

#: Measured with corrected gores of spheres, spheroids, airships, pears and eggs: 0.076 to 0.084.
LAW = 0.084
#: More gores are not tried for an accuracy; balloons in a row at most.
MOST_TRIED, TRIES = 60, 4


def expected_error(profile: Profile, count: int) -> float:
    """Mean distance from the body of revolution with so many gores, by the law, in parts of its diagonal."""
    steps = np.diff(profile.points, axis=0)
    lengths, radii = np.linalg.norm(steps, axis=1), 0.5 * (profile.points[1:, 0] + profile.points[:-1, 0])
    bent = float(np.abs(turn(steps[:-1], steps[1:])) @ profile.points[1:-1, 0] ** 3)
    return LAW * (np.pi / count) ** 2 * bent / float(lengths @ radii) / body_size(profile)


def gores_needed(profile: Profile, accuracy: float) -> int:
    """As many gores as a mean distance of so many parts of the diagonal takes by the law. InputError."""
    if not 0.0 < accuracy < 1.0:
        raise InputError("The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.")
    needed = np.ceil(np.sqrt(expected_error(profile, 1) / accuracy) - 1e-9)
    return int(np.clip(needed, FEWEST, MOST_TRIED))


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
        count = int(np.clip(np.ceil(count * np.sqrt(error / accuracy)), count + 1, MOST_TRIED))
    return judged(replace(design, passes=passes, seconds=seconds), accuracy)


def judged(design: BagDesign, accuracy: float) -> BagDesign:
    """The design of a body of gores with whether it is as near to its profile as was asked for."""
    assert isinstance(design.source, Profile) and design.residual is not None
    error = design.residual.mean / design.size
    count = sum(panel.name.startswith(GORE) for panel in design.bag.panels)
    if error <= accuracy:
        return design
    needed = max(int(np.ceil(count * np.sqrt(error / accuracy))), count + 1)
    hint = f"Take {needed} gores." if needed <= MOST_TRIED else "More gores hardly help: change the profile."
    warning = (
        f"The balloon of {number_text(count)} gores is {percent_text(error)} of its diagonal away from the"
        f" profile on average, and {percent_text(accuracy)} was asked for: its seams stand out by up to"
        f" {length_text(design.apart, 3)} over the middle of the gores. {hint}"
    )
    return replace(design, reached=False, warnings=(*design.warnings, warning))
