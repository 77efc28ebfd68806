# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body of revolution as equal flat gores, with discs at the ends that are no points.

A gore lies along the film, whose grain is along x unless it is said otherwise: its middle line along x, as
long as the meridian from the lower end on, its edges at the half widths on both sides of it. Its ends are
points, or arcs square to its edges as of a cone unrolled.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.bodies.profile import OPEN, POINT, Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import direction, turn
from BalloonWorkbench.core.types import Floats

#: So many gores can be made.
FEWEST, MOST = 3, 100
#: How gores are called, before their number.
GORE = "gore "
#: Lengths along a meridian between corners of the profile, points along each rim of a disc at least.
STATIONS, _RIM = 64, 48
#: A turn of the profile that is a corner of the gores' edges [rad].
_CORNER = np.radians(10.0)
#: Where along the gores the balloon is filled: near the lower end, but away from it.
_OPENING = 0.15


@dataclass(frozen=True)
class Gores:
    """What the gores of a profile are cut from.

    along        (m,) m, lengths along the meridian, from the lower end
    half_widths  (m,) m, there; 0 at a point
    stretch      how long the gore is, in lengths of the meridian
    """

    along: Floats
    half_widths: Floats
    stretch: float = 1.0


def plain_gores(profile: Profile, count: int) -> Gores:
    """The gores as wide as the body is around: with which a pattern begins. Raises InputError."""
    if not FEWEST <= count <= MOST:
        raise InputError(f"A body cannot be made of {count} gores. Take {FEWEST} to {MOST}.")
    lengths = line_lengths(profile.points)
    steps = np.diff(profile.points, axis=0)
    corners = 1 + np.flatnonzero(np.abs(turn(steps[:-1], steps[1:])) > _CORNER)
    stops = np.concatenate([[0.0], lengths[corners], lengths[-1:]])
    parts = np.maximum(np.rint(STATIONS * np.diff(stops) / lengths[-1]).astype(int), 2)
    pieces = [low + (high - low) * np.arange(k) / k for low, high, k in zip(stops, stops[1:], parts)]
    along = np.concatenate([*pieces, lengths[-1:]])
    return Gores(along, np.pi / count * point_on(profile.points, lengths, along)[:, 0])


def gored_bag(profile: Profile, count: int, gores: Gores | None = None) -> Bag:
    """So many equal gores, sealed edge to edge, and a disc at each end that is no point.

    gores  None for plain ones. A disc at an open end only closes it in the simulation. Raises InputError.
    """
    gores = gores or plain_gores(profile, count)
    parts = max(2, -(-_RIM // count))  # of each gore's end
    lower, right, upper = _outline(profile, gores, parts)
    outer = laid_along(np.concatenate([lower, right, upper, right[::-1] * (-1.0, 1.0)]))
    low, top = len(lower) - 1, len(lower) + len(right)  # the right corners; the left ones are 0 and last
    last = top + len(upper) - 1
    panels = [BagPanel(f"{GORE}{number + 1}", outer) for number in range(count)]
    seams = [BagSeam(Side(k, low, top), Side((k + 1) % count, 0, last)) for k in range(count)]
    around = parts * count
    if profile.lower != POINT:
        for k in range(count):
            rim = Side(len(panels), -k * parts % around, -(k + 1) * parts % around)
            seams.append(BagSeam(Side(k, 0, low), rim))
        panels.append(BagPanel("lower disc", _disc(lower, count, 1.0), cut=profile.lower != OPEN))
    if profile.upper != POINT:
        for k in range(count):
            rim = Side(len(panels), (k + 1) * parts % around, k * parts)
            seams.append(BagSeam(Side(k, top, last), rim))
        panels.append(BagPanel("upper disc", _disc(upper, count, -1.0), cut=profile.upper != OPEN))
    opening = None
    if OPEN not in (profile.lower, profile.upper):
        opening = Opening(0, low + int(np.argmin(np.abs(gores.along - _OPENING * gores.along[-1]))))
    return Bag(tuple(panels), tuple(seams), opening, notes=profile.notes)


def laid_along(upright: Floats) -> Floats:
    """Places (n, 2) of gores as they lie, of those of gores that stand upright: across and up."""
    return np.asarray(upright[:, ::-1] * (1.0, -1.0))


def stood_upright(lying: Floats) -> Floats:
    """The other way round: (n, 2) across a gore, to the right seen from outside, and up its middle line."""
    return np.asarray(lying[:, ::-1] * (-1.0, 1.0))


def _outline(profile: Profile, gores: Gores, parts: int) -> tuple[Floats, Floats, Floats]:
    """Three parts of an upright gore, (k, 2) m each: its lower end from left to right, the right edge between
    its corners, its upper end from right to left.
    """
    middle, half = gores.stretch * gores.along, gores.half_widths
    slopes = np.diff(half) / np.diff(middle)
    lower, upper = (
        np.array([[0.0, middle[end]]])
        + (np.zeros((1, 2)) if kind == POINT else _arc(float(half[end]), float(slopes[end]), parts))
        for end, kind in ((0, profile.lower), (-1, profile.upper))
    )
    heights = np.interp(middle, middle[[0, -1]], [lower[-1, 1], upper[-1, 1]])
    return lower, np.column_stack([half, heights])[1:-1], upper[::-1]


def _arc(half_width: float, slope: float, parts: int) -> Floats:
    """From left to right (parts + 1, 2) m through (0, 0), square to edges that part with this slope."""
    angle = np.arctan(slope)
    at = np.linspace(-1.0, 1.0, parts + 1)
    if abs(angle) < 1e-6:
        return half_width * np.column_stack([at, np.zeros(parts + 1)])
    radius = half_width / np.sin(angle)
    return radius * np.column_stack([np.sin(angle * at), np.cos(angle * at) - 1.0])


def _disc(end: Floats, count: int, sense: float) -> Floats:
    """The rim (count * parts, 2) m of a disc with edges as long as those of a gore's end, all round.

    sense  1 seen from below, -1 from above: so that its first point is between the last gore and the first
    """
    around = count * (len(end) - 1)
    radius = float(np.linalg.norm(end[1] - end[0])) / (2.0 * np.sin(np.pi / around))
    angles = 2.0 * np.pi * np.arange(around) / around + sense * np.pi / count
    return radius * direction(angles)
