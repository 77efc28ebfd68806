# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick an outline is: the distance between walls that face each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.normals import left_normals, turns
from BalloonWorkbench.core.geometry.polyline import arc_lengths, gaps, signed_area
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Walls face each other where their normals, or their directions from between them, differ by more [rad].
_FACING = np.radians(150.0)
#: Samples where the wall turns by more are corners and have no side to look from [rad].
_CORNER = np.radians(30.0)
#: Seen under a smaller angle, a wall is a bump beside the sample and not the other side [rad].
_BUMP = np.radians(60.0)
#: Walls face each other where the straight line between them goes so much along both normals (cosine), and
#: where the way round the rim is so much longer.
_AHEAD, _DETOUR = 0.5, 3.0


@dataclass(frozen=True)
class Thickness:
    """Thickness at samples of the boundary.

    points   (n, 2) m, on the boundary
    across   (n,) m, to the opposite wall; infinite where none faces the sample within reach
    channel  (n,) the walls run side by side there: not a tip that tapers off
    """

    points: Floats
    across: Floats
    channel: Bools

    @property
    def thinnest(self) -> tuple[float, Floats]:
        """Smallest thickness of the channels (infinite without any) and a point (2,) of the wall [m]."""
        narrow = np.where(self.channel, self.across, np.inf)
        worst = int(np.argmin(narrow))
        return float(narrow[worst]), self.points[worst]


def fine_spacing(outline: Outline, spacing: float, finest: float) -> float:
    """The spacing [m], halved until it shows facing walls however near they are, but not below the finest.

    Walls nearer than half of the distance between their samples would not be seen as such.
    """
    while spacing > finest:
        loops = [evenly(loop, spacing) for loop in outline.loops]
        points = np.concatenate(loops)
        one, other = kd_tree(points).query_pairs(2.0 * spacing, output_type="ndarray").T
        normals = np.concatenate([left_normals(loop) for loop in loops])
        across = points[other] - points[one]
        distance = np.linalg.norm(across, axis=1)
        ahead = (across * normals[one]).sum(axis=1) > _AHEAD * distance
        back = (across * normals[other]).sum(axis=1) < -_AHEAD * distance
        far = _way_round(loops, one, other) > _DETOUR * distance
        facing = np.flatnonzero(ahead & back & far)
        if _tapers(loops, one[facing], other[facing], distance[facing]).all():
            return spacing
        spacing *= 0.5
    return max(spacing, finest)


def _way_round(loops: list[Floats], first: Ints, second: Ints) -> Floats:
    """Length (n,) of rim between two samples, infinite on two loops [m]."""
    starts = np.cumsum([0, *(len(loop) for loop in loops)])
    around = [arc_lengths(loop) for loop in loops]
    along, whole = np.concatenate([one[:-1] for one in around]), np.array([one[-1] for one in around])
    owner = np.searchsorted(starts, first, side="right") - 1
    same = owner == np.searchsorted(starts, second, side="right") - 1
    return np.where(same, gaps(along[first], along[second], whole[owner]), np.inf)


def thickness(outline: Outline, reach: float, spacing: float) -> Thickness:
    """Thickness of an outline where it is below `reach` [m], at boundary samples `spacing` [m] apart.

    By shrinking tangent balls (Ma, Bae & Choi, The Visual Computer 28 (2012) 7-19).
    """
    loops = [evenly(loop, spacing) for loop in outline.loops]
    points = np.concatenate(loops)
    normals, turn = (np.concatenate([of(loop) for loop in loops]) for of in (left_normals, turns))
    tree = kd_tree(points)
    radius = np.full(len(points), 0.5 * reach)
    partner = np.full(len(points), -1)
    active = np.flatnonzero(np.abs(turn) < _CORNER)
    for _ in range(30):
        distance, nearest = tree.query(points[active] + radius[active, None] * normals[active])
        shrinks = distance < radius[active] * (1.0 - 1e-6)
        active, nearest = active[shrinks], nearest[shrinks]
        gap = points[nearest] - points[active]
        ahead = (gap * normals[active]).sum(axis=1)
        smaller = (gap**2).sum(axis=1) / np.maximum(2.0 * ahead, np.finfo(float).tiny)
        centre = points[active] + smaller[:, None] * normals[active]
        wall = (ahead > 0.0) & (_seen_apart(points[active], points[nearest], centre) > _BUMP)
        active = active[wall]
        radius[active], partner[active] = smaller[wall], nearest[wall]
        if not len(active):
            break
    partnered = np.flatnonzero(partner >= 0)
    other = partner[partnered]
    centre = points[partnered] + radius[partnered, None] * normals[partnered]
    opposed = (normals[partnered] * normals[other]).sum(axis=1) < np.cos(_FACING)
    across_corner = (turn[other] < -_CORNER) & (
        _seen_apart(points[partnered], points[other], centre) > _FACING
    )
    partnered = partnered[np.where(np.abs(turn[other]) < _CORNER, opposed, across_corner)]
    across = np.full(len(points), np.inf)
    across[partnered] = 2.0 * radius[partnered]
    channel = np.zeros(len(points), dtype=bool)
    channel[partnered] = ~_tapers(loops, partnered, partner[partnered], across[partnered])
    return Thickness(points, across, channel)


def _seen_apart(p: Floats, q: Floats, centre: Floats) -> Floats:
    """Angle (n,) between p and q seen from a centre."""
    u, v = p - centre, q - centre
    product = np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1)
    cosine = (u * v).sum(axis=1) / np.maximum(product, np.finfo(float).tiny)
    return np.arccos(np.clip(cosine, -1.0, 1.0))


def _tapers(loops: list[Floats], first: Ints, second: Ints, across: Floats) -> Bools:
    """Whether the piece cut off between two samples of one loop is a tip rather than a strip.

    A strip of length l holds l times its width, a tip that tapers off half as much.
    """
    starts = np.cumsum([0, *(len(loop) for loop in loops)])
    owner = np.searchsorted(starts, first, side="right") - 1
    tapers = np.zeros(len(first), dtype=bool)
    for index, loop in enumerate(loops):
        mine = np.flatnonzero((owner == index) & (second >= starts[index]) & (second < starts[index + 1]))
        i, j = np.sort([first[mine], second[mine]], axis=0) - starts[index]
        swept = np.cumsum(np.append(0.0, cross(loop, np.roll(loop, -1, axis=0))))
        piece = 0.5 * np.abs(swept[j] - swept[i] + cross(loop[j], loop[i]))
        lengths = arc_lengths(loop)
        arc = lengths[j] - lengths[i]
        longer = 2.0 * arc > lengths[-1]
        piece = np.where(longer, np.abs(signed_area(loop)) - piece, piece)
        arc = np.where(longer, lengths[-1] - arc, arc)
        tapers[mine] = piece < 0.75 * across[mine] * 0.5 * arc
    return tapers
