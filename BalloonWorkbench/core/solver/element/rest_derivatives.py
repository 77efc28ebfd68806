# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the forces of the film change when its flat vertices move and the inflated ones stay.

A corner b of a triangle that moves by e in the flat film takes the gradients G of the area coordinates, F and
the area A with it:

    dG_a = -(G_a . e) G_b,    dF = -F e (x) G_b,    dA = A G_b . e

The element's energy depends on all of them, and on F as if the inflated corner moved by -F e: with the forces
f_a of the corners and the exact stiffness K_ab between them, those of membrane and bending change by

    df_a = -K_ab F e - (G_a . e) f_b + (G_b . e) f_a (membrane alone) + J_a^T dK beta (bending alone)

where K beta is the bending law of dkt.py, whose change with the corners a complex step gives to the last bit.
The pressure's forces do not know of the flat film.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from BalloonWorkbench.core.solver.element.dkt import Numbers, rotation_stiffness
from BalloonWorkbench.core.solver.element.scatter import times_fields
from BalloonWorkbench.core.solver.element.seam_band import kink_operators
from BalloonWorkbench.core.solver.element.shell import Shell
from BalloonWorkbench.core.solver.element.space_band import SpaceBand
from BalloonWorkbench.core.types import Floats

_STEP = 1e-30  # its square is nothing beside 1


def force_changes(
    shell: Shell, positions: Floats, directors: Floats, frames: Floats, rest_moves: Floats
) -> Floats:
    """Changes (n, 5, k) of the gradient in all unknowns of each vertex, held or not.

    For fields of moves (n, 2, k) of the rest positions, with pressure and rigidities as they are. The shell
    must be exact and without tension.
    """
    elements = [(shell.triangles, film_rest_derivatives(shell, positions, directors, frames))]
    if shell.band is not None:
        elements.append((shell.band.hinges, band_rest_derivatives(shell, positions)))
    if shell.space_band is not None:
        bent = space_band_rest_derivatives(shell.space_band, shell, positions, directors, frames)
        elements.append((shell.space_band.hinges, bent))
    rows, columns, blocks = [], [], []
    for corners, changes in elements:  # (e, 3 corners, 5, 3 corners, 2)
        rows.append(np.repeat(corners, 3, axis=1).ravel())
        columns.append(np.tile(corners, (1, 3)).ravel())
        blocks.append(changes.transpose(0, 1, 3, 2, 4).reshape(-1, 5, 2))
    return times_fields(np.concatenate(rows), np.concatenate(columns), np.concatenate(blocks), rest_moves)


def film_rest_derivatives(shell: Shell, positions: Floats, directors: Floats, frames: Floats) -> Floats:
    """Changes of the forces of membrane and bending of each triangle: (m, 3 corners, 5, 3 corners, 2)."""
    film = shell.elastic(positions, directors, frames)
    count, shape = len(film.gradient), shell.shape
    changes = -film.stiffness[:, :, :9].reshape(count, 15, 3, 3) @ film.gradient[:, None]
    membrane = film.membrane[:, :9].reshape(-1, 3, 3)
    forces = film.force[:, :9].reshape(-1, 3, 3)
    moved = changes[:, :9].reshape(-1, 3, 3, 3, 2)  # a view
    moved += membrane[:, :, :, None, None] * shape[:, None, None]
    moved -= shape[:, :, None, None, :] * forces.transpose(0, 2, 1)[:, None, :, :, None]

    rotation = film.rotation[:, :, None]
    corners = shell.problem.rest_positions[shell.triangles]
    law = _changes(
        lambda places: (rotation_stiffness(places, shell.problem.poisson_ratio) @ rotation)[:, :, 0], corners
    )
    bent = np.swapaxes(film.jacobian, 1, 2) @ (shell.flexural_rigidity * law)
    changes += bent.reshape(changes.shape)
    turns = changes[:, 9:].reshape(-1, 3, 2, 3, 2)
    return np.concatenate([moved, turns], axis=2)


def band_rest_derivatives(shell: Shell, positions: Floats) -> Floats:
    """Changes of the forces of each hinge of the sealed band: (h, 3 corners, 5, 3 corners, 2)."""
    band = shell.band
    assert band is not None
    flat = positions[band.hinges][:, :, :2].reshape(-1, 6, 1)

    def force(places: Numbers) -> Numbers:
        operator, stiffness = kink_operators(places, band.rigidities)
        return stiffness[:, None] * (np.swapaxes(operator, 1, 2) @ (operator @ flat))[:, :, 0]

    changes = np.zeros((len(flat), 3, 5, 3, 2))
    changes[:, :, :2] = _changes(force, shell.problem.rest_positions[band.hinges]).reshape(-1, 3, 2, 3, 2)
    return changes


def space_band_rest_derivatives(
    band: SpaceBand, shell: Shell, positions: Floats, directors: Floats, frames: Floats
) -> Floats:
    """The same of a band in space, whose director at the middle vertex turns, too."""
    rows = _changes(
        lambda places: band.rest_forces(places, positions, directors, frames),
        shell.problem.rest_positions[band.hinges],
    )
    changes = np.zeros((len(rows), 3, 5, 3, 2))
    changes[:, :, :3] = rows[:, :9].reshape(-1, 3, 3, 3, 2)
    changes[:, 1, 3:] = rows[:, 9:].reshape(-1, 2, 3, 2)
    return changes


def _changes(vectors: Callable[[Numbers], Numbers], corners: Floats) -> Floats:
    """Derivatives (e, r, 6) of vectors (e, r) by the places (e, 3, 2) of three corners, by a complex step.

    All three corners together change nothing.
    """
    columns = []
    for coordinate in range(4):
        places = corners.astype(np.complex128)
        places.reshape(-1, 6)[:, coordinate] += 1j * _STEP
        columns.append(vectors(places).imag / _STEP)
    columns += [-columns[0] - columns[2], -columns[1] - columns[3]]
    return np.stack(columns, axis=2)
