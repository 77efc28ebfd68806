# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a divided target laid flat, as rigidly as possible, with seams equally long on both sides.

Each triangle is turned onto its place as well as it fits, then all points are moved to where the turned
triangles want them: by least squares (Liu, Zhang, Xu, Gotsman and Gortler 2008). Both sides of an edge of a
seam want to be as long as they are in the mean, with a weight that grows; at last they are made equal.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.flattening.conformal import (
    Complex,
    laid_flat,
    own_planes,
    signed_areas_of,
)
from BalloonWorkbench.core.flattening.equal_seams import equal_lengths, mean_edges
from BalloonWorkbench.core.flattening.factor import factored, sparse
from BalloonWorkbench.core.flattening.level import level_turn
from BalloonWorkbench.core.flattening.loops import loop_vertices, panel_loops
from BalloonWorkbench.core.flattening.unrolled import unrolled_panels
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Weights of equal lengths beside those of rigid triangles, and so many passes with each.
STAGES, PASSES = (1.0, 4.0, 16.0), 25


@memoized(2)
def flatten(division: Division) -> list[Floats]:
    """Places (k, 2) m of the opened vertices of each panel, counter-clockwise as seen from outside.

    Raises InputError for a panel without a boundary.
    """
    opened = division.opened
    points = division.target.points[opened.vertices]
    places = np.zeros(len(points), dtype=np.complex128)
    known = unrolled_panels(division)
    for number, loops in enumerate(panel_loops(division)):
        first, last = np.searchsorted(opened.panels, [number, number + 1])
        if number in known:
            places[first:last] = known[number].places @ (1.0, 1j)
            continue
        own = division.panels == number
        rims = [loop_vertices(loop) - first for loop in loops]
        places[first:last] = laid_flat(
            points[first:last],
            opened.triangles[own] - first,
            rims,
            float(division.target.areas[own].sum()),
        )
    pairs = _seam_edges(division)
    held = np.isin(opened.panels, list(known))
    if not held.all():
        stiff = _Rigid(points, opened.triangles, opened.panels, pairs, held)
        for weight in STAGES:
            places = stiff.relaxed(places, weight, PASSES)
        places = equal_lengths(places, pairs, held)
    flat = np.column_stack([places.real, places.imag])
    stops = np.searchsorted(opened.panels, np.arange(1, len(division.names)))
    return [
        known[number].places if number in known else panel @ level_turn(panel)
        for number, panel in enumerate(np.split(flat, stops))
    ]


def _seam_edges(division: Division) -> Ints:
    """Both sides of each edge of all seams, as opened vertices (e, 2 sides, 2 ends)."""
    parts = []
    for seam in division.seams:
        one, other = (np.column_stack([side[:-1], side[1:]]) for side in seam.sides)
        parts.append(np.stack([one, other], axis=1))
    return np.concatenate(parts).astype(np.int32)


@dataclass(frozen=True)
class _Rigid:
    """Triangles that want to stay as they are in space, and edges of seams; held (n,): what is not moved."""

    points: Floats
    triangles: Ints
    panels: Ints
    pairs: Ints
    held: Bools

    def relaxed(self, places: Complex, weight: float, passes: int) -> Complex:
        """Places (n,) after so many passes with this weight of equal lengths."""
        corners = own_planes(self.points, self.triangles)
        edges = np.roll(corners, -1, axis=1) - corners
        halves = 0.5 * _cotangents(corners)  # of the angle opposite to the edge from corner k to the next
        begin, end = self.triangles, np.roll(self.triangles, -1, axis=1)
        seams = self.pairs.reshape(-1, 2)
        starts = np.concatenate([begin.ravel(), seams[:, 0]])
        ends = np.concatenate([end.ravel(), seams[:, 1]])
        weights = np.concatenate([halves.ravel(), np.full(len(seams), weight)])
        fixed = self.held | (np.diff(self.panels, prepend=-1) != 0)
        solve = _laplace_solver(starts, ends, weights, fixed, places)
        for _ in range(passes):
            now = places[end] - places[begin]
            turned = (halves * now * np.conj(edges)).sum(axis=1)
            turned /= np.maximum(np.abs(turned), 1e-300)
            goals = np.concatenate(
                [(turned[:, None] * edges).ravel(), mean_edges(places, self.pairs, self.held)]
            )
            pulls = weights * goals
            loads = np.zeros(len(places), dtype=np.complex128)
            np.add.at(loads, ends, pulls)
            np.subtract.at(loads, starts, pulls)
            places = solve(loads)
        return places


def _cotangents(corners: Complex) -> Floats:
    """Of the angles (m, 3) opposite to the edge from each corner to the next."""
    far = np.roll(corners, -2, axis=1)
    product = np.conj(corners - far) * (np.roll(corners, -1, axis=1) - far)
    return np.asarray(product.real / np.maximum(product.imag, 1e-12 * np.abs(product) + 1e-300))


def _laplace_solver(starts: Ints, ends: Ints, weights: Floats, fixed: Bools, places: Complex) -> Any:
    """Solves for places (n,) complex; those that are fixed (n,) stay where they are."""
    package, count = sparse(), len(fixed)
    rows = np.concatenate([starts, ends, starts, ends])
    columns = np.concatenate([starts, ends, ends, starts])
    values = np.concatenate([weights, weights, -weights, -weights])
    matrix = package.csc_matrix((values, (rows, columns)), shape=(count, count))
    free = np.flatnonzero(~fixed)
    factor = factored(matrix[free][:, free])
    still = np.where(fixed, places, 0.0)
    pulled = (matrix @ still)[free]

    def solve(loads: Complex) -> Complex:
        solved = still.copy()
        missing = loads[free] - pulled
        both = factor.solve(np.column_stack([missing.real, missing.imag]))
        solved[free] = both[:, 0] + 1j * both[:, 1]
        return solved

    return solve


def area_changes(division: Division, flats: list[Floats]) -> Floats:
    """For each triangle (m,) of the target by what part its area grew as it was laid flat."""
    flat = np.concatenate(flats)
    areas = signed_areas_of(flat[:, 0] + 1j * flat[:, 1], division.opened.triangles)
    return np.asarray(areas / np.maximum(division.target.areas, 1e-300) - 1.0)
