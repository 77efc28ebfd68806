# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interior vertices to start with: hexagonal lattices of the wanted sizes, kept off the seam."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.geometry.crossings import inside
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.mesh.sizing import SizeField
from BalloonWorkbench.core.types import Floats

_ROW = np.sqrt(3.0) / 2.0
#: Lattice points closer to the seam than this share of the local size are left out.
_CLEARANCE = 0.62


def lattice(seams: tuple[Floats, ...], field: SizeField, lines: Sequence[Floats] = ()) -> Floats:
    """Points (k, 2) inside the seams, spaced like the field: one lattice per half octave of size.

    They keep off open lines as off the seams.
    """
    low, high = seams[0].min(axis=0), seams[0].max(axis=0)
    boundary = np.concatenate(
        [*(subdivided(seam, 4) for seam in seams), *(subdivided(line, 4)[:-3] for line in lines)]
    )
    tree = kd_tree(boundary)
    levels = int(np.ceil(2.0 * np.log2(field.size / field.smallest) - 1e-6)) if field.groups else 0
    cells = np.ceil((high - low) / field.size).astype(int) + 1
    if levels:
        index = np.stack(np.meshgrid(*(np.arange(n) for n in cells), indexing="ij"), axis=-1).reshape(-1, 2)
        in_cell = field.at(low + (index + 0.5) * field.size)
    chosen = []
    for level in range(levels + 1):
        size = field.size * 2.0 ** (-0.5 * level)
        points = _hexagons(low, high, size)
        upper = np.inf if level == 0 else size * 2.0**0.25
        lower = 0.0 if level == levels else size * 2.0**-0.25
        if levels:  # a coarse look first: the field changes slowly
            cell = ((points - low) / field.size).astype(int).clip(0, cells - 1)
            near = in_cell[cell[:, 0] * cells[1] + cell[:, 1]]
            in_range = (near < upper + 0.2 * field.size) & (near >= lower - 0.2 * field.size)
            points = points[in_range]
            local = field.at(points)
            in_range = (local < upper) & (local >= lower)
            points = points[in_range]
        if len(points):
            points = points[inside(seams, points)]
        if len(points):
            distance, _ = tree.query(points)
            chosen.append(points[distance > _CLEARANCE * field.at(points)])
    return np.concatenate(chosen) if chosen else np.empty((0, 2))


def _hexagons(low: Floats, high: Floats, size: float) -> Floats:
    """Lattice points (n, 2) over a box."""
    columns, rows = np.ceil((high - low) / (size * np.array([1.0, _ROW]))).astype(int) + 1
    row, column = np.divmod(np.arange(columns * rows), columns)
    # Centred in the box, so that a symmetric outline has a symmetric start.
    start = 0.5 * (low + high - size * np.array([columns - 0.5, (rows - 1) * _ROW]))
    return np.stack([start[0] + size * (column + 0.5 * (row % 2)), start[1] + size * _ROW * row], axis=1)


def subdivided(loop: Floats, parts: int) -> Floats:
    """The loop with each edge divided into equal parts."""
    share: Floats = np.linspace(0.0, 1.0, parts, endpoint=False)[None, :, None]
    following = np.roll(loop, -1, axis=0)
    return (loop[:, None] * (1.0 - share) + following[:, None] * share).reshape(-1, 2)
