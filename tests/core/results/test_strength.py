# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads of film and weld: closed forms, global balance, one answer on every mesh, and what they make safe."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from cut_through import balance, balance_of_all
from drawn_shapes import NAMED, corners_of, letter, star
from solver_cases import both_backends, circle

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.making.safety import FILM, WELD, safety, safety_with
from BalloonWorkbench.core.making.trade_figures import FILE, making
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.welds import spot
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.results import strength
from BalloonWorkbench.core.results.strength import loads, loads_along, seam_forces, settled_loads
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.volume_load import inflate_to_volume

FOIL = film("mylar")
PRESSURE = 2000.0
WIDTH = 0.1  # of the strip


SHAPES = {
    "disc": Outline(circle(0.2)),
    "star": star(5, 0.2, 0.04),
    "star of 12": star(12, 0.2, 0.1),
    "ring": Outline(circle(0.2), (circle(0.1)[::-1].copy(),)),
    "letter": letter("B"),
    "heart": NAMED["heart"],
    "strip": corners_of((0.0, 0.0), (0.8, 0.0), (0.8, WIDTH), (0.0, WIDTH)),
}


@cache
def panel(shape: str, vertices: int = 1500) -> Panel:
    return triangulate(SHAPES[shape], size_for(SHAPES[shape], vertices))


@cache
def inflated(shape: str, vertices: int = 1500) -> Inflation:
    return inflate(panel(shape, vertices), FOIL, PRESSURE)


# --- loads along a seam


def test_an_even_load_is_found_on_any_spacing() -> None:
    """On spacings much finer and much coarser than the window."""
    random = np.random.default_rng(1)
    for typical in (2e-4, 3e-3, 0.03):
        steps = typical * random.uniform(0.5, 1.5, 80)
        own = 0.5 * (steps + np.roll(steps, 1))
        forces = own[:, None] * np.array([3.0, 0.0, -4.0])
        found = loads_along(steps, forces, 0.01, 2.5 * typical)
        assert found.max() == pytest.approx(5.0, rel=0.06)


def test_a_force_in_a_point_is_shared_over_two_seal_widths() -> None:
    """Whatever the spacing, wherever the loop begins; beside a load that is small, and not zero."""
    for count in (20, 100, 1000):
        steps = np.full(count, 0.4 / count)
        forces = np.outer(steps, [0.0, 0.0, -10.0])
        forces[7, 2] -= 2.0
        for begin in (0, 5, 8):
            moved = loads_along(steps, np.roll(forces, begin, axis=0), 0.01, 2.5 * steps[0])
            assert np.argmax(moved) == (7 + begin) % count
            assert moved.max() == pytest.approx(200.0 + 10.0, rel=0.06)


def test_forces_of_crumples_cancel() -> None:
    """They are averaged as vectors: what pulls one way and then the other cancels along the seam."""
    steps = np.full(400, 1e-3)
    forces = np.outer(steps, [0.0, 0.0, -50.0])
    forces[::2, 0] += 0.2
    forces[1::2, 0] -= 0.2
    assert loads_along(steps, forces, 0.01, 2.5e-3).max() == pytest.approx(50.0, rel=0.01)
    assert np.linalg.norm(forces, axis=1).mean() / 1e-3 > 200.0


def test_a_loop_shorter_than_the_window_bears_its_load_along_itself() -> None:
    steps = np.full(24, 1e-4)
    forces = np.outer(np.ones(24), [0.0, 0.0, -0.01])
    assert loads_along(steps, forces, 0.01, 0.02).max() == pytest.approx(100.0, rel=0.05)


# --- closed forms and balance


def test_loads_of_a_long_strip() -> None:
    """A cylinder of radius w / pi: film and weld bear p w / pi (reference solutions of a tube)."""
    inflation = inflated("strip")
    flat, exact = inflation.panel.rest_positions, PRESSURE * WIDTH / np.pi
    ((seam, steps, forces),) = seam_forces(inflation, FOIL)
    lower = (np.abs(flat[seam, 0] - 0.4) < 0.15) & (flat[seam, 1] < 0.5 * WIDTH)
    own = 0.5 * (steps + np.roll(steps, 1))[lower].sum()
    assert np.linalg.norm(forces[lower].sum(axis=0)) / own == pytest.approx(exact, rel=0.03)
    found = loads(inflation, FOIL)
    assert exact < found.weld.value < 1.3 * exact
    assert exact < found.film.value


def test_load_of_the_weld_of_a_disc() -> None:
    """A seam of flat length 2 pi a holds p pi r^2, r = 0.76276 a: N = 0.2909 p a. Scallops take a little
    more."""
    found = loads(inflated("disc"), FOIL)
    exact = 0.5 * 0.762760**2 * PRESSURE * 0.2
    assert exact < found.weld.value < 1.12 * exact
    assert found.film.value > 3.0 * exact  # at the pole
    assert np.linalg.norm(found.film.place[:2]) < 0.03
    assert np.linalg.norm(found.weld.place[:2]) == pytest.approx(0.7628 * 0.2, rel=0.05)
    assert found.weld.place[2] == 0.0


def test_tension_across_planes() -> None:
    """Through the middle of a disc and beside it: pressure times section."""
    for middle in (0.3, 0.5, 0.6):
        places = np.linspace(middle - 0.03, middle + 0.03, 60)
        assert balance(inflated("disc"), FOIL, 0.3, places) == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("shape", ["ring", "star"])
def test_global_balance(shape: str) -> None:
    """Tension across planes is pressure times section; the seams hold the pressure on what they enclose."""
    inflation = inflate(panel(shape), FOIL, PRESSURE, start=inflated(shape), settings=NewtonSettings(1e-9))
    for angle in (0.0, 0.7, 0.5 * np.pi, 2.2):
        assert balance_of_all(inflation, FOIL, angle) == pytest.approx(1.0, abs=3e-3)
    pulled = -sum(float(forces[:, 2].sum()) for _, _, forces in seam_forces(inflation, FOIL))
    x, y = inflation.positions[:, :2].T
    enclosed = 0.0
    for seam in inflation.panel.loops:
        after = np.roll(seam, -1)
        enclosed += 0.5 * float(np.sum(x[seam] * y[after] - x[after] * y[seam]))
    assert pulled == pytest.approx(PRESSURE * enclosed, rel=0.015)


@pytest.mark.parametrize(
    ("shape", "pressure"),
    [("star", PRESSURE), ("letter", PRESSURE), ("letter", 300.0), ("star of 12", 300.0)],
)
def test_a_balloon_as_it_is_shown_is_in_balance(shape: str, pressure: float) -> None:
    """Not only one that is solved anew for its loads; also at a low pressure, beside which film is stiff."""
    inflation = inflated(shape) if pressure == PRESSURE else inflate(panel(shape), FOIL, pressure)
    for angle in (0.0, 0.7, 0.5 * np.pi, 2.2):
        assert balance_of_all(inflation, FOIL, angle) == pytest.approx(1.0, abs=0.02)


# --- the mesh


def test_loads_are_the_same_on_another_mesh() -> None:
    """1 500 vertices and 3 000; up to 12 000, and more shapes: benchmarks/validation/strength.py."""
    coarse, fine = (settled_loads(inflated("star", vertices), FOIL) for vertices in (1500, 3000))
    assert coarse[1]
    assert fine[1]
    assert coarse[0].weld.value == pytest.approx(fine[0].weld.value, rel=0.08)
    assert coarse[0].film.value == pytest.approx(fine[0].film.value, rel=0.08)


def test_sharp_notches_are_the_weakest_place() -> None:
    found = safety(inflated("star"), FOIL, exact=False)
    assert found.weakest == WELD
    assert found.place is not None
    assert np.linalg.norm(found.place[:2]) < 0.05  # an inner corner
    assert 2500.0 < found.safe_pressure < 3500.0


def test_loads_come_from_a_film_at_rest() -> None:
    """A letter whose tensions still change where the eye sees no more: like those of a solve to the end."""
    seen = inflate(panel("letter", 1500), FOIL, PRESSURE, settings=NewtonSettings(1e-3))
    found, at_rest = settled_loads(seen, FOIL)
    end = inflate(seen.panel, FOIL, PRESSURE, start=seen, settings=NewtonSettings(1e-11, 400))
    exact = loads(end, FOIL)
    assert at_rest
    assert found.film.value == pytest.approx(exact.film.value, rel=0.01)
    assert found.weld.value == pytest.approx(exact.weld.value, rel=0.01)
    assert loads(seen, FOIL).film.value > 1.02 * exact.film.value


def test_loads_that_do_not_come_to_rest_are_marked(monkeypatch: pytest.MonkeyPatch) -> None:
    inflation = inflated("disc")
    own = loads(inflation, FOIL)

    def none(*args: object, **options: object) -> Inflation:
        raise MissingPackageError("no solver")

    monkeypatch.setattr(strength, "inflate", none)
    found, at_rest = settled_loads(inflation, FOIL)
    assert not at_rest
    assert found.weld.value == own.weld.value

    def restless(*args: object, **options: object) -> Inflation:
        return replace(inflation, positions=1.02 * options["start"].positions)

    monkeypatch.setattr(strength, "inflate", restless)
    found, at_rest = settled_loads(inflation, FOIL)
    assert not at_rest
    assert found.film.value > own.film.value
    assert not safety(inflation, FOIL, exact=False).at_rest


# --- from loads to pressures


def test_the_margin_of_the_trade() -> None:
    data = json.loads(FILE.read_text(encoding="utf-8"))
    assert data["safety"] == making().safety == 2.0
    assert any(source.startswith("Safety: two") for source in data["sources"])


@pytest.mark.parametrize(("weld_limit", "weakest"), [(500.0, WELD), (1e9, FILM)])
@pytest.mark.parametrize("margin", [1.0, 2.0, 3.0])
def test_load_times_margin_is_the_limit_at_the_safe_pressure(
    weld_limit: float, weakest: str, margin: float
) -> None:
    found = safety_with(inflated("star"), FOIL, weld_limit, margin, exact=False)
    limit = {WELD: weld_limit, FILM: FOIL.max_stress * FOIL.thickness}[weakest]
    assert found.weakest == weakest
    assert found.safe_pressure * margin * found.load.value / PRESSURE == pytest.approx(limit, rel=1e-12)


def test_safe_pressure_of_a_long_strip() -> None:
    """Its weld of 500 N/m bears twice p w / pi at 7 854 Pa where the strip is straight; its corners less."""
    bound = making().seal_strength(FOIL) / making().safety * np.pi / WIDTH
    found = safety(inflated("strip"), FOIL, exact=False)
    assert found.weakest == WELD
    assert found.safe_pressure == pytest.approx(bound * PRESSURE * WIDTH / np.pi / found.load.value)
    assert 0.4 * bound < found.safe_pressure <= 1.01 * bound


def test_loads_at_the_safe_pressure() -> None:
    """Inflated to it, from a twentieth of it, the weld bears no more than its part."""
    low = inflate(panel("star"), FOIL, 150.0)
    bound = safety(low, FOIL, exact=False)
    there = inflate(panel("star"), FOIL, bound.safe_pressure)
    assert settled_loads(there, FOIL)[0].weld.value < 1.03 * bound.weld_limit / bound.margin


# --- balloons of other kinds


def test_a_spot_bears_the_film_around_it() -> None:
    """A spot of 5 mm in the middle of a square of 0.2 m: round it more than at the rim."""
    square = corners_of((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1))
    outline = replace(square, spots=(spot(np.zeros(2)),))
    inflation = inflate(triangulate(outline, size_for(outline, 1500)), FOIL, PRESSURE)
    found = settled_loads(inflation, FOIL)[0].weld
    around = inflation.positions[inflation.panel.loops[1]]
    assert np.linalg.norm(around - found.place, axis=1).min() < 0.003
    _, steps, forces = seam_forces(inflation, FOIL)[1]
    whole = np.linalg.norm(forces.sum(axis=0)) / steps.sum()
    assert whole * 0.98 < found.value < 1.5 * whole


def test_the_end_of_a_weld_inside_is_the_weakest_place() -> None:
    """From near the rim towards the middle: two chambers pull at it."""
    outline = replace(SHAPES["disc"], welds=(np.array([[0.0, -0.15], [0.0, 0.06]]),))
    inflation = inflate(triangulate(outline, size_for(outline, 1500)), FOIL, PRESSURE)
    found = settled_loads(inflation, FOIL)[0].weld
    ends = inflation.positions[inflation.panel.welds[0][[0, -1]]]
    assert np.linalg.norm(ends - found.place, axis=1).min() < 0.02
    assert found.value > 2.0 * loads(inflated("disc"), FOIL).weld.value


def test_two_panels_bear_what_one_and_its_mirror_image_bear() -> None:
    one = inflated("heart", 600)
    two = inflate(one.panel, FOIL, PRESSURE, model=Model(two_panels=True))
    expected, found = loads(one, FOIL), settled_loads(two, FOIL)[0]
    assert found.weld.value == pytest.approx(expected.weld.value, rel=0.1)
    assert found.film.value == pytest.approx(expected.film.value, rel=0.1)


@both_backends
def test_both_solvers_find_the_same_loads(backend: str) -> None:
    inflation = inflate(panel("star", 500), FOIL, PRESSURE, backend=backend)
    found, at_rest = settled_loads(inflation, FOIL)
    assert at_rest
    native = settled_loads(inflate(panel("star", 500), FOIL, PRESSURE), FOIL)[0]
    assert found.weld.value == pytest.approx(native.weld.value, rel=0.01)


def test_edges_longer_than_the_windows_have_the_even_load() -> None:
    """100 N/m all along, also where an edge between two vertices is longer than what is averaged over."""
    steps = np.array([0.1, 0.1, 0.1, 0.01, 0.01, 0.01])
    own = 0.5 * (steps + np.roll(steps, 1))
    forces = np.column_stack([0.0 * own, 0.0 * own, 100.0 * own])
    with np.errstate(all="raise"):
        found = loads_along(steps, forces, 0.005, 0.02)
    np.testing.assert_allclose(found[[1, 2]], 100.0)
    assert np.isfinite(found).all()


@pytest.mark.parametrize("kind", ["tiny", "grain", "shell", "soft", "volume", "no band"])
def test_odd_balloons_have_sound_loads(kind: str) -> None:
    """Smaller than the window, with a grain, as a plain shell, beyond the film's stretch, to a volume."""
    made_of, outline, pressure = FOIL, SHAPES["disc"], PRESSURE
    model = Model()
    if kind == "tiny":
        outline = Outline(circle(0.003))
    if kind == "grain":
        made_of = film("bopp-foil")
    if kind == "shell":
        model = Model(tension_field=False)
    if kind == "soft":
        made_of, pressure = film("pe"), 3e4
    if kind == "no band":
        made_of = replace(FOIL, seal_width=0.0)
    mesh = triangulate(outline, size_for(outline, 300))
    if kind == "volume":
        inflation = inflate_to_volume(mesh, made_of, 0.0097)
    else:
        inflation = inflate(mesh, made_of, pressure, model=model)
    found = settled_loads(inflation, made_of)[0]
    size = 0.5 * float(np.ptp(inflation.positions[:, 0]))
    mean = 0.5 * inflation.report.pressure * size
    most = 3.0 if model.tension_field else 30.0  # a plain shell crumples in a few sharp folds
    assert 0.5 * mean < found.weld.value < most * mean
    assert 0.5 * mean < found.film.value < max(most, 12.0) * mean
    assert safety(inflation, made_of, exact=False).safe_pressure > 0.0
