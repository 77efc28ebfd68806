# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be done to a division: two panels merged, a seam drawn, moved, cut at a plane, projected."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on
from BalloonWorkbench.core.seam_edits.drawn_lines import OFF, drawn_through, in_region, straight_on
from BalloonWorkbench.core.seam_edits.imprint import (
    ON_DIAGONAL,
    edge_keys,
    nearest_place,
    split_division,
    with_point,
)
from BalloonWorkbench.core.seam_edits.projected import ProjectedLine, projected
from BalloonWorkbench.core.seam_edits.redivide import (
    SLIVER,
    in_pieces,
    inside_panels,
    merged,
    on_edges,
    panels_not_discs,
    redivided,
)
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.refine import cut_where_zero
from BalloonWorkbench.core.targets.target import Division, SeamLine
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import place_text

#: A seam so near to a place is the one that is meant, of the diagonal.
_NEAR = 0.02
#: A seam that is moved goes through so many places on either side of the one that is given.
_PLACES = 4


def seam_near(division: Division, place: Floats) -> tuple[SeamLine, float]:
    """The seam nearest to a place (3,), and how far along it that is, of its length.

    InputError where there is none near by.
    """
    points, best = division.target.points, (np.inf, 0, 0.0)
    for number, seam in enumerate(division.seams):
        line = points[seam.vertices]
        ahead = np.diff(line, axis=0)
        share = np.einsum("ij,ij->i", place - line[:-1], ahead) / np.maximum((ahead**2).sum(axis=1), 1e-300)
        share = np.clip(share, 0.0, 1.0)
        away = np.linalg.norm(line[:-1] + share[:, None] * ahead - place, axis=1)
        k = int(np.argmin(away))
        if away[k] < best[0]:
            along = line_lengths(line)
            at = along[k] + share[k] * (along[k + 1] - along[k])
            best = float(away[k]), number, float(at / along[-1])
    if best[0] > _NEAR * division.target.diagonal:
        raise InputError(f"There is no seam near {place_text(place)}.")
    return division.seams[best[1]], best[2]


def names_at(division: Division, seam: SeamLine) -> tuple[str, ...]:
    """The names of the panels on both sides of a seam, in their order."""
    return tuple(division.names[panel] for panel in sorted(set(seam.panels)))


def seam_between(division: Division, names: Sequence[str]) -> SeamLine:
    """The longest seam between two panels; InputError where there is none."""
    numbers = {division.names.index(name) for name in names if name in division.names}
    seams = [seam for seam in division.seams if set(seam.panels) == numbers]
    if len(numbers) < len(set(names)) or not seams:
        raise InputError(f"There is no seam between panels {' and '.join(names)}.")
    return max(seams, key=lambda seam: length(division.target.points[seam.vertices]))


def merge(division: Division, seam: SeamLine) -> Division:
    """The panels on both sides of a seam made one; where that goes round others, it is opened."""
    one, other = min(seam.panels), max(seam.panels)
    if len(division.names) == 2 and one != other:
        raise InputError("A body has 2 panels or more: these are the last ones.")
    picked = _edges_along(seam.vertices)
    shared = [each for each in division.seams if set(each.panels) == set(seam.panels)]
    rest = np.concatenate(
        [np.zeros((0, 2), dtype=np.int32), *(_edges_along(each.vertices) for each in shared)]
    )
    none_left = _without(division, division.cuts, rest)
    for kept in (none_left, _without(division, np.concatenate([division.cuts, rest]), picked)):
        made = merged(
            division, one, other, kept if one != other else _without(division, division.cuts, picked)
        )
        if division.names[one] not in [made.names[panel] for panel in panels_not_discs(made)]:
            return made
    names = " and ".join(names_at(division, seam))
    raise InputError(f"Without this seam panel {names} goes round the body and cannot be laid flat.")


def cut(division: Division, places: Floats, *, panels: Sequence[str] = (), alone: bool = False) -> Division:
    """A seam along the shortest lines over the surface through places (k, 3).

    panels  those that it must divide; none: any
    alone   there is no proposal: it ends where it is drawn; else it goes straight on to the next seam
    InputError for one that divides no panel, or others.
    """
    divided = _divided(_drawn(division, ProjectedLine(places, False), alone), alone)
    changed = divided_panels(division, divided)
    if not changed and not alone:
        raise InputError(f"The seam near {place_text(places[0])} divides no panel.")
    if panels and set(changed) != set(panels):
        raise InputError(
            f"The seam near {place_text(places[0])} would divide panels {', '.join(changed)}, not"
            f" {', '.join(panels)}."
        )
    return divided


def _drawn(division: Division, line: ProjectedLine, alone: bool, *, onto_seams: bool = True) -> Division:
    """The division with a line over its surface among its cuts, whatever it divides."""
    made, vertices = drawn_through(division, line.places, closed=line.closed, onto_seams=onto_seams)
    if not alone:
        made, vertices = straight_on(made, vertices)
    return replace(made, cuts=np.concatenate([made.cuts, _edges_along(vertices)]).astype(np.int32))


def _divided(drawn: Division, alone: bool) -> Division:
    """The division with panels on both sides of its cuts, where those divide."""
    return redivided(replace(drawn, cuts=np.zeros((0, 2), dtype=np.int32)), drawn.cuts, slits=alone)


def divided_panels(before: Division, after: Division) -> tuple[str, ...]:
    """The names of the panels that an edit has changed, of those that were there before."""
    was = np.bincount(before.panels, before.target.areas, len(before.names))
    now = dict(zip(after.names, np.bincount(after.panels, after.target.areas, len(after.names)).tolist()))
    same = 1e-6 * float(was.sum())
    return tuple(
        name for name, area in zip(before.names, was.tolist()) if abs(now.get(name, 0.0) - area) > same
    )


def cut_at_plane(division: Division, point: Floats, normal: Floats, *, alone: bool = False) -> Division:
    """Seams where a plane through a point (3,) with a normal (3,) meets the body."""
    target = division.target
    heights = (target.points - point) @ (normal / np.linalg.norm(normal))
    split = cut_where_zero(target.points, target.triangles, heights, most=ON_DIAGONAL * target.diagonal)
    made = split_division(division, split)
    middles = (made.target.points[made.target.triangles] - point).mean(axis=1) @ normal
    apart = np.repeat(middles > 0.0, 3) != (middles > 0.0)[made.target.twins // 3]
    edges = half_edges(made.target.triangles)[apart]
    if not len(edges):
        raise InputError(f"The plane through {place_text(point)} does not meet the body.")
    divided = redivided(made, edges, slits=alone)
    if not alone and len(divided.names) == len(division.names):
        raise InputError(f"The plane through {place_text(point)} divides no panel.")
    return divided


def cut_at_line(
    division: Division, line: Floats, direction: Floats, *, near: bool = False, alone: bool = False
) -> Division:
    """Seams where a line (k, 3) meets the body, seen along a direction (3,)."""
    if not np.linalg.norm(direction) > 0.0:
        raise InputError("A line that is projected needs a direction. Give one.")
    if len(line) < 2 or not length(line) > 0.0:
        raise InputError("A line that is projected needs two points or more. Draw them.")
    parts = projected(division.target, line, direction, near=near)
    if not parts:
        raise InputError(f"The line at {place_text(line[0])} misses the body.")
    made = division
    for part in parts:
        made = _drawn(made, part, alone, onto_seams=False)
    made = _divided(made, alone)
    if not alone and not divided_panels(division, made):
        raise InputError(f"The line at {place_text(line[0])} divides no panel.")
    return made


def move(division: Division, seam: SeamLine, at: float, to: Floats) -> Division:
    """A seam that goes through a place (3,) on its two panels; its ends stay where they are.

    at  how far along the seam that place is taken from, of its length; what is near moves along
    """
    if not 0.0 < at < 1.0:
        raise InputError("The end of a seam cannot be moved alone. Take hold of the seam between its ends.")
    own = np.isin(division.panels, seam.panels)
    triangle, _, away = nearest_place(division.target, to)
    if not own[triangle] or away > OFF * division.target.diagonal:
        names = " and ".join(names_at(division, seam))
        raise InputError(f"The place {place_text(to)} is not on panels {names}, between which the seam lies.")
    made, line = _without_seam(division, seam), division.target.points[seam.vertices]
    mended = made.names.index(division.names[seam.panels[0]])
    vertices = [int(seam.vertices[0])]
    for place in _bent(line, at, to):
        triangle, shares, _ = nearest_place(made.target, place, made.panels == mended)
        made, vertex = with_point(made, triangle, shares)
        if vertex not in vertices:
            vertices.append(vertex)
    vertices.append(int(seam.vertices[-1]))
    legs = [np.array(vertices[:1], dtype=np.int32)]
    for start, goal in itertools.pairwise(vertices):
        made, leg = in_region(made, made.panels == mended, start, goal)
        legs.append(leg[1:])
    return _with_seam(division, made, seam, np.concatenate(legs))


def _without_seam(division: Division, seam: SeamLine) -> Division:
    """The two panels of a seam as one with the first one's name; other seams between them open it."""
    one, other = seam.panels
    shared = [_edges_along(each.vertices) for each in division.seams if set(each.panels) == {one, other}]
    kept = _without(division, np.concatenate([division.cuts, *shared]), _edges_along(seam.vertices))
    return merged(division, one, other, kept)


def _bent(line: Floats, at: float, to: Floats) -> Floats:
    """Places (k, 3) that a seam (n, 3) shall go through: those beside the one moved go part of it."""
    along = line_lengths(line)
    steps = np.arange(1, _PLACES + 1) / (_PLACES + 1)
    shares = np.concatenate([at * steps, [at], at + (1.0 - at) * steps])
    weights = np.sin(0.5 * np.pi * np.concatenate([steps, [1.0], 1.0 - steps])) ** 2
    places = point_on(line, along, shares * along[-1])
    return np.asarray(places + weights[:, None] * (to - places[_PLACES]))


def _with_seam(before: Division, made: Division, seam: SeamLine, line: Ints) -> Division:
    """The panels as they were before, those of a seam parted along another line of vertices (k,)."""
    one, other = seam.panels
    numbers = np.array([before.names.index(name) for name in made.names], dtype=np.int32)
    panels, own = numbers[made.panels], made.panels == made.names.index(before.names[one])
    pieces = in_pieces(made, made.seam_edges | on_edges(made, _edges_along(line)))
    parts = np.unique(pieces[own])
    if len(parts) != (1 if one == other else 2):
        raise InputError("A seam cannot be moved so far: it would meet another one.")
    cuts = made.cuts
    if one == other:
        cuts = np.concatenate([cuts, _edges_along(line)]).astype(np.int32)
        return replace(made, panels=panels, names=before.names, cuts=cuts)
    middles = made.target.points[made.target.triangles[own]].mean(axis=1)
    at = NearestSurface(before.target.points, before.target.triangles).query(middles).triangles
    first = made.target.areas[own] * (before.panels[at] == one)
    shares = [
        float(first[pieces[own] == k].sum()) / float(made.target.areas[pieces == k].sum()) for k in parts
    ]
    panels[own] = np.where(pieces[own] == parts[int(np.argmax(shares))], one, other)
    divided = replace(made, panels=panels, names=before.names, cuts=cuts)
    areas = np.bincount(panels, made.target.areas, len(before.names))
    if areas[[one, other]].min() < SLIVER * areas.mean():
        raise InputError("A seam cannot be moved so far: one of its panels would be lost.")
    return replace(divided, cuts=inside_panels(divided, cuts))


def _edges_along(line: Ints) -> Ints:
    """Edges (k - 1, 2) along vertices (k,)."""
    return np.column_stack([line[:-1], line[1:]]).astype(np.int32)


def _without(division: Division, cuts: Ints, edges: Ints) -> Ints:
    """Edges (k, 2) without some."""
    count = len(division.target.points)
    return cuts[~np.isin(edge_keys(cuts, count), edge_keys(edges, count))]
