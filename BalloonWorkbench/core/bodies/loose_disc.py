# SPDX-License-Identifier: LGPL-2.1-or-later
"""The disc at the end of a profile that pulls its film neither in nor out: along the profile's own direction.

A flat disc under pressure bulges, its film slack all around and carrying along the meridian alone: from its
middle it is bent like an inflated balloon of two discs (Paulsen 1994). With the radius r, the angle t of the
meridian to the disc's plane, and the radius a at which it would be square to it,

    sin t = (r / a)^2,    ds = a dt / (2 sqrt(sin t)).

Where the profile begins at a radius and an angle, the disc goes on from it if its own radius is the length s
up to there: A = 1.311 times the profile's where that is square to it, more where the body tapers.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on

#: A profile that runs outward more steeply would need a disc without end [rad].
_STEEPEST = np.radians(135.0)
#: The direction of a profile's end is that of so much of it, in its own radii there.
_END = 0.05
_STEPS = 200


def loose_radius(profile: Profile, end: int) -> float:
    """The radius [m] of such a disc at the lower end (0) or the upper end (-1) of a profile."""
    line = profile.points if end == 0 else profile.points[::-1]
    lengths = line_lengths(line)
    radius = float(line[0, 0])
    ahead = point_on(line, lengths, np.array([min(_END * radius, float(lengths[-1]))]))[0] - line[0]
    angle = float(np.arctan2(abs(ahead[1]), ahead[0]))
    return radius * _length(min(max(angle, 1e-3), _STEEPEST))


def _length(angle: float) -> float:
    """Of the disc's meridian from its middle to where it has this angle to its plane, for a radius of 1."""
    roots = np.sqrt(angle) * (np.arange(_STEPS) + 0.5) / _STEPS  # of the angle: so the integrand is smooth
    return float(np.sqrt(angle / np.sin(angle)) * np.mean(roots / np.sqrt(np.sin(roots**2))))
