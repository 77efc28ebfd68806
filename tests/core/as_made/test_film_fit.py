# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film that stretched and a weld that shrank: both numbers come back, or it is said that they cannot."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest
import shapely

from BalloonWorkbench.core.as_made.compare_job import Compared, compare_balloon, compared_files, rim_of
from BalloonWorkbench.core.as_made.comparison import Comparison, Expected, compare, compared, with_rim
from BalloonWorkbench.core.as_made.comparison_report import fit_data
from BalloonWorkbench.core.as_made.film_fit import FilmFit, fit_film
from BalloonWorkbench.core.as_made.fitted_film import fitted_film_file, mean_of
from BalloonWorkbench.core.as_made.photo_scale import PhotoScale
from BalloonWorkbench.core.as_made.photograph import SeenShape
from BalloonWorkbench.core.as_made.placement import Placement
from BalloonWorkbench.core.correction.fit import inflate_outline
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film, film_data
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern

SCALE = PhotoScale(0.0003, 0.0005)
FLAG = np.array([[0.0, 0.0], [0.2, 0.0], [0.2, 0.06], [0.11, 0.07], [0.1, 0.14], [0.03, 0.14], [0.0, 0.06]])
RIM = rim_of(film("mylar"), PatternOptions())
inflate = partial(inflate_outline, film=film("mylar"), mesh_size=0.012)


def shifted(loop: np.ndarray) -> np.ndarray:
    angle = 0.7
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return loop @ turn + [0.4, -0.1]


def by_film(loop: np.ndarray, outward: float) -> np.ndarray:
    """A loop moved outward [m], by shapely."""
    grown = shapely.Polygon(loop).buffer(outward, join_style="mitre")
    return np.array(shapely.get_coordinates(grown.exterior))[:-1][:: 1 if grown.exterior.is_ccw else -1]


@cache
def designed() -> Design:
    return inflate(Outline(FLAG), pressure=2000.0)


@cache
def as_made(stretch: float, shrinkage: float) -> Compared:
    """The balloon of a pattern that stretched and shrank before it was blown up, on a mesh of its own."""
    seam = Outline((1.0 + stretch) * by_film(FLAG, -shrinkage))
    blown = with_rim(inflate_outline(seam, film("mylar"), 2000.0, mesh_size=0.011).silhouette, RIM)
    pattern = build_pattern(Outline(FLAG), 0.005, PatternOptions(intake=False))
    shape = SeenShape(blown.map(shifted), SCALE)
    return compare_balloon(shape, [(designed(), pattern)], RIM, lambda seam, at: inflate(seam, pressure=at))


def test_stretch_and_shrinkage_come_back() -> None:
    """Within three of the errors that are told, which are small enough to be of use."""
    fit = as_made(0.012, 0.0009).fit
    assert fit is not None
    assert fit.apart
    assert fit.stretch == pytest.approx(0.012, abs=3.0 * fit.stretch_error)
    assert fit.shrinkage == pytest.approx(0.0009, abs=3.0 * fit.shrinkage_error)
    assert fit.stretch_error < 0.004
    assert fit.shrinkage_error < 0.0003


def linear(expected: Outline, stretch: float, shrinkage: float, share: float, noise: float) -> FilmFit:
    """The fit to an outline that is as the model says, with places that scatter [m].

    share  of a step inward of the seam that the silhouette follows
    """
    grown = Outline((1.0 + stretch) * by_film(expected.outer, -share * shrinkage))
    even = dense(grown.outer)
    rough = np.random.default_rng(2).normal(0.0, noise, even.outer.shape)
    comparison = replace(over(even, expected), seen=even.map(lambda loop: loop + rough))
    return fit_film(comparison, expected, Outline(by_film(expected.outer, -share * 0.001)), 0.001, SCALE)


def over(seen: Outline, expected: Outline) -> Comparison:
    return compare(SeenShape(seen, SCALE), [Expected(expected)])


def dense(loop: np.ndarray) -> Outline:
    return Outline(
        np.array(shapely.get_coordinates(shapely.segmentize(shapely.LinearRing(loop), 0.002)))[:-1]
    )


def test_the_error_grows_with_the_scatter_and_covers_it() -> None:
    exact = linear(dense(FLAG), 0.01, 0.001, 0.8, 0.0)
    assert exact.stretch == pytest.approx(0.01, abs=4e-4)
    assert exact.shrinkage == pytest.approx(0.001, abs=4e-5)
    assert exact.stretch_error > SCALE.uncertainty
    rough = linear(dense(FLAG), 0.01, 0.001, 0.8, 0.0004)
    assert rough.stretch_error > exact.stretch_error
    assert abs(rough.stretch - 0.01) < 3.0 * rough.stretch_error
    assert abs(rough.shrinkage - 0.001) < 3.0 * rough.shrinkage_error


def test_the_error_is_what_wrinkles_leave() -> None:
    """Twenty outlines with bumps some centimetres long: what comes out scatters by the errors that it has."""
    expected, scale = dense(FLAG), PhotoScale(1e-6, 0.0)
    narrower = Outline(by_film(expected.outer, -0.0008))
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(expected.outer, axis=0).T)))
    random, off = np.random.default_rng(5), []
    inward = shapely.LinearRing(by_film(expected.outer, -0.001))
    nearest = [inward.interpolate(inward.project(shapely.Point(at))) for at in expected.outer]
    outward = (expected.outer - shapely.get_coordinates(nearest)) / 0.001
    for _ in range(20):
        waves = along[:, None] / along[-1] * 2.0 * np.pi * np.arange(3, 25)
        heights = random.normal(0.0, 1e-4, 22) @ np.cos(waves + random.uniform(0.0, 7.0, 22)).T
        seen = Outline(expected.outer + heights[:, None] * outward)
        comparison = compared(seen, Expected(expected), Placement(np.eye(2), np.zeros(2), 0.0))
        fit = fit_film(comparison, expected, narrower, 0.001, scale)
        off.append([fit.stretch / fit.stretch_error, fit.shrinkage / fit.shrinkage_error])
    spread = np.sqrt(np.mean(np.square(off), axis=0))
    assert (spread > 0.4).all()
    assert (spread < 1.8).all()


def test_a_disc_does_not_tell_them_apart() -> None:
    """There both make all of it larger or smaller: each alone explains the difference."""
    angles = np.linspace(0.0, 2.0 * np.pi, 300, endpoint=False)
    disc = Outline(0.1 * np.column_stack([np.cos(angles), np.sin(angles)]))
    fit = linear(disc, 0.01, 0.0, 0.8, 0.0)
    assert not fit.apart
    assert fit.stretch == pytest.approx(0.01, rel=0.02)
    assert fit.shrinkage == pytest.approx(-0.01 * 0.1 / 0.8, rel=0.02)


def test_an_intake_is_left_out() -> None:
    """What sticks out of the photograph where the neck is moves nothing."""
    pattern = build_pattern(Outline(FLAG), 0.005, PatternOptions(intake_along=0.2))
    assert pattern.intake is not None
    expected = with_rim(designed().silhouette, RIM)
    seam = designed().inflation.panel.loops[0]
    rest = designed().inflation.panel.rest_positions[seam]
    root = np.argsort(np.linalg.norm(rest - pattern.intake.at, axis=1))[:2]
    foot = designed().inflation.positions[seam[root], :2].mean(axis=0)
    way = np.array([np.cos(pattern.intake.angle), np.sin(pattern.intake.angle)])
    neck = shapely.LineString([foot - 0.02 * way, foot + 0.05 * way]).buffer(0.005, cap_style="flat")
    whole = shapely.Polygon(expected.outer).union(neck)
    seen = SeenShape(Outline(np.array(whole.exterior.coords)[-2::-1]).map(shifted), SCALE)
    comparison = compare_balloon(seen, [(designed(), pattern)], RIM).comparison
    assert comparison.residual.max < 0.2e-3
    assert comparison.size == pytest.approx(expected.size, abs=1e-3)
    assert "The intake was left out of the comparison." in comparison.remarks
    plain = compare_balloon(
        seen, [(designed(), build_pattern(Outline(FLAG), 0.005, PatternOptions(intake=False)))], RIM
    )
    assert plain.comparison.residual.max > 0.03


def test_without_a_scale_nothing_is_fitted() -> None:
    shape = SeenShape(with_rim(designed().silhouette, RIM).map(shifted), None)
    pattern = build_pattern(Outline(FLAG), 0.005, PatternOptions(intake=False))
    with pytest.raises(InputError, match="tells nothing of the film"):
        compare_balloon(shape, [(designed(), pattern)], RIM, lambda seam, at: inflate(seam, pressure=at))


def test_the_files_say_the_same() -> None:
    compared = as_made(0.012, 0.0009)
    files = compared_files(compared)
    assert files == compared_files(compared)
    assert files["compare.png"].startswith(b"\x89PNG")
    data = json.loads(files["compare.json"])
    assert data["difference"]["mean_mm"] == pytest.approx(1e3 * compared.comparison.residual.mean)
    assert compared.fit is not None
    assert data["film"]["stretch"] == pytest.approx(compared.fit.stretch)
    rings = [shapely.LinearRing(data["outlines"][name][0]) for name in ("expected_mm", "seen_mm")]
    assert shapely.hausdorff_distance(*rings, 0.01) == pytest.approx(data["difference"]["max_mm"], abs=0.1)


def test_the_mean_of_photographs() -> None:
    """Weighed by errors, as in every textbook: of two alike the error is smaller by the root of two; of two
    that contradict each other it is half their distance. What a disc says counts only while nothing better
    is known."""
    one = fit_data(FilmFit(0.010, 0.002, 1e-3, 2e-4, True, 1e-4))
    assert mean_of([one]) == one
    both = mean_of([one, one])
    assert both["stretch_error"] == pytest.approx(0.002 / np.sqrt(2.0))
    assert both["weld_shrinkage_error_mm"] == pytest.approx(0.2 / np.sqrt(2.0))
    far = fit_data(FilmFit(0.030, 0.002, 1e-3, 2e-4, True, 3e-4))
    apart = mean_of([one, far])
    assert apart["stretch"] == pytest.approx(0.020)
    assert apart["stretch_error"] == pytest.approx(0.010)
    assert apart["left_mm"] == pytest.approx(0.2)
    sharp = fit_data(FilmFit(0.013, 0.001, 1e-3, 2e-4, True, 1e-4))
    assert mean_of([one, sharp])["stretch"] == pytest.approx((0.010 / 4.0 + 0.013) / 1.25)
    disc = fit_data(FilmFit(0.05, 0.0001, 9e-3, 1e-6, False, 1e-4))
    assert mean_of([one, disc]) == one
    assert mean_of([disc, disc])["told_apart"] is False


@pytest.mark.parametrize("as_made", [3, {"photographs": []}, {"photographs": {"a.jpg": {"stretch": 1}}}])
def test_a_spoiled_fit_is_named(tmp_path: Path, as_made: object) -> None:
    fit = FilmFit(0.010, 0.002, 1e-3, 2e-4, True, 1e-4)
    path = tmp_path / "mylar-as-made.json"
    path.write_text(json.dumps({**film_data("mylar"), "name": path.stem, "as_made": as_made}))
    with pytest.raises(InputError, match='"as_made" of the film'):
        fitted_film_file(str(path), fit, "photo.jpg")


def test_the_fitted_film_is_a_film_of_the_users_own(tmp_path: object) -> None:
    fit = as_made(0.012, 0.0009).fit
    assert fit is not None
    ((name, content),) = fitted_film_file("mylar", fit, "photo.jpg").items()
    path = tmp_path / name
    path.write_bytes(content)
    own = film(str(path))
    assert own.name == "mylar-as-made"
    assert own.young_modulus == film("mylar").young_modulus
    assert film_data(str(path))["as_made"]["weld_shrinkage_mm"] == pytest.approx(1e3 * fit.shrinkage)
    again = fitted_film_file(str(path), fit, "photo.jpg")
    assert again == {name: content}
    other = replace(fit, stretch=fit.stretch + 0.001, apart=True, stretch_error=fit.stretch_error)
    (added,) = fitted_film_file(str(path), other, "second.jpg").values()
    made = json.loads(added)["as_made"]
    assert made["stretch"] == pytest.approx(fit.stretch + 0.0005)
    assert made["source"] == "fitted to photo.jpg, second.jpg"
    path.write_bytes(added)
    assert fitted_film_file(str(path), fit, "photo.jpg") == {name: added}
    with pytest.raises(InputError, match="no film"):
        fitted_film_file("paper bag", fit, "photo.jpg")
