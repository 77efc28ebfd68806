# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sparse symmetric systems of a flattening, factored."""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.packages import without_scipy


def sparse() -> Any:
    """scipy.sparse. Raises MissingPackageError."""
    try:
        import scipy.sparse
        import scipy.sparse.linalg
    except ImportError as error:
        raise without_scipy("Flattening needs scipy: install it with pip install scipy.") from error
    return scipy.sparse


def factored(matrix: Any) -> Any:
    """The factors of a symmetric, positive definite matrix, with a method solve.

    Pivots stay on the diagonal: the search for others takes for ever where many triangles meet in a point.
    Raises InputError where the matrix is singular.
    """
    options = {"SymmetricMode": True}
    try:
        return sparse().linalg.splu(
            matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options
        )
    except RuntimeError:
        raise InputError(
            "The surface cannot be laid flat: some of its triangles have no area, or a panel hangs together"
            " in a point only. Repair the body, or take another number of panels."
        ) from None
