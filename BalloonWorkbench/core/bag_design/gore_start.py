# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gores laid on the body that they are cut for: where their inflation begins."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.bodies.gores import Gores, stood_upright
from BalloonWorkbench.core.bodies.profile import POINT, Profile
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.types import Floats, Ints


def on_profile(meshed: MeshedBag, profile: Profile, gores: Gores, count: int) -> Floats:
    """Places (n, 3) m of all vertices: gores round the z axis, the first one where x is; flat discs."""
    ends = [profile.points[end] for end, kind in ((0, profile.lower), (-1, profile.upper)) if kind != POINT]
    below = profile.lower != POINT
    parts = []
    for number, panel in enumerate(meshed.assembly.panels):
        flat = panel.rest_positions
        if number < count:
            parts.append(_gore(flat, profile, gores, count, number))
        else:
            disc = number - count
            sense = -1.0 if below and disc == 0 else 1.0
            parts.append(_disc(flat, ends[disc], sense))
    return np.concatenate(parts)


def _gore(flat: Floats, profile: Profile, gores: Gores, count: int, number: int) -> Floats:
    lengths = line_lengths(profile.points)
    sideways, upwards = stood_upright(flat).T
    along = np.clip(upwards / gores.stretch, 0.0, lengths[-1])
    r, z = point_on(profile.points, lengths, along).T
    half = np.interp(along, gores.along, gores.half_widths)
    across = np.clip(sideways / np.maximum(half, 1e-9 * lengths[-1]), -1.0, 1.0)
    angle = 2.0 * np.pi / count * (number + 0.5 * across)
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z])


def _disc(flat: Floats, end: Floats, sense: float) -> Floats:
    """A disc that is seen from above, or from below (sense -1), at the end (2,) r, z of a profile."""
    scale = end[0] / float(np.linalg.norm(flat, axis=1).max())
    return np.column_stack([scale * flat[:, 0], sense * scale * flat[:, 1], np.full(len(flat), end[1])])


def lower_end(meshed: MeshedBag, profile: Profile, count: int) -> Ints:
    """The vertices (k,) at the lower end of all gores, by which a balloon with lift is held."""
    assembly = meshed.assembly
    if profile.lower == POINT:
        tips = [assembly.seams[k].first.vertices[:1] + assembly.offsets[k] for k in range(count)]
        return np.unique(np.concatenate(tips)).astype(np.int32)
    rims = [assembly.seams[count + k].first.vertices + assembly.offsets[k] for k in range(count)]
    return np.unique(np.concatenate(rims)).astype(np.int32)
