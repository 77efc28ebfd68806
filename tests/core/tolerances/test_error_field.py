# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors along a seam: their spread and correlation by formula, and the contour that they make."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED, corners_of

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import arc_lengths, signed_area
from BalloonWorkbench.core.tolerances.error_field import field, offset, wave_weights
from BalloonWorkbench.core.tolerances.spread import NORMAL, UNIFORM, Spread
from BalloonWorkbench.core.types import Floats

AROUND, ALONG = 1.0, 0.05
AT = np.arange(40) * AROUND / 40.0
FIELDS = 4000


def fields() -> Floats:
    return np.array([field(AT, AROUND, ALONG, (1, number)) for number in range(FIELDS)])


def test_fields_have_the_spread_and_correlation_of_their_formula() -> None:
    """exp(-d^2/2l^2) along a line twenty times as long as l; errors of FIELDS samples are 1/sqrt(FIELDS)."""
    many = fields()
    apart = np.minimum(AT, AROUND - AT)
    assert np.abs(many.mean(axis=0)).max() < 4.0 / np.sqrt(FIELDS)
    assert np.abs(many.std(axis=0) - 1.0).max() < 4.0 / np.sqrt(2.0 * FIELDS)
    correlation = many.T @ many[:, 0] / FIELDS
    assert np.abs(correlation - np.exp(-0.5 * (apart / ALONG) ** 2)).max() < 4.0 / np.sqrt(FIELDS)


def test_uniform_errors_stay_within_their_bounds_and_fill_them() -> None:
    """As alike as 6/pi asin(rho/2) says (Kruskal, J. Am. Stat. Assoc. 53, 1958)."""
    errors = Spread(UNIFORM, 2e-4, along=ALONG).of_normal(fields())
    assert np.abs(errors).max() <= 2e-4
    assert errors.std() == pytest.approx(2e-4 / np.sqrt(3.0), rel=0.02)
    rho = np.exp(-0.5 * (AT[1] / ALONG) ** 2)
    alike = np.corrcoef(errors[:, 0], errors[:, 1])[0, 1]
    assert alike == pytest.approx(6.0 / np.pi * np.arcsin(0.5 * rho), abs=0.03)


def test_normal_errors_have_their_deviation() -> None:
    assert Spread(NORMAL, 2e-4, along=ALONG).of_normal(np.array([1.0, -2.0])) == pytest.approx([2e-4, -4e-4])


def test_long_errors_move_the_whole_line() -> None:
    weights = wave_weights(AROUND, 10.0 * AROUND)
    assert weights[0] == pytest.approx(1.0)
    assert np.ptp(field(AT, AROUND, 10.0 * AROUND, (3,))) < 1e-6


def test_a_seed_names_a_field() -> None:
    assert np.array_equal(field(AT, AROUND, ALONG, (1, 2)), field(AT, AROUND, ALONG, (1, 2)))
    assert not np.allclose(field(AT, AROUND, ALONG, (1, 2)), field(AT, AROUND, ALONG, (1, 3)))


def test_the_same_field_on_a_finer_line() -> None:
    fine = np.arange(80) * AROUND / 80.0
    assert field(fine, AROUND, ALONG, (7,))[::2] == pytest.approx(field(AT, AROUND, ALONG, (7,)))


def test_errors_finer_than_any_mesh_are_refused() -> None:
    with pytest.raises(InputError, match="too fine for a seam"):
        wave_weights(1.0, 1e-4)


def test_a_square_grows_to_a_larger_square() -> None:
    square = corners_of((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)).outer
    grown = offset(square, np.full(len(square), 0.1))
    assert signed_area(grown) == pytest.approx(1.2**2)
    assert grown.min(axis=0) == pytest.approx([-0.1, -0.1])


def test_a_hole_grows_into_it() -> None:
    """More film: the outer loop grows, and the hole gets smaller."""
    ring = NAMED["ring"]
    for loop in ring.loops:
        around = arc_lengths(loop)[-1]
        grown = signed_area(offset(loop, np.full(len(loop), 1e-4))) - signed_area(loop)
        assert grown == pytest.approx(1e-4 * around, rel=0.01)
