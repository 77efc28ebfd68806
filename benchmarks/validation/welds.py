# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rings and other shapes by the weld: elastic, softer, and crumpling freely as a resolved strip."""

from __future__ import annotations

from dataclasses import replace

from cold_balloons import cold_balloon
from drawn_letters import letter_outline
from drawn_shapes import hole, polar, ring
from validation.correction import FILM, PICTURES, PRESSURE
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction.fit import VERTICES, fit
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.tracing.picture import read_picture

SHARES = (0.0, 0.03, 0.07, 0.13, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
SPOTS = (0.002, 0.01)  # radii of a spot weld in the middle of a disc [m]
SOFTER = (0.1, 0.01)  # of the rigidity that film and weld have where nothing crumples


def welds() -> Section:
    """One pattern for each shape, corrected with the elastic weld, blown up with every weld."""
    rows = []
    for name, outline in _outlines().items():
        design = fit(outline, FILM, PRESSURE)
        size = max(outline.size)
        cases = [(FILM, Model()), *((replace(FILM, weld_rigidity=share), Model()) for share in SOFTER)]
        cells = [f"{100 * design.residual.mean / size:.2f}, {100 * design.residual.max / size:.1f}"]
        for film, model in [*cases, (FILM, Model(weld="crumpled"))]:
            error = cold_balloon(outline, design.pattern, film, PRESSURE, VERTICES, model)[1]
            cells.append(f"{100 * error.mean / size:.2f}, {100 * error.max / size:.1f}")
        told = max((100 * stretch.max / size for stretch in design.unreached), default=0.0)
        rows.append((name, *cells, f"{told:.1f}" if told else ""))
    text = paragraphs(
        """A weld is a narrow beam of two films that resists bending in its plane, E I = 2 E t b^3 / 12 with b
        the width of weld and allowance: that is the elastic weld. The other bound is a weld that crumples
        freely, resolved as a strip of film in two layers of triangles (`core/solver/weld_strip.py`). A real
        weld lies between.

        Each pattern was corrected with the elastic weld; its balloon was then blown up anew with that weld,
        with a tenth and a hundredth of its rigidity, and with the weld that crumples: mean and greatest
        distance from the drawing, in per cent of the larger dimension. A ring's number is the width of its
        hole by its own. Told is the greatest distance that the design warns of."""
    )
    head = ("shape", "reported", "elastic", "a tenth", "a hundredth", "crumpling", "told")
    return Section("Rings, holes and spots by weld", text + "\n" + table(head, rows))


def _outlines() -> dict[str, Outline]:
    disc = polar(0.15)
    return {
        **{f"ring {share:g}" if share else "disc": ring(share) for share in SHARES},
        **{
            f"disc, spot of {1e3 * radius:g} mm": Outline(disc, spots=(hole(radius, 0.0, 0.0)[::6],))
            for radius in SPOTS
        },
        **{f"sans bold {sign}": letter_outline("sans bold", sign) for sign in "ODH"},
        **{name: read_picture(PICTURES / f"{name}.png", 0.3, None) for name in ("fish", "star", "heart")},
    }
