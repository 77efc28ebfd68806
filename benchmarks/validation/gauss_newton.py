# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction by Gauss-Newton steps with the simulation's own sensitivities, for comparison.

At rest g(x, X) = 0, with x the balloon and X the flat panel, so H dx = -(dg/dX) dX. The seam of the pattern
moves along its normals in waves round the loop, the interior follows harmonically; dg/dX along each wave is a
central difference. The waves that take most of the rest away, by damped least squares, are the step.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import splu

from BalloonWorkbench.core.correction.iterate import Iterate
from BalloonWorkbench.core.correction.step import DRIFT
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import arc_lengths
from BalloonWorkbench.core.mesh.reuse import harmonic
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.types import Floats

WAVES = 24  # round the loop
DAMPING = 0.05  # of the largest singular value
SHIFT = 1e-6
STEP = 1e-4  # of the size, for differences


class GaussNewton:
    """Gauss-Newton steps as the update rule of the correction, for drawings of one loop."""

    def __init__(self, film: Film, pressure: float) -> None:
        self._film = film
        self._pressure = pressure

    def step(self, current: Iterate, correction: Floats) -> Floats:
        """How the finely sampled pattern (n, 2) shall move; what is missing is measured, not smoothed."""
        seam_map, panel, node = current.seam_map, current.panel, current.nodes[0]
        drawing, pattern, seam = seam_map.drawing[0], seam_map.pattern[0], panel.loops[0]
        points = current.inflation.positions[seam, :2]
        edge = float(arc_lengths(panel.rest_positions[seam])[-1]) / len(seam)
        drift = np.full(len(points), DRIFT * edge)
        missing = goals(drawing, points, node.lengths, node.corner_nodes, node.corners, drift) - points
        outward = _normals(pattern)
        angle = 2.0 * np.pi * np.arange(len(pattern)) / len(pattern)
        waves = [np.ones_like(angle)]
        for k in range(1, WAVES + 1):
            waves += [np.cos(k * angle), np.sin(k * angle)]
        fields = np.array(waves)[:, :, None] * outward  # (m, n, 2)
        at_nodes = np.stack([node.placed_on(field) for field in fields])
        normals = _normals(points)
        answers = _answers(current, self._film, self._pressure, at_nodes)[:, seam, :2]
        rows = np.einsum("mki,ki->km", answers, normals)
        residual = np.einsum("ki,ki->k", missing, normals)
        damping = DAMPING * np.linalg.norm(rows, 2)
        share = np.linalg.solve(rows.T @ rows + damping**2 * np.eye(rows.shape[1]), rows.T @ residual)
        return np.einsum("m,mni->ni", share, fields)


def _answers(current: Iterate, film: Film, pressure: float, at_nodes: Floats) -> Floats:
    """Moves (m, n, 3) of the balloon for moves (m, k, 2) of the pattern's seam."""
    panel, inflation = current.panel, current.inflation
    seam = panel.loops[0]
    free = np.setdiff1d(np.arange(len(panel.rest_positions)), seam)
    columns = np.moveaxis(at_nodes, 0, 1).reshape(len(seam), -1)
    moves = np.zeros((len(at_nodes), len(panel.rest_positions), 2))
    moves[:, seam] = at_nodes
    moves[:, free] = np.moveaxis(harmonic(panel, seam, free, columns).reshape(len(free), -1, 2), 1, 0)
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
