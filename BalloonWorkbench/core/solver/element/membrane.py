# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tension-field membrane: a film that carries no compression because it wrinkles instead.

The relaxed energy of an isotropic St Venant-Kirchhoff film in plane stress (Pipkin 1986,
"The relaxed energy density for isotropic elastic membranes"; Steigmann 1990). With the principal
Green strains E1 >= E2:

    slack     E1 <= 0            W = 0
    wrinkled  E2 + nu E1 <= 0    W = E t E1^2 / 2
    taut      otherwise          St Venant-Kirchhoff

It is C1 and convex in the strain; its stress is tensile, so neither the material nor the geometric
stiffness has a negative eigenvalue.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.types import Bools, Floats


@dataclass(frozen=True)
class MembraneResponse:
    """Energy density, second Piola-Kirchhoff stress and tangent of each triangle.

    energy   (m,) per rest area, in units of E t
    stress   (m, 3) S11, S22, S12 in units of E t
    tangent  (m, 3, 3) dS / d(E11, E22, 2 E12) in units of E t, positive semi-definite
    """

    energy: Floats
    stress: Floats
    tangent: Floats


def principal_strains(strain: Floats) -> tuple[Floats, Floats, Floats]:
    """Larger and smaller principal value and direction of the larger one.

    strain (m, 3) E11, E22, 2 E12. Returns (m,), (m,) and (m, 2) unit vectors.
    """
    mean = 0.5 * (strain[:, 0] + strain[:, 1])
    half_difference = 0.5 * (strain[:, 0] - strain[:, 1])
    radius = np.hypot(half_difference, 0.5 * strain[:, 2])
    angle = 0.5 * np.arctan2(0.5 * strain[:, 2], half_difference)
    return mean + radius, mean - radius, direction(angle)


def states(major: Floats, minor: Floats, poisson_ratio: float) -> tuple[Bools, Bools]:
    """Which triangles are taut and which are wrinkled, (m,) each; the rest is slack."""
    taut = minor + poisson_ratio * major > 0.0
    return taut, ~taut & (major > 0.0)


def tension_field(strain: Floats, poisson_ratio: float) -> MembraneResponse:
    """Response of the film to Green strains (m, 3) E11, E22, 2 E12."""
    nu = poisson_ratio
    major, minor, axis = principal_strains(strain)
    taut, wrinkled = states(major, minor, nu)

    elastic = plane_stress(nu)
    tangent = np.zeros((len(strain), 3, 3))
    tangent[taut] = elastic

    c, s = axis[wrinkled].T
    along = np.column_stack([c * c, s * s, c * s])  # E1 = along . strain
    across = np.column_stack([-c * s, c * s, 0.5 * (c * c - s * s)])  # shear that turns the wrinkles
    e1, e2 = major[wrinkled], minor[wrinkled]
    turning = 2.0 * e1 / (e1 - e2)
    tangent[wrinkled] = (
        along[:, :, None] * along[:, None, :]
        + turning[:, None, None] * across[:, :, None] * across[:, None, :]
    )

    stress = np.zeros_like(strain)
    stress[taut] = strain[taut] @ elastic
    stress[wrinkled] = e1[:, None] * along
    return MembraneResponse(0.5 * np.einsum("ij,ij->i", stress, strain), stress, tangent)


def plane_stress(poisson_ratio: float) -> Floats:
    """Stiffness (3, 3) of an isotropic film from E11, E22, 2 E12 to S11, S22, S12, in units of E t."""
    nu = poisson_ratio
    return np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]]) / (1.0 - nu**2)


def without_wrinkles(strain: Floats, stiffness: Floats) -> MembraneResponse:
    """Response of a plain shell, which carries compression like tension: stiffness (3, 3)."""
    stress = strain @ stiffness
    tangent = np.broadcast_to(stiffness, (len(strain), 3, 3))
    return MembraneResponse(0.5 * np.einsum("ij,ij->i", stress, strain), stress, tangent)


def principal_stresses(stress: Floats) -> Floats:
    """Larger and smaller principal value (m, 2) of stresses S11, S22, S12 (m, 3)."""
    mean = 0.5 * (stress[:, 0] + stress[:, 1])
    radius = np.hypot(0.5 * (stress[:, 0] - stress[:, 1]), stress[:, 2])
    return np.column_stack([mean + radius, mean - radius])


def principal_tensions(strain: Floats, membrane_stiffness: float, poisson_ratio: float) -> Floats:
    """Principal second Piola-Kirchhoff tensions (m, 2) N/m of an isotropic film, the larger one first."""
    return membrane_stiffness * principal_stresses(tension_field(strain, poisson_ratio).stress)
