# SPDX-License-Identifier: LGPL-2.1-or-later
"""A symmetric drawing gets a symmetric pattern."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED, corners_of, hole

from BalloonWorkbench.core.correction.fit import Method, fit
from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.correction.symmetric_pattern import pattern_symmetry
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.fairing import LIMIT
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.sampling import resample
from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import AUTO, Mirror, find_mirror, symmetric
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"


def designed(outline: Outline) -> Design:
    return fit(outline, film("mylar"), 2000.0, mesh_size=max(outline.size) / 18.0)


def picture(name: str) -> Outline:
    drawing = read_picture(PICTURES / f"{name}.png", 0.3, None)
    return symmetric(getattr(drawing, "largest", drawing), AUTO, drawn=True)


def away(outline: Outline, mirror: Mirror) -> float:
    """Largest distance from the mirror image of a corner to the nearest corner [m]."""
    points = np.concatenate(outline.loops)
    return max(float(np.linalg.norm(points - image, axis=1).min()) for image in mirror.reflect(points))


@pytest.mark.parametrize("name", ["heart", "butterfly", "rocket"])
def test_pattern_of_a_symmetric_picture_is_symmetric(name: str) -> None:
    drawing = picture(name)
    mirror = find_mirror(drawing)
    design = designed(drawing)
    assert design.reached
    assert away(design.pattern, mirror) < 1e-12
    assert residual(drawing, design.silhouette).mean < 0.003 * 0.3


def test_pattern_of_a_constructed_shape_at_an_angle_is_symmetric() -> None:
    """A wedge with two eyes beside its axis and a slot across it, turned by 33 degrees."""
    angle = np.radians(33.0)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    slot = corners_of((-0.06, -0.02), (-0.02, -0.02), (-0.02, 0.02), (-0.06, 0.02)).outer[::-1]
    drawing = Outline(
        corners_of((0.15, 0.0), (-0.1, 0.13), (-0.1, -0.13)).outer,
        (hole(0.012, -0.07, 0.065), hole(0.012, -0.07, -0.065), np.ascontiguousarray(slot)),
    ).map(lambda loop: loop @ turn)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=0.014)
    mirror = Mirror(np.zeros(2), angle, 0.0)
    assert len(design.pattern.holes) == 3
    assert away(design.pattern, mirror) < 1e-9


def test_welds_and_cuts_are_symmetric_within_their_simplification() -> None:
    drawing = picture("heart")
    mirror = find_mirror(drawing)
    pattern = build_pattern(designed(drawing).pattern, 0.005, PatternOptions(intake=False))
    for contour in pattern.contours:
        image = Outline(mirror.reflect(contour.points)[::-1])
        # each side within the limit of fairing, whose arcs end elsewhere on the other side
        assert residual(Outline(contour.points), image).max < 2.0 * LIMIT


def test_pattern_of_another_shape_is_left_alone() -> None:
    uneven = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.12, 0.1), (0.12, 0.2), (0.0, 0.2))
    free, held = (
        fit(uneven, film("mylar"), 2000.0, mesh_size=0.02, method=Method(symmetric=choice))
        for choice in (False, True)
    )
    assert free.pattern.outer.tobytes() == held.pattern.outer.tobytes()


def test_what_is_taken_back_crosses_nothing() -> None:
    """A strip 20 mm wide whose earlier place is 60 mm away: one side may not go back through the other."""
    strip = resample(corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.02), (0.0, 0.02)).outer, 0.002)
    now, earlier = SeamMap((strip,), (strip,)), SeamMap((strip,), (strip + np.array([0.0, 0.06]),))
    back = now.half_back(earlier, (0.15, 0.06), 0.005)
    assert first_crossing(back.pattern) is None
    assert not np.allclose(back.pattern[0], strip)


def test_halves_that_would_cross_go_back_together() -> None:
    """A bow tie whose two points are pulled past each other, on one side more than on the other."""
    drawing = corners_of((-0.1, -0.05), (0.1, -0.05), (0.02, 0.0), (0.1, 0.05), (-0.1, 0.05), (-0.02, 0.0))
    seam_map, pairs = pattern_symmetry(SeamMap.identity(drawing, 0.004), find_mirror(drawing))
    across = seam_map.pattern[0].copy()
    near = np.abs(seam_map.drawing[0][:, 1]) < 0.02
    left, right = near & (across[:, 0] < 0.0), near & (across[:, 0] > 0.0)
    across[left, 0] += 0.07
    across[right, 0] -= 0.03
    even = pairs.symmetrised(replace(seam_map, pattern=(across,)), seam_map)
    assert first_crossing(even.pattern) is None
    assert away(even.outline, find_mirror(drawing)) < 1e-12


def test_the_coarse_start_of_large_designs_stays_symmetric() -> None:
    """Fine meshes begin on coarse ones; the course is the same."""
    design = fit(NAMED["star"], film("mylar"), 2000.0, mesh_size=0.0075)
    assert away(design.pattern, Mirror(np.zeros(2), 0.5 * np.pi, 0.0)) < 1e-12


@pytest.mark.parametrize(("count", "mirrored"), [(2, False), (5, True), (12, False)])
def test_what_is_the_same_all_round_stays_so(count: int, mirrored: bool) -> None:
    """Polygons, and wheels of teeth that lean to one side."""
    angles = 2.0 * np.pi * np.arange(2 * count) / (2 * count) + 0.3
    lean = 0.0 if mirrored else 0.6 * np.pi / count
    turned = angles + lean * (np.arange(2 * count) % 2)
    radius = np.where(np.arange(2 * count) % 2, 0.11, 0.15)
    drawing = corners_of(*(radius * np.array([np.cos(turned), np.sin(turned)])).T)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=0.018)
    image = design.pattern.map(lambda loop: loop @ rotation(2.0 * np.pi / count))
    assert residual(design.pattern, image).max < 2e-5 * 0.3
    free = fit(drawing, film("mylar"), 2000.0, mesh_size=0.018, method=Method(symmetric=False)).pattern
    assert residual(free, free.map(lambda loop: loop @ rotation(2.0 * np.pi / count))).max > 2e-4 * 0.3
