# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a design promises is what is made: its pattern meshed anew and blown up from the flat film.

Short forms of the tables of `make validation`.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from cold_balloons import VERTICES, cold_balloon, laid_on
from drawn_letters import letter_outline
from drawn_shapes import snail

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"
MYLAR = film("mylar")
PRESSURE = 2000.0


def designed(drawing: Outline, vertices: int | None = None) -> Design:
    size = None if vertices is None else size_for(drawing.map(lambda loop: 1.28 * loop), vertices)
    return fit(drawing, MYLAR, PRESSURE, mesh_size=size)


def made(design: Design) -> float:
    """Mean error of the balloon that is made, of the larger dimension."""
    _, error = cold_balloon(design.target, design.pattern, MYLAR, PRESSURE, VERTICES[0])
    return error.mean / max(design.target.size)


@pytest.mark.slow
def test_what_is_promised_is_made() -> None:
    design = designed(letter_outline("sans bold", "O"))
    promised, found = design.residual.mean / max(design.target.size), made(design)
    assert found <= 1e-3
    assert found == pytest.approx(promised, abs=5e-4)


@pytest.mark.slow
def test_a_snail_keeps_its_feelers() -> None:
    assert made(designed(snail())) <= 2e-3


# Accidents


def waved(outline: Outline, share: float) -> Outline:
    """Drawn otherwise in waves half as long as the drawing, by a share of the size."""
    size = max(outline.size)

    def moved(loop: Floats) -> Floats:
        return loop + share * size * np.sin(4.0 * np.pi * loop[:, ::-1] / size + (1.0, 2.0))

    return outline.map(moved)


@pytest.mark.slow
def test_accidents_do_not_decide() -> None:
    """Another 0.1 % of the drawing, another first point, a coarser mesh: the same balloon."""
    drawing = letter_outline("sans bold", "S")
    usual = designed(drawing, 900)
    other = designed(waved(drawing, 1e-3).map(lambda loop: np.roll(loop, 7, axis=0)), 700)
    assert made(other) == pytest.approx(made(usual), abs=5e-4)
    laid = laid_on(other.pattern, usual.pattern)
    assert residual(usual.pattern, laid).mean < 2e-3 * max(drawing.size)
