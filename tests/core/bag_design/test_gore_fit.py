# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corrected gores against their profiles."""

from dataclasses import replace

import numpy as np
import pytest
from profiles import PROFILES, airship, bell, cone, envelope, sphere, spheroid

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_count import expected_error, fit_to_accuracy, gores_needed, judged
from BalloonWorkbench.core.bag_design.gore_fit import RisingPressure, fit_gores, inflate_gores
from BalloonWorkbench.core.bag_design.gore_sections import beside_axis, off_profile
from BalloonWorkbench.core.bag_pattern.seams import side_lines
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.natural_shape import natural_shape
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import Cancelled, InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film as film_named
from BalloonWorkbench.core.geometry.polyline import length, signed_area
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model

BALL = 4.0 * np.pi / 3.0
POLYESTER = film_named("mylar")


def stiff(profile: Profile, pressure: float = 1000.0, k: float = 1e3) -> Film:
    """A film that stretches by about 1 / k."""
    thickness = 2e-5
    modulus = k * pressure * length(profile.points) / thickness
    return Film("test", modulus, 0.3, thickness, 0.03, seal_width=0.0)


def error(design: BagDesign) -> float:
    assert design.residual is not None
    return design.residual.mean / design.size


def coarse(profile: Profile, count: int) -> float:
    """A mesh size for some 900 vertices."""
    return default_size(gored_bag(profile, count), 900)


@pytest.fixture(scope="module")
def ball() -> BagDesign:
    return fit_gores(sphere(), 6, POLYESTER, 1000.0, mesh_size=coarse(sphere(), 6))


@pytest.mark.parametrize(
    ("backend", "count", "share", "tolerance"),
    [("native", 6, 0.9740, 5e-3), ("native", 12, 0.9940, 3e-3), ("numpy", 12, 0.9940, 3e-3)],
)
def test_plain_gores_have_the_volumes_of_the_reference(
    backend: str, count: int, share: float, tolerance: float
) -> None:
    """Three nested meshes and another program: panels of film without bending, k = 1e4."""
    model = Model(bending=False)
    film = stiff(sphere(), k=1e4)
    design = inflate_gores(sphere(), count, film, 1000.0, backend=backend, model=model)
    assert design.inflation.report.converged and design.inflation.report.backend == backend
    assert design.inflation.volume / BALL == pytest.approx(share, rel=tolerance)


def test_six_gores_of_a_sphere_follow_the_law(ball: BagDesign) -> None:
    assert error(ball) <= 0.16 / 6**2
    assert ball.passes <= 8 and ball.reached and not ball.warnings
    assert ball.size == pytest.approx(np.sqrt(12.0))
    plain = inflate_gores(sphere(), 6, POLYESTER, 1000.0, mesh_size=coarse(sphere(), 6))
    assert error(ball) < 0.8 * error(plain)


def test_the_balloon_stands_on_the_axis_where_its_profile_is(ball: BagDesign) -> None:
    positions = ball.inflation.positions
    assert np.abs(positions[:, :2].mean(axis=0)).max() < 5e-3
    assert np.abs(positions[:, 2]).max() == pytest.approx(1.0, abs=0.02)
    offset = ball.inflation.assembly.offsets[1]  # the first gore lies in the direction of x
    assert (
        np.abs(np.arctan2(positions[:offset, 1], positions[:offset, 0])[positions[:offset, 0] > 0.2]).max()
        < 0.6
    )


def test_seams_stand_out_by_what_is_said(ball: BagDesign) -> None:
    seam = ball.meshed.assembly.seams[0].first
    edge = ball.inflation.positions[seam.vertices + ball.meshed.assembly.offsets[seam.panel]]
    off, _ = off_profile(sphere(), beside_axis(edge))
    every, _ = off_profile(sphere(), beside_axis(ball.inflation.positions))
    assert off.max() - every.min() == pytest.approx(ball.apart, rel=0.1)


def test_the_pattern_alone_makes_the_balloon(ball: BagDesign) -> None:
    """Meshed anew and closed up from nothing, its panels inflate to the same volume."""
    cold = inflate(mesh_bag(ball.bag, 0.09).assembly, POLYESTER, 1000.0)
    assert cold.volume == pytest.approx(ball.inflation.volume, rel=3e-3)


def test_the_model_airship_is_what_its_builder_had() -> None:
    """2.1 m x 0.73 m of six gores: 0.53 m3, 31 g a gore with its weld; in polyethylene of 50 um."""
    film = film_named("pe")
    design = fit_gores(airship(), 6, film, 300.0, mesh_size=coarse(airship(), 6))
    assert error(design) < 5e-3 and design.reached
    assert design.inflation.volume == pytest.approx(0.53, rel=0.03)
    flat = design.bag.panels[0].outer
    weld = 2.0 * length(flat[: len(flat) // 2 + 1]) * film.seal_width
    assert 1e3 * film.areal_density * (signed_area(flat) + weld) == pytest.approx(31.0, rel=0.05)


def test_waists_and_open_ends() -> None:
    profile = bell()
    design = fit_gores(profile, 8, stiff(profile), 1000.0, mesh_size=coarse(profile, 8))
    assert design.reached and design.passes <= 8
    assert error(design) < 4e-3


@pytest.mark.parametrize("name", ["cone", "drum"])
def test_rims_of_discs_are_where_the_profile_ends(name: str) -> None:
    """Plain gores are drawn in by up to 4 % there; corrected ones are as near as the law says.

    All profiles: benchmarks/validation/gores.py.
    """
    profile = PROFILES[name]()
    edge = coarse(profile, 8)
    plain = inflate_gores(profile, 8, POLYESTER, 1000.0, mesh_size=edge)
    design = fit_gores(profile, 8, POLYESTER, 1000.0, mesh_size=edge)
    assert design.residual is not None and plain.residual is not None
    assert error(design) <= 1.1 * expected_error(profile, 8) and error(design) < 2e-3
    assert design.residual.p95 <= max(0.4 * plain.residual.p95, 4e-3 * design.size)
    assert rim_off(design) < 0.5 * rim_off(plain) + 1e-3
    for seam in design.bag.seams:
        one, other = (length(line) for line in side_lines(design.bag, seam))
        assert one == pytest.approx(other, rel=1e-6)


def rim_off(design: BagDesign) -> float:
    """How far the rims of the discs are from the ends of the profile, in the mean, in parts of the size."""
    profile, offsets = design.source, design.inflation.assembly.offsets
    assert isinstance(profile, Profile)
    far = []
    for number, panel in enumerate(design.bag.panels):
        if "disc" in panel.name:
            rim = design.inflation.assembly.panels[number].loops[0] + offsets[number]
            end = profile.points[0 if panel.name == "lower disc" else -1]
            far.append(np.linalg.norm(beside_axis(design.inflation.positions[rim]) - end, axis=1).mean())
    return float(np.mean(far)) / design.size


def test_an_open_end_is_not_drawn_in_and_holds_nothing_beyond() -> None:
    profile = bell()
    design = inflate_gores(profile, 12, POLYESTER, 1000.0, mesh_size=coarse(profile, 12))
    assert rim_off(design) < 5e-3
    r, z = profile.points.T
    solid = np.pi * float(np.sum(0.5 * (r[1:] ** 2 + r[:-1] ** 2) * np.diff(z)))
    assert design.inflation.volume == pytest.approx(solid, rel=0.05)  # plain gores are 0.2 % of the size off
    film_only = design.inflation.positions[design.film]
    assert np.ptp(film_only[:, 2]) == pytest.approx(np.ptp(z), rel=0.02)
    assert np.ptp(design.inflation.positions[:, 2]) > 1.3 * np.ptp(z)


def test_a_lens_that_film_cannot_take_is_told() -> None:
    profile = spheroid(0.3, 0.1)
    design = fit_gores(profile, 8, stiff(profile), 1000.0, mesh_size=coarse(profile, 8))
    assert not design.reached and "cannot take this shape" in design.warnings[0]


def test_a_zero_pressure_balloon_has_its_natural_shape() -> None:
    """Held at the bottom, no pressure there: plain gores come near to it, corrected ones nearer."""
    profile = natural_shape(10.0)
    gradient = 10.0
    film = replace(stiff(profile, gradient * 10.0), seal_width=0.0)
    design = fit_gores(profile, 12, film, RisingPressure(0.0, gradient), mesh_size=coarse(profile, 12))
    assert error(design) < 2e-3 and design.reached
    assert design.inflation.volume == pytest.approx(0.126055e3, rel=0.01)
    assert np.abs(design.inflation.positions[:, 2].min()) < 1e-6


def test_the_law_for_spheres_and_spheroids() -> None:
    assert expected_error(sphere(), 10) == pytest.approx(1.6e-3, rel=0.01)
    assert expected_error(sphere(3.0), 20) == pytest.approx(0.4e-3, rel=0.01)
    assert expected_error(spheroid(1.0, 2.0), 10) == pytest.approx(0.40e-3, rel=0.05)
    assert gores_needed(sphere(), 0.01) == 4
    assert gores_needed(sphere(), 0.0016) == 10
    assert gores_needed(cone(), 0.01) == 3
    assert gores_needed(sphere(), 1e-5) == 60


@pytest.mark.parametrize("accuracy", [0.0, 1.0, -1.0, np.nan])
def test_an_accuracy_that_is_none_is_refused(accuracy: float) -> None:
    with pytest.raises(InputError, match="accuracy"):
        gores_needed(sphere(), accuracy)


def test_as_many_gores_as_an_accuracy_takes() -> None:
    profile = envelope(2.0)
    design = fit_to_accuracy(profile, 0.006, stiff(profile), 1000.0, mesh_size=coarse(profile, 6))
    assert error(design) <= 0.006 and design.reached
    count = sum(panel.cut for panel in design.bag.panels)
    assert gores_needed(profile, 0.006) <= count <= gores_needed(profile, 0.006) + 1


def test_too_few_gores_for_an_accuracy_are_told(ball: BagDesign) -> None:
    assert judged(ball, 0.01) is ball
    hinted = judged(ball, 0.002)
    assert not hinted.reached and "0.2 %" in hinted.warnings[-1] and "Take 9 gores." in hinted.warnings[-1]


def test_the_work_can_be_stopped() -> None:
    with pytest.raises(Cancelled):
        fit_gores(sphere(), 6, stiff(sphere()), 1000.0, progress=lambda fraction, text: fraction < 0.3)


def test_the_same_gores_twice() -> None:
    one, other = (fit_gores(airship(), 4, stiff(airship()), 1000.0, mesh_size=0.12) for _ in range(2))
    assert one.inflation.positions.tobytes() == other.inflation.positions.tobytes()
    assert gored_bag(airship(), 4).panels[0].outer.shape == one.bag.panels[0].outer.shape
