# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters with a side band inflate to the drawing; arms and discs against their closed forms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_letters import letter_outline
from drawn_shapes import corners_of

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.band_fit import fit_band
from BalloonWorkbench.core.bag_design.band_width import band_for_thickness
from BalloonWorkbench.core.bags.mesh_bag import mesh_bag
from BalloonWorkbench.core.bodies.banded import SideBand
from BalloonWorkbench.core.design.compare import laid_on, residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats

MYLAR, PRESSURE = film("mylar"), 2000.0
STIFF = Film("stiff", 1e11, 0.3, 1e-5, 0.0, seal_width=0.0)
A, B = 1.3110287771, 0.5990701174  # of the Mylar balloon
TURN = 2.0 * np.pi * np.arange(180) / 180
RADIUS, WIDTH = 0.15, 0.06
DISC = Outline(RADIUS * np.stack([np.cos(TURN), np.sin(TURN)], axis=1))
BAR = corners_of((0.0, 0.0), (0.4, 0.0), (0.4, WIDTH), (0.0, WIDTH))


def designed(outline: Outline, band: float, edge: float = 0.018, of: Film = MYLAR) -> BagDesign:
    return fit_band(outline, SideBand(band), of, PRESSURE, mesh_size=edge)


@pytest.mark.parametrize("band", [0.08])
def test_of_a_disc_front_and_half_of_the_band_are_the_mylar_balloon(band: float) -> None:
    design = designed(DISC, band, of=STIFF)
    pattern = np.linalg.norm(design.bag.panels[0].outer, axis=1)
    assert pattern.mean() == pytest.approx(A * RADIUS - 0.5 * band, rel=0.015)
    assert np.ptp(design.inflation.positions[:, 2]) == pytest.approx(2.0 * B * RADIUS, rel=0.02)
    assert design.residual is not None
    assert design.residual.mean < 0.005 * design.size  # its rim crumples


@pytest.mark.parametrize("band", [0.05])
def test_a_straight_arm_is_a_cylinder_as_wide_as_drawn(band: float) -> None:
    """Its face and the band together are half of the way round, so the face is cut narrower for more band."""
    design = designed(BAR, band, 0.013, STIFF)
    face = design.bag.panels[0].outer
    middle = face[np.abs(face[:, 0] - 0.2) < 0.05]
    assert np.ptp(middle[:, 1]) == pytest.approx(0.5 * np.pi * WIDTH - band, rel=0.03)
    places = design.inflation.positions
    section = places[np.abs(places[:, 0] - 0.2) < 0.05]
    assert np.ptp(section[:, 2]) == pytest.approx(WIDTH, rel=0.03)


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "limit"), [("O", 0.002), ("E", 0.005)])
def test_letters_look_as_drawn(sign: str, limit: float) -> None:
    """Also on a mesh that the design has not seen, from the assembly alone."""
    drawing = letter_outline("sans bold", sign)
    design = designed(drawing, 0.04)
    assert design.residual is not None
    assert design.residual.mean < limit * design.size
    assert len(design.bag.panels[0].holes) == len(drawing.holes)
    again = inflate(mesh_bag(design.bag, 0.016).assembly, MYLAR, PRESSURE)
    lying = replace(again, positions=lying_down(again))
    seen = silhouette(laid_on(lying, silhouette(lying), drawing))
    assert residual(drawing, seen).mean < 1.5 * limit * design.size


def lying_down(balloon: Inflation) -> Floats:
    """Places turned so that the front lies as near as may be to how it was cut (Kabsch)."""
    flat = balloon.panel.rest_positions
    own, goals = balloon.positions[: len(flat)], np.column_stack([flat, np.zeros(len(flat))])
    left, _, right = np.linalg.svd((own - own.mean(axis=0)).T @ (goals - goals.mean(axis=0)))
    left[:, 2] *= np.linalg.det(left @ right)
    return (balloon.positions - own.mean(axis=0)) @ left @ right + goals.mean(axis=0)


def test_a_symmetric_letter_has_a_symmetric_pattern() -> None:
    letter = corners_of(
        (0.0, 0.2), (0.09, 0.2), (0.09, 0.0), (0.15, 0.0), (0.15, 0.2), (0.24, 0.2), (0.24, 0.26), (0.0, 0.26)
    )
    face = designed(letter, 0.03).bag.panels[0].outer
    middle = 0.5 * (face[:, 0].min() + face[:, 0].max())
    mirrored = face * (-1.0, 1.0) + (2.0 * middle, 0.0)
    away = np.linalg.norm(mirrored[:, None] - face[None], axis=2).min(axis=1)
    assert away.max() < 1e-6


def test_the_design_is_that_of_its_own_bag_and_says_how_it_lies() -> None:
    design = fit_band(BAR, SideBand(0.03, 0.3), MYLAR, PRESSURE, mesh_size=0.015)
    assert max(float(np.ptp(panel.outer[:, 0])) for panel in design.bag.panels[2:]) <= 0.3
    assert len(design.bag.panels) == 6
    assert design.inflation.assembly is design.meshed.assembly
    assert design.meshed.bag is design.bag
    front = design.inflation.positions[: design.meshed.assembly.offsets[1]]
    assert front[:, 2].mean() > 0.3 * WIDTH
    assert design.inflation.positions[:, :2].mean(axis=0) == pytest.approx([0.2, 0.5 * WIDTH], abs=2e-3)
    assert design.passes > 2


def test_a_band_for_a_thickness_is_that_of_the_drum() -> None:
    wanted = 0.22
    band = band_for_thickness(DISC, wanted)
    assert band == pytest.approx(wanted + 2.0 * (A - 1.0 - B) * RADIUS, rel=0.05)


def test_an_arm_is_as_thick_as_it_is_wide_whatever_its_band() -> None:
    assert band_for_thickness(BAR, WIDTH) > 0.0
    with pytest.raises(InputError, match=r"becomes .* thick, not 120 mm"):
        band_for_thickness(BAR, 2.0 * WIDTH)
    with pytest.raises(InputError, match="thicker than 0"):
        band_for_thickness(BAR, 0.0)


def test_welds_inside_are_refused() -> None:
    welded = Outline(BAR.outer, welds=(np.array([[0.1, 0.03], [0.3, 0.03]]),))
    with pytest.raises(InputError, match="no welds inside"):
        designed(welded, 0.03)


def test_a_band_as_long_as_half_round_an_arm_is_refused() -> None:
    with pytest.raises(InputError, match=r"of 96 mm leaves nothing of the front, whose widest part is 60 mm"):
        designed(BAR, 0.096)
