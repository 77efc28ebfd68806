# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected of panels: how far their corners and a few places of each side of a seam move."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.flattening.seam_curves import knot_shapes
from BalloonWorkbench.core.flattening.seam_points import all_points, at_points, panel_points, seam_points
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.target_design.mirrored_panels import NOT_MIRRORED, MirroredPanels
from BalloonWorkbench.core.types import Floats, Ints

#: Knots along a seam: one for so much of the size; all unknowns together, if seams are not too many.
SPACING, MOST = 0.07, 450
#: Spans of a seam at least and at most.
FEWEST_SPANS, MOST_SPANS = 2, 16
#: Moves that images have in common to less than this part, as those across a line of symmetry, are none.
_ALIKE = 1e-3
#: Lengths that follow a move by less than this part of it do not: those of images stay equal by themselves.
_NONE = 1e-6


@dataclass(frozen=True)
class SeamUnknowns:
    """The panels of a bag by what changes them, as points move by moves @ values.

    Each value keeps both sides of all seams equally long, and mirrored panels alike.

    moves  (points, 2, size), the points of all loops in a row
    basis  (k, size) how far corners and bulges of the panels that are no images move, of length 1
    owners (k,) the panel that each of these is of
    bends  (r, size) differences of the bulges at neighbouring knots of a side, second ones
    """

    moves: Floats
    basis: Floats
    owners: Ints
    bends: Floats

    @classmethod
    def of(cls, bag: Bag, spans: list[int], mirrored: MirroredPanels = NOT_MIRRORED) -> SeamUnknowns:
        """Those of a bag; spans between knots of each seam, as spans_of gives them."""
        points, seams = all_points(bag), seam_points(bag)
        moves, bends, owners = _moves(bag, spans)
        chosen = np.eye(len(owners))
        if mirrored.orbits:
            moves, chosen, owners = _alike(points, moves, owners, mirrored)
        lengths = np.stack([_grows(moves, points, one) - _grows(moves, points, two) for one, two in seams])
        left, values, _ = np.linalg.svd(lengths.T, full_matrices=True)
        rank = int((values > _NONE).sum())
        basis = np.asarray(left[:, rank:])
        return cls(moves @ basis, basis, owners, bends @ (chosen @ basis))

    @property
    def size(self) -> int:
        """How many values there are."""
        return self.moves.shape[2]

    def moved(self, bag: Bag, values: Floats, mirrored: MirroredPanels = NOT_MIRRORED) -> Bag:
        """A bag, that or one like it, for values (size,) m, with equally long sides of seams."""
        return mirrored.alike(at_points(bag, all_points(bag) + self.moves @ values))

    def rest_moves(self, meshed: MeshedBag) -> Floats:
        """How the vertices of a mesh of the bag follow the values: (n, 2, size)."""
        stops = np.cumsum([weights.shape[1] for weights in meshed.weights])[:-1]
        return meshed.rest_moves(np.split(self.moves, stops))


def _moves(bag: Bag, spans: list[int]) -> tuple[Floats, Floats, Ints]:
    """How the points (points, 2, k) follow corners and bulges, the bends of these and their panels."""
    points, seams = all_points(bag), seam_points(bag)
    corners = np.unique(np.concatenate([side[[0, -1]] for sides in seams for side in sides]))
    total = 2 * len(corners) + sum(2 * (count - 1) for count in spans)
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
    panel_of = np.repeat(np.arange(len(bag.panels)), [len(each) for each in panel_points(bag)])
    owners = panel_of[np.abs(moves).sum(axis=1).argmax(axis=0)]
    return moves, np.array(bends).reshape(-1, total), owners


def _alike(
    points: Floats, moves: Floats, owners: Ints, mirrored: MirroredPanels
) -> tuple[Floats, Floats, Ints]:
    """Moves (points, 2, j) that keep images alike, as sums (k, j) of moves, and their panels."""
    fields, chosen, owned = [], [], []
    panels = sorted(set(mirrored.first))
    for orbit, images in enumerate(mirrored.orbits):
        panel = panels[orbit]
        columns = np.flatnonzero(owners == panel)
        field = mirrored.fields(points, moves[:, :, columns], orbit)
        # what a panel that is its own image cannot do is left out, and what it can is there once
        _, strengths, sums = np.linalg.svd(
            field[images[0].numbers].reshape(-1, len(columns)), full_matrices=False
        )
        sums = sums[strengths > _ALIKE * strengths.max()].T
        fields.append(field @ sums)
        chosen.append(np.zeros((len(owners), sums.shape[1])))
        chosen[-1][columns] = sums
        owned += [panel] * sums.shape[1]
    return np.concatenate(fields, axis=2), np.concatenate(chosen, axis=1), np.array(owned, dtype=np.int32)


def spans_of(bag: Bag, size: float, share: float = 1.0) -> list[int]:
    """Into how many spans between knots each seam is parted, of a bag whose balloon is about so large [m].

    share  of the panels that are no images of others
    """
    points = all_points(bag)
    lengths = [length(points[one]) for one, _ in seam_points(bag)]
    spacing = SPACING * size
    while True:
        spans = [int(np.clip(round(each / spacing), FEWEST_SPANS, MOST_SPANS)) for each in lengths]
        if share * (2 * sum(spans) + 2 * len(spans)) <= MOST or max(spans) <= FEWEST_SPANS:
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
