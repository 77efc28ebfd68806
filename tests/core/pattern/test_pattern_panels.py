# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second panel, copies, corner relief, and cut = seal + half the seal width + allowance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated

from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.pattern.sheet import on_sheet

SEAL = 0.005


def line(contour: Contour) -> shapely.Geometry:
    return (shapely.LinearRing if contour.closed else shapely.LineString)(contour.points)


def made(name: str, **values: object) -> Pattern:
    wanted = PatternOptions(**values)
    return sheet_of(make_pattern(NAMED[name], SEAL, wanted), wanted)


@pytest.mark.parametrize(("seal", "allowance"), [(0.002, 0.0), (0.003, 0.004), (0.012, 0.010)])
@pytest.mark.parametrize("seed", [1, 4, 6])
def test_cut_is_half_a_seal_and_the_allowance_outside_the_weld(
    seed: int, seal: float, allowance: float
) -> None:
    """So far is the cut from each point of the weld, and the weld from each of the cut, but for corners."""
    pattern = make_pattern(generated(seed), seal, PatternOptions(allowance=allowance, intake=False))
    (cut,), (weld,) = pattern.of(Role.CUT), [c for c in pattern.of(Role.SEAL) if signed_area(c.points) > 0.0]
    wanted = 0.5 * seal + allowance
    near = shapely.distance(line(cut), shapely.points(np.asarray(line(weld).segmentize(5e-4).coords)))
    assert near.min() == pytest.approx(wanted, abs=1.5e-5)
    assert np.median(near) == pytest.approx(wanted, abs=1.5e-5)
    away = shapely.distance(line(weld), shapely.points(np.asarray(line(cut).segmentize(5e-4).coords)))
    assert away.min() == pytest.approx(wanted, abs=1.5e-5)
    assert away.max() < 2.2 * wanted  # mitred corners
    assert (np.abs(away - wanted) < 3e-5).mean() > 0.6


def test_the_second_panel_has_the_border_of_its_print_on_its_own_film() -> None:
    """It goes past the cut by so much all round, on both panels; text alone is not turned over."""
    pattern = make_pattern(generated(4), SEAL, PatternOptions())
    (cut,) = pattern.of(Role.CUT)
    border = closed_loop(shapely.Polygon(cut.points).buffer(0.003).exterior, True)
    with_print = replace(pattern, contours=(Contour(Role.PRINT, border, True), *pattern.contours))
    sheet = on_sheet(with_print, True, 1)
    for own, film in zip(
        *(sorted(sheet.of(role), key=_left) for role in (Role.PRINT, Role.CUT)), strict=True
    ):
        past = shapely.distance(line(film), shapely.points(np.asarray(line(own).coords)))
        assert past == pytest.approx(0.003, abs=2e-5)


def _left(contour: Contour) -> float:
    return float(contour.points[:, 0].min())


def test_second_panel_is_the_mirror_image() -> None:
    pattern = made("heart", mirror=True, label="AB", notches=12, intake_angle=0.3)
    one, two = sorted(pattern.of(Role.CUT), key=lambda cut: cut.points[:, 0].min())
    axis = 0.5 * (one.points[:, 0].max() + two.points[:, 0].min())
    turned = shapely.Polygon(np.stack([2.0 * axis - two.points[:, 0], two.points[:, 1]], axis=1))
    assert turned.symmetric_difference(shapely.Polygon(one.points)).area < 1e-9
    assert signed_area(one.points) > 0.0
    assert signed_area(two.points) > 0.0
    assert two.points[:, 0].min() - one.points[:, 0].max() == pytest.approx(0.005)
    assert len(pattern.of(Role.NOTCH)) % 2 == 0
    assert pattern.contours[-1].role is pattern.contours[-2].role is Role.CUT
    # letters are not mirrored: the same outlines, in the same order from left to right
    letters = pattern.of(Role.ENGRAVE)
    shapes = [contour.points - contour.points.mean(axis=0) for contour in letters]
    half = len(shapes) // 2
    for k in range(half):
        np.testing.assert_allclose(shapes[k], shapes[half + k], atol=1e-12)
    left, right = (shapely.Polygon(cut.points) for cut in (one, two))
    assert sum(left.contains(line(contour)) for contour in letters) == half
    assert sum(right.contains(line(contour)) for contour in letters) == half


def test_copies_are_alike_and_apart() -> None:
    single, many = made("star"), made("star", copies=5)
    assert len(many.of(Role.CUT)) == 5
    assert many.film_area == pytest.approx(5 * single.film_area)
    assert many.seam_length == pytest.approx(5 * single.seam_length)
    sheets = [shapely.Polygon(cut.points) for cut in many.of(Role.CUT)]
    assert min(a.distance(b) for k, a in enumerate(sheets) for b in sheets[:k]) > 0.0049
    roles = [contour.role for contour in many.contours]
    assert roles == sorted(roles, key=list(Role).index)
    for copies in (0, 101):
        with pytest.raises(InputError, match="copies"):
            made("disc", copies=copies)


def test_copies_of_both_panels_with_pieces() -> None:
    sheet = made("heart", copies=3, mirror=True, intake_kind="film-valve")
    assert len(sheet.of(Role.CUT)) == 3 * 2 * 2
    films = [shapely.Polygon(cut.points) for cut in sheet.of(Role.CUT)]
    assert min(a.distance(b) for k, a in enumerate(films) for b in films[:k]) > 0.0049


@pytest.mark.parametrize("name", ["square", "star", "L"])
def test_corner_relief_rounds_the_cut_alone(name: str) -> None:
    """Every bend of the cut is as wide as it is wanted; the weld is as before, all of it on film."""
    sharp = made(name, intake=False, allowance=0.004)
    round_ = made(name, intake=False, allowance=0.004, corner_radius=0.003)
    curve = fit_curve(round_.of(Role.CUT)[0].points, True)
    assert not curve.corners.any()
    assert curve.radii.min() == pytest.approx(0.003, abs=5e-5)
    assert (fit_curve(sharp.of(Role.CUT)[0].points, True).corners).any()
    (seal,), (before,) = round_.of(Role.SEAL), sharp.of(Role.SEAL)
    np.testing.assert_array_equal(seal.points, before.points)
    assert line(round_.of(Role.CUT)[0]).distance(line(seal)) >= 0.5 * SEAL - 5e-6


def test_corner_relief_that_would_take_the_weld_is_refused() -> None:
    with pytest.raises(InputError, match="relief of 20 mm would cut into the weld"):
        made("star", intake=False, corner_radius=0.020)
    with pytest.raises(InputError, match="0 or above"):
        made("star", intake=False, corner_radius=-0.001)


def test_the_mouth_stays_square() -> None:
    pattern = made("disc", corner_radius=0.002)
    curve = fit_curve(pattern.of(Role.CUT)[0].points, True)
    assert curve.corners.sum() == 2
