# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters with holes inflate to the drawing: a closed curved tube that kinks would be far off."""

from __future__ import annotations

import pytest
from drawn_shapes import LETTERS, NAMED, letter

from BalloonWorkbench.core.design.fit import fit
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.outline.outline import Outline

SHAPES: dict[str, Outline] = {**{name: letter(name) for name in LETTERS}, "ring": NAMED["ring"]}
#: The narrow triangle in an A needs a finer mesh than the others.
VERTICES = {"A": 1500}


@pytest.mark.parametrize("name", SHAPES)
def test_holes_inflate_to_the_drawing(name: str) -> None:
    drawing = SHAPES[name]
    mesh_size = size_for(drawing.map(lambda loop: 1.2 * loop), VERTICES.get(name, 800))
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=mesh_size)
    assert design.inflation.report.converged
    assert len(design.silhouette.holes) == len(drawing.holes)
    assert design.residual.mean < 0.006 * max(drawing.size)
    assert design.residual.p95 < 0.015 * max(drawing.size)
