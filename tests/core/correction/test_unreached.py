# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be reached is told by its amount: as far as an independent balloon of the pattern is off."""

from __future__ import annotations

import re

import numpy as np
import pytest
from cold_balloons import cold_balloon
from drawn_shapes import hole, polar

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.outline.outline import Outline

MESH = 0.02  # m
VERTICES = (700, 1000)  # of the independent balloons


def slit() -> Outline:
    """A disc with a slit 1 mm wide and 120 mm deep."""
    half = np.arcsin(0.0005 / 0.12)
    angle = np.linspace(0.5 * np.pi + half, 2.5 * np.pi - half, 400)
    return Outline(np.concatenate([polar(0.12, angle), [[0.0005, 0.0], [-0.0005, 0.0]]]))


FAR = {
    "spot": (Outline(polar(0.15), spots=(polar(0.01)[::6],)), "folds across a hole or a spot"),
    "slit": (slit(), "film cannot follow it there"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FAR)
def test_what_cannot_be_reached_is_told_by_its_amount(name: str) -> None:
    """Within 20 % of the worse of two balloons on other meshes."""
    drawing, reason = FAR[name]
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=MESH)
    made = [cold_balloon(design.target, design.pattern, film("mylar"), 2000.0, count) for count in VERTICES]
    largest = max(error.max for _, error in made)
    assert largest > 0.015 * 0.3
    assert design.unreached[0].max == pytest.approx(largest, rel=0.2)
    sentence = next(text for text in design.warnings if text.startswith("Near"))
    measured = re.search(r"stays up to ([\d.]+) mm", sentence)
    assert measured is not None
    assert float(measured[1]) == pytest.approx(1e3 * largest, rel=0.2)
    assert reason in sentence


@pytest.mark.slow
@pytest.mark.parametrize(("x", "most"), [(0.0, 0.012), (0.05, 0.001)])
def test_film_that_slides_along_the_rim_is_no_error(x: float, most: float) -> None:
    """Round a small hole the rim crumples more on one side; the outline stays where it is.

    In the middle it crumples to a side that the rounding of the processor chooses, so only beside it can
    another mesh tell the same.
    """
    drawing = Outline(polar(0.15), (hole(0.01, x, 0.0),))
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=MESH)
    assert design.residual.mean < most * 0.3
    if x:
        _, error = cold_balloon(drawing, design.pattern, film("mylar"), 2000.0, VERTICES[1])
        assert design.residual.mean == pytest.approx(error.mean, rel=0.2, abs=1e-4 * 0.3)
