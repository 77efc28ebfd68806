# SPDX-License-Identifier: LGPL-2.1-or-later
"""The discrete Kirchhoff triangle (Batoz, Bathe and Ho 1980, "A study of three-node triangular plate
bending elements", IJNME 15).

The rotations beta of the normal vary quadratically. At a corner they are unknowns; at the middle of a
side (i, j) with unit tangent s and normal n Kirchhoff's hypothesis gives

    beta = -3/(2 l) (w_j - w_i) s + (n n^T / 2 - s s^T / 4) (beta_i + beta_j)

In the shell the deflection is measured from the triangle's own plane, so w = 0 at the corners and only
the six rotations remain (see shell.py).

All of it is analytic in the corners, so that complex ones with a small imaginary part give its derivatives
(Squire and Trapp 1998, "Using complex variables to estimate derivatives of real functions").
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.types import Floats

#: Real, or complex for the sake of derivatives.
Numbers = NDArray[Any]

SIDES = ((0, 1), (1, 2), (2, 0))


def shape_derivatives(area_coordinates: Floats) -> Floats:
    """d N / d L: (6, 3) for one point given by its three area coordinates."""
    derivative = np.zeros((6, 3))
    for corner in range(3):
        derivative[corner, corner] = 4.0 * area_coordinates[corner] - 1.0
    for side, (i, j) in enumerate(SIDES):
        derivative[3 + side, i] = 4.0 * area_coordinates[j]
        derivative[3 + side, j] = 4.0 * area_coordinates[i]
    return derivative


# derivatives of the six quadratic shape functions (corners, then sides 01, 12, 20) with respect to the
# area coordinates (L0, L1, L2), at the middles of the sides, where a quadratic integrand is exact
_MIDDLES = np.array([[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]])
_AT_MIDDLES = np.stack([shape_derivatives(middle) for middle in _MIDDLES])


def gradients(corners: Numbers) -> tuple[Numbers, Numbers]:
    """Gradients of the area coordinates (m, 3, 2) and the areas (m,) of triangles (m, 3, 2)."""
    edge = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)  # opposite to each corner
    double_area = edge[:, 1, 0] * edge[:, 2, 1] - edge[:, 1, 1] * edge[:, 2, 0]
    gradient = np.stack([-edge[:, :, 1], edge[:, :, 0]], axis=2) / double_area[:, None, None]
    return gradient, 0.5 * double_area


def curvature_operators(corners: Numbers) -> Numbers:
    """Curvatures from (w_i, beta_x_i, beta_y_i): (m, 3 points, 3, 9).

    corners (m, 3, 2). The points are the middles of the sides, each with a third of the area; the rows are
    beta_x,x and beta_y,y and beta_x,y + beta_y,x.
    """
    count = len(corners)
    gradient, _ = gradients(corners)
    # rotations at the six nodes from the nine unknowns: (m, 6 nodes, 2, 9)
    rotation = np.zeros((count, 6, 2, 9), dtype=gradient.dtype)
    for corner in range(3):
        rotation[:, corner, 0, 3 * corner + 1] = 1.0
        rotation[:, corner, 1, 3 * corner + 2] = 1.0
    for side, (i, j) in enumerate(SIDES):
        vector = corners[:, j] - corners[:, i]
        length = np.sqrt((vector**2).sum(axis=1))
        s = vector / length[:, None]
        n = perpendicular(s)
        average = 0.5 * n[:, :, None] * n[:, None, :] - 0.25 * s[:, :, None] * s[:, None, :]
        slope = 1.5 * s / length[:, None]
        for corner, sign in ((i, 1.0), (j, -1.0)):
            rotation[:, 3 + side, :, 3 * corner] = sign * slope
            rotation[:, 3 + side, :, 3 * corner + 1 : 3 * corner + 3] = average
    slopes = _AT_MIDDLES @ gradient[:, None]
    along = np.swapaxes(slopes.reshape(count, 3, 6, 2), 2, 3).reshape(count, 6, 6)
    changes = (along @ rotation.reshape(count, 6, 18)).reshape(count, 3, 2, 2, 9)  # by x and y, of beta
    across = changes[:, :, 1, 0] + changes[:, :, 0, 1]
    return np.stack([changes[:, :, 0, 0], changes[:, :, 1, 1], across], axis=2)


def bending_law(poisson_ratio: float) -> Floats:
    """(3, 3) moments from curvatures, per flexural rigidity."""
    nu = poisson_ratio
    return np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]])


def plate_stiffness(corners: Floats, poisson_ratio: float) -> Floats:
    """Element stiffness (m, 9, 9) per flexural rigidity, unknowns (w, theta_x = w,y, theta_y = -w,x)."""
    operators = curvature_operators(corners)
    operators = operators[..., [0, 2, 1, 3, 5, 4, 6, 8, 7]]  # (w, beta_y, beta_x)
    operators[..., 1::3] *= -1.0  # theta_x = -beta_y
    return _integrate(operators, corners, poisson_ratio)


def rotation_stiffness(corners: Numbers, poisson_ratio: float) -> Numbers:
    """Element stiffness (m, 6, 6) per flexural rigidity in (beta_x, beta_y) of the corners, with w = 0."""
    operators = curvature_operators(corners)[..., [1, 2, 4, 5, 7, 8]]
    return _integrate(operators, corners, poisson_ratio)


def _integrate(operators: Numbers, corners: Numbers, poisson_ratio: float) -> Numbers:
    _, areas = gradients(corners)
    moments = bending_law(poisson_ratio) @ operators
    flat = (len(operators), 9, operators.shape[3])  # three curvatures at three points
    stiffness = np.swapaxes(operators.reshape(flat), 1, 2) @ moments.reshape(flat)
    return np.asarray(stiffness * (areas / 3.0)[:, None, None])
