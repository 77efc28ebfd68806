# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of lines and arcs: against formulas, and against shapely's distances to the polyline."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated, polar

from BalloonWorkbench.core.arcs.curves import Curve, Segment, polyline
from BalloonWorkbench.core.arcs.fit_arcs import TOLERANCE, fit_curve
from BalloonWorkbench.core.job import Settings, make_balloon
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Role

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"
FINE = 5e-7  # m, far below what is measured


def line(points: np.ndarray, closed: bool) -> shapely.LineString:
    return shapely.LinearRing(points) if closed else shapely.LineString(points)


def apart(curve: Curve, points: np.ndarray) -> float:
    """The largest distance between curve and polyline, both ways [m]."""
    drawn, given = line(curve.flattened(FINE), curve.closed), line(points, curve.closed)
    ways = ((drawn, given), (given, drawn))
    return max(
        float(shapely.distance(shapely.points(np.array(a.segmentize(3e-4).coords)), b).max()) for a, b in ways
    )


def kinks(curve: Curve) -> np.ndarray:
    """Turning at the joints inside or all round [rad], from the ends of the flattened arcs."""
    first, last = curve.headings
    turns = np.abs(np.angle(np.exp(1j * (first - np.roll(last, 1)))))
    return turns if curve.closed else turns[1:]


def rounded(width: float, height: float, radius: float, step: float) -> np.ndarray:
    quarter = np.radians(np.arange(0.0, 90.0 + step / 2, step))
    corners = [
        (width - radius, radius),
        (width - radius, height - radius),
        (radius, height - radius),
        (radius, radius),
    ]
    return np.concatenate(
        [np.array(at) + polar(radius, quarter - np.pi / 2 + k * np.pi / 2) for k, at in enumerate(corners)]
    )


def circle_of(points: int, radius: float) -> np.ndarray:
    return polar(radius, np.linspace(0.0, 2.0 * np.pi, points, endpoint=False)) + 0.2


@pytest.mark.parametrize(("points", "radius"), [(24, 0.003), (24, 0.15), (90, 0.15)])
def test_a_coarse_polygon_is_no_circle(points: int, radius: float) -> None:
    """The middle of each side is further from the circle than the tolerance: the curve keeps to the sides."""
    assert radius * (1.0 - np.cos(np.pi / points)) > TOLERANCE
    loop = circle_of(points, radius)
    curve = fit_curve(loop, True)
    assert len(curve) > 4
    assert apart(curve, loop) <= TOLERANCE


@pytest.mark.parametrize(("points", "radius"), [(90, 0.003), (720, 0.003), (720, 0.15)])
def test_circle_is_a_few_arcs(points: int, radius: float) -> None:
    loop = circle_of(points, radius)
    curve = fit_curve(loop, True)
    assert len(curve) <= 4
    assert not curve.corners.any()
    assert curve.radii == pytest.approx(np.full(len(curve), radius), abs=0.3 * TOLERANCE)
    assert curve.length == pytest.approx(2.0 * np.pi * radius, rel=1e-3)
    assert apart(curve, loop) <= TOLERANCE


@pytest.mark.parametrize("step", [2.0, 5.0])
def test_rounded_rectangle_is_four_lines_and_four_arcs(step: float) -> None:
    curve = fit_curve(np.roll(rounded(0.12, 0.08, 0.01, step), 7, axis=0), True)
    lines = curve.bulges == 0.0
    assert lines.sum() <= 5  # one may be divided where the curve begins
    assert (~lines).sum() <= 5
    assert curve.radii[~lines] == pytest.approx(np.full((~lines).sum(), 0.01), rel=1e-6)
    assert np.abs(curve.turns[~lines]).sum() == pytest.approx(2.0 * np.pi)
    assert kinks(curve).max() < 1e-6
    area = shapely.Polygon(curve.flattened(1e-9)).area
    assert area == pytest.approx(0.12 * 0.08 - (4.0 - np.pi) * 0.01**2, rel=1e-6)


@pytest.mark.parametrize("name", ["square", "star", "spiky", "L", "wedge"])
def test_polygons_stay_as_they_are(name: str) -> None:
    """As they are, and begun amid an edge where the contour began."""
    corners = NAMED[name].outer
    loop = np.concatenate([0.5 * (corners[:1] + corners[-1:]), corners])
    curve = fit_curve(loop, True)
    assert not curve.bulges.any()
    assert np.array_equal(curve.joints, loop)
    assert list(curve.corners) == [False, *[True] * len(corners)]


@pytest.mark.parametrize("name", ["disc", "heart", "flower", "S", "neck", "ring"])
def test_smooth_patterns(name: str) -> None:
    """Two-way distance, smooth joints, exact ends, far fewer segments than points."""
    for contour in build_pattern(NAMED[name], 0.005).contours:
        curve = fit_curve(contour.points, contour.closed)
        assert apart(curve, contour.points) <= 1.01 * TOLERANCE
        inner = curve.corners if contour.closed else curve.corners[1:-1]
        assert kinks(curve)[~inner].max(initial=0.0) < np.radians(0.1)
        assert len(curve) < 0.2 * len(contour.points)
        if not contour.closed:
            assert curve.joints[[0, -1]] == pytest.approx(contour.points[[0, -1]], abs=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 2, 3, 4, 5, 8, 9, 14])
def test_generated_patterns(seed: int) -> None:
    for contour in build_pattern(generated(seed), 0.005).contours:
        curve = fit_curve(contour.points, contour.closed)
        assert apart(curve, contour.points) <= 1.01 * TOLERANCE
        inner = curve.corners if contour.closed else curve.corners[1:-1]
        assert kinks(curve)[~inner].max(initial=0.0) < np.radians(0.1)


def test_a_polygon_that_begins_in_a_corner_has_no_empty_edge() -> None:
    for shift in ((0.0, 0.0), (0.3070046, 0.0101)):
        box = np.array([[0.034, 0.0], [0.034, 0.1], [0.0, 0.1], [0.0, 0.0]]) + shift
        curve = fit_curve(box, True)
        assert len(curve) == 4
        assert curve.lengths == pytest.approx([0.1, 0.034, 0.1, 0.034])


def test_corners_are_kept_exactly() -> None:
    """Two half circles that meet in two tips."""
    side = polar(0.1, np.radians(np.linspace(60, 120, 61)))[:-1] - [0.0, 0.1 * np.sin(np.pi / 3.0)]
    lens = np.concatenate([side, -side])
    curve = fit_curve(np.roll(lens, 30, axis=0), True)
    sharp = curve.joints[curve.corners]
    assert len(sharp) == 2
    for tip in lens[[0, 60]]:
        assert np.abs(sharp - tip).sum(axis=1).min() == 0.0
    assert len(curve) <= 8


def test_scattered_points_are_passed_within_the_tolerance() -> None:
    random = np.random.default_rng(3)
    loop = polar(
        0.1 + random.uniform(-1.5e-5, 1.5e-5, 400), np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    )
    curve = fit_curve(loop, True)
    assert apart(curve, loop) <= 1.01 * TOLERANCE
    assert kinks(curve).max() < np.radians(0.1)
    assert len(curve) <= 60


def test_a_scattered_side_is_one_line() -> None:
    """A triangle with points every millimetre, 0.018 mm off its sides at most."""
    tips, random = polar(0.1, np.radians([0.0, 120.0, 240.0])), np.random.default_rng(7)
    loop = []
    for tip, other in zip(tips, np.roll(tips, -1, axis=0)):
        ahead = (other - tip) / np.hypot(*(other - tip))
        side = tip + np.arange(0.0, 0.173, 0.001)[:, None] * ahead
        side[1:] += random.uniform(-1.8e-5, 1.8e-5, len(side) - 1)[:, None] * [-ahead[1], ahead[0]]
        loop.append(side)
    curve = fit_curve(np.concatenate(loop), True)
    assert len(curve) == 3
    assert not curve.bulges.any()


def test_same_points_same_curve() -> None:
    loop = NAMED["heart"].outer
    one, two = fit_curve(loop, True), fit_curve(loop, True)
    assert np.array_equal(one.joints, two.joints)
    assert np.array_equal(one.bulges, two.bulges)


def test_half_circle_by_hand() -> None:
    """From (0, 0) over (1, -1) to (2, 0): bulge 1 turns left; closed by its diameter."""
    curve = Curve(np.array([[0.0, 0.0], [2.0, 0.0]]), np.array([1.0, 0.0]), True)
    assert curve.length == pytest.approx(np.pi + 2.0)
    low, high = curve.bounds
    assert low == pytest.approx([0.0, -1.0])
    assert high == pytest.approx([2.0, 0.0])
    assert curve.radii[0] == pytest.approx(1.0)
    flat = curve.flattened(1e-6)
    assert np.hypot(*(flat - [1.0, 0.0])[:-1].T) == pytest.approx(np.ones(len(flat) - 1))
    assert flat[:, 1].min() == pytest.approx(-1.0, abs=1e-6)
    assert curve.corners.all()
    back = curve.reversed()
    assert back.length == pytest.approx(curve.length)
    assert back.bounds[0] == pytest.approx(low)
    assert back.reversed().joints == pytest.approx(curve.joints)
    cut = curve.split(0, 0.5)
    assert cut.joints[1] == pytest.approx([1.0, -1.0])
    assert cut.length == pytest.approx(curve.length)
    assert list(cut.corners) == [True, False, True]


def test_an_arc_of_a_very_large_radius_is_flattened() -> None:
    """Nearly a line: a tolerance below the last digit of its radius leaves at least its ends."""
    curve = Curve(np.array([[0.0, 0.0], [0.1, 0.0]]), np.array([1e-13]), False)
    points = curve.flattened(2e-7)
    assert points[[0, -1]] == pytest.approx(curve.joints)
    assert len(points) < 10


@pytest.mark.parametrize("turn", [-3.0, -0.5, 0.0, 1.0, 2.0 * np.pi / 3.0])
def test_the_middle_of_an_arc_lies_on_it(turn: float) -> None:
    """On a circle that runs through the origin along +x and turns so far, positive to the left."""
    angles = np.array([0.0, 0.5 * turn, turn])
    points = np.stack([np.sin(angles), 1.0 - np.cos(angles)], axis=1) / (turn or 1.0)
    if turn == 0.0:
        points = np.array([[0.0, 0.0], [0.5, 0.0], [1.0, 0.0]])
    segment = Segment(points[0], points[2], float(np.tan(0.25 * turn)))
    assert segment.middle == pytest.approx(points[1], abs=1e-12)


def test_polyline_is_a_curve_of_lines() -> None:
    curve = polyline(NAMED["star"].outer, True)
    assert not curve.bulges.any()
    assert np.array_equal(curve.flattened(1e-3), NAMED["star"].outer)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["heart", "fish"])
def test_patterns_of_pictures_take_a_tenth(name: str) -> None:
    """Ten times fewer lines and arcs than the seam of a corrected pattern has points, on average of weld and
    cut: rounding errors of the seam make some more or fewer."""
    balloon = make_balloon(PICTURES / f"{name}.png", Settings(), width=0.3)
    for part in balloon.parts:
        seam = part.design.pattern.outer
        contours = (*part.pattern.of(Role.SEAL), *part.pattern.of(Role.CUT))
        curves = [fit_curve(contour.points, contour.closed) for contour in contours]
        assert 10 * sum(map(len, curves)) <= len(curves) * len(seam)
        for curve, contour in zip(curves, contours, strict=True):
            assert apart(curve, contour.points) <= 1.01 * TOLERANCE


def slivers(count: int) -> list[np.ndarray]:
    """Loops along a wave, a hundredth of a millimetre wide where they begin."""
    random = np.random.default_rng(1)
    found = []
    for _ in range(count):
        x = np.linspace(0.0, 0.03, int(random.integers(25, 60)))
        half, opening = random.uniform(3e-6, 2.5e-5), random.uniform(0.0, 0.002)
        turns, begin = random.uniform(200.0, 600.0), random.uniform(0.0, 6.0)
        other = np.linspace(0.0, 0.03, int(random.integers(25, 60)))
        low, high = (0.0008 * (np.sin(turns * at + begin) - np.sin(begin)) for at in (x, other))
        side = np.stack([x, low - half * (x > 0.0)], axis=1)
        back = np.stack([other, high + half * (other > 0.0) + opening * other], axis=1)
        found.append(np.concatenate([side, back[:0:-1]]))
    return found


@pytest.mark.parametrize("number", [3, 7])
def test_sides_of_a_sliver_do_not_cross(number: int) -> None:
    """Within the tolerance they could: it is wider than the sliver."""
    points = slivers(8)[number]
    assert shapely.LinearRing(points).is_simple
    curve = fit_curve(points, True)
    assert shapely.LinearRing(curve.flattened(1e-6)).is_simple
    assert (
        shapely.hausdorff_distance(
            shapely.LinearRing(curve.flattened(1e-6)), shapely.LinearRing(points), densify=0.01
        )
        < 2e-5
    )
