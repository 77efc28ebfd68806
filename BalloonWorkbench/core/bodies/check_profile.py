# SPDX-License-Identifier: LGPL-2.1-or-later
"""From points of half a section to a profile: cleaned, its ends told apart, refused where no body has it."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bodies.profile import DISC, OPEN, POINT, Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import extent, length, line_lengths, part_of
from BalloonWorkbench.core.options.body import AUTOMATIC
from BalloonWorkbench.core.options.film import FilmOptions
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, place_text

#: Radius of the disc that takes the place of a point [m]: the film is sealed along its rim, and stays in it.
CAP_RADIUS = 3.0 * FilmOptions.seal_width
#: Nearer to each other or to the axis than this part of the profile's size, points are one, or on the axis.
_SAME = 1e-6
#: Smaller and larger balloons are surely a slip of the unit [m].
_LEAST, _MOST = 1e-3, 100.0
_FLATTEST = 1e-2  # part of the radius that a body is high at least
_ENDS = (AUTOMATIC, POINT, DISC, OPEN)


def checked_profile(
    points: Floats, lower: str = AUTOMATIC, upper: str = AUTOMATIC, notes: tuple[str, ...] = ()
) -> Profile:
    """A profile of points (n, 2) r, z [m], from either end to the other.

    lower, upper  POINT, DISC or OPEN, or AUTOMATIC: a point where the profile ends on the axis, else a disc.
                  An end that runs straight to the axis and square to it is a disc, too; a disc where the
                  profile comes to a point cuts it off, CAP_RADIUS wide.
    Raises InputError.
    """
    for name, end in (("lower", lower), ("upper", upper)):
        if end not in _ENDS:
            raise InputError(f"The {name} end of the profile is '{end}'. Use one of {', '.join(_ENDS)}.")
    line = _cleaned(np.asarray(points, dtype=np.float64).reshape(-1, 2))
    line, lower = _ended(line, lower, "lower")
    turned, upper = _ended(line[::-1], upper, "upper")
    line = np.ascontiguousarray(turned[::-1])
    _check(line)
    return Profile(line, lower, upper, notes)


def with_ends(profile: Profile, lower: str, upper: str) -> Profile:
    """The same profile with its ends closed in another way; AUTOMATIC leaves one as it is. InputError."""
    chosen = [
        new if new != AUTOMATIC else old for new, old in ((lower, profile.lower), (upper, profile.upper))
    ]
    if chosen == [profile.lower, profile.upper]:
        return profile
    return checked_profile(profile.points, chosen[0], chosen[1], profile.notes)


def _cleaned(points: Floats) -> Floats:
    """The line from below without points that are there twice, those on the axis exactly there."""
    if len(points) < 2 or not np.isfinite(points).all():
        raise InputError("The profile needs at least two points, each a pair of numbers: radius and height.")
    size = extent(points)
    if not _LEAST <= size <= _MOST:
        raise InputError(
            f"The profile is {length_text(size)} large. Give it a size between {length_text(_LEAST)} and"
            f" {length_text(_MOST)}, and check its unit."
        )
    same = _SAME * size
    line = points[np.append(True, np.linalg.norm(np.diff(points, axis=0), axis=1) > same)]
    if len(line) > 2 and np.linalg.norm(line[-1] - line[0]) <= same:
        line = _opened(line[:-1], same)
    line = line[::-1] if line[0, 1] > line[-1, 1] else line
    inside = line[:, 0] < -same
    if inside.any():
        place = line[int(np.argmin(line[:, 0]))]
        raise InputError(
            f"The profile goes to the other side of its axis at the height {length_text(float(place[1]))}:"
            f" the radius is {length_text(float(place[0]))}. Draw one half only."
        )
    return np.column_stack([np.where(line[:, 0] <= same, 0.0, line[:, 0]), line[:, 1]])


def _opened(loop: Floats, same: float) -> Floats:
    """A closed line (n, 2) without the edge that runs along the axis."""
    on_axis = np.abs(loop[:, 0]) <= same
    edges = np.flatnonzero(on_axis & np.roll(on_axis, -1))
    if not len(edges):
        raise InputError(
            "The profile is a closed line that does not run along its axis. Draw one half of the section,"
            " from the lower to the upper end."
        )
    return np.roll(loop, -int(edges[-1]) - 1, axis=0)


def _ended(line: Floats, end: str, name: str) -> tuple[Floats, str]:
    """The line, of which this end comes first, closed in this way; and which it is."""
    if len(line) < 2:
        return line, end
    on_axis, flat = line[0, 0] == 0.0, abs(line[1, 1] - line[0, 1]) <= 1e-4 * abs(line[1, 0] - line[0, 0])
    if end == POINT and not on_axis:
        raise InputError(
            f"The {name} end of the profile is {length_text(float(line[0, 0]))} away from the axis, so no"
            " gores can meet there in a point. Close it with a disc, or leave it open."
        )
    if end == AUTOMATIC and not on_axis:
        return line, DISC
    if on_axis and end != POINT and flat and len(line) > 2:
        return line[1:], DISC if end == AUTOMATIC else end
    if end in (AUTOMATIC, POINT):
        return line, POINT
    return (_cut_off(line, name) if on_axis else line), end


def _cut_off(line: Floats, name: str) -> Floats:
    """The line, which begins on the axis, from where it is CAP_RADIUS away."""
    outside = np.flatnonzero(line[:, 0] > CAP_RADIUS)
    if not len(outside) or line[:, 0].max() < 2.0 * CAP_RADIUS:
        raise InputError(
            f"The profile is too slender for a disc of {length_text(2.0 * CAP_RADIUS)} at its {name} end."
            " Let the gores meet in a point there."
        )
    last = int(outside[0])
    (r0, _), (r1, _) = line[last - 1], line[last]
    lengths = line_lengths(line)
    at = float(lengths[last - 1] + (CAP_RADIUS - r0) / (r1 - r0) * (lengths[last] - lengths[last - 1]))
    return part_of(line, at, float(lengths[-1]))


def _check(line: Floats) -> None:
    """InputError for a line of which no body can be made."""
    if len(line) < 2 or length(line) <= 0.0 or not line[:, 0].max() > 0.0:
        raise InputError("The profile lies on its axis. Draw the half outline at a distance from it.")
    radius, height = float(line[:, 0].max()), float(np.ptp(line[:, 1]))
    if height < _FLATTEST * radius:
        raise InputError(
            f"The body of the profile is {length_text(height)} high and {length_text(2.0 * radius)} wide: no"
            " balloon is so flat. Draw its profile higher, or make it of two panels."
        )
    waist = np.flatnonzero(line[1:-1, 0] == 0.0)
    if len(waist):
        height = float(line[1 + waist[0], 1])
        raise InputError(
            f"The profile touches its axis at the height {length_text(height)}, which parts the balloon in"
            " two. Keep it away from the axis there."
        )
    if (place := first_crossing([], [line])) is not None:
        raise InputError(f"The profile crosses or touches itself at {place_text(place)}. Draw a simple line.")
