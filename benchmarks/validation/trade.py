# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trade data and inverse design."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from drawn_shapes import corners_of
from solver_cases import circle
from validation.balloons import meshed
from validation.report import Row, Section, section

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

INCH, FOOT = 0.0254, 0.3048
#: Air less helium, kg/m3, at 20 degrees and one atmosphere.
BUOYANCY = 1.204 - 0.166
AREAL_DENSITY = 0.0315  # kg/m2
HEART = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures" / "heart.png"
_PRESSURE = 2000.0


def trade() -> Section:
    """Section 10: party balloons."""
    foil = replace(film("mylar"), areal_density=AREAL_DENSITY)
    rows = []
    wide, high = (read_picture(HEART, *size) for size in ((18.0 * INCH, None), (None, 18.0 * INCH)))
    for what, outline, feet, lift in (
        ("18 inch circle", Outline(circle(9.0 * INCH)), 0.5, 4.2),
        ("24 inch circle", Outline(circle(12.0 * INCH)), 1.2, 13.0),
        ("heart 18 inches wide", wide, 0.4, None),
        ("heart 18 inches high", high, 0.4, None),
    ):
        volume, mass = _filled(outline, foil)
        rows.append(Row(f"{what}: volume, cubic feet", volume / FOOT**3, feet, 0.1, 3))
        if lift is not None:
            trade = BUOYANCY * feet * FOOT**3 - mass
            rows += [
                Row(f"{what}: lift, g", 1e3 * (BUOYANCY * volume - mass), lift, 0.1, 3),
                Row(f"{what}: lift of the trade's own volume, g", 1e3 * trade, lift, 0.1, 3),
            ]
    return section(
        "10. Trade data",
        f"""Mylar of {1e3 * AREAL_DENSITY:g} g/m^2 (the trade says 31 to 32) at 2 kPa, helium and air at
        20 degrees; the size is that of the flat balloon, sealed to its edge. Lift is a small difference:
        3 % of the volume are 11 % of the lift of an 18 inch circle. The published lift of the 24 inch circle
        does not fit its own volume: 1.2 cubic feet lift 35 g and two discs of that film weigh 18 g; 13 g
        would need 38 g/m^2. The heart is that of the example pictures; which heart the trade measures, and
        across what, is not known.""",
        rows,
    )


def inverse() -> Section:
    """Section 11: the growth of a pattern."""
    rows = []
    half, width = 0.6, 0.06
    strip = corners_of((-half, -width / 2), (half, -width / 2), (half, width / 2), (-half, width / 2))
    for words, seal_width in (("with a sealed band", 0.005), ("without", 0.0)):
        stiff = replace(custom_film(2.4e10, 0.3, 25e-6), seal_width=seal_width)
        disc = fit(Outline(circle(0.1)), stiff, 300.0, mesh_size=0.009)
        radius = np.sqrt(signed_area(disc.pattern.outer) / np.pi)
        pattern = fit(strip, stiff, 300.0).pattern.outer
        middle = pattern[np.abs(pattern[:, 0]) < 0.5 * half]
        grown = middle[middle[:, 1] > 0, 1].mean() - middle[middle[:, 1] < 0, 1].mean()
        rows += [
            Row(f"disc, {words}: radius of the pattern / drawn", float(radius / 0.1), 1.311028777, 0.003),
            Row(f"strip, {words}: width of the pattern / drawn", float(grown / width), np.pi / 2.0, 0.003),
        ]
    return section(
        "11. Inverse design",
        """Patterns found by the correction for a film that hardly stretches (k about 10 000). The strip is 20
        times as long as wide; its width is that of its middle half.""",
        rows,
    )


def _filled(outline: Outline, foil: Film) -> tuple[float, float]:
    """Volume [m3] and mass of both panels [kg]."""
    return inflate(meshed(outline), foil, _PRESSURE).volume, 2.0 * outline.area * foil.areal_density
