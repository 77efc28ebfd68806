# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected of panels: how far their corners and a few places of each side of a seam move."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.flattening.seam_curves import knot_shapes
from BalloonWorkbench.core.flattening.seam_points import all_points, at_points, seam_points, with_equal_seams
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.target_design.mirrored_panels import NOT_MIRRORED, MirroredPanels
from BalloonWorkbench.core.types import Floats, Ints

#: Knots along a seam: one for so much of the size; all unknowns together, if seams are not too many.
SPACING, MOST = 0.07, 450
#: Spans of a seam at least and at most.
FEWEST_SPANS, MOST_SPANS = 2, 16


@dataclass(frozen=True)
class SeamUnknowns:
    """The panels of a bag by what changes them, as points move by moves @ values.

    bag      whose panels they are
    moves    (points, 2, size), the points of all loops in a row
    owners   (size,) the panel that each value moves
    lengths  (seams, size) by how much each value makes the first side of a seam longer than the second
    bends    (r, size) differences of the bulges at neighbouring knots of a side, second ones
    """

    bag: Bag
    moves: Floats
    owners: Ints
    lengths: Floats
    bends: Floats

    @classmethod
    def of(cls, bag: Bag, spans: list[int]) -> SeamUnknowns:
        """Those of a bag; spans between knots of each seam, as spans_of gives them."""
        points, seams = all_points(bag), seam_points(bag)
        corners = np.unique(np.concatenate([side[[0, -1]] for sides in seams for side in sides]))
        inner = [2 * (count - 1) for count in spans]
        total = 2 * len(corners) + sum(inner)
        moves = np.zeros((len(points), 2, total))
        bends: list[Floats] = []
        first = 2 * len(corners)
        for sides, count in zip(seams, spans):
            for side in sides:
                ends = 2 * np.searchsorted(corners, side[[0, -1]])
                _add_side(moves, points, side, ends, first, count)
                bends += _bends(first, count, total)
                first += count - 1
        moves[corners] = 0.0
        for axis in range(2):
            moves[corners, axis, 2 * np.arange(len(corners)) + axis] = 1.0
        panel_of = np.repeat(np.arange(len(bag.panels)), [sum(map(len, panel.loops)) for panel in bag.panels])
        owners = panel_of[np.abs(moves).sum(axis=1).argmax(axis=0)]
        lengths = np.stack([_grows(moves, points, one) - _grows(moves, points, two) for one, two in seams])
        return cls(bag, moves, owners, lengths, np.array(bends).reshape(-1, total))

    @property
    def size(self) -> int:
        """How many values there are."""
        return self.moves.shape[2]

    def moved(self, values: Floats, mirrored: MirroredPanels = NOT_MIRRORED) -> Bag:
        """The bag for values (size,) m, with equally long sides of seams, and mirrored panels."""
        bag = at_points(self.bag, all_points(self.bag) + self.moves @ values)
        return with_equal_seams(mirrored.alike(bag))

    def rest_moves(self, meshed: MeshedBag) -> Floats:
        """How the vertices of a mesh of the bag follow the values: (n, 2, size)."""
        offsets, first = meshed.assembly.offsets, 0
        result = np.zeros((int(offsets[-1]), 2, self.size))
        for number, weights in enumerate(meshed.weights):
            own = np.flatnonzero(self.owners == number)
            part = self.moves[first : first + weights.shape[1]][:, :, own]
            followed = weights @ part.reshape(weights.shape[1], -1)
            result[offsets[number] : offsets[number + 1], :, own] = followed.reshape(len(weights), 2, -1)
            first += weights.shape[1]
        return result

    def allowed(self) -> Floats:
        """An orthonormal basis (size, k) of the values that keep both sides of all seams equally long."""
        left, values, _ = np.linalg.svd(self.lengths.T, full_matrices=True)
        rank = int((values > 1e-9 * max(float(values.max()), 1e-300)).sum())
        return np.asarray(left[:, rank:])


def spans_of(bag: Bag, size: float) -> list[int]:
    """Into how many spans between knots each seam is parted, of a bag whose balloon is about so large [m]."""
    points = all_points(bag)
    lengths = [length(points[one]) for one, _ in seam_points(bag)]
    spacing = SPACING * size
    while True:
        spans = [int(np.clip(round(each / spacing), FEWEST_SPANS, MOST_SPANS)) for each in lengths]
        if 2 * sum(spans) + 2 * len(spans) <= MOST or max(spans) <= FEWEST_SPANS:
            return spans
        spacing *= 1.1


def _add_side(moves: Floats, points: Floats, side: Ints, ends: Ints, first: int, count: int) -> None:
    """How the points along a side follow its ends and the bulges at its inner knots."""
    at = np.linspace(0.0, 1.0, len(side))
    for axis in range(2):
        moves[side, axis, ends[0] + axis] = 1.0 - at
        moves[side, axis, ends[1] + axis] = at
    line = points[side]
    ahead = np.gradient(line, axis=0)
    normals = perpendicular(unit(ahead))
    shapes = knot_shapes(at, count)
    for knot in range(1, count):
        moves[side, :, first + knot - 1] = shapes[:, knot, None] * normals


def _bends(first: int, count: int, total: int) -> list[Floats]:
    """Second differences of the bulges of a side, which are 0 at its ends."""
    rows = np.diff(np.eye(count + 1), n=2, axis=0)[:, 1:-1]
    placed = np.zeros((len(rows), total))
    placed[:, first : first + count - 1] = rows
    return list(placed)


def _grows(moves: Floats, points: Floats, side: Ints) -> Floats:
    """By how much each value makes a side longer: (size,)."""
    ahead = unit(np.diff(points[side], axis=0))
    return np.asarray(np.einsum("ed,edk->k", ahead, np.diff(moves[side], axis=0)))
