# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth borders between regions: they run through the triangles instead of along their edges."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.targets.half_edges import area_vectors, half_edges
from BalloonWorkbench.core.targets.refine import Split, cut_where_zero
from BalloonWorkbench.core.types import Floats, Ints


def with_smooth_borders(points: Floats, triangles: Ints, labels: Ints, reach: float) -> tuple[Split, Ints]:
    """The surface split along smooth borders, and the regions (m',) of its triangles; labels (m,) from 0.

    How much of each region there is around a point follows from letting it spread by diffusion for a short
    time, so that borders are smoothed over `reach` lengths of edges; a point belongs to the region of which
    there is most. A region that is too narrow for that is lost.
    """
    shares = _spread(points, triangles, labels, reach)
    count = shares.shape[1]
    carried = np.column_stack([points, shares])
    origin = np.arange(len(triangles), dtype=np.int32)
    for region in range(count):
        checkpoint()
        carried, triangles, parents = cut_where_zero(carried, triangles, _ahead(carried[:, 3:], region))
        origin = origin[parents]
    most = np.argmax(carried[triangles, 3:].sum(axis=1), axis=1).astype(np.int32)
    return Split(np.ascontiguousarray(carried[:, :3]), triangles, origin), most


def _ahead(shares: Floats, region: int) -> Floats:
    """By how much there is more (n,) of a region than of any other; shares (n, p)."""
    others = shares.max(axis=1)
    first = np.flatnonzero(shares[:, region] == others)
    others[first] = np.delete(shares[first], region, axis=1).max(axis=1)
    return np.asarray(shares[:, region] - others)


def _spread(points: Floats, triangles: Ints, labels: Ints, reach: float) -> Floats:
    """How much of each region there is around each point, (n, p)."""
    try:
        from scipy.sparse import diags
        from scipy.sparse.linalg import splu
    except ImportError as error:
        raise without_scipy("Dividing a body needs scipy: install it with pip install scipy.") from error
    third = np.linalg.norm(area_vectors(points, triangles), axis=1) / 3.0
    count = int(labels.max()) + 1
    there = np.zeros((len(points), count))
    np.add.at(there, (triangles, labels[:, None]), third[:, None])
    mass = there.sum(axis=1)
    ends = points[half_edges(triangles)]
    length = reach * float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).mean())
    matrix = diags(mass) + length**2 * stiffness(points, triangles)
    return np.asarray(splu(matrix.tocsc()).solve(there))


def stiffness(points: Floats, triangles: Ints) -> Any:
    """The matrix (n, n) of diffusion over a surface, of scipy: linear on each triangle.

    Weights of obtuse angles are left out, so that nothing flows uphill.
    """
    from scipy.sparse import coo_matrix, csgraph

    corners = points[triangles]
    rows, columns, weights = [], [], []
    for k in range(3):
        one, other = (corners[:, (k + step) % 3] - corners[:, k] for step in (1, 2))
        area = np.linalg.norm(np.cross(one, other), axis=1)
        weight = 0.5 * np.einsum("ij,ij->i", one, other) / np.maximum(area, 1e-300)
        rows.append(triangles[:, (k + 1) % 3])
        columns.append(triangles[:, (k + 2) % 3])
        weights.append(weight)
    shape = (len(points), len(points))
    entries = coo_matrix(
        (np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))), shape=shape
    )
    graph = (entries + entries.T).tocsr()
    graph.data = np.maximum(graph.data, 0.0)
    return csgraph.laplacian(graph)
