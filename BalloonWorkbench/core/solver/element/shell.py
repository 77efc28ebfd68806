# SPDX-License-Identifier: LGPL-2.1-or-later
"""The discrete film: energy, gradient and Hessian of a triangulated shell under pressure.

Unknowns are the positions x_i and a unit director d_i at each vertex. With F = dx/dX (3 x 2) of a triangle,
the rotations at its corner i are beta_i = (d_i . F e_X, d_i . F e_Y); the bending energy is the DKT energy of
these six numbers, bilinear in positions and directors, so that it is right at large rotations.

    energy = sum A W(E) + sum beta^T K beta / 2 + energy of the sealed band - p V(x) - g M(x) - loads . x

W is the tension field (membrane.py), V the volume between the film and the plane z = 0, and M, for a pressure
that grows with z by g, the integral of z over the inside of a closed film. The Hessian is
exact but for the second derivatives of beta, whose omission (Gauss-Newton) keeps the bending part positive
semi-definite; `exact` adds them. `tension` adds the stiffness of so much tension in all directions to the
Hessian, and `slack_stiffness` that part of the stiffness of taut film, whatever state it is in.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.errors import SolverError
from BalloonWorkbench.core.solver.element import dkt
from BalloonWorkbench.core.solver.element.kinematics import (
    deformation_gradients,
    facet_volume,
    first_moment,
    green_strains,
)
from BalloonWorkbench.core.solver.element.scatter import Scatter, rounds
from BalloonWorkbench.core.solver.element.seam_band import SeamBand
from BalloonWorkbench.core.solver.element.space_band import SpaceBand
from BalloonWorkbench.core.solver.problem import Energies, FilmProblem
from BalloonWorkbench.core.types import Bools, Floats, Ints

if TYPE_CHECKING:
    from scipy import sparse


def tangent_frames(directors: Floats) -> Floats:
    """Two unit vectors across each director, as columns: (n, 3, 2)."""
    smallest = np.argmin(np.abs(directors), axis=1)
    first = np.cross(directors, np.eye(3)[smallest])
    first /= np.linalg.norm(first, axis=1)[:, None]
    return np.stack([first, np.cross(directors, first)], axis=2)


def turned(directors: Floats, frames: Floats, turn: Floats) -> Floats:
    """Directors moved by turn (n, 2) in their tangent frames and put back on the sphere."""
    moved = directors + np.einsum("nij,nj->ni", frames, turn)
    return np.asarray(moved / np.linalg.norm(moved, axis=1)[:, None])


@dataclass(frozen=True)
class ElasticElements:
    """Forces and stiffness of the film of each triangle, without pressure, loads and bands.

    Rows are x, y, z of the three corners, then the two turns of each of their directors.
    gradient   (m, 3, 2) F
    membrane   (m, 15) forces of the stretched film, those in the turns 0
    rotation   (m, 6) beta
    jacobian   (m, 6, 15) d beta; 0 without bending
    moments    (m, 6) by which the bent film turns the rotations
    stiffness  (m, 15, 15)
    """

    gradient: Floats
    membrane: Floats
    rotation: Floats
    jacobian: Floats
    moments: Floats
    stiffness: Floats

    @property
    def force(self) -> Floats:
        """Of membrane and bending: (m, 15)."""
        return self.membrane + np.einsum("mik,mi->mk", self.jacobian, self.moments)


class Shell:
    """A film problem made ready for evaluation."""

    def __init__(self, problem: FilmProblem) -> None:
        self.problem = problem
        rest_positions, triangles, fixed = problem.rest_positions, problem.triangles, problem.fixed
        corners = rest_positions[triangles]
        self.triangles = triangles
        self.fixed = fixed
        self.membrane_stiffness = problem.membrane_stiffness
        self._membrane = problem.membrane
        self.flexural_rigidity = problem.flexural_rigidity
        self.pressure, self.gradient = problem.pressure, problem.gradient
        self.tension = self.slack_stiffness = 0.0
        self.exact = False
        self.loads = np.zeros((len(rest_positions), 3)) if problem.loads is None else problem.loads
        self.shape, self.areas = dkt.gradients(corners)  # (m, 3, 2), (m,)
        self._rotation_stiffness = dkt.rotation_stiffness(corners, problem.poisson_ratio)
        corner_areas = np.repeat(self.areas / 3.0, 3)
        self.vertex_areas = np.bincount(triangles.ravel(), corner_areas, len(rest_positions))
        if not np.all(self.vertex_areas):
            raise SolverError("The mesh has a vertex without triangles. Mesh the outline anew.")
        self.band: SeamBand | None = None
        self.space_band: SpaceBand | None = None
        if problem.hinges is not None and problem.hinge_rigidities is not None:
            if problem.in_space:
                self.space_band = SpaceBand(rest_positions, problem.hinges, problem.hinge_rigidities)
            else:
                self.band = SeamBand(rest_positions, problem.hinges, problem.hinge_rigidities)
        self.number, self.count = _numbered(fixed, problem.tied)

    @cached_property
    def scatter(self) -> Scatter:
        """From triangles and hinges to the free unknowns."""
        at_corners = self.number[self.triangles]  # (m, 3, 5)
        moves, turns = at_corners[:, :, :3].reshape(-1, 9), at_corners[:, :, 3:].reshape(-1, 6)
        elements = [np.concatenate([moves, turns], 1)]
        if self.band is not None:
            elements.append(self.number[self.band.hinges][:, :, :2].reshape(-1, 6))
        if self.space_band is not None:
            hinges = self.space_band.hinges
            places = self.number[hinges][:, :, :3].reshape(-1, 9)
            elements.append(np.concatenate([places, self.number[hinges[:, 1], 3:]], 1))
        return Scatter(elements, self.count)

    def energies(self, positions: Floats, directors: Floats) -> Energies:
        """The parts of the energy at positions (n, 3) and directors (n, 3)."""
        gradient = deformation_gradients(positions, self.triangles, self.shape)
        membrane = float(self.areas @ self._membrane(green_strains(gradient)).energy)
        bending = 0.0
        if self.flexural_rigidity:
            rotation = _rotations(gradient, directors[self.triangles])
            bending = float(np.einsum("mi,mij,mj->", rotation, self._rotation_stiffness, rotation))
        return Energies(
            self.membrane_stiffness * membrane,
            0.5 * self.flexural_rigidity * bending,
            -self.pressure * facet_volume(positions, self.triangles)
            - (self.gradient * first_moment(positions, self.triangles) if self.gradient else 0.0),
            -float(np.einsum("ij,ij->", self.loads, positions)),
            self._seam_energy(positions, directors),
        )

    def _seam_energy(self, positions: Floats, directors: Floats) -> float:
        if self.space_band is not None:
            return self.space_band.energy(positions, directors)
        return 0.0 if self.band is None else self.band.energy(positions)

    def derivatives(
        self, positions: Floats, directors: Floats, frames: Floats
    ) -> tuple[Floats, sparse.csc_matrix]:
        """Gradient (count,) and Hessian (count, count) in the free unknowns."""
        corners = positions[self.triangles]
        film = self.elastic(positions, directors, frames)
        force, stiffness = film.force, film.stiffness
        nodal = (self.pressure + 0.25 * self.gradient * corners[:, :, 2].sum(axis=1)) / 6.0
        for a in range(3):
            b, c = (a + 1) % 3, (a + 2) % 3
            force[:, 3 * a : 3 * a + 3] -= nodal[:, None] * np.cross(corners[:, b], corners[:, c])
            turning = nodal[:, None, None] * _cross_matrix(corners[:, c])
            stiffness[:, 3 * a : 3 * a + 3, 3 * b : 3 * b + 3] += turning
            stiffness[:, 3 * b : 3 * b + 3, 3 * a : 3 * a + 3] -= turning
        if self.gradient:
            _add_gradient(force, stiffness, corners, 0.25 * self.gradient)

        forces, stiffnesses = [force], [stiffness]
        if self.band is not None:
            band_force, band_stiffness = self.band.derivatives(positions)
            forces.append(band_force)
            stiffnesses.append(band_stiffness)
        if self.space_band is not None:
            band_force, band_stiffness = self.space_band.derivatives(
                positions, directors, frames, exact=self.exact
            )
            forces.append(band_force)
            stiffnesses.append(band_stiffness)
        loads = np.pad(self.loads, ((0, 0), (0, 2)))
        return self.scatter.vector(forces) - self.gathered(loads), self.scatter.matrix(stiffnesses)

    def elastic(self, positions: Floats, directors: Floats, frames: Floats) -> ElasticElements:
        """Membrane and bending of each triangle."""
        d, frames = directors[self.triangles], frames[self.triangles]
        gradient = deformation_gradients(positions, self.triangles, self.shape)
        membrane = self._membrane(green_strains(gradient))
        scale = self.membrane_stiffness * self.areas

        strain_operator = _strain_operator(gradient, self.shape)  # (m, 3, 9)
        force = np.zeros((len(d), 15))
        force[:, :9] = np.einsum("mik,mi->mk", strain_operator, membrane.stress * scale[:, None])
        stiffness = np.zeros((len(d), 15, 15))
        tangent = membrane.tangent
        if self.slack_stiffness:
            tangent = tangent + self.slack_stiffness * self.problem.taut_stiffness
        weighted = np.matmul(tangent * scale[:, None, None], strain_operator)
        stiffness[:, :9, :9] = np.matmul(np.swapaxes(strain_operator, 1, 2), weighted)
        s11, s22, s12 = (membrane.stress * scale[:, None]).T
        stress = np.stack([np.stack([s11, s12], 1), np.stack([s12, s22], 1)], 1)
        stress += (self.tension * self.areas)[:, None, None] * np.eye(2)
        geometric = self.shape @ stress @ np.swapaxes(self.shape, 1, 2)
        blocks = stiffness[:, :9, :9].reshape(-1, 3, 3, 3, 3)
        for axis in range(3):
            blocks[:, :, axis, :, axis] += geometric

        rotation = _rotations(gradient, d)
        if not self.flexural_rigidity:  # much of the work is for nothing then
            idle = np.zeros((len(d), 6, 15))
            return ElasticElements(gradient, force, rotation, idle, np.zeros_like(rotation), stiffness)
        jacobian = _rotation_operator(gradient, d, self.shape, frames)  # (m, 6, 15)
        bending = self.flexural_rigidity * self._rotation_stiffness
        stiffness += np.matmul(np.swapaxes(jacobian, 1, 2), np.matmul(bending, jacobian))
        moments = np.einsum("mij,mj->mi", bending, rotation)
        if self.exact:
            _add_second_rotations(stiffness, moments, rotation, self.shape, frames)
        return ElasticElements(gradient, force, rotation, jacobian, moments, stiffness)

    def gathered(self, values: Floats) -> Floats:
        """Values (n, 5, ...) of the unknowns of each vertex, summed in the free unknowns: (count, ...)."""
        free = self.number >= 0
        numbers, parts = self.number[free], values[free]
        total = np.zeros((self.count, *values.shape[2:]))
        for here in rounds(numbers):
            total[numbers[here]] += parts[here]
        return total

    def spread(self, step: Floats) -> tuple[Floats, Floats]:
        """Displacements (n, 3, ...) and director turns (n, 2, ...) from free unknowns (count, ...)."""
        full = step[self.number]
        full[self.number < 0] = 0.0
        return full[:, :3], full[:, 3:]


def _numbered(fixed: Bools, tied: Ints | None) -> tuple[Ints, int]:
    """Number (n, 5) of each unknown, -1 where it is held, and how many there are."""
    own = ~fixed
    if tied is not None:
        own[tied != np.arange(len(tied)), :3] = False
    number = np.full(fixed.shape, -1, dtype=np.int32)
    number[own] = np.arange(np.count_nonzero(own))
    if tied is not None:
        number[:, :3] = number[tied, :3]
    return number, int(np.count_nonzero(own))


def _strain_operator(gradient: Floats, shape: Floats) -> Floats:
    f1, f2 = gradient[:, None, :, 0], gradient[:, None, :, 1]
    g1, g2 = shape[:, :, None, 0], shape[:, :, None, 1]
    rows = np.stack([g1 * f1, g2 * f2, g1 * f2 + g2 * f1], axis=1)  # (m, 3, corner, axis)
    return rows.reshape(-1, 3, 9)


def _rotations(gradient: Floats, corner_directors: Floats) -> Floats:
    return np.matmul(corner_directors, gradient).reshape(-1, 6)


def _rotation_operator(gradient: Floats, corner_directors: Floats, shape: Floats, frames: Floats) -> Floats:
    count = len(gradient)
    operator = np.zeros((count, 3, 2, 15))
    # with respect to positions: d(beta_i)_k = d_i . dx_a g_a,k
    operator[:, :, :, :9] = (
        shape.transpose(0, 2, 1)[:, None, :, :, None] * corner_directors[:, :, None, None, :]
    ).reshape(count, 3, 2, 9)
    turning = np.einsum("mik,mcij->mckj", gradient, frames)
    for corner in range(3):
        operator[:, corner, :, 9 + 2 * corner : 11 + 2 * corner] = turning[:, corner]
    return operator.reshape(count, 6, 15)


def _add_second_rotations(
    stiffness: Floats, moments: Floats, rotation: Floats, shape: Floats, frames: Floats
) -> None:
    """The moments (m, 6) times the second derivatives of the rotations, on stiffness (m, 15, 15).

    beta is bilinear in positions and directors; a director that turns by an angle t sinks by t^2 / 2.
    """
    at_corners = moments.reshape(-1, 3, 2)
    mixed = np.einsum("mik,mak,mijt->majit", at_corners, shape, frames, optimize=True).reshape(-1, 9, 6)
    stiffness[:, :9, 9:] += mixed
    stiffness[:, 9:, :9] += np.swapaxes(mixed, 1, 2)
    sunk = np.einsum("mik,mik->mi", at_corners, rotation.reshape(-1, 3, 2))
    for turn in range(6):
        stiffness[:, 9 + turn, 9 + turn] -= sunk[:, turn // 2]


def _add_gradient(force: Floats, stiffness: Floats, corners: Floats, quarter: float) -> None:
    """What a quarter of the pressure's gradient adds: the pressure of a triangle changes with its heights."""
    normals = np.cross(np.roll(corners, -1, axis=1), np.roll(corners, -2, axis=1)) / 6.0  # dV / dx (m, 3, 3)
    force[:, 2:9:3] -= quarter * np.einsum("mi,mi->m", corners[:, 0], normals[:, 0])[:, None]
    changes = quarter * normals.reshape(-1, 9, 1)
    stiffness[:, :9, 2:9:3] -= changes
    stiffness[:, 2:9:3, :9] -= np.swapaxes(changes, 1, 2)


def _cross_matrix(vectors: Floats) -> Floats:
    x, y, z = vectors.T
    o = np.zeros_like(x)
    return np.stack([np.stack([o, -z, y], 1), np.stack([z, o, -x], 1), np.stack([-y, x, o], 1)], 1)
