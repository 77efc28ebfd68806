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
from BalloonWorkbench.core.bodies.loose_disc import loose_radius
from BalloonWorkbench.core.bodies.profile import DISC, OPEN, POINT, Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on
from BalloonWorkbench.core.geometry.vectors import direction, turn
from BalloonWorkbench.core.types import Floats

#: So many gores can be made.
FEWEST, MOST = 3, 100
#: Lengths along a meridian between corners of the profile, points along each rim of a disc at least.
STATIONS, _RIM = 64, 48
#: A turn of the profile that is a corner of the gores' edges [rad].
_CORNER = np.radians(10.0)
#: So far from a disc the gores may be flared for it: in its radii, and at most in lengths of the meridian.
_FLARE, _MOST_FLARED = 0.3, 0.25
#: Where along the gores the balloon is filled: near the lower end, but away from it.
_OPENING = 0.15


@dataclass(frozen=True)
class Gores:
    """What the gores of a profile are cut from.

    along        (m,) m, lengths along the meridian, from the lower end
    half_widths  (m,) m, there; 0 at a point
    slopes       how fast the half width grows at the lower and at the upper end, whose arcs are square to it
    stretch      how long the gore is, in lengths of the meridian
    """

    along: Floats
    half_widths: Floats
    slopes: tuple[float, float]
    stretch: float = 1.0


def plain_gores(profile: Profile, count: int) -> Gores:
    """The gores as wide as the body is around: with which a pattern begins. Raises InputError."""
    if not FEWEST <= count <= MOST:
        raise InputError(f"A body cannot be made of {count} gores. Take {FEWEST} to {MOST}.")
    lengths = line_lengths(profile.points)
    steps = np.diff(profile.points, axis=0)
    corners = 1 + np.flatnonzero(np.abs(turn(steps[:-1], steps[1:])) > _CORNER)
    stops = np.concatenate([[0.0], lengths[corners], lengths[-1:]])
    for reach, end in _reaches(profile):
        stops = np.append(stops, np.abs(end - reach * np.array([1.0, 2.0, 3.0]) / 3.0))
    stops = np.unique(stops)
    parts = np.maximum(np.rint(STATIONS * np.diff(stops) / lengths[-1]).astype(int), 2)
    pieces = [low + (high - low) * np.arange(k) / k for low, high, k in zip(stops, stops[1:], parts)]
    along = np.concatenate([*pieces, lengths[-1:]])
    half = np.pi / count * point_on(profile.points, lengths, along)[:, 0]
    slopes = np.diff(half) / np.diff(along)
    return Gores(along, half, (float(slopes[0]), float(slopes[-1])))


def flares(profile: Profile, along: Floats) -> Floats:
    """Parts (m, discs) by which gores may be wider beside each disc, lower first, at lengths (m,) along them.

    1 where the disc is, and smoothly 0 from a part of its radius on.
    """
    parts = [np.maximum(0.0, 1.0 - np.abs(along - end) / reach) ** 2 for reach, end in _reaches(profile)]
    return np.stack(parts, axis=1) if parts else np.zeros((len(along), 0))


def folds_at(profile: Profile, place: Floats) -> bool:
    """Whether a place (3,) m of an upright body is beside a disc, where the corners of flared gores fold."""
    here, lengths = np.array([np.hypot(place[0], place[1]), place[2]]), line_lengths(profile.points)
    rims = [(reach, point_on(profile.points, lengths, np.array([at]))[0]) for reach, at in _reaches(profile)]
    return any(float(np.linalg.norm(here - rim)) < 2.0 * reach for reach, rim in rims)


def _reaches(profile: Profile) -> list[tuple[float, float]]:
    """For each disc, lower first: how far [m] from it the gores may be flared, and its length along them."""
    whole = length(profile.points)
    return [
        (min(_FLARE * float(profile.points[end, 0]), _MOST_FLARED * whole), at)
        for end, at, kind in ((0, 0.0, profile.lower), (-1, whole, profile.upper))
        if kind == DISC
    ]


def discs_of(bag: Bag, profile: Profile) -> list[tuple[int, int]]:
    """Numbers of the discs of a profile's bag, which come after the gores, each with its end: 0 or -1."""
    ends = [end for end, kind in ((0, profile.lower), (-1, profile.upper)) if kind != POINT]
    return list(enumerate(ends, len(bag.panels) - len(ends)))


def gores_of(bag: Bag, profile: Profile) -> int:
    """How many gores a profile's bag has."""
    return len(bag.panels) - len(discs_of(bag, profile))


def gored_bag(profile: Profile, count: int, gores: Gores | None = None) -> Bag:
    """So many equal gores, sealed edge to edge, and a disc at each end that is no point.

    gores  None for plain ones. A disc at an open end only closes it in the simulation: it is gathered along
           its rim, so that it pulls along the profile. Raises InputError.
    """
    gores = gores or plain_gores(profile, count)
    parts = max(2, -(-_RIM // count))  # of each gore's end
    lower, right, upper = _outline(profile, gores, parts)
    outer = laid_along(np.concatenate([lower, right, upper, right[::-1] * (-1.0, 1.0)]))
    low, top = len(lower) - 1, len(lower) + len(right)  # the right corners; the left ones are 0 and last
    last = top + len(upper) - 1
    panels = [BagPanel(f"gore {number + 1}", outer) for number in range(count)]
    seams = [BagSeam(Side(k, low, top), Side((k + 1) % count, 0, last)) for k in range(count)]
    around = parts * count
    if profile.lower != POINT:
        for k in range(count):
            rim = Side(len(panels), -k * parts % around, -(k + 1) * parts % around)
            seams.append(BagSeam(Side(k, 0, low), rim))
        radius = loose_radius(profile, 0) if profile.lower == OPEN else None
        panels.append(BagPanel("lower disc", _disc(lower, count, 1.0, radius), cut=radius is None))
    if profile.upper != POINT:
        for k in range(count):
            rim = Side(len(panels), (k + 1) * parts % around, k * parts)
            seams.append(BagSeam(Side(k, top, last), rim))
        radius = loose_radius(profile, -1) if profile.upper == OPEN else None
        panels.append(BagPanel("upper disc", _disc(upper, count, -1.0, radius), cut=radius is None))
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
    lower, upper = (
        np.array([[0.0, middle[end]]])
        + (np.zeros((1, 2)) if kind == POINT else _arc(float(half[end]), gores.slopes[end], parts))
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


def _disc(end: Floats, count: int, sense: float, radius: float | None) -> Floats:
    """The rim (count * parts, 2) m of a disc with as many edges as a gore's end has, all round.

    sense   1 seen from below, -1 from above: so that its first point is between the last gore and the first
    radius  [m], None for edges as long as those of the gore's end
    """
    around = count * (len(end) - 1)
    if radius is None:
        radius = float(np.linalg.norm(end[1] - end[0])) / (2.0 * np.sin(np.pi / around))
    angles = 2.0 * np.pi * np.arange(around) / around + sense * np.pi / count
    return radius * direction(angles)
