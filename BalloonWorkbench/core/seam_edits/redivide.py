# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels after lines were drawn: what falls apart becomes panels of its own; all of them can be laid flat."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.seam_edits.imprint import edge_keys, with_path
from BalloonWorkbench.core.seam_edits.paths import PathSurface
from BalloonWorkbench.core.targets.half_edges import (
    connected_parts,
    euler_numbers,
    first_corners,
    half_edges,
    twins,
)
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import place_text

#: A piece with less than this part of the mean area of a panel is none.
SLIVER = 0.03
#: Length of the mean of the normals of a panel that lies flat enough to keep a hole.
_FLAT = 0.998


def on_edges(division: Division, line: Ints) -> Bools:
    """Whether each half-edge (3 m,) is one of edges (k, 2)."""
    count = len(division.target.points)
    own = edge_keys(half_edges(division.target.triangles), count)
    return np.isin(own, edge_keys(line.reshape(-1, 2), count))


def in_pieces(division: Division, barrier: Bools) -> Ints:
    """For each triangle the number (m,) of the piece that hangs together without half-edges (3 m,)."""
    edges = np.flatnonzero(~barrier)
    return connected_parts(len(division.panels), edges // 3, division.target.twins[edges] // 3)


def redivided(division: Division, line: Ints, *, slits: bool) -> Division:
    """The panels after seams were drawn along edges (k, 2).

    slits  what divides nothing opens its panel all the same
    The largest piece of a panel keeps its name. A piece that is too small stays with the one beside it.
    """
    target, drawn = division.target, on_edges(division, line)
    pieces = in_pieces(division, division.seam_edges | drawn)
    count = int(pieces.max()) + 1
    areas = np.asarray(np.bincount(pieces, target.areas, count), dtype=np.float64)
    owners = np.zeros(count, dtype=np.int32)
    owners[pieces] = division.panels
    whole = _with_slivers(
        pieces, owners, areas, target.twins, drawn, SLIVER * areas.sum() / len(division.names)
    )
    areas = np.asarray(np.bincount(whole[pieces], target.areas, count), dtype=np.float64)
    names, labels = list(division.names), np.zeros(count, dtype=np.int32)
    for panel in range(len(division.names)):
        own = np.unique(whole[owners == panel])
        for number, piece in enumerate(own[np.argsort(-areas[own], kind="stable")].tolist()):
            labels[whole == piece] = panel if number == 0 else len(names)
            if number:
                names.append(_new_name(division.names[panel], names, numbered=slits))
    inside = drawn & (pieces[np.repeat(np.arange(len(pieces)), 3)] == pieces[target.twins // 3])
    made = replace(division, panels=labels[pieces], names=tuple(names))
    closed = panels_not_discs(made)
    opening = inside & (slits | np.isin(np.repeat(made.panels, 3), closed))
    cuts = np.concatenate([division.cuts, _edges_of(target.triangles, opening)])
    return replace(made, cuts=inside_panels(made, cuts))


def _with_slivers(pieces: Ints, owners: Ints, areas: Floats, twin: Ints, drawn: Bools, least: float) -> Ints:
    """Which piece (k,) each piece is a part of: itself, or that beside it with most of their edges."""
    whole = np.arange(len(areas), dtype=np.int32)
    one, other = np.repeat(pieces, 3)[drawn], pieces[twin[drawn] // 3]
    for piece in np.argsort(areas, kind="stable"):
        if areas[piece] >= least:
            break
        beside = whole[other[(whole[one] == whole[piece]) & (owners[other] == owners[piece])]]
        beside = beside[beside != whole[piece]]
        if len(beside):
            whole[whole == whole[piece]] = np.argmax(np.bincount(beside))
    return whole


def _new_name(name: str, known: Collection[str], *, numbered: bool) -> str:
    """A name for a piece of a panel that is none of those known: a number, or a letter behind the panel's."""
    letters = [] if numbered else [name + letter for letter in "bcdefghijklmnopqrstuvwxyz"]
    more = ((str(number) if numbered else f"{name}-{number}") for number in range(2, len(known) + 3))
    return next(each for each in [*letters, *more] if each not in known)


def _edges_of(triangles: Ints, opening: Bools) -> Ints:
    """Edges (k, 2) of half-edges (3 m,), each once."""
    return np.unique(np.sort(half_edges(triangles)[opening], axis=1), axis=0).astype(np.int32)


def inside_panels(division: Division, cuts: Ints) -> Ints:
    """Those of edges (k, 2) that have the same panel on both sides."""
    same = np.repeat(division.panels, 3) == division.panels[division.target.twins // 3]
    return _edges_of(division.target.triangles, on_edges(division, cuts) & same)


def merged(division: Division, one: int, other: int, kept: Ints) -> Division:
    """Two panels, or one opened by itself, without the seams between them; those along edges (k, 2) stay."""
    labels = np.where(division.panels == other, one, division.panels)
    left, panels = np.unique(labels, return_inverse=True)
    names = tuple(division.names[panel] for panel in left.tolist())
    made = replace(division, panels=panels.astype(np.int32), names=names, cuts=kept)
    return replace(made, cuts=inside_panels(made, kept))


def panels_not_discs(division: Division) -> Ints:
    """Panels (k,) that cannot be laid flat: no discs as they are opened; a flat one may have holes."""
    target, count = division.target, len(division.names)
    opened = np.where(division.seam_edges, -1, target.twins)
    euler = euler_numbers(opened, division.panels)
    vectors = target.area_vectors
    sums = np.stack([np.bincount(division.panels, each, count) for each in vectors.T], axis=1)
    flat = np.linalg.norm(sums, axis=1) > _FLAT * np.bincount(division.panels, target.areas, count)
    return np.flatnonzero((euler != 1) & ~(flat & (euler < 1))).astype(np.int32)


class Region:
    """Some triangles of a division, opened along its seams: where a line may run.

    own      (m,) triangles
    """

    def __init__(self, division: Division, own: Bools) -> None:
        triangles, twin = division.target.triangles, division.target.twins
        other = own[twin // 3]
        hangs = np.repeat(own, 3) & other & ~division.seam_edges
        corners = first_corners(twin, hangs).reshape(-1, 3)[own]
        firsts, numbers = np.unique(corners, return_inverse=True)
        #: The vertex of the whole surface of each of the region's.
        self.vertices = triangles.ravel()[firsts]
        self.surface = PathSurface(
            division.target.points[self.vertices], numbers.reshape(-1, 3).astype(np.int32)
        )

    def numbers_of(self, vertex: int) -> Ints:
        """The vertices (k,) of the region in one of the whole surface; more than one where it is opened."""
        return np.flatnonzero(self.vertices == vertex).astype(np.int32)


def opened_to_discs(division: Division) -> tuple[Division, tuple[str, ...]]:
    """The division with cuts that open panels which go round the body or round others, and sentences.

    InputError for a panel that cuts cannot open.
    """
    notes = []
    for panel in panels_not_discs(division).tolist():
        name = division.names[panel]
        for _ in range(8):
            if panel not in panels_not_discs(division):
                break
            division = _with_cut(division, panel)
        else:
            raise InputError(no_disc(division, panel))
        notes.append(f"Panel {name} goes round a part of the body: it is cut open there.")
    return division, tuple(notes)


def no_disc(division: Division, panel: int) -> str:
    """The sentence about a panel that cannot be laid flat, with its place."""
    own = division.target.triangles[division.panels == panel]
    middle = division.target.points[own].mean(axis=(0, 1))
    at = np.argmin(np.linalg.norm(division.target.points[own].mean(axis=1) - middle, axis=1))
    place = place_text(division.target.points[own[at]].mean(axis=0))
    return (
        f"Panel {division.names[panel]} near {place} goes round the body and cannot be laid flat."
        " Draw a seam across it."
    )


def _with_cut(division: Division, panel: int) -> Division:
    """A panel cut open from one of its borders to the next."""
    region = Region(division, division.panels == panel)
    edges = half_edges(region.surface.triangles)
    rim = edges[twins(region.surface.triangles) < 0]
    loops = connected_parts(len(region.vertices), rim[:, 0], rim[:, 1])
    on_rim = np.unique(rim)
    first = on_rim[loops[on_rim] == loops[on_rim[0]]]
    others = on_rim[loops[on_rim] != loops[on_rim[0]]] if len(on_rim) else on_rim
    if not len(others):
        raise InputError(no_disc(division, panel))
    start, goal = region.surface.nearest_pair(first, others)
    path = region.surface.path(start, goal)
    assert path is not None, "both lie on borders of one piece"
    path = path._replace(ends=region.vertices[path.ends].astype(np.int32))
    division, line = with_path(division, path)
    added = np.column_stack([line[:-1], line[1:]])
    return replace(division, cuts=np.concatenate([division.cuts, added]).astype(np.int32))
