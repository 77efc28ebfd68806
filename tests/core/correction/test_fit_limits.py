# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a corrected pattern keeps: room for the cutter, smoothness, its sanity where film cannot follow."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED, generated

from BalloonWorkbench.core.correction.clearance import enforce_clearance
from BalloonWorkbench.core.correction.fit import Method, fit
from BalloonWorkbench.core.design.compare import far_stretches, misfit, residual
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.initial_pattern import initial_displacements
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at, signed_area
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pictures.preview import preview_png
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"


def circle(radius: float, count: int = 3000) -> np.ndarray:
    angle = 2.0 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


# First pattern


def test_first_pattern_of_a_disc_and_of_an_arm() -> None:
    """A disc grows by 1.311, an arm by pi / 2 across and hardly along."""
    disc = triangulate(Outline(circle(0.1, 240)), 0.01)
    rim = (disc.rest_positions + initial_displacements(disc))[disc.loops[0]]
    assert np.sqrt(signed_area(rim) / np.pi) / 0.1 == pytest.approx(1.311028777, rel=0.02)
    arm = triangulate(NAMED["rectangle"].map(lambda loop: loop * (1.0, 0.5)), 0.006)  # 300 x 50 mm
    before, after = arm.rest_positions, arm.rest_positions + initial_displacements(arm)
    middle = np.abs(before[:, 0] - 0.15) < 0.05
    upper, lower = (middle & (np.abs(before[:, 1] - side) < 1e-9) for side in (0.05, 0.0))
    across = after[upper, 1].mean() - after[lower, 1].mean()
    assert across / 0.05 == pytest.approx(np.pi / 2, rel=0.06)


def test_first_pattern_keeps_the_hole_of_a_ring() -> None:
    """Round its hole a ring is taut: there it may not shrink, and hardly has to grow."""
    ring = triangulate(NAMED["ring"], 0.012)
    hole = (ring.rest_positions + initial_displacements(ring))[ring.loops[1]]
    assert np.sqrt(-signed_area(hole) / np.pi) == pytest.approx(0.075, rel=0.05)


# The same answer on any mesh


@pytest.mark.slow
def test_few_and_many_vertices_give_the_same_pattern() -> None:
    """All pictures, and 5000 vertices: benchmarks/validation/accidents.py."""
    drawing = read_picture(PICTURES / "fish.png", 0.3, None)
    grown_drawing = drawing.map(lambda loop: 1.28 * loop)
    few, many = (
        fit(drawing, film("mylar"), 2000.0, mesh_size=size_for(grown_drawing, count)) for count in (600, 1500)
    )
    # the balloon that is shown is blown up on a somewhat finer mesh than the pattern was found on
    assert len(few.inflation.panel.rest_positions) < 1000
    assert len(many.inflation.panel.rest_positions) > 1320
    # where the pattern lies on the table is free
    rotation, shift = alignment(few.pattern.outer, many.pattern.outer, np.ones(len(few.pattern.outer)))
    laid = few.pattern.map(lambda loop: loop @ rotation.T + shift)
    size = max(drawing.size)
    assert residual(laid, many.pattern).mean < 0.002 * max(many.pattern.size)
    assert residual(few.silhouette, many.silhouette).mean < 0.002 * size


# Smoothness


def short_waves(loop: np.ndarray, below: float) -> float:
    """Share of the energy of a loop's curvature in waves from a quarter of `below` to `below` [m]."""
    count = 4096
    lengths = arc_lengths(loop)
    points = point_at(loop, lengths, lengths[-1] * np.arange(count) / count)
    along = np.roll(points, -1, axis=0) - points
    heading = np.unwrap(np.arctan2(along[:, 1], along[:, 0])) - 2.0 * np.pi * np.arange(count) / count
    waves = np.arange(count // 2 + 1)
    curvature = 2.0 * np.abs(np.fft.rfft(heading)) / count * waves  # in that of a circle of this length
    length = lengths[-1] / np.maximum(waves, 1)
    short = (length < below) & (length > 0.25 * below)
    energy = curvature**2
    return float(energy[short].sum() / (2.0 + energy[waves > 0].sum()))


def mean_edge(design: Design) -> float:
    seam = design.inflation.panel.rest_positions[design.inflation.panel.loops[0]]
    return float(arc_lengths(seam)[-1] / len(seam))


@pytest.mark.parametrize(
    "drawing",
    [
        pytest.param(Outline(circle(0.15)), id="disc"),
        pytest.param(generated(10), id="blob"),
    ],
)
def test_pattern_of_a_smooth_drawing_has_no_waves_of_the_mesh(drawing: Outline) -> None:
    """Waves shorter than three mesh edges hold less than 0.2 % of the energy of the curvature."""
    design = fit(
        drawing, film("mylar"), 2000.0, mesh_size=size_for(drawing.map(lambda loop: 1.28 * loop), 700)
    )
    edge = mean_edge(design)
    assert short_waves(drawing.outer, 3.0 * edge) < 1e-3  # not the drawing's own
    assert short_waves(design.pattern.outer, 3.0 * edge) < 2e-3


def test_waves_of_the_mesh_would_be_seen() -> None:
    angle = 2.0 * np.pi * np.arange(3000) / 3000
    wavy = circle(0.15) * (1.0 + 1e-3 * np.cos(60.0 * angle))[:, None]
    assert short_waves(wavy, 0.03) > 0.5


# Room for weld and cut


def gap_between(loop: np.ndarray, left: float, right: float, height: float) -> float:
    """Smallest distance between the two sides of a bay, above `height`."""
    near = loop[(loop[:, 1] > height) & (loop[:, 0] > left) & (loop[:, 0] < right)]
    middle = 0.5 * (left + right)
    return float(near[near[:, 0] > middle, 0].min() - near[near[:, 0] < middle, 0].max())


def test_bays_keep_room_for_two_welds_and_a_cut() -> None:
    """Two arms 26 mm apart would grow to 9 mm; the cutter needs 2 (5 + 2) + 1 = 15 mm between the seams."""
    bay = [(0.0, 0.0), (0.126, 0.0), (0.126, 0.1), (0.076, 0.1), (0.076, 0.06), (0.05, 0.06), (0.05, 0.1)]
    drawing = Outline(np.array([*bay, (0.0, 0.1)]))
    sampled = point_at(drawing.outer, np.arange(9.0), np.arange(0.0, 8.0, 0.02))
    narrow = sampled + np.where(sampled[:, :1] < 0.063, (0.008, 0.0), (-0.008, 0.0))
    pushed = Outline(enforce_clearance((sampled,), (narrow,), 0.015)[0])
    assert gap_between(narrow, 0.05, 0.076, 0.08) == pytest.approx(0.010)
    assert gap_between(pushed.outer, 0.05, 0.076, 0.08) == pytest.approx(0.015, rel=0.05)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=0.012)
    contours = build_pattern(design.pattern, 0.005, PatternOptions(intake=False))
    assert len(contours.contours) == 2  # one weld and one cut: no bay is closed by them


@pytest.mark.parametrize("seed", [2, 7])
def test_patterns_of_generated_outlines_are_valid(seed: int) -> None:
    """No crossings, no needles: the pattern turns back on itself nowhere but at the drawing's corners."""
    drawing = generated(seed)
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=0.014)
    assert first_crossing(design.pattern.loops) is None
    assert signed_area(design.pattern.outer) > signed_area(drawing.outer)
    loop = design.pattern.outer
    lengths = arc_lengths(loop)
    points = point_at(loop, lengths, np.arange(0.0, lengths[-1], 0.0005))
    ahead = np.roll(points, -1, axis=0) - points
    turn = np.angle((ahead[:, 0] + 1j * ahead[:, 1]) / np.roll(ahead[:, 0] + 1j * ahead[:, 1], 1))
    # a turn of more than 1 rad along 0.5 mm is a corner: radius below 0.5 mm
    assert np.count_nonzero(np.abs(turn) > 1.0) <= len(drawing.outer)
    build_pattern(design.pattern, 0.005)


# Where film cannot follow


@pytest.fixture(scope="module")
def slit() -> Design:
    """A disc with a slit 1 mm wide and 120 mm deep, whose sides film lays over each other."""
    half = np.arcsin(0.0005 / 0.12)
    angle = np.linspace(0.5 * np.pi + half, 2.5 * np.pi - half, 400)
    rim = 0.12 * np.column_stack([np.cos(angle), np.sin(angle)])
    drawing = Outline(np.concatenate([rim, [[0.0005, 0.0], [-0.0005, 0.0]]]))
    return fit(drawing, film("mylar"), 2000.0, mesh_size=0.014, method=Method(symmetric=False))


def test_what_cannot_be_reached_is_marked(slit: Design) -> None:
    worst = slit.unreached[0]
    assert abs(worst.place[0]) < 0.005 and -0.01 < worst.place[1] < 0.1
    assert worst.loop == 0 and worst.end - worst.start > 0.05
    assert worst.max > 0.02 and 0.0 < worst.mean < worst.max
    assert any("film cannot follow it there" in text for text in slit.warnings)


def test_the_rest_of_the_outline_is_not_distorted(slit: Design) -> None:
    apart = misfit(slit.target, slit.silhouette)
    loop = slit.target.outer
    lengths = arc_lengths(loop)
    places = point_at(loop, lengths, apart.share * lengths[-1])
    elsewhere = (np.abs(places[:, 0]) > 0.03) | (places[:, 1] < -0.03)
    assert apart.distances[elsewhere].mean() < 0.003 * max(slit.target.size)
    assert first_crossing(slit.pattern.loops) is None
    # far from the slit it is the pattern of a disc
    below = slit.pattern.outer[slit.pattern.outer[:, 1] < slit.pattern.outer[:, 1].min() + 0.12]
    assert np.ptp(below[:, 0]) / 0.24 == pytest.approx(1.311, rel=0.06)


def test_a_reached_drawing_has_no_marks() -> None:
    outline = Outline(circle(0.1))
    assert far_stretches(outline, misfit(outline, Outline(circle(0.1005)))) == ()


def test_a_stretch_over_the_start_of_a_loop_is_one() -> None:
    """A bump of 10 mm, 40 mm to either side of the loop's first point."""
    drawing = Outline(circle(0.1))
    angle = np.arctan2(drawing.outer[:, 1], drawing.outer[:, 0])
    bump = 1.0 + 0.1 * np.clip(1.0 - (angle / 0.4) ** 2, 0.0, None)
    (found,) = far_stretches(drawing, misfit(drawing, Outline(drawing.outer * bump[:, None])))
    assert found.max == pytest.approx(0.01, rel=0.01)
    assert found.end > 0.2 * np.pi > found.start
    assert found.end - found.start == pytest.approx(0.075, rel=0.1)
    np.testing.assert_allclose(found.place, (0.1, 0.0), atol=2e-3)


def test_the_preview_shows_what_is_not_reached(slit: Design) -> None:
    from matplotlib.image import imread

    picture = imread(io.BytesIO(preview_png([slit], [build_pattern(slit.pattern, 0.005)])))
    yellow = (picture[..., 0] > 0.85) & (picture[..., 2] < 0.4) & (picture[..., 1] > 0.6)
    assert np.count_nonzero(yellow) > 100
