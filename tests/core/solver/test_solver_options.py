# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the simulation: plain shell, no bending, grain, volume as the load, and the film's state."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drawn_shapes import oriented, polar
from inflated import lifted
from solver_cases import PRESSURE, film, panel

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film as library_film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.results.film_state import State, film_state, thickness
from BalloonWorkbench.core.results.stl import balloon_mesh, enclosed_volume
from BalloonWorkbench.core.solver.backend import available
from BalloonWorkbench.core.solver.element.orthotropic import Grain, orthotropic_tension_field
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model, grain_of
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.volume_load import inflate_to_volume

BACKENDS = [backend.name for backend in available()]


@pytest.fixture(scope="module")
def square() -> Panel:
    return square_panel()


@cache
def square_panel() -> Panel:
    return panel("square", 350)


@cache
def blown(made_of: Film, backend: str | None = None, model: Model | None = None) -> Inflation:
    """The square, once for each film, solver and model."""
    return inflate(square_panel(), made_of, PRESSURE, backend=backend, model=model)


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_plain_shell_loses_volume(square, backend) -> None:
    """Compression charged like tension: 0.172 in the limit of no bending, far below the 0.2027 of a film."""
    plain = blown(film(1000), backend, model=Model(tension_field=False))
    relaxed = blown(film(1000), backend)
    assert plain.volume < 0.97 * relaxed.volume


@pytest.mark.parametrize("backend", BACKENDS)
def test_without_bending_the_volume_is_the_same(square, backend) -> None:
    bare = blown(film(1000), backend, model=Model(bending=False))
    bent = blown(film(1000), backend)
    assert bare.report.flexural_rigidity == 0.0
    assert bare.report.bending_share == 0.0
    assert bare.volume == pytest.approx(bent.volume, rel=3e-3)


def test_bending_shows_in_paper_and_not_in_foil(square) -> None:
    metre = float(np.ptp(square.rest_positions, axis=0).max())
    shares = {}
    for name in ("kraft-paper", "mylar"):
        small = replace(square, rest_positions=square.rest_positions * (0.1 / metre))
        shares[name] = inflate(
            small, library_film(name), 1000.0, model=Model(bending_floor=1e-12)
        ).report.bending_share
    assert shares["kraft-paper"] > 0.02
    assert shares["mylar"] < 0.1 * shares["kraft-paper"]


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_grain_of_equal_moduli_changes_nothing(square, backend) -> None:
    base = film(300)
    grained = replace(base, young_modulus_across=base.young_modulus, grain_angle=0.6)
    plain, same = (blown(one, backend).volume for one in (base, grained))
    assert same == pytest.approx(plain, rel=1e-9)


@pytest.mark.parametrize("backend", BACKENDS)
def test_turning_the_grain_of_a_square_by_a_right_angle_changes_nothing_but_the_sides(
    square, backend
) -> None:
    base = replace(film(50), young_modulus_across=0.3 * film(50).young_modulus)
    along, across = (blown(replace(base, grain_angle=angle), backend) for angle in (0.0, np.pi / 2))
    assert along.volume == pytest.approx(across.volume, rel=2e-3)
    assert along.volume > blown(film(50), backend).volume  # weaker across: softer


def test_orthotropic_energy_is_the_largest_over_tensile_stresses() -> None:
    """The dual form of relaxation, by brute force over rank-one and full stresses."""
    grain = Grain(0.4, 0.2, 0.3)
    compliance = np.linalg.inv(grain.stiffness)
    rng = np.random.default_rng(3)
    angles = np.linspace(0.0, np.pi, 2001)
    fibres = np.column_stack([np.cos(angles) ** 2, np.sin(angles) ** 2, np.cos(angles) * np.sin(angles)])
    for strain in rng.uniform(-0.1, 0.1, (50, 3)):
        response = orthotropic_tension_field(strain[None], grain)
        stretch = np.maximum(fibres @ strain, 0.0)
        uniaxial = 0.5 * stretch**2 / np.einsum("ai,ij,aj->a", fibres, compliance, fibres)
        stress = grain.stiffness @ strain
        full = (
            0.5 * stress @ strain
            if stress[0] + stress[1] > 0 and stress[0] * stress[1] > stress[2] ** 2
            else 0.0
        )
        assert response.energy[0] == pytest.approx(max(uniaxial.max(), full), rel=1e-5, abs=1e-12)


def test_a_missing_shear_modulus_is_that_of_an_isotropic_film() -> None:
    base = film(100)
    grain = grain_of(replace(base, young_modulus_across=base.young_modulus))
    assert grain is not None
    assert grain.shear == pytest.approx(0.5 / (1.0 + base.poisson_ratio))
    assert grain_of(base) is None


def test_a_volume_as_the_load_gives_the_pressure_back(square) -> None:
    known = blown(film(40))
    found = inflate_to_volume(square, film(40), known.volume)
    assert found.volume == pytest.approx(known.volume, rel=1e-4)
    assert found.report.pressure == pytest.approx(PRESSURE, rel=0.02)


@pytest.mark.parametrize("factor", [0.5, 20.0, -1.0, float("nan")])
def test_impossible_volumes_are_refused(square, factor) -> None:
    volume = blown(film(1000)).volume
    with pytest.raises(InputError):
        inflate_to_volume(square, film(1000), factor * volume)


def test_a_disc_is_taut_at_the_pole_and_wrinkled_at_the_rim() -> None:
    disc = panel("disc", 800)
    inflation = inflate(disc, film(500, seal_width=0.0), PRESSURE)
    state = film_state(inflation, film(500))
    middles = disc.rest_positions[disc.triangles].mean(axis=1)
    radius = np.linalg.norm(middles, axis=1) / np.linalg.norm(disc.rest_positions, axis=1).max()
    assert (state.state[radius < 0.1] == State.TAUT).mean() > 0.5
    rim = (radius > 0.8) & (state.state == State.WRINKLED)
    assert rim.sum() > 0.7 * (radius > 0.8).sum()
    # wrinkles run along the meridians
    outward = middles / np.linalg.norm(middles, axis=1)[:, None]
    sideways = np.einsum(
        "mi,mi->m", state.direction[rim, :2], np.column_stack([-outward[rim, 1], outward[rim, 0]])
    )
    assert np.median(np.abs(sideways)) < 0.25
    # and hide what the rim is too long: on the Mylar balloon a circle of flat radius 0.965 shrinks to 0.7611
    band = (np.abs(radius - 0.965) < 0.025) & (state.state == State.WRINKLED)
    assert state.intensity[band].mean() == pytest.approx(1.0 - 0.7611 / 0.965, abs=0.04)
    assert state.tensions.min() > -1e-9
    assert thickness(inflation).max() == pytest.approx(2.0 * inflation.positions[:, 2].max())


@pytest.mark.parametrize("backend", BACKENDS)
def test_two_panels_find_the_same_balloon_as_one(square, backend) -> None:
    one = blown(film(500), backend)
    two = blown(film(500), backend, model=Model(two_panels=True))
    assert two.volume == pytest.approx(one.volume, rel=1e-3)
    assert two.lower is not None
    seam = square.loops[0]
    np.testing.assert_allclose(two.lower[seam], two.positions[seam], atol=1e-12)
    assert two.lower[:, 2].min() == pytest.approx(-two.positions[:, 2].max(), rel=0.01)


def test_two_panels_make_a_closed_mesh(square) -> None:
    both = blown(film(500), model=Model(two_panels=True))
    assert enclosed_volume(*balloon_mesh(both)) == pytest.approx(both.volume, rel=0.01)


def test_two_panels_with_a_grain_aslant_are_refused(square) -> None:
    grained = replace(film(500), young_modulus_across=1e8, grain_angle=0.3)
    with pytest.raises(InputError):
        blown(grained, model=Model(two_panels=True))


def test_state_of_a_film_with_grain_is_that_of_a_strip_under_one_tension() -> None:
    """Strains from the compliance of Hooke's law, and a known width folded away across the tension."""
    grained = replace(film(100), young_modulus_across=0.3 * film(100).young_modulus, grain_angle=0.4)
    grain = grain_of(grained)
    assert grain is not None
    tension, hidden, angle = 3.0, 0.02, 1.1
    n, m = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    stress = tension / grained.membrane_stiffness * np.array([n[0] ** 2, n[1] ** 2, n[0] * n[1]])
    elastic = np.linalg.solve(grain.turn.T @ grain.stiffness @ grain.turn, stress)
    strain = np.array([[elastic[0], 0.5 * elastic[2]], [0.5 * elastic[2], elastic[1]]])
    free = 1.0 + 2.0 * m @ strain @ m
    strain -= 0.5 * free * (1.0 - (1.0 - hidden) ** 2) * np.outer(m, m)
    values, vectors = np.linalg.eigh(np.eye(2) + 2.0 * strain)
    stretch = vectors @ np.diag(np.sqrt(values)) @ vectors.T
    turn, _ = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))
    sheet = triangulate(Outline(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])), 0.3)
    flat = np.column_stack([sheet.rest_positions @ stretch, np.zeros(len(sheet.rest_positions))])
    inflation = replace(lifted(sheet), positions=flat @ turn.T)
    state = film_state(inflation, grained)
    assert (state.state == State.WRINKLED).all()
    np.testing.assert_allclose(state.tensions, np.tile([tension, 0.0], (len(sheet.triangles), 1)), atol=1e-9)
    np.testing.assert_allclose(state.intensity, hidden, rtol=1e-6)
    along = turn[:, :2] @ (stretch @ n)
    np.testing.assert_allclose(np.abs(state.direction @ along), np.linalg.norm(along), rtol=1e-9)
    assert state.shares() == {State.SLACK: 0.0, State.WRINKLED: pytest.approx(1.0), State.TAUT: 0.0}


def test_two_panels_start_from_a_balloon_that_lies_aslant(square) -> None:
    """The panels stay together at the seam, so that the volume is that of a closed surface."""
    both = blown(film(500), model=Model(two_panels=True))
    aslant = both.positions + np.outer(0.05 * both.positions[:, 0] + 0.02, (0.0, 0.0, 1.0))
    again = inflate(
        square, film(500), PRESSURE, model=Model(two_panels=True), start=replace(both, positions=aslant)
    )
    assert again.lower is not None
    seam = square.loops[0]
    np.testing.assert_allclose(again.lower[seam], again.positions[seam], atol=1e-12)
    assert again.volume == pytest.approx(both.volume, rel=1e-3)


def test_two_panels_come_to_rest_where_a_long_solve_does() -> None:
    """A narrow ring on its way for many steps, in which little is gained: warped first, flat in the end."""
    ellipse = polar(0.15) * [1.0, 0.6]
    ring = triangulate(Outline(ellipse, (oriented(0.8 * ellipse, False),)), 0.009)
    heights = []
    for settings in (None, NewtonSettings(1e-8, 400)):
        model = Model(two_panels=True, twist=0.3)
        both = inflate(ring, library_film("mylar"), 2000.0, model=model, settings=settings)
        heights.append(np.ptp(both.positions[np.concatenate(ring.loops), 2]) / 0.3)
    assert heights[0] == pytest.approx(heights[1], abs=0.01)


def test_a_ring_warps_however_it_lies() -> None:
    """A start along an axis of symmetry of the outline would not leave it: half of the height then."""
    ellipse = polar(0.15) * [1.0, 0.6]
    ring = triangulate(Outline(ellipse, (oriented(0.5 * ellipse, False),)), 0.009)
    heights = []
    for degrees in (0.0, 45.0):
        cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        turned = replace(ring, rest_positions=ring.rest_positions @ np.array([[cos, sin], [-sin, cos]]))
        both = inflate(turned, library_film("mylar"), 2000.0, model=Model(two_panels=True, twist=0.3))
        heights.append(np.ptp(both.positions[np.concatenate(ring.loops), 2]) / 0.3)
    assert heights[0] == pytest.approx(heights[1], rel=0.1)
    assert min(heights) > 0.07
