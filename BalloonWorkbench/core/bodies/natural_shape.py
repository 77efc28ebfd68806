# SPDX-License-Identifier: LGPL-2.1-or-later
"""The natural shape of a weightless balloon, whose film carries along its meridians alone (Upson 1939).

The pressure grows with the height. At a radius r the meridian carries C / r on each length around, the same
force all the way up, and turns as the pressure b z bends it: with its angle t to the axis and the length s
along it, in units of (C / b)^(1/3),

    dr/ds = sin t,    dz/ds = cos t,    dt/ds = -z r.

It begins in a point, and ends in one, flat, for one angle at the bottom only: 50.149 degrees.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.types import Floats

_STEP = 2e-3  # of Runge and Kutta's method
_POINTS = 400


def natural_shape(gore_length: float) -> Profile:
    """The profile of the weightless zero-pressure balloon with gores so long [m], closed in two points."""
    shape = _shape()
    return Profile(shape * (gore_length / length(shape)))


@cache
def _shape() -> Floats:
    """Its points (n, 2) in units of (C / b)^(1/3)."""
    angle, after = np.radians(50.0), np.radians(50.3)
    off, off_after = _meridian(angle)[1], _meridian(after)[1]
    while abs(after - angle) > 1e-11:  # secant
        angle, after, off = after, after - off_after * (after - angle) / (off_after - off), off_after
        off_after = _meridian(after)[1]
    line = _meridian(after)[0]
    chosen = np.unique(np.rint(np.linspace(0, len(line) - 1, _POINTS)).astype(int))
    return line[chosen] * np.append(np.ones(len(chosen) - 1), 0.0)[:, None] ** [1.0, 0.0]


def _meridian(angle: float) -> tuple[Floats, float]:
    """Its points (n, 2) until it is back at the axis, and the angle by which it is not square to it there."""
    state = np.array([0.0, 0.0, angle])
    states = [state]
    while len(states) < 3 or state[0] > 0.0:
        state = _advanced(state, _STEP)
        states.append(state)
    before, beyond = states[-2], states[-1]
    share = before[0] / (before[0] - beyond[0])
    last = _advanced(before, share * _STEP)
    line = np.array([*states[:-1], last])[:, :2]
    return line, float(last[2] + 0.5 * np.pi)


def _advanced(state: Floats, step: float) -> Floats:
    """A step of Runge and Kutta's method of fourth order."""
    first = _slope(state)
    second = _slope(state + 0.5 * step * first)
    third = _slope(state + 0.5 * step * second)
    fourth = _slope(state + step * third)
    return np.asarray(state + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth))


def _slope(state: Floats) -> Floats:
    r, z, angle = state
    return np.array([np.sin(angle), np.cos(angle), -z * r])
