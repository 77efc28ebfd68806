# SPDX-License-Identifier: LGPL-2.1-or-later
"""How wide a side band has to be for a balloon of a wanted thickness.

A long straight arm is a cylinder whatever its band is: it is as thick as it is drawn wide. A disc of diameter
D is 0.599 D thick with a band up to 0.311 D, and thicker by what a wider one has more. Letters lie between,
and where their arms meet they are thicker: so a few coarse balloons are corrected and measured.
"""

from __future__ import annotations

from contextlib import suppress

import numpy as np

from BalloonWorkbench.core.bag_design.band_fit import begun
from BalloonWorkbench.core.bags.mesh_bag import default_size
from BalloonWorkbench.core.bodies.banded import SideBand, banded_bag
from BalloonWorkbench.core.errors import InputError, MeshError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.units import length_text

VERTICES = 600
BALLOONS = 4  # of each width that is tried
LEAST, MOST = 0.5, (1.2, 0.95, 0.7)  # widths that are tried, of the mean width of the drawing's parts
TRIALS = 4  # between these
NEARLY = 0.01  # of the thickness
#: k = E t / (p L) of the balloons: film that hardly stretches, as most are.
_STIFFNESS, _PRESSURE, _FILM = 1000.0, 1000.0, 1e-5


def band_for_thickness(outline: Outline, thickness: float) -> float:
    """The width [m] of the side band with which the balloon of an outline becomes so thick [m], within 1 %.

    Raises InputError for a thickness that no band gives, with those that one does.
    """
    if not (np.isfinite(thickness) and thickness > 0.0):
        raise InputError(
            f"The balloon must be thicker than 0, not {length_text(thickness)}. Give its thickness."
        )
    target = check(outline)
    width = 2.0 * target.area / target.perimeter
    widths, reached = [LEAST * width], [_thickness(target, LEAST * width)]
    for share in MOST:
        with suppress(MeshError, SolverError):  # nothing is left of a thin part: a narrower band
            reached.append(_thickness(target, share * width))
            widths.append(share * width)
            break
    for _ in range(TRIALS):
        nearest = int(np.argmin(np.abs(np.array(reached) - thickness)))
        if abs(reached[nearest] - thickness) <= NEARLY * thickness:
            return widths[nearest]
        if not min(reached) < thickness < max(reached):
            break
        widths.append(_between(widths, reached, thickness))
        reached.append(_thickness(target, widths[-1]))
    nearest = int(np.argmin(np.abs(np.array(reached) - thickness)))
    if abs(reached[nearest] - thickness) <= 2.0 * NEARLY * thickness:
        return widths[nearest]
    low, high = length_text(min(reached), 2), length_text(max(reached), 2)
    raise InputError(
        f"With a side band the balloon of this drawing becomes {low} to {high} thick, not"
        f" {length_text(thickness, 2)}. Choose a thickness between, or draw its parts wider or narrower."
    )


def _between(widths: list[float], reached: list[float], thickness: float) -> float:
    """A width between the nearest ones on both sides, where a straight line has the thickness."""
    order = np.argsort(widths, kind="stable")
    x, y = np.array(widths)[order], np.array(reached)[order] - thickness
    step = int(np.flatnonzero(np.sign(y[:-1]) != np.sign(y[1:]))[-1])
    share = float(np.clip(y[step] / (y[step] - y[step + 1]), 0.1, 0.9))
    return float(x[step] + share * (x[step + 1] - x[step]))


def _thickness(target: Outline, band: float) -> float:
    """Of a coarse balloon with a band, nearly corrected [m]."""
    modulus = _STIFFNESS * _PRESSURE * max(target.size) / _FILM
    film = Film("film", modulus, 0.3, _FILM, 0.0, 0.0)
    edge = default_size(banded_bag(target, band), VERTICES)
    return begun(target, SideBand(band), film, _PRESSURE, edge).run(1.0, BALLOONS).thickness
