# SPDX-License-Identifier: LGPL-2.1-or-later
"""Symmetry of an outline: Automatic for pictures, Forced for anything, the pattern after it."""

from pathlib import Path

import numpy as np
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.outline.symmetry import EXACT, find_mirror

#: Corners lie on the nanometres of the engine's grid: each of a pair may be half of its diagonal away.
GRID = 1e-9 * 2.0**0.5
PICTURES = Path(__file__).parents[2] / "resources" / "examples" / "pictures"


def without_twin(obj, prefix):
    """Largest distance of a mirrored corner to the nearest corner, in m."""
    mirror = find_mirror(part_shapes.stored(obj, prefix))
    points = np.concatenate(part_shapes.stored(obj, prefix).loops)
    return max(float(np.linalg.norm(points - image, axis=1).min()) for image in mirror.reflect(points))


def test_a_picture_of_a_heart_gets_a_symmetric_pattern(doc):
    parts = create.balloon_from_picture(doc, PICTURES / "heart.png", width=200, mesh_size=14)
    assert parts.outline.Symmetry == "Automatic"
    assert parts.outline.SizeX.Value == pytest.approx(200, abs=1e-9)
    assert without_twin(parts.outline, "Loop") < GRID
    assert without_twin(parts.balloon, "Seam") < GRID
    seam = [tuple(point) for point in parts.balloon.SeamPoints]
    parts.outline.Symmetry = "Off"
    doc.recompute()
    assert without_twin(parts.outline, "Loop") > 1e-6
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert [tuple(point) for point in parts.balloon.SeamPoints] != seam


def test_a_sketch_is_made_symmetric_only_by_force(doc):
    lines = sketches.polygon((0, 0), (120, 0), (120, 80), (70, 80), (70, 120), (0, 120))
    parts = create.make(doc)
    parts.outline.Source = (sketches.sketch(doc, *lines), [])
    parts.outline.recompute()
    drawn = part_shapes.stored(parts.outline, "Loop")
    assert len(drawn.outer) == 6
    assert find_mirror(drawn).error > EXACT
    parts.outline.Symmetry = "Forced"
    parts.outline.recompute()
    assert parts.outline.Status == status.READY
    assert without_twin(parts.outline, "Loop") < GRID
    assert any("left one was kept" in note for note in parts.outline.Notes)
