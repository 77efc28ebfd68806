# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both sides of each edge of a seam made equally long, with the smallest moves that do it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.flattening.conformal import Complex
from BalloonWorkbench.core.flattening.factor import factored, sparse
from BalloonWorkbench.core.types import Bools, Ints

#: Newton's method: so many passes, to this part of the longest edge.
PASSES, EXACT = 30, 1e-13


def mean_edges(places: Complex, pairs: Ints, held: Bools) -> Complex:
    """Edges (2 e,) of both sides in their own directions, as long as they are in the mean.

    Where one side is held, it is as long as that; where both are, each is as long as it is.
    """
    now = places[pairs[:, :, 1]] - places[pairs[:, :, 0]]
    lengths = np.abs(now)
    still = held[pairs].all(axis=2)
    share = np.where(still.any(axis=1, keepdims=True), still, 1.0)
    goal = (share * lengths).sum(axis=1, keepdims=True) / share.sum(axis=1, keepdims=True)
    goal = np.where(still, lengths, goal)
    return np.asarray((now / np.maximum(lengths, 1e-300) * goal).ravel())


def equal_lengths(places: Complex, pairs: Ints, held: Bools) -> Complex:
    """Places moved as little as can be so that both sides of each edge of a seam are equally long.

    held  (n,) places that stay where they are
    """
    package, edges = sparse(), pairs.reshape(-1, 2)
    goal = np.abs(mean_edges(places, pairs, held))
    rim, number = np.unique(edges, return_inverse=True)
    begin, end = number.reshape(-1, 2).T
    free = np.repeat(~held[rim], 2).astype(float)
    rows = np.arange(len(edges))
    for _ in range(PASSES):
        ahead = places[edges[:, 1]] - places[edges[:, 0]]
        lengths = np.abs(ahead)
        missing = goal - lengths
        if np.abs(missing).max() <= EXACT * goal.max():
            break
        ahead /= np.maximum(lengths, 1e-300)
        values = np.concatenate([ahead.real, ahead.imag, -ahead.real, -ahead.imag])
        columns = np.concatenate([2 * end, 2 * end + 1, 2 * begin, 2 * begin + 1])
        values *= free[columns]
        change = package.csr_matrix((values, (np.tile(rows, 4), columns)), shape=(len(edges), 2 * len(rim)))
        normal = (change @ change.T + 1e-12 * package.identity(len(edges))).tocsc()
        moves = change.T @ factored(normal).solve(missing)
        places = places.copy()
        places[rim] += moves[::2] + 1j * moves[1::2]
    return places
