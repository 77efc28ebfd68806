# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles that a path passes, laid flat one after the other, and the shortest path through them."""

from __future__ import annotations

import cmath
import itertools
from typing import NamedTuple

_Portal = tuple[complex, complex]


class Laid(NamedTuple):
    """Half-edges of a surface as they are laid flat.

    edges    from which to which vertex each one runs
    twin     the one that runs back, -1 for none
    tops     where the third vertex of its triangle lies, for a half-edge from 0 to 1 in the complex plane
    lengths  m
    """

    edges: list[list[int]]
    twin: list[int]
    tops: list[complex]
    lengths: list[float]


class Sleeve(NamedTuple):
    """Triangles one beside the other: the half-edges over which they are left in turn."""

    crossed: list[int]

    def without(self, start: int, goal: int, laid: Laid) -> Sleeve:
        """The same without steps back, without triangles that only turn about its ends."""
        kept: list[int] = []
        for edge in self.crossed:
            if kept and laid.twin[kept[-1]] == edge:
                kept.pop()
            else:
                kept.append(edge)
        first, last = 0, len(kept)
        while first < last and start in laid.edges[kept[first]]:
            first += 1
        while last > first and goal in laid.edges[kept[last - 1]]:
            last -= 1
        return Sleeve(kept[first:last])


class Corner(NamedTuple):
    """A vertex at which the shortest path through a sleeve bends.

    left         whether it lies to the left of the path
    first, last  numbers of the half-edges crossed on the way round it
    beside       angle there from the path to the first of them and from the last to the path [rad]
    """

    vertex: int
    left: bool
    first: int
    last: int
    beside: float


class Pulled(NamedTuple):
    """The shortest path through a sleeve: the edges that it crosses, where, and how long it is [m]."""

    sleeve: Sleeve
    crossed: list[list[int]]
    shares: list[float]
    corners: list[Corner]
    length: float


class _Bend(NamedTuple):
    """A place where the path bends: the number of the half-edge, and on which side; both ends are bends."""

    at: int
    left: bool
    vertex: int
    place: complex


def pulled(sleeve: Sleeve, start: int, goal: int, laid: Laid) -> Pulled:
    """The shortest path from vertex to vertex through a sleeve."""
    crossed = sleeve.crossed
    if not crossed:
        return Pulled(sleeve, [], [], [], _straight_length(start, goal, laid))
    begin, end, portals = _unfolded(crossed, laid)
    bends = _bends(crossed, portals, (start, begin), (goal, end), laid)
    shares = [0.0] * len(crossed)
    for one, other in itertools.pairwise(bends):
        for k in range(max(one.at, 0), min(other.at + 1, len(crossed))):
            shares[k] = _share(one, other, portals[k], k)
    corners = [_corner(bends[k - 1 : k + 2], crossed, portals, laid) for k in range(1, len(bends) - 1)]
    length = sum(abs(other.place - one.place) for one, other in itertools.pairwise(bends))
    return Pulled(sleeve, [laid.edges[edge] for edge in crossed], shares, corners, length)


def _straight_length(start: int, goal: int, laid: Laid) -> float:
    """Of an edge; the sleeve is empty where both vertices share a triangle."""
    edge = next((k for k, ends in enumerate(laid.edges) if set(ends) == {start, goal}), None)
    return 0.0 if edge is None else laid.lengths[edge]


def _unfolded(crossed: list[int], laid: Laid) -> tuple[complex, complex, list[_Portal]]:
    """Where the first and the last vertex lie, and the left and right end of each half-edge crossed."""
    first = crossed[0]
    right, left = 0j, complex(laid.lengths[first])
    begin = laid.tops[first] * left
    portals = [(left, right)]
    at = dict(zip(laid.edges[first], (right, left)))
    for edge, after in zip(crossed, [*crossed[1:], -1]):
        one, other = laid.edges[edge]
        # the next triangle lies on the other side of the half-edge, whose twin runs back
        twin = laid.twin[edge]
        from_here, to_there = at[other], at[one]
        top = from_here + laid.tops[twin] * (to_there - from_here)
        if after < 0:
            return begin, top, portals
        at = {one: to_there, other: from_here, laid.edges[_after(twin)][1]: top}
        start, end = laid.edges[after]
        portals.append((at[end], at[start]))
    raise AssertionError("a sleeve has an end")


def _after(edge: int) -> int:
    return edge - edge % 3 + (edge + 1) % 3


def _cross(one: complex, other: complex) -> float:
    return one.real * other.imag - one.imag * other.real


def _bends(
    crossed: list[int],
    portals: list[_Portal],
    start: tuple[int, complex],
    goal: tuple[int, complex],
    laid: Laid,
) -> list[_Bend]:
    """Where the shortest path bends, with both ends (the funnel of Lee and Preparata 1984)."""
    count = len(crossed)
    gates = [(laid.edges[edge][1], laid.edges[edge][0]) for edge in crossed] + [(goal[0], goal[0])]
    places = [*portals, (goal[1], goal[1])]
    bends = [_Bend(-1, True, *start)]
    sides = dict.fromkeys((True, False), bends[0])
    k = 0
    while k <= count:
        apex, turned = bends[-1], None
        for left in (True, False):
            vertex, place = gates[k][0 if left else 1], places[k][0 if left else 1]
            own, other, sign = sides[left], sides[not left], 1.0 if left else -1.0
            if sign * _cross(own.place - apex.place, place - apex.place) > 0.0 and own.vertex != apex.vertex:
                continue  # wider than the funnel
            free = apex.vertex in (other.vertex, own.vertex)
            if free or sign * _cross(other.place - apex.place, place - apex.place) > 0.0:
                sides[left] = _Bend(k, left, vertex, place)
            else:
                turned = other
                break
        if turned is None:
            k += 1
            continue
        bends.append(turned)
        sides = {True: turned, False: turned}
        k = turned.at + 1
    if bends[-1].vertex != goal[0]:
        bends.append(_Bend(count, True, *goal))
    return [bends[0], *bends[1:-1], bends[-1]._replace(at=count)]


def _share(one: _Bend, other: _Bend, portal: _Portal, k: int) -> float:
    """How far from the right end of a half-edge the path crosses it, between two bends."""
    left, right = portal
    for bend in (one, other):
        if bend.at == k:
            return 1.0 if bend.left else 0.0
    ahead, across = other.place - one.place, left - right
    scale = _cross(across, ahead)
    if abs(scale) <= 1e-14 * abs(ahead) * abs(across):
        near = (
            one.place if abs(one.place - left) + abs(one.place - right) < 1.5 * abs(across) else other.place
        )
        return min(max(((near - right) / across).real, 0.0), 1.0)
    return min(max(_cross(one.place - right, ahead) / scale, 0.0), 1.0)


def _corner(bends: list[_Bend], crossed: list[int], portals: list[_Portal], laid: Laid) -> Corner:
    """What is to be known of the middle one of three bends."""
    before, bend, after = bends
    own, facing = (1, 0) if bend.left else (0, 1)
    first = last = bend.at
    while first > 0 and laid.edges[crossed[first - 1]][own] == bend.vertex:
        if laid.edges[crossed[first]][facing] == before.vertex:
            break
        first -= 1
    while last + 1 < len(crossed) and laid.edges[crossed[last + 1]][own] == bend.vertex:
        if laid.edges[crossed[last]][facing] == after.vertex:
            break
        last += 1
    side = 1 if bend.left else 0
    beside = _angle(before.place - bend.place, portals[first][side] - portals[first][1 - side])
    beside += _angle(after.place - bend.place, portals[last][side] - portals[last][1 - side])
    return Corner(bend.vertex, bend.left, first, last, beside)


def _angle(one: complex, other: complex) -> float:
    """Between two directions [rad]."""
    return abs(cmath.phase(one / other)) if one and other else 0.0
