# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a simulation behaves: what it refuses, reports, keeps and repeats."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, both_backends, film, needs_native, panel

from BalloonWorkbench.core.errors import Cancelled, InputError
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import stiffness_levels
from BalloonWorkbench.core.solver.problem import NewtonSettings


def drawn(name: str, vertices: int = 400) -> Panel:
    return triangulate(NAMED[name], size_for(NAMED[name], vertices))


@pytest.mark.parametrize("pressure", [0.0, -5.0, float("nan"), float("inf")])
def test_pressure_must_be_positive(pressure: float) -> None:
    with pytest.raises(InputError, match="pressure must be positive"):
        inflate(panel("disc", 400), film(100), pressure)


@both_backends
def test_progress_rises_and_is_named(backend: str) -> None:
    seen: list[tuple[float, str]] = []

    def watch(fraction: float, text: str) -> bool:
        seen.append((fraction, text))
        return True

    result = inflate(panel("disc", 400), film(100), PRESSURE, backend=backend, progress=watch)
    assert len(seen) == result.report.newton_steps
    assert {text for _, text in seen} == {"inflating"}
    assert all(0.0 <= fraction <= 1.0 for fraction, _ in seen)
    assert seen[-1][0] == 1.0


@both_backends
def test_cancel(backend: str) -> None:
    calls = []

    def stop_at_third(fraction: float, text: str) -> bool:
        calls.append(fraction)
        return len(calls) < 3

    with pytest.raises(Cancelled):
        inflate(panel("disc", 400), film(100), PRESSURE, backend=backend, progress=stop_at_third)
    assert len(calls) == 3


@both_backends
def test_failing_progress_comes_through(backend: str, capfd: pytest.CaptureFixture[str]) -> None:
    """What the callback raises reaches the caller, and nothing is printed on the way."""

    def broken(fraction: float, text: str) -> bool:
        raise ZeroDivisionError("the bar broke")

    with pytest.raises(ZeroDivisionError, match="the bar broke"):
        inflate(panel("disc", 400), film(100), PRESSURE, backend=backend, progress=broken)
    assert capfd.readouterr().err == ""


@both_backends
def test_running_out_of_steps_keeps_the_last_state(backend: str) -> None:
    result = inflate(
        panel("disc", 400), film(1000), PRESSURE, backend=backend, settings=NewtonSettings(max_steps=3)
    )
    assert not result.report.converged
    assert result.report.newton_steps == 3
    for array in (result.positions, result.directors, result.tensions):
        assert np.isfinite(array).all()
    assert 0.5 < result.volume < 5.0


@both_backends
def test_same_input_same_bytes(backend: str) -> None:
    first, second = (inflate(drawn("ring"), films()["mylar"], 2000.0, backend=backend) for _ in range(2))
    for name in ("positions", "directors", "tensions"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes()
    assert first.volume == second.volume


@pytest.mark.parametrize("k", [1, 7, 100, 1e4, 1e5])
@both_backends
def test_from_very_soft_to_very_stiff(backend: str, k: float) -> None:
    result = inflate(panel("disc", 250), film(k, seal_width=0.02), PRESSURE, backend=backend)
    assert result.report.converged
    assert result.report.newton_steps <= 30
    assert result.volume > 1.2
    assert (result.volume < 1.26) == (k >= 100)


@pytest.mark.parametrize("name", sorted(films()))
@needs_native
def test_every_film(name: str) -> None:
    """A star of 0.3 m at party pressure from each film of the library; the softer one holds more.

    Its weld takes up to a tenth: of thick paper it hardly bends in its plane.
    """
    bare, result = (
        inflate(drawn("star", 600), made_of, 2000.0, backend="native")
        for made_of in (replace(films()[name], seal_width=0.0), films()[name])
    )
    assert bare.report.converged
    assert result.report.converged
    assert 0.00049 < bare.volume < 0.00056
    assert 0.9 < result.volume / bare.volume < 1.0
    assert result.report.flexural_rigidity >= films()[name].flexural_rigidity * (1.0 - 1e-12)


@pytest.mark.parametrize("name", sorted(NAMED))
@needs_native
def test_every_shape(name: str) -> None:
    result = inflate(drawn(name, 600), films()["mylar"], 2000.0, backend="native")
    assert result.report.converged
    seams = np.concatenate(result.panel.loops)
    assert not result.positions[seams, 2].any()
    assert np.delete(result.positions[:, 2], seams).min() > 0.0
    assert result.tensions.min() > -1e-9 * result.tensions.max()
    ends = result.panel.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    before, now = (
        np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
        for points in (result.panel.rest_positions, result.positions)
    )
    assert (now / before).max() < 1.03  # mylar hardly stretches


@needs_native
def test_thin_strip_is_a_tube() -> None:
    """40 mm by 1 m: volume w^2 / pi a length less 0.0595 w^3 at each end, thickness 2 w / pi.

    The thickness is that of the vertices of a polygon with four chords across. Without a sealed band, which
    keeps the ends wide.
    """
    strip = panel("strip", 600)
    result = inflate(strip, film(1000), PRESSURE, backend="native")
    assert result.report.converged
    w = 0.04
    assert result.volume == pytest.approx(w**2 / np.pi - 2.0 * 0.0595 * w**3, rel=0.01)
    assert 2.0 * result.positions[:, 2].max() == pytest.approx(2.0 * w / np.pi, rel=0.04)


@pytest.mark.parametrize("name", ["ring", "holes"])
@needs_native
def test_holes_stay_open(name: str) -> None:
    result = inflate(drawn(name, 600), films()["nylon-foil"], 2000.0, backend="native")
    assert result.report.converged
    for seam in result.panel.loops[1:]:
        loops = result.panel.rest_positions[seam], result.positions[seam, :2]
        before, now = (np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1).sum() for loop in loops)
        assert now == pytest.approx(before, rel=0.05)
        assert signed_area(loops[1]) == pytest.approx(signed_area(loops[0]), rel=0.1)


@needs_native
def test_warm_start() -> None:
    """A rim moved by one per cent: fewer steps than from a dome, and the same balloon."""
    mylar = films()["mylar"]
    first = drawn("heart", 600)
    before = inflate(first, mylar, 2000.0, backend="native")
    moved = move_rim(first, [first.rest_positions[seam] * (1.01, 1.0) for seam in first.loops])
    assert moved is not None
    cold = inflate(moved, mylar, 2000.0, backend="native")
    warm = inflate(moved, mylar, 2000.0, backend="native", start=before)
    assert warm.report.converged
    assert warm.report.newton_steps < cold.report.newton_steps
    assert warm.report.newton_steps <= 12
    assert warm.volume == pytest.approx(cold.volume, rel=0.001)
    assert warm.volume > before.volume


@needs_native
def test_small_edits_need_few_steps() -> None:
    """As in the last passes of a correction: a rim moved by a thousandth, and no edit at all."""
    mylar = films()["mylar"]
    first = drawn("heart", 600)
    before = inflate(first, mylar, 2000.0, backend="native")
    moved = move_rim(first, [first.rest_positions[seam] * (1.001, 1.0) for seam in first.loops])
    assert moved is not None
    warm = inflate(moved, mylar, 2000.0, backend="native", start=before)
    again = inflate(first, mylar, 2000.0, backend="native", start=before)
    assert warm.report.converged
    assert max(warm.report.newton_steps, again.report.newton_steps) <= 6
    assert again.volume == pytest.approx(before.volume, rel=1e-4)
    assert 1.0005 < warm.volume / before.volume < 1.003


def test_start_from_another_mesh_is_a_cold_one() -> None:
    other = inflate(panel("disc", 400), film(100), PRESSURE)
    mesh = panel("disc", 500)
    cold = inflate(mesh, film(100), PRESSURE)
    assert inflate(mesh, film(100), PRESSURE, start=other).positions.tobytes() == cold.positions.tobytes()


def test_size_does_not_matter() -> None:
    """The same balloon ten times larger at a tenth of the pressure: k and the shape stay."""
    small = panel("disc", 400)
    large = Panel(10.0 * small.rest_positions, small.triangles, small.loops)
    one = inflate(small, film(100), PRESSURE)
    other = inflate(large, film(100), 0.1 * PRESSURE)
    assert other.report.stiffness_k == pytest.approx(one.report.stiffness_k)
    assert other.positions == pytest.approx(10.0 * one.positions, abs=1e-3)
    assert other.volume == pytest.approx(1000.0 * one.volume, rel=1e-5)
    assert other.tensions.max() == pytest.approx(one.tensions.max(), rel=1e-3)


def test_stiffness_levels() -> None:
    assert stiffness_levels(5.0) == (5.0,)
    levels = np.array(stiffness_levels(1000.0))
    assert levels[0] == pytest.approx(6.0)
    assert levels[-1] == pytest.approx(1000.0)
    ratios = levels[1:] / levels[:-1]
    assert ratios == pytest.approx(ratios[0])
    assert 1.0 < ratios[0] <= 5.0
