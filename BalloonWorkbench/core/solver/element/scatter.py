# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assembly of element vectors and matrices into the global ones, with the pattern found once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from BalloonWorkbench.core.types import Floats, Ints

if TYPE_CHECKING:
    from scipy import sparse


def rounds(rows: Ints) -> Iterator[Ints]:
    """All places of rows (e,) in a few groups, in each of which no row is there twice."""
    order = np.argsort(rows, kind="stable")
    ascending = rows[order]
    turn = np.arange(len(rows)) - np.searchsorted(ascending, ascending)
    for place in range(int(turn.max(initial=-1)) + 1):
        yield order[turn == place]


def times_fields(rows: Ints, columns: Ints, blocks: Floats, fields: Floats) -> Floats:
    """Blocks (e, a, b), summed in rows and columns (e,) of n, times fields (n, b, k): (n, a, k)."""
    count = len(fields)
    pairs, slot = np.unique(rows.astype(np.int64) * count + columns, return_inverse=True)
    flat = blocks.reshape(len(blocks), -1)
    merged = np.stack([np.bincount(slot, part, len(pairs)) for part in flat.T], axis=1)
    merged = merged.reshape(-1, *blocks.shape[1:])
    row, column = np.divmod(pairs, count)
    total = np.zeros((count, blocks.shape[1], fields.shape[2]))
    lengths = np.bincount(row, minlength=count)
    for length in np.unique(lengths[lengths > 0]).tolist():  # rows with equally many blocks at a time
        here = np.flatnonzero(lengths[row] == length).reshape(-1, length)
        wide = np.swapaxes(merged[here], 1, 2).reshape(len(here), blocks.shape[1], -1)
        total[row[here[:, 0]]] = wide @ fields[column[here]].reshape(len(here), -1, fields.shape[2])
    return total


class Scatter:
    """The map from elements to free unknowns.

    elements: arrays (m, k) of unknown numbers, one array for each kind of element; -1 is a held unknown.
    """

    def __init__(self, elements: Sequence[Ints], count: int) -> None:
        self.count = count
        self._elements = elements
        self._free = [element >= 0 for element in elements]
        self._pairs = [free[:, :, None] & free[:, None, :] for free in self._free]
        keys = []
        for element, pairs in zip(elements, self._pairs, strict=True):
            wide = element.astype(np.int64)
            keys.append((wide[:, :, None] * count + wide[:, None, :])[pairs])
        unique, slot = np.unique(np.concatenate(keys), return_inverse=True)
        self._slots = np.split(slot, np.cumsum([len(key) for key in keys])[:-1])
        rows, self._columns = np.divmod(unique, count)
        self._starts = np.searchsorted(rows, np.arange(count + 1))
        self._diagonal = np.flatnonzero(rows == self._columns)

    def vector(self, forces: Sequence[Floats]) -> Floats:
        """Sum of element vectors, each (m, k): (count,)."""
        total = np.zeros(self.count)
        for element, free, force in zip(self._elements, self._free, forces, strict=True):
            total += np.bincount(element[free], force[free], self.count)
        return total

    def matrix(self, stiffnesses: Sequence[Floats]) -> sparse.csc_matrix:
        """Sum of symmetric element matrices, each (m, k, k): (count, count)."""
        from scipy import sparse

        data = np.zeros(len(self._columns))
        for slot, pairs, stiffness in zip(self._slots, self._pairs, stiffnesses, strict=True):
            data += np.bincount(slot, stiffness[pairs], len(data))
        return sparse.csc_matrix((data, self._columns, self._starts), shape=(self.count, self.count))

    def shifted(self, matrix: sparse.csc_matrix, shift: Floats) -> sparse.csc_matrix:
        """A copy of a matrix with shift (count,) added to its diagonal."""
        copy = matrix.copy()
        copy.data[self._diagonal] += shift
        return copy
