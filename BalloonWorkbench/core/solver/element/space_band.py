# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sealed band along a seam in space: each panel's half of it keeps its curvature in the film's own plane.

Two flat panels whose edges are curved differently can be sealed, and the film then stands at an angle. What
bends without stretching keeps the curvature of its edges in its own plane (the geodesic one), however it
stands; so no such balloon feels its bands, and each half of the band, which is welded to one film, resists
what differs from that. It is the law of seam_band.py in the plane across the director d of the film at the
middle vertex of a hinge. With u = e_before / l_before and v = e_after / l_after, T two unit vectors across d,
R the rotation by the turning angle at rest and a the length of seam that belongs to the vertex:

    E I / (2 a) |r|^2,    r = T^T v - R T^T u

It does not depend on the choice of T, nor on how the balloon lies; it is 0 for an even shortening, quadratic
in the positions, so that edges may shrink to nothing, and for d = e_z it is the law in the plane. A vertex
in the middle that moves by dx and a director that turns by t in T change r by

    dr = T^T dv - R T^T du + (R (d . u) - (d . v)) t

The energy lies between 0 and E I (|u| + |v|)^2 / (2 a). Without the second derivatives of r (Gauss-Newton)
its Hessian has no negative eigenvalue; `exact` adds them.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.solver.element.dkt import Numbers
from BalloonWorkbench.core.solver.element.seam_band import rest_turns
from BalloonWorkbench.core.types import Floats, Ints


class SpaceBand:
    """The band along the boundaries and welds of all panels of an assembly.

    hinges      (h, 3) vertices that are neighbours along one of them
    rigidities  (h,) E I of one panel's half of the band there
    """

    def __init__(self, rest_positions: Floats, hinges: Ints, rigidities: Floats) -> None:
        self.hinges, self.rigidities = hinges, rigidities
        self._corners = rest_positions[hinges]

    def energy(self, positions: Floats, directors: Floats) -> float:
        """Energy of the bent band at positions (n, 3) and directors (n, 3)."""
        rotation, before, after, stiffness = _rest(self._corners, self.rigidities)
        places, d = positions[self.hinges], directors[self.hinges[:, 1]]
        u, v = (places[:, 1] - places[:, 0]) * before[:, None], (places[:, 2] - places[:, 1]) * after[:, None]
        kink = v - rotation[:, 0, :1] * u - rotation[:, 1, :1] * np.cross(d, u)
        squares = np.sum(kink**2, axis=1) - np.einsum("hi,hi->h", d, kink) ** 2
        return 0.5 * float(stiffness @ squares)

    def derivatives(
        self, positions: Floats, directors: Floats, frames: Floats, *, exact: bool
    ) -> tuple[Floats, Floats]:
        """Forces (h, 11) and stiffnesses (h, 11, 11) in x, y, z of the three vertices and the two turns of
        the director of the middle one, in the frames (n, 3, 2).
        """
        rotation, before, after, stiffness = _rest(self._corners, self.rigidities)
        d, frame = directors[self.hinges[:, 1]], frames[self.hinges[:, 1]]
        places = positions[self.hinges]
        kink, operator = _kinks(rotation, before, after, places, d, frame)
        weighted = stiffness[:, None, None] * operator
        force = np.einsum("hki,hk->hi", weighted, kink)
        hessian = np.matmul(np.swapaxes(weighted, 1, 2), operator)
        if exact:
            back = np.einsum("hki,hk->hi", rotation, kink) * before[:, None]
            ahead = kink * after[:, None]
            shares = np.stack([-back, back + ahead, -ahead], axis=1) * stiffness[:, None, None]
            mixed = np.einsum("hi,hat->hait", d, shares).reshape(-1, 9, 2)
            hessian[:, :9, 9:] += mixed
            hessian[:, 9:, :9] += np.swapaxes(mixed, 1, 2)
            hessian[:, 9:, 9:] += stiffness[:, None, None] * _sinking(
                rotation, before, after, places, d, frame
            )
        return force, hessian

    def rest_forces(self, corners: Numbers, positions: Floats, directors: Floats, frames: Floats) -> Numbers:
        """The forces (h, 11) with other flat corners (h, 3, 2), analytic in them, as dkt.py is."""
        rotation, before, after, stiffness = _rest(corners, self.rigidities)
        middle = self.hinges[:, 1]
        kink, operator = _kinks(
            rotation, before, after, positions[self.hinges], directors[middle], frames[middle]
        )
        return np.asarray(np.einsum("h,hki,hk->hi", stiffness, operator, kink))


def _rest(corners: Numbers, rigidities: Floats) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """Of hinges with these flat corners: R (h, 2, 2), 1 / l_before, 1 / l_after and E I / a, (h,) each."""
    cosine, sine, before, after = rest_turns(corners)
    rotation = np.stack([np.stack([cosine, -sine], 1), np.stack([sine, cosine], 1)], 1)
    return rotation, 1.0 / before, 1.0 / after, 2.0 * rigidities / (before + after)


def _kinks(
    rotation: Numbers, before: Numbers, after: Numbers, places: Floats, d: Floats, frame: Floats
) -> tuple[Numbers, Numbers]:
    """r (h, 2) and its derivatives (h, 2, 11)."""
    ahead = np.swapaxes(frame, 1, 2) * after[:, None, None]
    back = rotation @ np.swapaxes(frame, 1, 2) * before[:, None, None]
    first, second = places[:, 1] - places[:, 0], places[:, 2] - places[:, 1]
    sunk, risen = (np.einsum("hi,hi->h", d, edge) * part for edge, part in ((first, before), (second, after)))
    turning = rotation * sunk[:, None, None] - risen[:, None, None] * np.eye(2)
    kink = np.einsum("hki,hi->hk", ahead, second) - np.einsum("hki,hi->hk", back, first)
    return kink, np.concatenate([back, -back - ahead, ahead, turning], axis=2)


def _sinking(
    rotation: Floats, before: Floats, after: Floats, places: Floats, d: Floats, frame: Floats
) -> Floats:
    """What Gauss-Newton leaves out in the turns, (h, 2, 2): a director that turns by t sinks by t^2 / 2."""
    u, v = (places[:, 1] - places[:, 0]) * before[:, None], (places[:, 2] - places[:, 1]) * after[:, None]
    cosine, sine = rotation[:, 0, 0], rotation[:, 1, 0]
    triple = sine * np.einsum("hi,hi->h", d, np.cross(u, v))
    flat_u, flat_v = np.einsum("hik,hi->hk", frame, u), np.einsum("hik,hi->hk", frame, v)
    crossed = flat_u[:, :, None] * flat_v[:, None, :]
    squares = flat_u[:, :, None] * flat_u[:, None, :] + flat_v[:, :, None] * flat_v[:, None, :]
    squares -= cosine[:, None, None] * (crossed + np.swapaxes(crossed, 1, 2))
    return np.asarray(triple[:, None, None] * np.eye(2) - squares)
