# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sealed band: what bends it costs energy, what crumples it does not."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, circle, film, needs_native, panel

from BalloonWorkbench.core.film.library import film as library_film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.element.seam_band import SeamBand, seam_hinges
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model, film_problem
from BalloonWorkbench.core.tracing.picture import read_picture
from BalloonWorkbench.core.types import Floats, Ints

PICTURES = Path(__file__).parents[4] / "resources" / "examples" / "pictures"


def lifted(points: Floats) -> Floats:
    return np.column_stack([points, np.zeros(len(points))])


def loop(count: int) -> tuple[Ints, ...]:
    return (np.arange(count, dtype=np.int32),)


def band_of(rest: Floats, rigidity: float) -> SeamBand:
    """Along a loop through all points."""
    return SeamBand(rest, seam_hinges(loop(len(rest))), np.full(len(rest), rigidity))


def energy(rest: Floats, now: Floats, rigidity: float = 1.0) -> float:
    return band_of(rest, rigidity).energy(lifted(now))


STAR = NAMED["star"].outer


def test_rigid_motion_costs_nothing() -> None:
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    assert energy(STAR, STAR @ turn.T + (3.0, 1.0)) == pytest.approx(0.0, abs=1e-20)


@pytest.mark.parametrize("scale", [0.3, 0.9, 1.05])
def test_even_shrinking_costs_nothing(scale: float) -> None:
    """Corners and all: the turning angles stay."""
    assert energy(STAR, scale * STAR) == pytest.approx(0.0, abs=1e-20)


def test_circle_bent_into_an_ellipse() -> None:
    """r = 1 + e cos 2 s changes the curvature by 3 e cos 2 s; the integral of E I / 2 times its square."""
    rest = circle(1.0, 2000)
    turn = np.arctan2(rest[:, 1], rest[:, 0])
    e = 1e-3
    # the film of the rim keeps its length: u_r = e cos 2 s, u_t = - e sin(2 s) / 2
    radial, around = e * np.cos(2.0 * turn), -0.5 * e * np.sin(2.0 * turn)
    now = rest * (1.0 + radial)[:, None] + np.column_stack([-rest[:, 1], rest[:, 0]]) * around[:, None]
    assert energy(rest, now, 2.5) == pytest.approx(2.5 * 4.5 * np.pi * e**2, rel=0.002)


def test_straight_band_bent_into_a_circle() -> None:
    """A straight band bent by 1 / r all along: E I / 2 times 2 pi / r, but for the ends."""
    count, radius = 400, 0.7
    straight = np.column_stack([np.linspace(0.0, 2.0 * np.pi * radius, count + 1), np.zeros(count + 1)])
    bent = np.vstack([circle(radius, count), circle(radius, count)[:1]])
    band = band_of(straight, 3.0)
    inner = slice(1, -1)  # the hinges over the ends join what is far apart
    band.hinges, band._operator, band._stiffness = (
        part[inner] for part in (band.hinges, band._operator, band._stiffness)
    )
    expected = 0.5 * 3.0 * 2.0 * np.pi / radius * (count - 1) / count
    assert band.energy(lifted(bent)) == pytest.approx(expected, rel=1e-3)


def test_same_energy_on_any_spacing() -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 1500, endpoint=False)
    uneven = turn + 0.3 * np.sin(turn)
    found = []
    for angle in (turn, uneven):
        rest = np.column_stack([np.cos(angle), np.sin(angle)])
        found.append(energy(rest, rest * (1.0 + 0.01 * np.cos(3.0 * angle))[:, None]))
    assert found[1] == pytest.approx(found[0], rel=0.002)


def test_forces_and_stiffness_are_derivatives() -> None:
    rest = circle(1.0, 12) * (1.0, 0.6)
    band = band_of(rest, 0.7)
    now = lifted(rest + np.random.default_rng(2).normal(0.0, 0.05, rest.shape))
    force, stiffness = band.derivatives(now)
    total = np.zeros((12, 2))
    np.add.at(total, band.hinges, force.reshape(-1, 3, 2))
    step = 1e-6
    for vertex in range(12):
        for axis in range(2):
            change = np.zeros_like(now)
            change[vertex, axis] = step
            slope = (band.energy(now + change) - band.energy(now - change)) / (2.0 * step)
            assert total[vertex, axis] == pytest.approx(slope, abs=1e-8)
    # quadratic: the force is the stiffness times the positions
    flat = now[band.hinges][:, :, :2].reshape(-1, 6)
    assert force == pytest.approx(np.einsum("hij,hj->hi", stiffness, flat), abs=1e-12)


def test_hinges_follow_each_seam() -> None:
    seams = (np.array([4, 7, 9], dtype=np.int32), np.array([1, 3, 2], dtype=np.int32))
    assert seam_hinges(seams).tolist() == [[9, 4, 7], [4, 7, 9], [7, 9, 4], [2, 1, 3], [1, 3, 2], [3, 2, 1]]
    assert seam_hinges(()).shape == (0, 3)


#: E t and pressure of the film below [N/m, Pa]; 3 mm of weld and the 2 mm beyond it as a beam: b^3 / 12 [m3].
STIFFNESS, BEAM = 100.0 * PRESSURE, 0.005**3 / 12.0


@pytest.mark.parametrize("shape", ["disc", "ring", "square"])
@pytest.mark.parametrize("share", [1.0, 0.3])
def test_one_law_for_rim_and_holes(shape: str, share: float) -> None:
    """Two films as wide as weld and allowance, half for each panel: share E t b^3 / 12, over p L^4."""
    welded = replace(film(100, seal_width=0.003), weld_rigidity=share)
    sealed = panel(shape, 400)
    problem = film_problem(sealed, welded, PRESSURE)
    own = share * STIFFNESS * BEAM / (PRESSURE * sealed.size**4)
    assert len(problem.hinges) == sum(map(len, sealed.loops))
    assert problem.hinge_rigidities == pytest.approx(own, rel=1e-12)
    pair = film_problem(sealed, welded, PRESSURE, Model(two_panels=True))
    assert pair.hinge_rigidities == pytest.approx(2.0 * own, rel=1e-12)
    assert film_problem(sealed, film(100), PRESSURE).hinges is None


@pytest.mark.parametrize("name", ["kraft-paper", "tracing-paper"])
@needs_native
def test_a_glued_seam_of_paper_takes_little_of_the_air(name: str) -> None:
    """Less than 1 % of a star of 0.3 m; a weld that stays flat would take 8 %."""
    star = read_picture(PICTURES / "star.png", 0.3, None)
    mesh, paper = triangulate(star, size_for(star, 600)), library_film(name)
    free, glued = (
        inflate(mesh, replace(paper, weld_rigidity=share), 2000.0).volume
        for share in (1e-5, paper.weld_rigidity)
    )
    assert glued == pytest.approx(free, rel=0.01)


def test_the_same_law_at_a_weld_and_a_spot() -> None:
    """Inside, too; of a weld the hinges between its ends, once for both of its sides."""
    line = np.array([[-0.2, 0.3], [0.2, 0.3]])
    outline = Outline(circle(0.5), (), (line,), (circle(0.1)[::-1].copy(),))
    welded = triangulate(outline, 0.03)
    problem = film_problem(welded, film(100, seal_width=0.003), PRESSURE)
    assert len(problem.hinges) == sum(map(len, welded.loops)) + len(welded.welds[0]) - 2
    own = STIFFNESS * BEAM / (PRESSURE * welded.size**4)
    assert problem.hinge_rigidities == pytest.approx(own, rel=1e-12)
