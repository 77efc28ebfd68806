# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarse simulations of a balloon with holes: whether it stays in its plane, and its outline if welds crease.

No measure of the drawing alone tells: a small hole in the middle of a disc warps it, the same hole off the
middle or in a square does not.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from BalloonWorkbench.core.design.compare import Misfit, laid_over, misfit
from BalloonWorkbench.core.design.draft import rough_panel
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import BEYOND_WELD, Model
from BalloonWorkbench.core.solver.problem import NewtonSettings

PRESSURE = 2000.0  # Pa; the shape hardly depends on it
_VERTICES = 200  # in a panel; the height is then within a factor 1.5 (validation study)
_TWIST = 0.3  # a start that is plainly out of plane: the flat balloon is at rest, too, though not stably
#: Of its stiffness, what a creased weld is taken to keep: with much less every ring kinks, with more none.
CREASED = 0.03
_STEPS = 60  # in which a ring has kinked, if it does
#: How often that is tried, with patterns larger by so much.
_TRIES, _HAIR = 8, 1e-9


def seam_height(pattern: Outline, film: Film) -> float:
    """Height [m] by which the seam of a pattern leaves its plane."""
    panel = rough_panel(pattern, _VERTICES)
    both = inflate(panel, _plain(film), PRESSURE, model=Model(two_panels=True, twist=_TWIST))
    return float(np.ptp(both.positions[np.concatenate(panel.loops), 2]))


def creased_outlines(pattern: Outline, film: Film, seal_widths: tuple[float, ...]) -> list[Misfit]:
    """How far the outline of a pattern moves where its weld creases, for welds of some widths [m].

    From where it is with the first of these widths while that stays elastic. Each starts from the balloon
    that the one before has creased: a kinked ring and an even one may both be at rest, and which comes out of
    the flat film is an accident of mesh and rounding. So only a width that straightens a ring helps.
    """
    rigidities = [film.weld_rigidity * _stiffer(film, width) for width in seal_widths]
    creased = _first_creased(pattern, film, CREASED * rigidities[0])
    panel = creased.panel
    sound = inflate(panel, replace(_plain(film), weld_rigidity=rigidities[0]), PRESSURE)
    outline, rim = silhouette(sound), sound.positions[np.concatenate(panel.loops), :2]
    moved = [misfit(outline, silhouette(laid_over(creased, rim)))]
    for rigidity in rigidities[1:]:
        creased = _creased(panel, film, CREASED * rigidity, creased)
        moved.append(misfit(outline, silhouette(laid_over(creased, rim))))
    return moved


def _first_creased(pattern: Outline, film: Film, rigidity: float) -> Inflation:
    """The balloon from the flat film that is soon at rest.

    Rounding may lead it past that place to one far away, after many steps. Patterns that differ by less than
    a nanometre are tried then, so that another processor tells the same.
    """
    for number in range(_TRIES):
        grown = pattern.map(partial(np.multiply, 1.0 + _HAIR * number))
        creased = _creased(rough_panel(grown, _VERTICES), film, rigidity, None)
        if creased.report.converged:
            break
    return creased


def _stiffer(film: Film, seal_width: float) -> float:
    """How many times as stiff in its plane a weld of some width [m] is as the film's (seam_band.py)."""
    return ((seal_width + BEYOND_WELD) / (film.seal_width + BEYOND_WELD)) ** 3


def _creased(panel: Panel, film: Film, rigidity: float, start: Inflation | None) -> Inflation:
    weak = replace(_plain(film), weld_rigidity=rigidity)
    return inflate(panel, weak, PRESSURE, start=start, settings=NewtonSettings(max_steps=_STEPS))


def _plain(film: Film) -> Film:
    """Without its grain: two panels with a grain aslant are no mirror images."""
    return replace(film, young_modulus_across=None)
