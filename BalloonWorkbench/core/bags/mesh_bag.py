# SPDX-License-Identifier: LGPL-2.1-or-later
"""From bag to assembly: panels whose vertices meet along their seams and follow the points of the bag."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel
from BalloonWorkbench.core.bags.division import divisions, side_line
from BalloonWorkbench.core.errors import InputError, MeshError
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import (
    edge_vectors,
    extent,
    length,
    line_lengths,
    perimeter,
    signed_area,
)
from BalloonWorkbench.core.mesh.delaunay import triangulate_points
from BalloonWorkbench.core.mesh.lattice import lattice
from BalloonWorkbench.core.mesh.relax import relax
from BalloonWorkbench.core.mesh.reuse import harmonic
from BalloonWorkbench.core.mesh.sizing import SizeField
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.panels.surface import first_of_each
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import length_text

#: Narrow panels get smaller edges, for so many across their mean width, down to a share of the size.
_ACROSS, _SMALLEST = 2.0, 0.25
#: Where a rim crosses itself, edges are halved so often.
_HALVINGS = 6
_ROUNDING = 1e-9  # of a length
#: So often tips are looked at again for edges that fall on others.
_PASSES = 8
#: More vertices are surely a slip of the unit.
_MOST_VERTICES = 1_000_000


@dataclass(frozen=True)
class PanelRim:
    """The boundary vertices of a panel, which lie between the points of its loops.

    points  (r, 2) numbers, all loops of the panel in a row, of the points before and after each vertex
    shares  (r,) how far it is on the way from the one to the other
    starts  number of the first vertex of each loop, and at last of all
    """

    points: Ints
    shares: Floats
    starts: tuple[int, ...]

    @property
    def loops(self) -> tuple[Ints, ...]:
        """Vertices of each loop in order."""
        return tuple(np.arange(low, high, dtype=np.int32) for low, high in pairwise(self.starts))

    def places(self, points: Floats) -> Floats:
        """Where the vertices lie (r, d) for places (p, d) of the points."""
        share = self.shares[:, None]
        return (1.0 - share) * points[self.points[:, 0]] + share * points[self.points[:, 1]]

    def weights(self, count: int) -> Floats:
        """The same as a matrix (r, count)."""
        rows, matrix = np.arange(len(self.shares)), np.zeros((len(self.shares), count))
        np.add.at(matrix, (rows, self.points[:, 0]), 1.0 - self.shares)
        np.add.at(matrix, (rows, self.points[:, 1]), self.shares)
        return matrix


@dataclass(frozen=True)
class MeshedBag:
    """A bag and its triangles. Seam i of the assembly is seam i of the bag.

    rims      which of the points the boundary vertices of each panel lie between
    original  the panels as they were meshed, whose inner vertices say how the others follow
    known     the weights, where they have been worked out for another bag with this mesh
    """

    bag: Bag
    assembly: Assembly
    rims: tuple[PanelRim, ...]
    original: tuple[Panel, ...]
    known: tuple[Floats, ...] | None = None

    @cached_property
    def weights(self) -> tuple[Floats, ...]:
        """For each panel a matrix (vertices, points) with rest_positions = matrix @ points; rows sum to 1.

        Points are those of all loops in a row. Boundary vertices lie on the way between two of them, inner
        ones follow by a harmonic field with the cotangent weights of the mesh as it was made. These give a
        flat mesh back exactly, and a uniform stretch stays one.
        """
        if self.known is not None:
            return self.known
        return tuple(_followed(*of) for of in zip(self.original, self.rims, self.bag.panels))

    def with_bag(self, bag: Bag) -> MeshedBag:
        """The same triangles for a bag whose points have moved a little."""
        if [list(map(len, panel.loops)) for panel in bag.panels] != [
            list(map(len, panel.loops)) for panel in self.bag.panels
        ]:
            raise InputError("The panels have other points than those that were meshed. Mesh the bag anew.")
        panels = [
            replace(panel, rest_positions=weights @ np.concatenate(piece.loops))
            for panel, weights, piece in zip(self.assembly.panels, self.weights, bag.panels)
        ]
        seams = [
            replace(seam, ease=bag.ease_of(bag.seams[number]) + _cut_off(bag, number, seam.runs, panels))
            for number, seam in enumerate(self.assembly.seams)
        ]
        assembly = replace(self.assembly, panels=tuple(panels), seams=tuple(seams))
        return replace(self, bag=bag, assembly=assembly, known=self.weights)

    def rest_moves(self, point_moves: Sequence[Floats]) -> Floats:
        """Moves (n, 2, k) of all vertices for moves (points, 2, k) of each panel's points."""
        moves = [np.tensordot(*each, 1) for each in zip(self.weights, point_moves, strict=True)]
        return np.concatenate(moves)

    def places(self, points: Sequence[Floats]) -> Floats:
        """Places in space (n, 3) of all vertices, between places (points, 3) of each panel's points."""
        return np.concatenate([weights @ at for weights, at in zip(self.weights, points, strict=True)])


def default_size(bag: Bag, vertices: int = 2000) -> float:
    """The mesh size that gives about so many vertices in all panels together [m]."""
    coarsest = max(extent(panel.outer) for panel in bag.panels)
    finest = coarsest / vertices
    for _ in range(40):
        middle = float(np.sqrt(finest * coarsest))
        if _vertices(bag, middle) > vertices:
            finest = middle
        else:
            coarsest = middle
    return coarsest


def _vertices(bag: Bag, size: float) -> float:
    """About how many a mesh has: one per sqrt(3)/2 size^2, and half of one more per edge of a rim."""
    count = 0.0
    for panel, own in zip(bag.panels, _sizes(bag, size)):
        area, around = sum(map(signed_area, panel.loops)), sum(map(perimeter, panel.loops))
        count += 2.0 / np.sqrt(3.0) * area / own**2 + 0.5 * around / own
    return count


def _sizes(bag: Bag, size: float) -> list[float]:
    """The size for each panel: smaller in narrow ones, by their mean widths, as of long strips."""
    widths = [
        2.0 * sum(map(signed_area, panel.loops)) / sum(map(perimeter, panel.loops)) for panel in bag.panels
    ]
    return [size * float(np.clip(width / _ACROSS / size, _SMALLEST, 1.0)) for width in widths]


def mesh_bag(bag: Bag, size: float) -> MeshedBag:
    """Triangles with edges about `size` [m] long on all panels of a bag that is in order.

    Both sides of a seam have vertices at equal fractions of their lengths, corners of either side among them.
    Equal panels get equal triangles. Raises MeshError for a size that makes no sense, or a panel whose parts
    touch.
    """
    _check_size(bag, size)
    sizes = _sizes(bag, size)
    least = [size * 0.5**_HALVINGS for size in sizes]
    while True:
        rims, runs = _rims(bag, divisions(bag, sizes))
        places = [rim.places(np.concatenate(panel.loops)) for rim, panel in zip(rims, bag.panels)]
        crossing = [k for k, (rim, at) in enumerate(zip(rims, places)) if _crosses(rim, at)]
        if not crossing:
            break
        for number in crossing:
            sizes[number] *= 0.5
            if sizes[number] < least[number]:
                raise MeshError(
                    f"Panel '{bag.panels[number].name}' crosses or nearly touches itself: separate the parts"
                    " that meet there."
                )
    panels = _meshed(rims, places, sizes)
    panels = _uncollapsed(panels, runs)
    seams = tuple(
        Seam(*both, bag.ease_of(bag.seams[number]) + _cut_off(bag, number, both, panels))
        for number, both in enumerate(runs)
    )
    return MeshedBag(bag, Assembly(panels, seams), tuple(rims), panels)


def _check_size(bag: Bag, size: float) -> None:
    if not (np.isfinite(size) and size > 0.0):
        raise MeshError(f"The mesh size is {length_text(size)}: give one above 0.")
    if _vertices(bag, size) > _MOST_VERTICES:
        raise MeshError(
            f"A mesh of {length_text(size)} would need more than a million vertices for these panels: use at"
            f" least {length_text(default_size(bag, _MOST_VERTICES))}."
        )


def _rims(bag: Bag, fractions: Sequence[Floats]) -> tuple[list[PanelRim], list[tuple[Run, Run]]]:
    """The boundary of each panel, and the two runs of each seam."""
    pieces: dict[tuple[int, int], list[tuple[int, int, bool]]] = {}
    for number, seam in enumerate(bag.seams):
        pieces.setdefault((seam.a.panel, seam.a.loop), []).append((seam.a.start, number, False))
        pieces.setdefault((seam.b.panel, seam.b.loop), []).append((seam.b.end, number, True))
    rims = []
    runs: dict[tuple[int, bool], Run] = {}
    for panel, piece in enumerate(bag.panels):
        points, shares, starts, first_point = [], [], [0], 0
        for loop in range(len(piece.loops)):
            first = at = starts[-1]
            own = sorted(pieces[panel, loop])
            around = sum(len(fractions[number]) - 1 for _, number, _ in own)
            for _, number, is_second in own:
                beside, share = _between(bag, number, fractions[number], second=is_second)
                points.append(first_point + beside)
                shares.append(share)
                vertices = first + (at - first + np.arange(len(share) + 1)) % around
                runs[number, is_second] = Run(
                    panel, (vertices[::-1] if is_second else vertices).astype(np.int32)
                )
                at += len(share)
            starts.append(at)
            first_point += len(piece.loops[loop])
        rims.append(PanelRim(np.concatenate(points), np.concatenate(shares), tuple(starts)))
    return rims, [(runs[number, False], runs[number, True]) for number in range(len(bag.seams))]


def _between(bag: Bag, number: int, fractions: Floats, *, second: bool) -> tuple[Ints, Floats]:
    """Points (k, 2) before and after each vertex of a side but its last, along the loop; and shares (k,)."""
    seam = bag.seams[number]
    side = seam.b if second else seam.a
    numbers, line = side.points(bag.panels, against=second), side_line(bag, side, against=second)
    if second:
        numbers, line, fractions = numbers[::-1], line[::-1], 1.0 - fractions[::-1]
    lengths = line_lengths(line)
    at = fractions[:-1] * lengths[-1]
    edge = np.clip(np.searchsorted(lengths, at, side="right") - 1, 0, len(lengths) - 2)
    share = np.clip((at - lengths[edge]) / (lengths[edge + 1] - lengths[edge]), 0.0, 1.0)
    return np.column_stack([numbers[edge], numbers[edge + 1]]), share


def _cut_off(bag: Bag, number: int, runs: tuple[Run, Run], panels: Sequence[Panel]) -> float:
    """By how much the edges along a seam are shorter than its curves, as a part of their length."""
    lost = []
    for side, run, against in zip(bag.seams[number].sides, runs, (False, True)):
        whole = length(side_line(bag, side, against=against))
        lost.append(1.0 - length(panels[side.panel].rest_positions[run.vertices]) / whole)
    return max(lost) + _ROUNDING


def _crosses(rim: PanelRim, places: Floats) -> bool:
    loops = [places[loop] for loop in rim.loops]
    if min(map(len, loops)) < 3 or not signed_area(loops[0]) > 0.0:
        return True
    return first_crossing(loops) is not None


def _meshed(rims: Sequence[PanelRim], places: Sequence[Floats], sizes: Sequence[float]) -> tuple[Panel, ...]:
    """Triangles within each boundary; those of an equal one before it are taken again."""
    known: dict[tuple[object, ...], Panel] = {}
    panels = []
    for rim, points, size in zip(rims, places, sizes):
        key = (rim.starts, size, points.tobytes())
        if key not in known:
            loops = [points[loop] for loop in rim.loops]
            edges = np.concatenate([np.linalg.norm(edge_vectors(loop), axis=1) for loop in loops])
            # edges of a finer panel beside it are let grow away from the seam
            field = SizeField(size).limited(points, edges)
            inner = lattice(tuple(loops), field)
            known[key] = Panel(*relax(np.concatenate([points, inner]), rim.loops, field), rim.loops)
        panels.append(known[key])
    return tuple(panels)


def _uncollapsed(panels: tuple[Panel, ...], runs: Sequence[tuple[Run, Run]]) -> tuple[Panel, ...]:
    """With a vertex more wherever an edge through a panel would fall on another one, or to a point.

    That happens in the tips of panels, where vertices are few.
    """
    for _ in range(_PASSES):
        collapsed = _collapsed(panels, runs)
        if not any(map(len, collapsed)):
            break
        panels = tuple(map(_with_middles, panels, collapsed))
    return panels


def _collapsed(panels: Sequence[Panel], runs: Sequence[tuple[Run, Run]]) -> list[Ints]:
    """Those edges of each panel, as its vertices (k, 2)."""
    offsets = np.cumsum([0, *(len(panel.rest_positions) for panel in panels)])
    count = int(offsets[-1])
    pairs = [np.column_stack([run.vertices + offsets[run.panel] for run in both]) for both in runs]
    first = first_of_each(count, np.concatenate(pairs))
    within, names = [], [_names(first[pair[:-1, 0]], first[pair[1:, 0]], count) for pair in pairs]
    for panel, offset in zip(panels, offsets):
        edges = np.sort(np.concatenate([panel.triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
        own = np.concatenate([np.column_stack([loop, np.roll(loop, -1)]) for loop in panel.loops])
        inner = ~np.isin(_names(edges[:, 0], edges[:, 1], count), _names(own[:, 0], own[:, 1], count))
        within.append(np.unique(edges[inner], axis=0))
        names.append(_names(first[within[-1][:, 0] + offset], first[within[-1][:, 1] + offset], count))
    every, counts = np.unique(np.concatenate(names), return_counts=True)
    shared = every[(counts > 1) | (every // count == every % count)]
    return [ends[np.isin(own, shared)] for ends, own in zip(within, names[len(runs) :])]


def _names(one: Ints, other: Ints, count: int) -> Ints:
    """A number (k,) for each pair of vertices, whichever comes first."""
    return np.asarray(np.minimum(one, other).astype(np.int64) * count + np.maximum(one, other))


def _with_middles(panel: Panel, edges: Ints) -> Panel:
    """With a vertex in the middle of each of some inner edges (k, 2)."""
    if not len(edges):
        return panel
    points = np.concatenate([panel.rest_positions, panel.rest_positions[edges].mean(axis=1)])
    return replace(panel, rest_positions=points, triangles=triangulate_points(points, panel.loops))


def _followed(panel: Panel, rim: PanelRim, piece: BagPanel) -> Floats:
    """How each vertex follows the points of its panel: (vertices, points)."""
    boundary = rim.weights(sum(map(len, piece.loops)))
    outer = np.arange(len(boundary))
    inner = np.arange(len(boundary), len(panel.rest_positions))
    if not len(inner):
        return boundary
    weights = np.concatenate([boundary, harmonic(panel, outer, inner, boundary)])
    return np.asarray(weights / weights.sum(axis=1, keepdims=True))
