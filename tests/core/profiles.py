# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles for tests: half the sections of a sphere, an airship, bodies with a waist and with an open end."""

from __future__ import annotations

import json

import numpy as np

from BalloonWorkbench.core.bodies.check_profile import checked_profile
from BalloonWorkbench.core.bodies.natural_shape import natural_shape
from BalloonWorkbench.core.bodies.profile import DISC, OPEN, Profile
from BalloonWorkbench.core.types import Floats

_TURN = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 241)


def spheroid(radius: float, half_height: float) -> Profile:
    return checked_profile(np.column_stack([radius * np.cos(_TURN), half_height * np.sin(_TURN)]))


def sphere(radius: float = 1.0) -> Profile:
    return spheroid(radius, radius)


def airship(length: float = 2.1, width: float = 0.73) -> Profile:
    """The hull of a model airship: thickest before the middle, as long and thick as given."""
    share = 0.5 * (1.0 - np.cos(np.pi * np.linspace(0.0, 1.0, 241)))
    radii = np.sqrt(share) * (1.0 - share) ** 0.75
    return checked_profile(np.column_stack([0.5 * width * radii / radii.max(), length * (1.0 - share)]))


def _smooth(knots: list[tuple[float, float]], count: int = 240) -> Floats:
    """A curve (count + 1, 2) through points, as smooth as a cubic spline makes it."""
    from scipy.interpolate import CubicSpline

    points = np.array(knots)
    at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    return np.asarray(CubicSpline(at, points)(np.linspace(0.0, at[-1], count + 1)))


def pear() -> Profile:
    """A waist between a large and a small ball, 0.5 m high."""
    turn = np.pi * np.linspace(0.0, 1.0, 241)
    radii = np.sin(turn) * (0.165 + 0.055 * np.cos(turn) + 0.035 * np.cos(2.0 * turn))
    return checked_profile(np.column_stack([radii, 0.25 * (1.0 - np.cos(turn))]))


def egg() -> Profile:
    turn = np.pi * np.linspace(0.0, 1.0, 241)
    return checked_profile(
        np.column_stack([0.19 * np.sin(turn) * (1.0 + 0.17 * np.cos(turn)), 0.25 * (1.0 - np.cos(turn))])
    )


def bottle() -> Profile:
    """A flat bottom, straight walls, shoulders and a neck with a flat top."""
    line = _smooth(
        [(0.1, 0.0), (0.1, 0.12), (0.1, 0.24), (0.085, 0.31), (0.05, 0.37), (0.035, 0.42), (0.035, 0.5)]
    )
    return checked_profile(line, DISC, DISC)


def bell() -> Profile:
    """Open below, a waist, a round top."""
    line = _smooth(
        [(0.25, 0.0), (0.19, 0.06), (0.155, 0.16), (0.14, 0.27), (0.11, 0.35), (0.05, 0.395), (0.0, 0.405)]
    )
    return checked_profile(line * [1.0, 1.0], OPEN)


def cone(radius: float = 0.25, height: float = 0.5) -> Profile:
    return checked_profile(np.array([(radius, 0.0), (0.0, height)]))


def drum(radius: float = 0.15, height: float = 0.4) -> Profile:
    return checked_profile(np.array([(radius, 0.0), (radius, height)]))


def capsule(opening: float = 0.35) -> Profile:
    """A ball drawn long, its ends cut off at this angle from the axis."""
    turn = np.linspace(opening - 0.5 * np.pi, 0.5 * np.pi - opening, 241)
    points = 0.2 * np.column_stack([np.cos(turn), np.sin(turn) + 2.0 * (turn > 0.0)])
    return checked_profile(points, DISC, DISC)


def envelope(gore: float = 3.0) -> Profile:
    return natural_shape(gore)


def profile_json(profile: Profile) -> bytes:
    """The JSON text of a profile, in millimetres."""
    points = (1e3 * profile.points).round(4).tolist()
    text = {"unit": "mm", "profile": points, "lower": profile.lower, "upper": profile.upper}
    return json.dumps(text).encode()


PROFILES = {
    "sphere": sphere,
    "spheroid 2:1": lambda: spheroid(0.25, 0.5),
    "oblate 1:2": lambda: spheroid(0.5, 0.25),
    "airship": airship,
    "pear": pear,
    "egg": egg,
    "bottle": bottle,
    "bell": bell,
    "cone": cone,
    "drum": drum,
    "capsule": capsule,
    "envelope": envelope,
}
