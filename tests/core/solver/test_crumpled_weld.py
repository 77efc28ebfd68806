# SPDX-License-Identifier: LGPL-2.1-or-later
"""A weld that crumples freely, resolved as film: the other bound of what a weld does."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drawn_shapes import hole, polar
from solver_cases import PRESSURE, both_backends, film, needs_native, panel, radii

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.results.film_state import film_state
from BalloonWorkbench.core.results.strength import loads
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.split_along_welds import split_assembly
from BalloonWorkbench.core.solver.weld_strip import with_strip

CRUMPLED = Model(weld="crumpled")
WELDED = film(1000, seal_width=0.05)
#: Of 0.3 m, from mylar with a weld of 5 mm, at party pressure.
DRAWN = {"disc": Outline(polar(0.15)), "ring": Outline(polar(0.15), (hole(0.06, 0.0, 0.0),))}

#: Whether a ring of crumpled weld kinks, and how, hangs on the mesh: most of these must.
RINGS = (900, 1000, 1300)


@cache
def drawn(shape: str, weld: str, vertices: int = 800) -> Inflation:
    mesh = triangulate(DRAWN[shape], size_for(DRAWN[shape], vertices))
    return inflate(mesh, films()["mylar"], 2000.0, model=Model(weld=weld), backend="native")


@cache
def square(backend: str) -> Inflation:
    exact = NewtonSettings(tolerance=1e-9)
    return inflate(panel("square", 250), WELDED, PRESSURE, model=CRUMPLED, backend=backend, settings=exact)


def out_of_round(inflation: Inflation, seam: int) -> float:
    """Of the radii of a loop, root mean square, relative."""
    found = radii(inflation, seam)
    return float(found.std() / found.mean())


@needs_native
def test_a_ring_kinks_that_an_elastic_weld_keeps_round() -> None:
    """A closed curved tube is unstable without the rigidity of its weld: the hole is no circle any more."""
    elastic, crumpled = ([drawn("ring", weld, count) for count in RINGS] for weld in ("elastic", "crumpled"))
    assert all(ring.report.converged and out_of_round(ring, 1) < 1e-3 for ring in elastic)
    assert sum(ring.report.converged and out_of_round(ring, 1) > 1e-2 for ring in crumpled) >= 2


@needs_native
def test_a_disc_holds_as_much() -> None:
    """Its rim scallops where it has to become shorter, which takes no air."""
    elastic, crumpled = (drawn("disc", weld) for weld in ("elastic", "crumpled"))
    assert out_of_round(elastic, 0) < 2e-3 < out_of_round(crumpled, 0)
    assert crumpled.volume == pytest.approx(elastic.volume, rel=3e-3)
    means = [float(radii(each, 0).mean()) for each in (elastic, crumpled)]
    assert means[1] == pytest.approx(means[0], rel=0.02)


@both_backends
def test_the_balloon_is_that_of_its_panel(backend: str) -> None:
    """Without the strip: as many vertices and triangles as the panel, its rim in the plane."""
    found = square(backend)
    assert found.report.converged
    assert len(found.positions) == len(found.directors) == len(found.panel.rest_positions)
    assert len(found.tensions) == len(found.panel.triangles)
    assert np.abs(found.positions[found.panel.loops[0], 2]).max() == 0.0
    assert found.report.model == CRUMPLED
    assert film_state(found, WELDED).areas.sum() > 0.9
    assert loads(found, WELDED).weld.value > 0.0


@needs_native
def test_both_solvers_find_the_same() -> None:
    one, other = square("native"), square("numpy")
    assert other.volume == pytest.approx(one.volume, rel=1e-6)


def test_an_earlier_balloon_is_a_start() -> None:
    cold = square("numpy")
    warm = inflate(cold.panel, WELDED, PRESSURE, model=CRUMPLED, start=cold, backend="numpy")
    assert warm.report.converged
    assert warm.report.newton_steps < cold.report.newton_steps
    assert warm.volume == pytest.approx(cold.volume, rel=1e-3)


def test_without_a_weld_there_is_no_strip() -> None:
    bare = replace(WELDED, seal_width=0.0)
    one, other = (
        inflate(panel("disc", 250), bare, PRESSURE, model=Model(weld=weld), backend="numpy")
        for weld in ("elastic", "crumpled")
    )
    assert np.array_equal(one.positions, other.positions)


def test_the_strip_follows_the_panel() -> None:
    """Its vertices come last, the first of them share the places of the rim."""
    split = split_assembly(Assembly.mirrored(panel("ring", 250)))
    longer = with_strip(split, 0.05)
    count, rim = len(split.origin), np.concatenate(panel("ring", 250).loops)
    assert longer.strip == len(longer.origin) - count == 3 * len(rim)
    assert np.array_equal(longer.triangles[: len(split.triangles)], split.triangles)
    assert longer.tied[count : count + len(rim)].tolist() == rim.tolist()
    assert longer.tied[count + len(rim) :].tolist() == [*range(count + len(rim), len(longer.origin))]
    assert np.array_equal(longer.own, split.own)


@pytest.mark.parametrize("whole", [True, False])
def test_other_balloons_are_refused(whole: bool) -> None:
    """Two panels, or any in space: which way out of the seam is the plane?"""
    square = panel("square", 250)
    body = Assembly.mirrored(square).in_full() if whole else square
    with pytest.raises(InputError, match="choose the elastic weld"):
        inflate(body, WELDED, PRESSURE, model=replace(CRUMPLED, two_panels=not whole))
