# SPDX-License-Identifier: LGPL-2.1-or-later
"""Symmetric linear systems by preconditioned conjugate gradients.

The preconditioner is an incomplete LU factorisation with a minimum-degree ordering (Li and Shao 2011,
"A supernodal approach to incomplete LU factorization with partial pivoting"). SuperLU drops small entries
of L and of U separately: their product is not symmetric, and conjugate gradients stall with its inverse. The
mean of that inverse and its transpose is symmetric: a few iterations where the other takes hundreds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.types import Floats

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix

DROPPED = 1e-5  # entries below this part of their column
FILL = 20.0  # the factor holds at most so many times the entries of the matrix


@dataclass(frozen=True)
class LinearSolution:
    """Result of conjugate gradients; not definite: a direction of negative curvature was met."""

    solution: Floats
    iterations: int
    definite: bool


class IncompleteFactor:
    """An approximate inverse of a symmetric matrix with a positive diagonal.

    definite is False when the matrix is, as far as the factors tell, not positive definite; then the factor
    is no preconditioner.
    """

    def __init__(self, matrix: csc_matrix) -> None:
        from scipy.sparse.linalg import spilu

        diagonal = matrix.diagonal()
        self.definite = bool(np.all(diagonal > 0.0))
        if not self.definite:
            return
        # moves and turns differ by many powers of ten: an even diagonal makes dropping fair
        self._scale = 1.0 / np.sqrt(diagonal)
        even = matrix.copy()
        even.data *= self._scale[even.indices] * np.repeat(self._scale, np.diff(even.indptr))
        try:
            self._factor = spilu(
                even,
                drop_tol=DROPPED,
                fill_factor=FILL,
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # exactly singular
            self.definite = False
            return
        # without row exchanges the signs of the pivots are those of the eigenvalues
        positive = bool(np.all(self._factor.U.diagonal() > 0.0))
        self.definite = positive and np.array_equal(self._factor.perm_r, self._factor.perm_c)

    def __call__(self, load: Floats) -> Floats:
        """Approximate solution (count,) for a load (count,)."""
        even = self._scale * load
        return np.asarray(0.5 * self._scale * (self._factor.solve(even) + self._factor.solve(even, "T")))


def conjugate_gradients(
    matrix: Callable[[Floats], Floats],
    load: Floats,
    precondition: Callable[[Floats], Floats],
    tolerance: float,
    most: int = 10_000,
) -> LinearSolution:
    """Solve matrix(x) = load (Hestenes and Stiefel 1952) until the residual falls below a part of the load.

    Both are measured with the preconditioner, sqrt(r . M^-1 r). Gives up after so many iterations, and
    where the matrix or the preconditioner turns out not to be positive definite.
    """
    solution = np.zeros_like(load)
    residual = load.copy()
    nearly = precondition(residual)
    direction = nearly.copy()
    size = first = float(residual @ nearly)
    iterations = 0
    while size > tolerance**2 * first and iterations < most:
        iterations += 1
        image = matrix(direction)
        curvature = float(direction @ image)
        if curvature <= 0.0:
            return LinearSolution(solution, iterations, False)
        length = size / curvature
        solution += length * direction
        residual -= length * image
        nearly = precondition(residual)
        previous, size = size, float(residual @ nearly)
        direction = nearly + size / previous * direction
    return LinearSolution(solution, iterations, size >= 0.0)
