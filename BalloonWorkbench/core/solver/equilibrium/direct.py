# SPDX-License-Identifier: LGPL-2.1-or-later
"""Symmetric linear systems of one pattern by factorisation; which order fills in least is looked for once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.types import Floats, Ints

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import SuperLU


@dataclass(frozen=True)
class Factor:
    """Of a positive definite matrix, whose unknowns have been put in order first."""

    lu: SuperLU
    order: Ints | None

    def solve(self, loads: Floats) -> Floats:
        """Solutions (count, ...) for loads (count, ...)."""
        if self.order is None:
            return np.asarray(self.lu.solve(loads))
        solution = np.empty_like(loads)
        solution[self.order] = self.lu.solve(np.ascontiguousarray(loads[self.order]))
        return solution


class Factorisations:
    """Factorisations of matrices with the same pattern."""

    def __init__(self) -> None:
        self._order: Ints | None = None
        self._ordered: csc_matrix | None = None
        self._places: Ints | None = None  # of the numbers of the ordered matrix in the other

    def factor(self, matrix: csc_matrix) -> Factor | None:
        """Without row exchanges, or None when the matrix is not positive definite."""
        from scipy.sparse.linalg import splu

        order = self._order
        try:
            lu = splu(
                matrix if order is None else self._in_order(matrix, order),
                permc_spec="MMD_AT_PLUS_A" if order is None else "NATURAL",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # exactly singular
            return None
        if order is None:
            self._order = np.argsort(lu.perm_c)
        # without row exchanges the signs of the pivots are those of the eigenvalues
        definite = bool(np.all(lu.U.diagonal() > 0.0)) and np.array_equal(lu.perm_r, lu.perm_c)
        return Factor(lu, order) if definite else None

    def _in_order(self, matrix: csc_matrix, order: Ints) -> csc_matrix:
        """The matrix with its rows and columns in this order; valid until the next one."""
        if self._ordered is None:
            numbered = matrix.copy()
            numbered.data = np.arange(len(matrix.data), dtype=np.float64)
            self._ordered = numbered[order][:, order].tocsc()
            self._ordered.sort_indices()
            self._places = self._ordered.data.astype(np.int32)
        self._ordered.data = matrix.data[self._places]
        return self._ordered
