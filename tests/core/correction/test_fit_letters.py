# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters with holes inflate to the drawing: a closed curved tube that kinks would be far off."""

from __future__ import annotations

import pytest
from drawn_shapes import generated, letter

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.polyline import arc_lengths
from BalloonWorkbench.core.mesh.sizing import size_for

SHAPES = {name: letter(name) for name in ("B", "8")}
LIMIT = 0.006  # of the larger dimension, for the mean error


@pytest.mark.slow
@pytest.mark.parametrize("name", SHAPES)
def test_holes_inflate_to_the_drawing(name: str) -> None:
    drawing = SHAPES[name]
    mesh_size = size_for(drawing.map(lambda loop: 1.2 * loop), 800)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=mesh_size)
    assert design.inflation.report.converged
    assert len(design.silhouette.holes) == len(drawing.holes)
    assert design.residual.mean < LIMIT * max(drawing.size)
    assert design.residual.p95 < 3.0 * LIMIT * max(drawing.size)


@pytest.mark.slow
def test_small_holes_stay_open_and_keep_their_rim() -> None:
    """Film is taut round a hole, whose rim so needs the length that is drawn."""
    drawing = generated(19)
    mesh_size = size_for(drawing.map(lambda loop: 1.28 * loop), 800)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=mesh_size)
    assert design.inflation.report.converged
    assert design.residual.mean < 0.0015 * max(drawing.size)
    assert len(design.silhouette.holes) == 3
    for drawn, made in zip(drawing.holes, design.pattern.holes, strict=True):
        assert arc_lengths(made)[-1] == pytest.approx(arc_lengths(drawn)[-1], rel=0.05)
