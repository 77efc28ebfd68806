# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tension field of a film that is stiffer along its grain than across it.

A wrinkled film carries one tension, along t = (cos a, sin a). By duality its relaxed energy is the largest
over a of E(a) (t . E t)^2 / 2, with Young's modulus in the direction of a

    1 / E(a) = cos^4 a + sin^4 a / r + cos^2 a sin^2 a (1 / g - 2 nu)

in units of the modulus along the grain; r is the modulus across, g the shear modulus, nu the contraction
across under tension along. For r = 1 and g = 1 / (2 + 2 nu) it is the isotropic tension field of membrane.py.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.solver.element.membrane import MembraneResponse
from BalloonWorkbench.core.types import Floats

# The native solver is given these numbers (c_interface.py).
DIRECTIONS = 24  # directions tried before Newton's method finds the best
DIRECTION_STEPS = 8


@dataclass(frozen=True)
class Grain:
    """Elasticity of an orthotropic film relative to the modulus along the grain.

    across   Young's modulus across the grain
    shear    shear modulus
    poisson  contraction across under tension along
    angle    of the grain from the x axis of the panel [rad]
    """

    across: float
    shear: float
    poisson: float
    angle: float = 0.0

    @property
    def stiffness(self) -> Floats:
        """Plane stress (3, 3) from E11, E22, 2 E12 to S11, S22, S12 in the grain's axes."""
        scale = 1.0 / (1.0 - self.poisson**2 * self.across)
        coupling = scale * self.poisson * self.across
        return np.array(
            [[scale, coupling, 0.0], [coupling, scale * self.across, 0.0], [0.0, 0.0, self.shear]]
        )

    @property
    def turn(self) -> Floats:
        """(3, 3) from strains E11, E22, 2 E12 in the panel's axes to those in the grain's."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        return np.array(
            [[c * c, s * s, c * s], [s * s, c * c, -c * s], [-2 * c * s, 2 * c * s, c * c - s * s]]
        )


def orthotropic_tension_field(strain: Floats, grain: Grain) -> MembraneResponse:
    """Response at Green strains (m, 3), in units of the modulus along the grain times t."""
    turn = grain.turn
    local = strain @ turn.T
    stiffness = grain.stiffness
    stress = local @ stiffness
    tangent = np.zeros((len(strain), 3, 3))
    smaller = 0.5 * (stress[:, 0] + stress[:, 1]) - np.hypot(
        0.5 * (stress[:, 0] - stress[:, 1]), stress[:, 2]
    )
    longest = 0.5 * (local[:, 0] + local[:, 1]) + np.hypot(
        0.5 * (local[:, 0] - local[:, 1]), 0.5 * local[:, 2]
    )
    taut = smaller > 0.0
    wrinkled = ~taut & (longest > 0.0)
    tangent[taut] = stiffness
    stress[~taut] = 0.0
    stress[wrinkled], tangent[wrinkled] = _wrinkled(local[wrinkled], grain)
    energy = 0.5 * np.einsum("ij,ij->i", stress, local)
    return MembraneResponse(energy, stress @ turn, turn.T @ tangent @ turn)


def _wrinkled(strain: Floats, grain: Grain) -> tuple[Floats, Floats]:
    """Stress (m, 3) and tangent (m, 3, 3) of wrinkled triangles, in the grain's axes."""
    # the direction of the longest fibre is tried too: where a film hardly lengthens, only its neighbours do
    longest = 0.5 * np.arctan2(strain[:, 2], strain[:, 0] - strain[:, 1])
    spread = np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    trials = np.column_stack([longest, np.broadcast_to(spread, (len(strain), DIRECTIONS))])
    c, s = np.cos(trials), np.sin(trials)
    lengthening = c * c * strain[:, :1] + s * s * strain[:, 1:2] + c * s * strain[:, 2:]
    merit = np.where(lengthening > 0.0, _modulus(trials, grain)[0] * lengthening**2, -1.0)
    angle = trials[np.arange(len(strain)), np.argmax(merit, axis=1)]
    for _ in range(DIRECTION_STEPS):
        slope, bend, _, _ = _merit(angle, strain, grain)
        step = np.where(bend < 0.0, -slope / np.where(bend < 0.0, bend, 1.0), 0.0)
        angle = angle + np.clip(step, -0.5 * np.pi / DIRECTIONS, 0.5 * np.pi / DIRECTIONS)
    _, bend, stress, mixed = _merit(angle, strain, grain)
    c, s = np.cos(angle), np.sin(angle)
    along = np.column_stack([c * c, s * s, c * s])
    modulus, _, _ = _modulus(angle, grain)
    tangent = modulus[:, None, None] * along[:, :, None] * along[:, None, :]
    tangent -= mixed[:, :, None] * mixed[:, None, :] / np.minimum(bend, -1e-300)[:, None, None]
    return stress, tangent


def _modulus(angle: Floats, grain: Grain) -> tuple[Floats, Floats, Floats]:
    """Young's modulus in a direction, and its first and second derivative by the angle."""
    mixed = 1.0 / grain.shear - 2.0 * grain.poisson
    c2, s2 = np.cos(2.0 * angle), np.sin(2.0 * angle)
    # cos^4 = (1 + c2)^2 / 4, sin^4 = (1 - c2)^2 / 4, cos^2 sin^2 = s2^2 / 4
    compliance = 0.25 * ((1.0 + c2) ** 2 + (1.0 - c2) ** 2 / grain.across + mixed * s2**2)
    first = -(1.0 + c2) * s2 + (1.0 - c2) * s2 / grain.across + mixed * s2 * c2
    c4 = c2**2 - s2**2
    second = -2.0 * (c2 + c4) + 2.0 * (c2 - c4) / grain.across + 2.0 * mixed * c4
    return 1.0 / compliance, -first / compliance**2, 2.0 * first**2 / compliance**3 - second / compliance**2


def _merit(angle: Floats, strain: Floats, grain: Grain) -> tuple[Floats, Floats, Floats, Floats]:
    """Derivatives by the angle of E(a) e^2 / 2, its gradient and mixed derivative by the strain."""
    modulus, first, second = _modulus(angle, grain)
    c, s = np.cos(angle), np.sin(angle)
    along = np.column_stack([c * c, s * s, c * s])
    turned = np.column_stack([-2.0 * c * s, 2.0 * c * s, c * c - s * s])  # d along / da
    e = np.einsum("ij,ij->i", along, strain)
    de = np.einsum("ij,ij->i", turned, strain)
    dde = -4.0 * e + 2.0 * (strain[:, 0] + strain[:, 1])
    slope = 0.5 * first * e**2 + modulus * e * de
    bend = 0.5 * second * e**2 + 2.0 * first * e * de + modulus * (de**2 + e * dde)
    stress = (modulus * e)[:, None] * along
    mixed = (first * e + modulus * de)[:, None] * along + (modulus * e)[:, None] * turned
    return slope, bend, stress, mixed
