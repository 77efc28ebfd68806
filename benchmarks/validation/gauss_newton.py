# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction by Gauss-Newton steps with the simulation's own sensitivities, for comparison.

At rest g(x, X) = 0, with x the balloon and X the flat panel, so H dx = -(dg/dX) dX. The seam of the pattern
moves along its normals in waves round the loop, the interior follows harmonically; dg/dX along each wave is a
central difference. The waves that take most of the rest away, by damped least squares, are the step.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import splu

from BalloonWorkbench.core.correction import fit as correction
from BalloonWorkbench.core.correction.seam_map import Course
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.reuse import _harmonic
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.types import Floats

WAVES = 24  # round the loop
DAMPING = 0.05  # of the largest singular value
SHIFT = 1e-6
STEP = 1e-4  # of the size, for differences


@contextmanager
def instead_of_mixing(film: Film, pressure: float) -> Iterator[None]:
    """Within it `fit` takes Gauss-Newton steps; for drawings of one loop."""

    def corrected(
        current: Any, mixing: Any, hopes: Any, edge: float, width: float, size: float, room: float
    ) -> Course:
        course = current.course
        field = _step(current, film, pressure, edge)
        length = np.linalg.norm(field, axis=1, keepdims=True)
        field *= np.minimum(1.0, correction.CLAMP * size / np.maximum(length, 1e-300))
        return course.moved((field,), correction.TIP * edge, room)

    kept = correction._corrected
    correction._corrected = corrected
    try:
        yield
    finally:
        correction._corrected = kept


def _step(current: Any, film: Film, pressure: float, edge: float) -> Floats:
    """How the finely sampled pattern (n, 2) shall move."""
    course, panel, node = current.course, current.panel, current.nodes[0]
    drawing, pattern, seam = course.drawing[0], course.pattern[0], panel.seams[0]
    points = current.inflation.positions[seam, :2]
    reach = np.full(len(points), correction.DRIFT * edge)
    missing = goals(drawing, points, node.lengths, node.corner_nodes, node.corners, reach) - points
    outward = _normals(pattern)
    angle = 2.0 * np.pi * np.arange(len(pattern)) / len(pattern)
    waves = [np.ones_like(angle)]
    for k in range(1, WAVES + 1):
        waves += [np.cos(k * angle), np.sin(k * angle)]
    fields = np.array(waves)[:, :, None] * outward  # (m, n, 2)
    at_nodes = np.stack([node.placed_on(field) for field in fields])
    normals = _normals(points)
    rows = np.einsum("mki,ki->km", _answers(current, film, pressure, at_nodes)[:, seam, :2], normals)
    wanted = np.einsum("ki,ki->k", missing, normals)
    damping = DAMPING * np.linalg.norm(rows, 2)
    share = np.linalg.solve(rows.T @ rows + damping**2 * np.eye(rows.shape[1]), rows.T @ wanted)
    return np.einsum("m,mni->ni", share, fields)


def _answers(current: Any, film: Film, pressure: float, at_nodes: Floats) -> Floats:
    """Moves (m, n, 3) of the balloon for moves (m, k, 2) of the pattern's seam."""
    panel, inflation = current.panel, current.inflation
    seam = panel.seams[0]
    free = np.setdiff1d(np.arange(len(panel.rest_positions)), seam)
    columns = np.moveaxis(at_nodes, 0, 1).reshape(len(seam), -1)
    moves = np.zeros((len(at_nodes), len(panel.rest_positions), 2))
    moves[:, seam] = at_nodes
    moves[:, free] = np.moveaxis(_harmonic(panel, seam, free, columns).reshape(len(free), -1, 2), 1, 0)
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    problem = film_problem(panel, film, pressure)
    positions, directors = inflation.positions / size, inflation.directors
    frames = tangent_frames(directors)
    shell = Shell(problem)
    _, hessian = shell.derivatives(positions, directors, frames)
    diagonal = np.abs(hessian.diagonal())
    factor = splu((hessian + diags(SHIFT * diagonal.max() * np.ones_like(diagonal))).tocsc())
    answers = []
    for move in moves:
        scale = STEP / max(float(np.abs(move).max()), 1e-300)
        sides = []
        for sign in (1.0, -1.0):
            rest = problem.rest_positions + sign * scale * move
            sides.append(
                Shell(replace(problem, rest_positions=rest)).derivatives(positions, directors, frames)[0]
            )
        change = (sides[0] - sides[1]) / (2.0 * scale)
        answers.append(shell.spread(factor.solve(-change))[0])
    return np.array(answers)


def _normals(loop: Floats) -> Floats:
    """Unit normals (n, 2) to the right of a loop: outward of an outer one."""
    along = np.roll(loop, -1, axis=0) - np.roll(loop, 1, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    return np.column_stack([along[:, 1], -along[:, 0]])
