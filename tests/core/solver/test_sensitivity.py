# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a balloon at rest moves with its flat film, against balloons that were inflated again."""

from dataclasses import replace

import bodies
import numpy as np
import pytest
from drawn_shapes import NAMED
from scipy.sparse.linalg import spsolve
from solver_cases import NATIVE, NUMPY, both_solvers, needs_native
from test_welds import WELDED

from BalloonWorkbench.core.errors import InputError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver import model as models
from BalloonWorkbench.core.solver import sensitivity
from BalloonWorkbench.core.solver.backend import Backend, available
from BalloonWorkbench.core.solver.element.rest_derivatives import force_changes
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames, turned
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model, film_problem, problem_of
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.solver.split_along_welds import split_assembly
from BalloonWorkbench.core.solver.start import dome, vertex_normals
from BalloonWorkbench.core.types import Floats

PRESSURE = 2000.0
NEARLY = NewtonSettings(tolerance=1e-11, max_steps=300)
STEP = 1e-6
MYLAR = films()["mylar"]
GRAIN_ALONG = replace(MYLAR, young_modulus_across=0.6 * MYLAR.young_modulus)
GRAIN = replace(MYLAR, young_modulus_across=0.6 * MYLAR.young_modulus, grain_angle=0.5)
SHAPES = {"heart": NAMED["heart"], "L": NAMED["L"], "hole": NAMED["ring"], "weld": WELDED}


def meshed(outline: Outline, vertices: int = 150) -> Panel:
    return triangulate(outline, size_for(outline, vertices))


def at_rest(assembly: Assembly, film: Film, start: Inflation | None = None) -> Inflation:
    """Inflated until the forces are nothing but rounding, which no energy tells: by the exact Hessian."""
    earlier = start and replace(start, assembly=assembly)  # from where it was, not stretched
    rest = inflate(assembly, film, PRESSURE, start=earlier, settings=NEARLY)
    split = split_assembly(assembly)
    problem = problem_of(split, film, PRESSURE, rest.report.model)
    shell = Shell(problem)
    shell.exact = True
    positions, directors = sensitivity._state(rest, split, problem, NUMPY)
    for _ in range(8):
        frames = tangent_frames(directors)
        gradient, hessian = shell.derivatives(positions, directors, frames)
        moves, turns = shell.spread(spsolve(shell.scatter.shifted(hessian, 1e-9), -gradient))
        positions, directors = positions + moves, turned(directors, frames, turns)
    assert np.abs(gradient).max() < 1e-12
    places = positions[split.own] * split.assembly.size
    return replace(rest, positions=places, directors=directors[split.own])


def wave(rest: Floats) -> Floats:
    """A smooth field of moves (n, 2) m."""
    x, y = (2.0 * np.pi * (rest - rest.mean(axis=0)) / np.ptp(rest, axis=0).max()).T
    return 0.1 * np.column_stack([np.sin(y + 0.3) * np.cos(x), np.cos(1.5 * x)])


def without_rigid_motion(places: Floats, changes: Floats) -> Floats:
    """Changes (n, 3) without what moves and turns all places (n, 3)."""
    turns = [np.cross(axis, places) for axis in np.eye(3)]
    moves = [np.broadcast_to(axis, places.shape) for axis in np.eye(3)]
    rigid = np.stack([field.ravel() for field in turns + moves], axis=1)
    share = np.linalg.lstsq(rigid, changes.ravel(), rcond=None)[0]
    return changes - (rigid @ share).reshape(-1, 3)


def missed(places: Floats, found: Floats, expected: Floats) -> float:
    """The largest relative difference of fields of changes (n, 3, k), but for rigid motions."""
    worst = 0.0
    for field in range(found.shape[2]):
        one, other = (without_rigid_motion(places, fields[:, :, field]) for fields in (found, expected))
        worst = max(worst, float(np.linalg.norm(one - other) / np.linalg.norm(other)))
    return worst


@pytest.mark.parametrize(
    ("shape", "film"), [("heart", MYLAR), ("L", GRAIN), ("hole", MYLAR), ("weld", GRAIN)]
)
def test_changes_are_those_of_balloons_inflated_again(
    shape: str, film: Film, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the rigidities that the derivative holds constant: their floors follow from the panel's width."""
    compare(Assembly.mirrored(meshed(SHAPES[shape])), film, monkeypatch)


def test_changes_of_an_assembly_in_space(monkeypatch: pytest.MonkeyPatch) -> None:
    compare(bodies.drum(1.0, 3), MYLAR, monkeypatch)


def compare(assembly: Assembly, film: Film, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of both backends with the differences of two balloons."""
    width = models.typical_width(assembly.panels)
    monkeypatch.setattr(models, "typical_width", lambda panels: width)
    rest = at_rest(assembly, film)
    moves = np.concatenate([wave(panel.rest_positions) for panel in assembly.panels])
    ahead, behind = (at_rest(moved(assembly, step * moves), film, rest) for step in (STEP, -STEP))
    expected = (ahead.positions - behind.positions)[:, :, None] / (2.0 * STEP)
    for backend in available():
        result = position_changes(rest, film, moves[:, :, None], backend)
        assert result.exact
        assert missed(rest.positions, result.changes, expected) < 1e-4


def moved(assembly: Assembly, moves: Floats) -> Assembly:
    """The same panels, their rest positions moved."""
    parts = np.split(moves, assembly.offsets[1:-1])
    panels = [
        replace(panel, rest_positions=panel.rest_positions + part)
        for panel, part in zip(assembly.panels, parts, strict=True)
    ]
    return replace(assembly, panels=tuple(panels))


@needs_native
@pytest.mark.parametrize(
    ("shape", "two_panels"), [("heart", False), ("hole", False), ("weld", False), ("weld", True)]
)
def test_both_solvers_find_the_same_changes(shape: str, two_panels: bool) -> None:
    panel, model = meshed(SHAPES[shape], 150), Model(two_panels=two_panels)
    rest = inflate(panel, GRAIN_ALONG, PRESSURE, model=model)
    moves = np.random.default_rng(1).standard_normal((len(rest.positions), 2, 3))
    one, other = (position_changes(rest, GRAIN_ALONG, moves, backend) for backend in ("native", "numpy"))
    assert one.exact == other.exact
    assert missed(rest.positions, one.changes, other.changes) < 1e-8


def test_two_equal_panels_stay_mirror_images() -> None:
    """The lower one lies with its other side out, and moves as the upper one does."""
    panel, model = meshed(SHAPES["heart"]), Model(two_panels=True, twist=0.0)
    rest = inflate(panel, MYLAR, PRESSURE, model=model)
    changes = position_changes(rest, MYLAR, wave(panel.rest_positions)[:, :, None]).changes
    assert changes.shape == (len(panel.rest_positions), 3, 1)
    assert np.abs(changes[panel.sealed, 2]).max() < 1e-4 * np.abs(changes).max()


@needs_native
def test_both_solvers_give_way_alike_where_the_hessian_is_indefinite() -> None:
    """On the way to rest Newton's Hessian takes its place, with tension; and it is said."""
    panel = meshed(SHAPES["hole"])
    problem = film_problem(panel, MYLAR, PRESSURE)
    positions = 0.7 * dome(panel) / panel.size
    directors = vertex_normals(positions, panel)
    moves = np.random.default_rng(2).standard_normal((len(positions), 2, 3))
    shell = Shell(problem)
    shell.exact = True
    loads = force_changes(shell, positions, directors, tangent_frames(directors), moves)
    one, other = (solver.tangent_solve(problem, positions, directors, loads) for solver in (NATIVE, NUMPY))
    assert not one.exact
    assert not other.exact
    assert missed(positions, one.changes, other.changes) < 1e-8
    assert not one.changes[panel.sealed, 2].any()  # held


def test_a_weld_that_crumples_is_refused() -> None:
    """Its film outside the seams pulls at the balloon, too, and where it lies is not known any more."""
    panel = meshed(SHAPES["heart"])
    rest = inflate(panel, MYLAR, PRESSURE)
    crumpled = replace(rest, report=replace(rest.report, model=Model(weld="crumpled")))
    with pytest.raises(InputError, match="elastic weld"):
        position_changes(crumpled, MYLAR, np.zeros((len(panel.rest_positions), 2, 1)))


@both_solvers
def test_a_state_that_is_no_balloon_is_refused(solver: Backend) -> None:
    problem = film_problem(meshed(SHAPES["heart"]), MYLAR, PRESSURE)
    places = np.full((len(problem.fixed), 3), np.nan)
    up = np.tile([0.0, 0.0, 1.0], (len(places), 1))
    with pytest.raises(SolverError, match="not near rest"):
        solver.tangent_solve(problem, places, up, np.ones((len(places), 5, 1)))
