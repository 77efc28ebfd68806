# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of revolution from their profile alone: an independent reference for discs and rings.

Two equal annuli inner < s < outer of a relaxed St Venant-Kirchhoff film, sealed at both rims; inner = 0
is the disc. The unknowns are radius r and height z along the meridian of one film, on so fine a grid that
its error does not show. Wrinkles relieve the film along the meridian or along the parallel; a film free
to break the symmetry may hold a little more."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from BalloonWorkbench.core.types import Floats

_NODES = 4000


@dataclass(frozen=True)
class Profile:
    """The meridian of the upper film.

    In units of the outer flat radius: flat radius (n,), radius (n,) and height (n,) when inflated; in
    units of p times that radius: tension (n - 1,) along the meridian, between the nodes."""

    flat: Floats
    radius: Floats
    height: Floats
    tension: Floats

    @property
    def volume(self) -> float:
        """Volume of the whole balloon."""
        r, z = self.radius, self.height
        mean = (r[:-1] ** 2 + r[:-1] * r[1:] + r[1:] ** 2) / 3.0
        return float(2.0 * np.pi * mean @ -np.diff(z))

    @property
    def thickness(self) -> float:
        """Greatest thickness of the balloon."""
        return float(2.0 * self.height.max())

    def cap_tension(self, reach: float) -> float:
        """Mean tension over the flat disc of radius reach around the pole."""
        middle = 0.5 * (self.flat[1:] + self.flat[:-1])
        inside = middle < reach
        return float(np.average(self.tension[inside], weights=middle[inside]))


@cache
def profile(stiffness: float, inner: float = 0.0, poisson_ratio: float = 0.3) -> Profile:
    """The profile of a balloon of flat radii inner and 1 with E t / (p outer) = stiffness."""
    film = _Meridian(inner, poisson_ratio)
    s = film.nodes
    if inner:  # half a circle as long as the film is wide, or a quarter of one
        turn, bow = np.pi * (s - inner) / (1.0 - inner), (1.0 - inner) / np.pi
        state = np.column_stack([inner + bow * (1.0 - np.cos(turn)), bow * np.sin(turn)])
    else:
        state = np.column_stack([np.sin(0.5 * np.pi * s), np.cos(0.5 * np.pi * s)]) / (0.5 * np.pi)
    state[~film.free] = np.column_stack([np.full_like(s, inner), np.zeros_like(s)])[~film.free]
    for level in (20.0, 200.0, 2000.0, 20000.0):
        if level < stiffness:
            state = film.relaxed(state, level)
    state = film.relaxed(state, stiffness)
    return Profile(s, state[:, 0], state[:, 1], stiffness * film.stress(state)[0][:, 0])


class _Meridian:
    """The chain of conical bands between neighbouring nodes; energies are per 2 pi, with p = 1."""

    def __init__(self, inner: float, poisson_ratio: float) -> None:
        self.nodes = np.linspace(inner, 1.0, _NODES)
        self.nu = poisson_ratio
        self.length = np.diff(self.nodes)
        self.middle = 0.5 * (self.nodes[1:] + self.nodes[:-1])
        self.area = self.length * self.middle
        free = np.ones((_NODES, 2), dtype=bool)
        free[-1, 1] = False
        free[0, 0 if inner == 0.0 else 1] = False
        self.number = np.where(free, np.cumsum(free.ravel()).reshape(free.shape) - 1, -1)
        self.free = free

    def strain(self, state: Floats) -> Floats:
        """Green strains (n - 1, 2) along the meridian and along the parallel."""
        step = np.diff(state, axis=0)
        radius = 0.5 * (state[1:, 0] + state[:-1, 0])
        along = ((step**2).sum(axis=1) / self.length**2 - 1.0) / 2.0
        return np.column_stack([along, ((radius / self.middle) ** 2 - 1.0) / 2.0])

    def stress(self, state: Floats) -> tuple[Floats, Floats]:
        """Stresses (n - 1, 2) and tangents (n - 1, 2, 2) of the relaxed film, for E t = 1."""
        strain, nu = self.strain(state), self.nu
        taut = (strain.min(axis=1) + nu * strain.max(axis=1)) > 0.0
        tangent = np.zeros((len(strain), 2, 2))
        tangent[taut] = np.array([[1.0, nu], [nu, 1.0]]) / (1.0 - nu**2)
        rows, larger = np.arange(len(strain)), np.argmax(strain, axis=1)
        tangent[rows, larger, larger] += (~taut & (strain.max(axis=1) > 0.0)).astype(float)
        return np.einsum("nij,nj->ni", tangent, strain), tangent

    def energy(self, state: Floats, stiffness: float) -> float:
        stress, _ = self.stress(state)
        elastic = 0.5 * stiffness * self.area @ (stress * self.strain(state)).sum(axis=1)
        r, z = state.T
        return float(elastic + (r[:-1] ** 2 + r[:-1] * r[1:] + r[1:] ** 2) @ np.diff(z) / 6.0)

    def relaxed(self, state: Floats, stiffness: float) -> Floats:
        """Newton's method with a shift and a line search, down to rounding."""
        from scipy.sparse import csc_matrix, identity
        from scipy.sparse.linalg import splu

        shift, count = 1e-6, int(self.free.sum())
        energy = self.energy(state, stiffness)
        for _ in range(400):
            force, rows, columns, values = self._derivatives(state, stiffness)
            hessian = csc_matrix((values, (rows, columns)), shape=(count, count))
            while True:
                scale = shift / _NODES
                factor = splu(
                    hessian + scale * identity(count, format="csc"),
                    permc_spec="NATURAL",
                    diag_pivot_thresh=0.0,
                    options={"SymmetricMode": True},
                )
                if (factor.U.diagonal() > 0.0).all():
                    break
                shift = max(8.0 * shift, 1e-4)
            step = np.zeros_like(state)
            step[self.free] = factor.solve(-force)
            decrease = -float(force @ step[self.free])
            part = 1.0
            while (
                part > 1e-6 and self.energy(state + part * step, stiffness) > energy - 1e-4 * part * decrease
            ):
                part *= 0.5
            if decrease < 1e-13 or (part <= 1e-6 and decrease < 1e-9):
                return state
            if part > 1e-6:
                state = state + part * step
                energy = self.energy(state, stiffness)
            shift = shift * 0.2 if part == 1.0 else shift * 4.0
            shift = max(shift, 1e-10)
        raise RuntimeError("The profile did not come to rest.")

    def _derivatives(self, state: Floats, stiffness: float) -> tuple[Floats, Floats, Floats, Floats]:
        """Gradient of the free unknowns, and rows, columns and values of the Hessian."""
        stress, tangent = self.stress(state)
        weight = stiffness * self.area
        step = np.diff(state, axis=0) / self.length[:, None] ** 2
        radius = 0.25 * (state[1:, 0] + state[:-1, 0]) / self.middle**2
        zero = np.zeros_like(radius)
        # unknowns of a band: r, z at its start, r, z at its end
        operator = np.stack(
            [np.column_stack([-step, step]), np.column_stack([radius, zero, radius, zero])], axis=1
        )
        force = np.einsum("n,ni,nik->nk", weight, stress, operator)
        matrix = np.einsum("n,nik,nij,njl->nkl", weight, operator, tangent, operator)
        bend = (weight * stress[:, 0] / self.length**2)[:, None, None]
        matrix += bend * np.kron(np.array([[1.0, -1.0], [-1.0, 1.0]]), np.eye(2))
        hoop = (weight * stress[:, 1] / (4.0 * self.middle**2))[:, None, None]
        matrix += hoop * np.outer([1.0, 0.0, 1.0, 0.0], [1.0, 0.0, 1.0, 0.0])
        (a, b), (y, z) = (state[:-1, 0], state[1:, 0]), (state[:-1, 1], state[1:, 1])
        by_a, by_b, sum_ = (2 * a + b) / 6.0, (a + 2 * b) / 6.0, (a * a + a * b + b * b) / 6.0
        rise = z - y
        force += np.column_stack([by_a * rise, -sum_, by_b * rise, sum_])
        matrix[:, 0, 0] += rise / 3.0
        matrix[:, 2, 2] += rise / 3.0
        for first, second, value in (
            (0, 2, rise / 6.0),
            (0, 1, -by_a),
            (0, 3, by_a),
            (2, 1, -by_b),
            (2, 3, by_b),
        ):
            matrix[:, first, second] += value
            matrix[:, second, first] += value
        numbers = np.concatenate([self.number[:-1], self.number[1:]], axis=1)
        used = numbers >= 0
        gradient = np.bincount(numbers[used], force[used], int(self.free.sum()))
        pairs = used[:, :, None] & used[:, None, :]
        rows = np.broadcast_to(numbers[:, :, None], pairs.shape)[pairs]
        columns = np.broadcast_to(numbers[:, None, :], pairs.shape)[pairs]
        return gradient, rows, columns, matrix[pairs]
