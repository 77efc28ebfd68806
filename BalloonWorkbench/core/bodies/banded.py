# SPDX-License-Identifier: LGPL-2.1-or-later
"""A letter with a side band: front and back of one shape, and a strip along each loop between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.normals import corners
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_lengths, edge_vectors, perimeter
from BalloonWorkbench.core.geometry.sampling import with_points_at
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import length_text

FRONT, BACK = 0, 1
#: More pieces of a loop are surely a slip of the unit.
MOST_PIECES = 100
_FINE = 0.1  # of a piece, between points at which it may end
_HAIR = 1e-9  # of a loop: places so near to each other are one


@dataclass(frozen=True)
class SideBand:
    """A band: its width from seam to seam, and its longest piece, 0: one piece for each loop [m]."""

    width: float
    piece: float = 0.0


@dataclass(frozen=True)
class BandPiece:
    """A piece of the band.

    panel        its number in the bag
    loop         the loop of the front to which it is sealed
    first, last  numbers of that loop's points between which it lies; the same where it goes all the way round
    """

    panel: int
    loop: int
    first: int
    last: int

    def along(self, count: int) -> Ints:
        """The numbers (k,) of the loop's points that it meets, of so many."""
        ahead = (self.last - self.first - 1) % count + 1
        return np.asarray((self.first + np.arange(ahead + 1)) % count, dtype=np.int32)


def banded_bag(outline: Outline, band: float, piece: float = 0.0, joints: Sequence[Ints] = ()) -> Bag:
    """Front, back and a band between them along each loop of the outline.

    band    [m], its width from seam to seam
    piece   [m], the longest piece of it; 0: each loop has one piece
    joints  for each loop the numbers of the points where pieces meet, as band_joints gives them; () works
            them out
    Each point of the outline is one of the front, of the back and of the band; where it has too few for the
    joints, its edges are divided. The back is the front's mirror image, its point -i the front's i. Raises
    InputError for a band or an outline that cannot be made so.
    """
    _check(outline, band, piece)
    loops = outline.loops if joints else divided(outline, piece).loops
    parts = band_pieces(joints or band_joints(loops, piece))
    panels = [BagPanel("front", loops[0], loops[1:])]
    outer, *holes = (np.roll(loop[::-1], 1, axis=0) * (-1.0, 1.0) for loop in loops)
    panels.append(BagPanel("back", outer, tuple(holes)))
    seams = []
    for part in parts:
        count, width = len(loops[part.loop]), len(part.along(len(loops[part.loop]))) - 1
        name = "band" if len(parts) == 1 else f"band {part.panel - BACK}"
        panels.append(BagPanel(name, _strip(loops[part.loop], part, band)))
        top = Side(part.panel, 2 * width + 1, width + 1)
        seams.append(BagSeam(Side(FRONT, part.first, part.last, part.loop), top))
        under = Side(BACK, -part.first % count, -part.last % count, part.loop)
        seams.append(BagSeam(Side(part.panel, 0, width), under))
    for part in parts:
        (after,) = (other for other in parts if other.loop == part.loop and other.first == part.last)
        width = len(part.along(len(loops[part.loop]))) - 1
        end = len(after.along(len(loops[after.loop]))) - 1
        seams.append(BagSeam(Side(part.panel, width, width + 1), Side(after.panel, 0, 2 * end + 1)))
    return Bag(tuple(panels), tuple(seams), _opening(loops[0], parts))


def divided(outline: Outline, piece: float) -> Outline:
    """The outline with its long edges divided, so that pieces no longer than that [m] can meet anywhere.

    Points are added where pieces meet that are to be equally long.
    """
    if piece <= 0.0:
        return outline
    loops = []
    for loop in (_divided(loop, piece) for loop in outline.loops):
        places, _ = evenly_joined(loop, _joints(loop, piece), corners(loop))
        lengths = arc_lengths(loop)
        at = np.interp(places, np.arange(len(lengths), dtype=np.float64), lengths)
        added = at[np.abs(at[:, None] - lengths).min(axis=1) > _HAIR * lengths[-1]]
        loops.append(with_points_at(loop, lengths, added)[0])
    return outline.with_loops(loops)


def band_joints(loops: Sequence[Floats], piece: float = 0.0) -> tuple[Ints, ...]:
    """For each loop (n, 2) m of a divided outline the numbers (k,) of the points where pieces meet.

    Pieces are nearly equal and at most `piece` [m] long, unless 0. The first joint is the loop's highest
    corner, or point; the others are corners where there are some, for a piece that begins at one is easily
    laid.
    """
    return tuple(_joints(loop, piece) for loop in loops)


def evenly_joined(loop: Floats, joints: Ints, sharp: Ints) -> tuple[Floats, Ints]:
    """Where on a loop (n, 2) m pieces meet so that they are equally long where no corner decides.

    joints  numbers of the points where they meet now; sharp: of the loop's corners
    The first joint and those at corners stay where they are, the others are spread evenly between them. For
    each joint its place along the loop's points, counted from 0 to n, and the number of the point nearest to
    that, to be moved there.
    """
    lengths, count = arc_lengths(loop), len(loop)
    around = float(lengths[-1])
    fixed = np.isin(joints, sharp)
    fixed[0] = True
    along = np.append(np.mod(lengths[joints] - lengths[joints[0]], around), around)
    order = np.arange(len(joints) + 1)
    stay = np.append(np.flatnonzero(fixed), len(joints))
    even = np.mod(np.interp(order, order[stay], along[stay])[:-1] + lengths[joints[0]], around)
    places = np.interp(even, lengths, np.arange(count + 1, dtype=np.float64))
    places[fixed] = joints[fixed]
    below = np.floor(places).astype(int)
    up = places - below > 0.5
    up ^= np.isin((below + up) % count, sharp) & ~fixed
    return places, np.asarray((below + up) % count, dtype=np.int32)


def band_pieces(joints: Sequence[Ints]) -> tuple[BandPiece, ...]:
    """The pieces between joints, in the order of the bag's panels."""
    parts: list[BandPiece] = []
    for loop, places in enumerate(joints):
        for first, last in zip(places.tolist(), np.roll(places, -1).tolist(), strict=True):
            parts.append(BandPiece(BACK + 1 + len(parts), loop, first, last))
    return tuple(parts)


def band_places(loops: Sequence[Floats], joints: Sequence[Ints], band: float) -> list[Floats]:
    """Places (k, 3) m in space of all points of the bag, one array a panel, for loops where they are seen.

    The front lies in z = band / 2, the back in z = -band / 2, each piece of the band stands between them.
    """
    half = 0.5 * band
    front = np.concatenate([_at(loop, half) for loop in loops])
    back = np.concatenate([_at(np.roll(loop[::-1], 1, axis=0), -half) for loop in loops])
    strips = [
        np.concatenate([_at(line, -half), _at(line[::-1], half)])
        for line in (loops[part.loop][part.along(len(loops[part.loop]))] for part in band_pieces(joints))
    ]
    return [front, back, *strips]


def _at(points: Floats, height: float) -> Floats:
    return np.column_stack([points, np.full(len(points), height)])


def _check(outline: Outline, band: float, piece: float) -> None:
    if outline.welds or outline.spots:
        raise InputError(
            "A balloon with a side band has no welds inside: its front and back are apart."
            " Leave them out, or make it of two panels."
        )
    if not (np.isfinite(band) and band > 0.0):
        raise InputError(f"The side band must be wider than 0, not {length_text(band)}. Give it 20 mm or so.")
    if not (np.isfinite(piece) and piece >= 0.0):
        raise InputError(f"Pieces of the side band cannot be {length_text(piece)} long. Give 0 or more.")


def _strip(loop: Floats, part: BandPiece, band: float) -> Floats:
    """Corners (2 k, 2) of a flat piece seen from outside: the side of the back, then that of the front."""
    along = part.along(len(loop))
    steps = np.linalg.norm(np.diff(loop[along], axis=0), axis=1)
    x = np.append(0.0, np.cumsum(steps))
    under, top = np.column_stack([x, np.zeros_like(x)]), np.column_stack([x, np.full_like(x, band)])
    return np.concatenate([under, top[::-1]])


def _divided(loop: Floats, piece: float) -> Floats:
    most = max(_FINE * piece, _FINE / MOST_PIECES * perimeter(loop))
    counts = np.maximum(np.ceil(edge_lengths(loop) / most), 1.0).astype(int)
    share = np.concatenate([np.arange(count) / count for count in counts])[:, None]
    return np.asarray(np.repeat(loop, counts, axis=0) + share * np.repeat(edge_vectors(loop), counts, axis=0))


def _joints(loop: Floats, piece: float) -> Ints:
    lengths = arc_lengths(loop)
    around, sharp = float(lengths[-1]), corners(loop)
    first = _highest(loop, np.asarray(sharp if len(sharp) else np.arange(len(loop)), dtype=np.int32))
    gap = float(np.diff(lengths).max())
    parts = 1 if piece <= 0.0 or around <= piece else int(np.ceil(around / max(piece - gap, 1e-9)))
    if parts > MOST_PIECES:
        raise InputError(
            f"Pieces of {length_text(piece)} are too short for a side band of {length_text(around)}."
            " Allow longer ones."
        )
    along = np.mod(lengths[:-1] - lengths[first], around)
    chosen, here = [first], 0.0
    for left in range(parts, 1, -1):  # pieces that are still to come, with this one
        nearest, farthest = around - (left - 1) * (piece - gap), here + piece
        even = here + (around - here) / left
        reach = 0.5 * (even - here)
        good = sharp[(np.abs(along[sharp] - even) < reach) & (along[sharp] >= nearest - 1e-9)]
        good = good[along[good] <= farthest + 1e-9]
        ahead = np.flatnonzero((along > here) & (along <= farthest + 1e-9))
        among = good if len(good) else ahead
        best = int(among[np.argmin(np.abs(along[among] - even))])
        chosen.append(best)
        here = float(along[best])
    return np.array(chosen, dtype=np.int32)


def _highest(loop: Floats, among: Ints) -> int:
    """The one of these points that is highest, and leftmost of those as high."""
    x, y = loop[among].T
    high = y > y.max() - 1e-6 * np.ptp(loop[:, 1])
    return int(among[high][np.argmin(x[high])])


def _opening(outer: Floats, parts: Sequence[BandPiece]) -> Opening:
    """At the lowest point of the outer loop, where that is away from the pieces' ends, under the back."""
    own = [part for part in parts if part.loop == 0]
    lowest = int(np.argmin(outer[:, 1]))
    middles = [part.along(len(outer)) for part in own]
    for part, along in zip(own, middles, strict=True):
        inner = along[len(along) // 4 : max(3 * len(along) // 4, len(along) // 4 + 1)]
        if lowest in inner:
            return Opening(part.panel, int(np.flatnonzero(along == lowest)[0]))
    low = min(range(len(own)), key=lambda k: float(outer[middles[k][len(middles[k]) // 2], 1]))
    return Opening(own[low].panel, len(middles[low]) // 2)
