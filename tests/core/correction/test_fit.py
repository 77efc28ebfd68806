# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction: closed forms, real pictures, and honesty about what cannot be reached."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.correction.fit import Method, fit, inflate_outline
from BalloonWorkbench.core.correction.step import rotated_back, seam_rotations
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.errors import Cancelled, InputError, MeshError, OutlineError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.backend import available
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"
NAMES = sorted(path.stem for path in PICTURES.glob("*.png"))
# stiff enough to be inextensible: E t / (p L) is about 10 000
STIFF = replace(custom_film(2.4e10, 0.3, 25e-6), seal_width=0.0)


def circle(radius: float, count: int = 240) -> np.ndarray:
    angle = 2.0 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def test_there_are_eleven_pictures() -> None:
    assert len(NAMES) == 11


@pytest.mark.slow
def test_a_picture_inflates_to_the_drawing() -> None:
    """All of them: benchmarks/validation/correction.py."""
    drawing = read_picture(PICTURES / "butterfly.png", 0.3, None)
    design = fit(drawing, film("mylar"), 2000.0)
    size = max(drawing.size)
    assert design.reached
    assert design.inflation.report.converged
    assert design.residual.mean < 0.0015 * size
    assert design.residual.p95 < 0.006 * size
    assert first_crossing(design.pattern.loops) is None


SEALED = replace(STIFF, seal_width=0.005)
FILMS = pytest.mark.parametrize("film", [SEALED, STIFF], ids=["sealed", "unsealed"])


@pytest.mark.parametrize(
    ("backend", "film"), [*((backend.name, SEALED) for backend in available()), (None, STIFF)]
)
def test_pattern_of_a_disc_is_larger_by_the_elliptic_integral(backend: str | None, film: Film) -> None:
    """A disc of radius R needs a pattern of radius R int_0^1 dt / sqrt(1 - t^4)."""
    design = fit(Outline(circle(0.1)), film, 300.0, mesh_size=0.02, backend=backend)
    radius = np.sqrt(signed_area(design.pattern.outer) / np.pi)
    assert radius / 0.1 == pytest.approx(1.311028777, rel=3e-3)


@pytest.mark.slow
@FILMS
def test_pattern_of_a_strip_is_wider_by_half_pi(film: Film) -> None:
    """Far from its ends a tube of width w, here 20 times as long, needs a strip of width pi/2 w.

    A weld that hardly bends feels the ends farther, and coarse triangles more.
    """
    half, width = 0.6, 0.06
    strip = Outline(
        np.array([[-half, -width / 2], [half, -width / 2], [half, width / 2], [-half, width / 2]])
    )
    design = fit(strip, film, 300.0, mesh_size=0.006)
    middle = design.pattern.outer[np.abs(design.pattern.outer[:, 0]) < 0.1 * half]
    grown = middle[middle[:, 1] > 0, 1].mean() - middle[middle[:, 1] < 0, 1].mean()
    assert grown / width == pytest.approx(np.pi / 2, rel=3e-3)


def test_ring_keeps_its_hole() -> None:
    drawing = Outline(circle(0.1), (circle(0.05)[::-1],))
    design = fit(drawing, film("mylar"), 2000.0, mesh_size=0.012)
    assert len(design.pattern.holes) == len(design.silhouette.holes) == 1
    assert design.residual.mean < 0.01 * 0.2
    assert signed_area(design.pattern.holes[0]) < 0.0


def test_corners_of_the_drawing_stay_in_the_pattern() -> None:
    square = Outline(np.array([[0.0, 0.0], [0.2, 0.0], [0.2, 0.2], [0.0, 0.2]]))
    design = fit(square, film("mylar"), 2000.0, mesh_size=0.012)
    loop = design.pattern.outer
    ahead = np.roll(loop, -1, axis=0) - loop
    back = np.roll(ahead, 1, axis=0)
    turn = np.arctan2(back[:, 0] * ahead[:, 1] - back[:, 1] * ahead[:, 0], (back * ahead).sum(axis=1))
    assert np.count_nonzero(turn > np.radians(40.0)) == 4


def test_inflating_an_outline_keeps_it_as_the_pattern() -> None:
    drawing = Outline(circle(0.1))
    design = inflate_outline(drawing, film("mylar"), 2000.0, mesh_size=0.01)
    assert design.passes == 0
    np.testing.assert_allclose(design.pattern.outer, drawing.outer)
    shown = np.sqrt(signed_area(design.silhouette.outer) / np.pi)
    assert shown == pytest.approx(0.1 * 0.7644, rel=0.005)


def test_same_input_gives_the_same_pattern_to_the_last_digit() -> None:
    drawing = Outline(circle(0.1, 60) * (1.0, 0.7))
    first, second = (fit(drawing, film("mylar"), 2000.0, mesh_size=0.015) for _ in range(2))
    assert first.pattern.outer.tobytes() == second.pattern.outer.tobytes()


@pytest.mark.slow
def test_an_unreachable_drawing_is_marked() -> None:
    """A comb whose slits film closes still gives a valid pattern and a warning."""
    comb = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.1]]
    for slit in range(7):
        middle = 0.3 - 0.3 * (slit + 1) / 8
        sides = middle + np.array([[0.0005], [-0.0005]])
        comb += [[sides[0, 0], 0.1], [middle, 0.03], [sides[1, 0], 0.1]]
    drawing = Outline(np.array([*comb, [0.0, 0.1]]))
    design = fit(drawing, film("pe"), 2000.0, mesh_size=0.012, method=Method(symmetric=False))
    assert first_crossing(design.pattern.loops) is None
    assert not design.reached
    assert design.residual.mean > 0.01 * 0.3
    assert any("film cannot follow" in text for text in design.warnings)


def test_progress_can_stop_the_design() -> None:
    with pytest.raises(Cancelled):
        fit(
            Outline(circle(0.1)), film("mylar"), 2000.0, mesh_size=0.02, progress=lambda fraction, text: False
        )


def test_progress_rises() -> None:
    seen: list[float] = []

    def note(fraction: float, text: str) -> bool:
        seen.append(fraction)
        return True

    fit(Outline(circle(0.1)), film("mylar"), 2000.0, mesh_size=0.02, progress=note)
    assert seen == sorted(seen)
    assert seen[0] >= 0.0 and seen[-1] <= 1.0


@pytest.mark.parametrize(
    ("loop", "pressure", "mesh_size", "error"),
    [
        (circle(0.1), 0.0, None, InputError),
        (circle(0.1), -5.0, None, InputError),
        (circle(0.1), float("nan"), None, InputError),
        (circle(0.1), 2000.0, 0.15, MeshError),
        (np.array([[0.0, 0.0], [0.3, 0.0], [0.3, 0.001], [0.0, 0.001]]), 2000.0, 0.02, MeshError),
        (np.array([[0.0, 0.0], [0.1, 0.1], [0.1, 0.0], [0.0, 0.1]]), 2000.0, None, OutlineError),
        (np.zeros((4, 2)), 2000.0, None, OutlineError),
    ],
)
def test_bad_input_has_its_own_error(
    loop: np.ndarray, pressure: float, mesh_size: float | None, error: type[Exception]
) -> None:
    with pytest.raises(error):
        fit(Outline(loop), film("mylar"), pressure, mesh_size=mesh_size)


def test_alignment_undoes_a_rotation_and_a_shift() -> None:
    points = circle(1.0, 20) * (2.0, 1.0)
    angle = 0.4
    turned = points @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]) + (
        3.0,
        -1.0,
    )
    rotation, shift = alignment(turned, points, np.ones(20))
    np.testing.assert_allclose(turned @ rotation.T + shift, points, atol=1e-12)


def test_residual_is_the_distance_between_concentric_circles() -> None:
    error = residual(Outline(circle(1.0, 2000)), Outline(circle(1.02, 2000)))
    assert error.mean == pytest.approx(0.02, rel=1e-3)
    assert error.max == pytest.approx(0.02, rel=1e-3)


def test_curled_arms_are_uncurled() -> None:
    """The arms of an S curl up by a fifth of its size; the pattern's are straighter by as much."""
    drawing = NAMED["S"]
    scale = 0.19 / max(drawing.size)
    design = fit(drawing.map(lambda loop: scale * loop), film("mylar"), 2000.0, mesh_size=0.01)
    assert design.residual.mean < 0.003 * 0.19
    assert design.residual.max < 0.015 * 0.19


def test_turning_is_undone() -> None:
    """A square turned by a quarter, and what is missing above it is missing on its right in the pattern."""
    flat = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    quarter = np.column_stack([-flat[:, 1], flat[:, 0]])
    turn = seam_rotations(flat, quarter)
    np.testing.assert_allclose(turn, [[1.0, 0.0]] * 4, atol=1e-15)
    np.testing.assert_allclose(rotated_back(np.array([[0.0, 2.0]] * 4), 3.0 * turn), [[2.0, 0.0]] * 4)
