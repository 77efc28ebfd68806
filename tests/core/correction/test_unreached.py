# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be reached is told by its amount: as far as an independent inflation of the pattern is off."""

from __future__ import annotations

import re

import numpy as np
import pytest
from drawn_shapes import hole, polar

from BalloonWorkbench.core.correction.fit import SAMPLES, Method, fit
from BalloonWorkbench.core.correction.seam_map import SeamMap, seam_nodes
from BalloonWorkbench.core.design.compare import laid_over, residual
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.problem import NewtonSettings

MESH = 0.026  # m
FOLDING = {
    "hole": Outline(polar(0.15), (hole(0.01, 0.0, 0.0),)),
    "spot": Outline(polar(0.15), spots=(polar(0.01),)),
}


def off(design: Design, mesh: float) -> float:
    """Largest distance [m] between the drawing and the pattern as it is cut, inflated from flat."""
    panel = triangulate(faired_seam(design.pattern), mesh)
    balloon = inflate(panel, film("mylar"), 2000.0, settings=NewtonSettings(tolerance=1e-6))
    drawn = SeamMap.identity(design.target, max(design.target.size) / SAMPLES)
    seam_map = drawn.resized(design.pattern, 1.0)
    assert seam_map is not None
    nodes = zip(seam_nodes(seam_map, panel), seam_map.drawing, strict=True)
    placed = laid_over(balloon, np.concatenate([node.placed_on(loop) for node, loop in nodes]))
    return residual(design.target, silhouette(trimmed(placed))).max


@pytest.mark.parametrize("name", FOLDING)
def test_what_a_small_hole_or_spot_does_is_told_by_its_amount(name: str) -> None:
    """Round it the balloon folds, whatever its pattern: within 20 % of the worse of two other meshes."""
    design = fit(FOLDING[name], film("mylar"), 2000.0, mesh_size=MESH, method=Method(symmetric=False))
    largest = max(off(design, share * MESH) for share in (0.75, 0.65))
    assert largest > 0.03 * 0.3
    assert design.unreached[0].max == pytest.approx(largest, rel=0.2)
    sentence = next(text for text in design.warnings if text.startswith("Near"))
    measured = re.search(r"stays up to ([\d.]+) mm", sentence)
    assert measured is not None
    assert float(measured[1]) == pytest.approx(1e3 * largest, rel=0.2)
    assert "folds across a hole or a spot" in sentence
    away = np.abs(np.linalg.norm(design.unreached[0].place) - 0.15)
    assert design.unreached[0].loop or away < 1e-3  # a place of the drawing
