# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tangent matrix of an inflated film, and the file in which yardstick.cpp reads it.

The file, in the machine's own byte order, holds the lower triangle of a symmetric matrix column by column,
the rows of a column in rising order:

    int64   count        unknowns
    int64   entries      of the lower triangle
    int64   starts       (count + 1) where each column begins
    int32   rows         (entries)
    float64 values       (entries)
    int32   vertices     (count) the vertex that each unknown belongs to
    int32   vertex_count
    float64 places       (vertex_count, 2) of the vertices in the flat panel
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.equilibrium.newton import DIRECTOR_SHIFT
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.types import Floats, Ints

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix


def tangent(
    inflation: Inflation, film: Film, pressure: float, shift: float
) -> tuple[csc_matrix, Ints, Floats]:
    """The Hessian at an inflated film, dimensionless, made definite by a shift as the solver does it.

    Every position and director is an unknown, however the solver arranges its own systems. Also the vertex of
    each unknown, and the vertices' places (n, 2) in the flat panel.
    """
    size = float(np.ptp(inflation.panel.rest_positions, axis=0).max())
    shell = Shell(film_problem(inflation.panel, film, pressure))
    _, hessian = shell.derivatives(
        inflation.positions / size, inflation.directors, tangent_frames(inflation.directors)
    )
    mass = np.empty(shell.fixed.shape)
    mass[:, :3] = shell.vertex_areas[:, None]
    mass[:, 3:] = DIRECTOR_SHIFT * shell.flexural_rigidity
    matrix = shell.scatter.shifted(hessian, shift * mass[~shell.fixed])
    return matrix, np.nonzero(~shell.fixed)[0].astype(np.int32), inflation.panel.rest_positions


def write_matrix(path: Path, matrix: csc_matrix, vertices: Ints, places: Floats) -> None:
    """Write the lower triangle of a symmetric matrix for yardstick.cpp."""
    from scipy.sparse import tril

    lower = tril(matrix, format="csc")
    lower.sort_indices()
    with path.open("wb") as file:
        for array, kind in (
            ([lower.shape[0], lower.nnz], np.int64),
            (lower.indptr, np.int64),
            (lower.indices, np.int32),
            (lower.data, np.float64),
            (vertices, np.int32),
            ([len(places)], np.int32),
            (places, np.float64),
        ):
            file.write(np.ascontiguousarray(array, dtype=kind).tobytes())
