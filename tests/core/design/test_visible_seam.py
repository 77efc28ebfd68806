# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the seam: facets less than film, bulges more than the seam, nothing in a closed slit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cold_balloons import laid_on
from drawn_shapes import polar

from BalloonWorkbench.core.correction.fit import fit, inflate_outline
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed, visible_places
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"
STIFF = replace(custom_film(2.4e10, 0.3, 25e-6), seal_width=0.005)


@pytest.mark.parametrize("vertices", [300, 1200])
def test_a_trimmed_disc_is_nearer_to_the_exact_one(vertices: int) -> None:
    """Two discs of film that does not stretch: 1 / 1.31103 of their radius."""
    outline = Outline(polar(0.131102877))
    balloon = inflate(triangulate(outline, size_for(outline, vertices)), STIFF, 300.0)
    raw, film_like = (
        np.sqrt(signed_area(silhouette(one).outer) / np.pi) / 0.1 - 1.0 for one in (balloon, trimmed(balloon))
    )
    assert raw > 1e-3
    assert abs(film_like) < 0.75 * raw and abs(film_like) < 2e-3


@pytest.mark.slow
@pytest.mark.parametrize("name", ["star", "bear"])
def test_a_pattern_of_few_vertices_fits_the_drawing_on_many(name: str) -> None:
    """The pattern found on 600 vertices, simulated with nine times as many, still makes the drawing."""
    drawing = read_picture(PICTURES / f"{name}.png", 0.3, None)
    pattern = fit(drawing, film("mylar"), 2000.0, mesh_size=size_for(drawing, 430)).pattern
    check = inflate_outline(pattern, film("mylar"), 2000.0, mesh_size=size_for(pattern, 5400))
    shown = laid_on(check.silhouette, drawing)  # where the balloon lies is free
    assert residual(drawing, shown).mean < 0.0016 * max(drawing.size)


def test_seen_is_the_nearest_edge_of_the_silhouette() -> None:
    square = Outline(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]))
    points = np.array([[0.5, 0.01], [0.5, -0.01], [0.5, 0.3]])
    np.testing.assert_allclose(
        visible_places(points, square, 0.05), [[0.5, 0.0], [0.5, 0.0], [0.5, 0.3]], atol=1e-12
    )
