# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vectors: turns, directions, rotations and the foot on an edge against complex numbers and closed forms."""

import numpy as np
import pytest

from BalloonWorkbench.core.geometry.vectors import (
    alignment,
    cross,
    direction,
    foot,
    perpendicular,
    rotation,
    turn,
    unit,
    wrapped,
)

RANDOM = np.random.default_rng(4)


def as_complex(vectors):
    return vectors[..., 0] + 1j * vectors[..., 1]


def test_products_and_turns_are_those_of_complex_numbers() -> None:
    one, other = RANDOM.normal(size=(2, 200, 2))
    product = np.conj(as_complex(one)) * as_complex(other)
    assert cross(one, other) == pytest.approx(product.imag, abs=1e-14)
    assert turn(one, other) == pytest.approx(np.angle(product), abs=1e-12)
    assert as_complex(perpendicular(one)) == pytest.approx(1j * as_complex(one))


def test_a_reversal_turns_by_half_a_circle_and_no_vector_by_nothing() -> None:
    assert abs(float(turn(np.array([1.0, 0.0]), np.array([-1.0, 0.0])))) == pytest.approx(np.pi)
    assert float(turn(np.zeros(2), np.array([1.0, 0.0]))) == 0.0


def test_unit_vectors_have_length_one_and_nothing_stays_nothing() -> None:
    vectors = RANDOM.normal(size=(50, 3)) * 10.0 ** RANDOM.uniform(-150, 150, (50, 1))
    assert np.linalg.norm(unit(vectors), axis=1) == pytest.approx(1.0)
    assert np.array_equal(unit(np.zeros((2, 2))), np.zeros((2, 2)))


def test_angles_are_wrapped_round() -> None:
    angles = RANDOM.uniform(-30.0, 30.0, 500)
    assert as_complex(direction(wrapped(angles))) == pytest.approx(np.exp(1j * angles))
    assert np.abs(wrapped(angles)).max() <= np.pi


@pytest.mark.parametrize("quarters", range(-4, 5))
def test_quarter_turns_are_exact(quarters: int) -> None:
    """A panel turned twice by a quarter is the same panel turned by half a circle, to the last digit."""
    points = RANDOM.normal(size=(20, 2))
    turned = points @ rotation(0.5 * np.pi * quarters)
    assert np.array_equal(as_complex(turned), as_complex(points) * [1, 1j, -1, -1j][quarters % 4])


def test_a_rotation_turns_counter_clockwise() -> None:
    for angle in RANDOM.uniform(-10.0, 10.0, 50):
        points = RANDOM.normal(size=(5, 2))
        assert as_complex(points @ rotation(angle)) == pytest.approx(as_complex(points) * np.exp(1j * angle))


@pytest.mark.parametrize("angle", [0.0, 1e-12, 0.3, np.pi, -2.0])
def test_alignment_undoes_a_motion_and_is_the_best_one(angle: float) -> None:
    points = RANDOM.normal(size=(20, 2))
    weights = RANDOM.uniform(0.1, 1.0, 20)
    matrix, shift = alignment(points @ rotation(angle) + (3.0, -1.0), points, weights)
    assert (points @ rotation(angle) + (3.0, -1.0)) @ matrix.T + shift == pytest.approx(points, abs=1e-12)
    goals = points + 0.1 * RANDOM.normal(size=points.shape)
    matrix, shift = alignment(points, goals, weights)

    def missed(matrix, shift) -> float:
        return float(weights @ ((points @ matrix.T + shift - goals) ** 2).sum(axis=1))

    best = missed(matrix, shift)
    for _ in range(50):
        moved = matrix @ rotation(0.01 * RANDOM.normal()), shift + 0.01 * RANDOM.normal(size=2)
        assert missed(*moved) >= best


def test_the_foot_is_the_nearest_of_many_places_on_the_edge() -> None:
    for _ in range(200):
        x, y, u, v = RANDOM.normal(size=4)
        share, away = foot(x, y, u, v)
        many = np.linspace(0.0, 1.0, 2001)
        distances = np.hypot(x - many * u, y - many * v)
        assert distances.min() >= away - 1e-15
        assert away == pytest.approx(distances.min(), abs=1e-3)
        assert share == pytest.approx(many[np.argmin(distances)], abs=1e-3)


def test_an_edge_without_length_is_its_point() -> None:
    share, away = foot(np.array([3.0, 0.0]), np.array([4.0, 0.0]), 0.0, 0.0)
    assert np.array_equal(share, [0.0, 0.0])
    assert np.array_equal(away, [5.0, 0.0])
