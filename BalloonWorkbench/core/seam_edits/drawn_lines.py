# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines drawn over the surface of a division, through places on it, from seam to seam."""

from __future__ import annotations

import cmath
import itertools

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.seam_edits.imprint import nearest_place, with_path, with_point
from BalloonWorkbench.core.seam_edits.paths import PathSurface, SurfacePath
from BalloonWorkbench.core.seam_edits.redivide import Region
from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Bools, Floats, Ints
from BalloonWorkbench.core.units import place_text

#: A place so far from the body is none of it, and one so near to a seam is on that; of the diagonal.
OFF, NEAR_SEAM = 0.05, 0.01
_AROUND = 2.0  # lengths of a short leg, in which its path is looked for
_MOST = 4000  # triangles that a line is followed through


def drawn_through(
    division: Division, places: Floats, *, closed: bool = False, onto_seams: bool = True
) -> tuple[Division, Ints]:
    """The division with a line along edges through places (k, 3) near its surface, and vertices (n,) of that.

    onto_seams  ends so near to a seam are moved onto it
    InputError for a place that is not on the body.
    """
    vertices: list[int] = []
    for number, place in enumerate(places):
        end = onto_seams and not closed and number in (0, len(places) - 1)
        division, vertex = _with_place(division, place, end)
        if not vertices or vertices[-1] != vertex:
            vertices.append(vertex)
    if closed and len(vertices) > 1 and vertices[0] != vertices[-1]:
        vertices.append(vertices[0])
    if len(vertices) < 2:
        raise InputError(f"A seam near {place_text(places[0])} has one place only. Draw it through two.")
    line = [np.array(vertices[:1], dtype=np.int32)]
    for start, goal in itertools.pairwise(vertices):
        division, leg = _leg(division, start, goal, short=len(places) > 2)
        line.append(leg[1:])
    return division, np.concatenate(line).astype(np.int32)


def path_through(division: Division, places: Floats) -> Floats:
    """Points (n, 3) m of the shortest line over the surface through places (k, 3): that a cut follows."""
    divided, line = drawn_through(division, places)
    return np.asarray(divided.target.points[line])


def _with_place(division: Division, place: Floats, on_seam: bool) -> tuple[Division, int]:
    """The division with a vertex nearest to a place (3,)."""
    triangle, shares, away = nearest_place(division.target, place)
    if away > OFF * division.target.diagonal:
        raise InputError(f"The body has nothing near {place_text(place)}. Give a place on its surface.")
    if on_seam:
        spot = shares @ division.target.points[division.target.triangles[triangle]]
        at = _on_seam(division, spot, NEAR_SEAM * division.target.diagonal)
        triangle, shares = at or (triangle, shares)
    return with_point(division, triangle, shares)


def _on_seam(division: Division, place: Floats, most: float) -> tuple[int, Floats] | None:
    """The triangle and the shares of its corners in the place of a seam that is nearest, and so near."""
    on = np.flatnonzero(division.seam_edges)
    if not len(on):
        return None
    ends = division.target.points[half_edges(division.target.triangles)[on]]
    ahead = ends[:, 1] - ends[:, 0]
    share = np.einsum("ij,ij->i", place - ends[:, 0], ahead) / np.maximum((ahead**2).sum(axis=1), 1e-300)
    share = np.clip(share, 0.0, 1.0)
    away = np.linalg.norm(ends[:, 0] + share[:, None] * ahead - place, axis=1)
    best = int(np.argmin(away))
    if away[best] > most:
        return None
    shares = np.zeros(3)
    corner = int(on[best]) % 3
    shares[corner], shares[(corner + 1) % 3] = 1.0 - share[best], share[best]
    return int(on[best]) // 3, shares


def _leg(division: Division, start: int, goal: int, *, short: bool) -> tuple[Division, Ints]:
    """The division with the shortest line between two vertices; one that is short is looked for near by."""
    path = _near_by(division, start, goal) if short else None
    if path is None:
        path = PathSurface(division.target.points, division.target.triangles).path(start, goal)
    assert path is not None, "a body hangs together"
    return with_path(division, path)


def _near_by(division: Division, start: int, goal: int) -> SurfacePath | None:
    """The shortest line over the triangles round two vertices; None where they do not join these."""
    target = division.target
    ends = target.points[[start, goal]]
    reach = _AROUND * float(np.linalg.norm(ends[1] - ends[0]))
    corners = target.points[target.triangles]
    away = np.linalg.norm(corners - ends.mean(axis=0), axis=2).min(axis=1)
    own = (away < reach) | np.isin(target.triangles, (start, goal)).any(axis=1)
    used, numbers = np.unique(target.triangles[own], return_inverse=True)
    surface = PathSurface(target.points[used], numbers.reshape(-1, 3).astype(np.int32))
    first, last = np.searchsorted(used, (start, goal)).tolist()
    path = surface.path(first, last)
    return path and path._replace(ends=used[path.ends].astype(np.int32))


def in_region(division: Division, own: Bools, start: int, goal: int) -> tuple[Division, Ints]:
    """The division with the shortest line between two vertices over triangles (m,) that are opened at seams.

    InputError where these do not hang together between them.
    """
    region = Region(division, own)
    for first in region.numbers_of(start).tolist():
        for last in region.numbers_of(goal).tolist():
            path = region.surface.path(first, last)
            if path is not None:
                return with_path(division, path._replace(ends=region.vertices[path.ends].astype(np.int32)))
    raise InputError(f"No seam can be drawn near {place_text(division.target.points[goal])}.")


def straight_on(division: Division, line: Ints) -> tuple[Division, Ints]:
    """The division with a line of vertices (k,) that goes straight on at both ends until it meets a seam.

    An end that meets none stays as it is.
    """
    for _ in range(2):
        line = line[::-1]
        if len(line) > 1 and line[0] != line[-1] and not _is_on_seam(division, int(line[-1])):
            path = _ahead(division, int(line[-2]), int(line[-1]))
            if path is not None:
                division, more = with_path(division, path)
                line = np.concatenate([line, more[1:]])
    return division, line


def _is_on_seam(division: Division, vertex: int) -> bool:
    return bool((half_edges(division.target.triangles)[division.seam_edges] == vertex).any())


def _ahead(division: Division, before: int, last: int) -> SurfacePath | None:
    """The line straight on from an edge until it meets a seam: equal angles on both sides of the vertex."""
    surface = PathSurface(division.target.points, division.target.triangles)
    edge, turned = int(np.flatnonzero((surface.edges == (last, before)).all(axis=1))[0]), 0.0
    half = 0.5 * sum(surface.angles[k] for k in _round(surface, edge))
    while turned + surface.angles[edge] < half:
        turned += surface.angles[edge]
        edge = int(surface.twin[edge - edge % 3 + (edge + 2) % 3])
    laid = surface.laid
    # the triangle lies at 0, its first edge along the real axis; the line leaves it over the edge opposite
    place, heading = 0j, cmath.rect(1.0, half - turned)
    right, left = complex(laid.lengths[edge]), laid.tops[edge] * laid.lengths[edge]
    edge = edge - edge % 3 + (edge + 1) % 3
    ends, shares = [(last, last)], [0.0]
    for _ in range(_MOST):
        share = _crossing(place, heading, right, left)
        ends.append((laid.edges[edge][0], laid.edges[edge][1]))
        shares.append(share)
        if division.seam_edges[edge]:
            return SurfacePath(np.array(ends, dtype=np.int32), np.array(shares))
        twin = laid.twin[edge]
        top = left + laid.tops[twin] * (right - left)
        # seen from the twin its start is the left end
        if ((top - place) * heading.conjugate()).imag > 0.0:
            edge, left = twin - twin % 3 + (twin + 1) % 3, top
        else:
            edge, right = twin - twin % 3 + (twin + 2) % 3, top
    return None


def _crossing(place: complex, heading: complex, right: complex, left: complex) -> float:
    """How far from the right end to the left one a line crosses an edge."""
    one, other = ((each - place) * heading.conjugate() for each in (right, left))
    share = -one.imag / max(other.imag - one.imag, 1e-300)
    return min(max(share, 0.0), 1.0)


def _round(surface: PathSurface, edge: int) -> list[int]:
    """The half-edges that start at the vertex where one starts, counter-clockwise."""
    around = [edge]
    while True:
        edge = int(surface.twin[edge - edge % 3 + (edge + 2) % 3])
        if edge == around[0]:
            return around
        around.append(edge)
