# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mirror symmetry of drawings: found where it is, not found where it is not, made exact on demand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED, corners_of

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import (
    AUTO,
    DRAWN,
    EXACT,
    FORCE,
    OFF,
    exact_mirror,
    find_mirror,
    symmetric,
)
from BalloonWorkbench.core.tracing.picture import read_picture
from BalloonWorkbench.core.types import Floats

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"


def picture(name: str) -> Outline:
    drawing = read_picture(PICTURES / f"{name}.png", 0.3, None)
    return getattr(drawing, "largest", drawing)


def turned(outline: Outline, degrees: float) -> Outline:
    angle = np.radians(degrees)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return outline.map(lambda loop: loop @ turn + (0.4, -0.2))


def reflected(points: Floats, point: Floats, angle: float) -> Floats:
    """Mirror images by the textbook matrix (cos 2a, sin 2a; sin 2a, -cos 2a)."""
    cos, sin = np.cos(2.0 * angle), np.sin(2.0 * angle)
    return point + (points - point) @ np.array([[cos, sin], [sin, -cos]])


def without_twin(outline: Outline, point: Floats, angle: float) -> float:
    """Largest distance from the image of a corner to the nearest corner."""
    corners = np.concatenate(outline.loops)
    images = reflected(corners, point, angle)
    return max(float(np.linalg.norm(corners - image, axis=1).min()) for image in images)


@pytest.mark.parametrize(
    ("name", "angle"),
    [("heart", 90), ("butterfly", 90), ("bear", 90), ("cake", 90), ("star", 90), ("rocket", 45)],
)
def test_symmetric_pictures_are_found_with_their_axis(name: str, angle: float) -> None:
    mirror = find_mirror(picture(name))
    assert mirror.error < 0.2 * DRAWN
    assert np.degrees(mirror.angle) == pytest.approx(angle, abs=0.2)


@pytest.mark.parametrize("name", ["fish", "trex", "line-dog", "line-fish", "line-house"])
def test_other_pictures_are_not(name: str) -> None:
    assert find_mirror(picture(name)).error > 5.0 * DRAWN


@pytest.mark.parametrize("degrees", [-71.0, -20.0, 0.0, 3.3, 33.0, 88.0])
def test_an_axis_at_an_angle_is_found_to_rounding(degrees: float) -> None:
    """Of a heart drawn symmetric about the y axis."""
    mirror = find_mirror(turned(NAMED["heart"], degrees))
    assert mirror.error < 1e-9
    away = np.mod(np.degrees(mirror.angle) - 90.0 - degrees + 90.0, 180.0) - 90.0
    assert away == pytest.approx(0.0, abs=1e-5)
    across = (mirror.point - (0.4, -0.2)) @ (np.sin(mirror.angle), -np.cos(mirror.angle))
    assert across == pytest.approx(0.0, abs=1e-9)


def test_a_hand_drawing_has_the_axis_it_was_meant_to_have() -> None:
    """Rims that wander by 1 % of the size, the halves each in its own way."""
    random = np.random.default_rng(5)
    loop = NAMED["heart"].outer
    phase = 2.0 * np.pi * np.arange(len(loop)) / len(loop)
    wander = sum(
        np.outer(np.cos(k * phase + random.uniform(0.0, 6.3)), random.normal(0.0, 0.0012, 2))
        for k in range(2, 9)
    )
    mirror = find_mirror(turned(Outline(loop + wander), 12.0))
    assert 1e-3 < mirror.error < 0.02
    assert np.degrees(mirror.angle) == pytest.approx(102.0, abs=2.0)


def test_the_error_is_the_mean_distance_between_the_halves() -> None:
    """Of a tall strip whose right side stands 1 mm farther out over the upper half: the axis tilts along the
    straight line of least squares through that step, which leaves 5/24 of it on both long sides."""
    strip = corners_of((-0.05, -0.5), (0.05, -0.5), (0.05, 0.0), (0.051, 0.0), (0.051, 0.5), (-0.05, 0.5))
    mirror = find_mirror(strip)
    assert mirror.error == pytest.approx(5.0 / 24.0 * 1e-3 * 2.0 / 2.2, rel=0.05)
    assert np.degrees(mirror.angle) == pytest.approx(90.0, abs=0.1)


def test_of_many_axes_the_upright_one_is_taken() -> None:
    for name in ("disc", "ring", "square", "rectangle", "star", "spiky"):
        assert np.degrees(find_mirror(NAMED[name]).angle) == pytest.approx(90.0, abs=1e-6), name


def test_an_l_is_symmetric_about_its_diagonal_or_not_at_all() -> None:
    mirror = exact_mirror(NAMED["L"])
    assert mirror is not None
    assert np.degrees(mirror.angle) == pytest.approx(45.0)
    uneven = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.05), (0.05, 0.05), (0.05, 0.2), (0.0, 0.2))
    assert exact_mirror(uneven) is None
    assert find_mirror(uneven).error > DRAWN


@pytest.mark.parametrize("name", ["heart", "butterfly", "rocket"])
def test_a_symmetric_picture_becomes_exactly_so(name: str) -> None:
    drawn = picture(name)
    mirror = find_mirror(drawn)
    made = symmetric(drawn, AUTO, drawn=True)
    assert without_twin(made, mirror.point, mirror.angle) < 1e-12
    assert made.area == pytest.approx(drawn.area, rel=3e-3)
    assert exact_mirror(made) is not None
    assert made.notes == drawn.notes


def test_forced_symmetry_keeps_the_left_half_and_says_so() -> None:
    """A house with a chimney on its right side loses it; with one on its left gets two."""
    wall, top = (0.18, 0.2), (0.18, 0.22)
    right = [(0.0, 0.0), (0.2, 0.0), (0.2, 0.2), (0.2, 0.22), top, wall, (0.0, 0.2)]
    left = [(0.2 - x, y) for x, y in reversed(right)]
    for corners, area in ((right, 0.04), (left, 0.0408)):
        house = corners_of(*corners)
        made = symmetric(house, FORCE, drawn=False)
        mirror = find_mirror(made)
        assert without_twin(made, mirror.point, mirror.angle) < 1e-12
        assert made.area == pytest.approx(area, rel=7e-3)
        assert any("left one was kept" in note for note in made.notes)


def test_constructed_lines_and_off_stay_as_they_are() -> None:
    drawn = picture("heart")
    assert symmetric(drawn, OFF, drawn=True) is drawn
    assert symmetric(drawn, AUTO, drawn=False) is drawn
    fish = picture("fish")
    assert symmetric(fish, AUTO, drawn=True) is fish


def test_holes_are_mirrored_too() -> None:
    """Two eyes off the axis and a mouth across it, all of them a little wrong on the right side."""
    turn = np.linspace(0.0, 2.0 * np.pi, 90, endpoint=False)
    ellipse = np.stack([np.cos(turn), np.sin(turn)], axis=1)

    def eye(x: float, radius: float) -> Floats:
        return (radius * ellipse + (x, 0.04))[::-1]

    face = Outline(
        0.15 * ellipse, (eye(-0.05, 0.02), eye(0.05, 0.0201), (ellipse * (0.05, 0.01))[::-1] - (0.0, 0.05))
    )
    made = symmetric(face, FORCE, drawn=False)
    mirror = find_mirror(made)
    assert len(made.holes) == 3
    assert without_twin(made, mirror.point, mirror.angle) < 1e-12
    assert mirror.error < EXACT


def test_welds_inside_are_not_mirrored() -> None:
    welded = replace(NAMED["heart"], welds=(np.array([[-0.02, 0.0], [0.03, 0.01]]),))
    with pytest.raises(InputError, match="welds inside"):
        symmetric(welded, FORCE, drawn=False)


def test_an_unknown_choice_is_refused() -> None:
    with pytest.raises(InputError, match="auto, off, force"):
        symmetric(NAMED["disc"], "perhaps", drawn=True)
