# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge of a shape in a photograph to a part of a pixel: where its colour is half way to that beside it.

The picture reader follows what differs from the background of the whole picture, which a blurred edge, or one
in a shadow, does from further outside on. Here each place has its own inside and outside.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.sampling import evenly, simplify
from BalloonWorkbench.core.types import Floats

#: Between places along the edge, how far to either side is looked, and over which part of that the colours
#: of both sides are means [px].
_SPACING, _REACH, _PLATEAU = 1.0, 7.0, 2.0
_STEP = 0.25
#: Colours nearer than this, in RGB, 0 to 441, have no edge between them.
_CONTRAST = 25.0
#: The edge of a place is the median of so many neighbours', on either side.
_NEIGHBOURS = 3
_TOLERANCE = 0.05  # px


def at_half(rgba: NDArray[np.uint8], loop: Floats) -> Floats:
    """The closed loop (n, 2) px, y up from the lower left corner of a picture (h, w, 4), moved to the edge.

    Where no edge is seen, and where the loop would cross itself, it stays.
    """
    places = evenly(loop, _SPACING)
    outward = -left_normals(places)
    offsets = np.arange(-_REACH, _REACH + 0.5 * _STEP, _STEP)
    colours = _sampled(rgba, places[:, None] + offsets[None, :, None] * outward[:, None])
    count = round(_PLATEAU / _STEP)
    inside, outside = colours[:, :count].mean(axis=1), colours[:, -count:].mean(axis=1)
    axis = inside - outside
    contrast = (axis**2).sum(axis=1)
    shares = np.einsum("ijk,ik->ij", colours - outside[:, None], axis) / np.maximum(contrast, 1e-9)[:, None]
    moves = np.where(contrast > _CONTRAST**2, _crossing(shares, offsets), 0.0)
    around = np.stack([np.roll(moves, shift) for shift in range(-_NEIGHBOURS, _NEIGHBOURS + 1)])
    moved = simplify(places + np.median(around, axis=0)[:, None] * outward, _TOLERANCE)
    return loop if first_crossing([moved]) is not None else moved


def _crossing(shares: Floats, offsets: Floats) -> Floats:
    """Where rows of shares (n, k) fall below one half nearest to the middle, as offsets (n,); 0: nowhere."""
    falls = (shares[:, :-1] > 0.5) & (shares[:, 1:] <= 0.5)
    nearest = np.argmin(np.where(falls, np.abs(offsets[:-1] + 0.5 * _STEP), np.inf), axis=1)
    rows = np.arange(len(shares))
    before, after = shares[rows, nearest], shares[rows, nearest + 1]
    part = (before - 0.5) / np.maximum(before - after, 1e-9)
    return np.where(falls.any(axis=1), offsets[nearest] + _STEP * part, 0.0)


def _sampled(rgba: NDArray[np.uint8], places: Floats) -> Floats:
    """Colours (..., 3) between the centres of pixels at places (..., 2), y up; beyond it the border's."""
    height, width = rgba.shape[:2]
    x = np.clip(places[..., 0] - 0.5, 0.0, width - 1.0)
    y = np.clip(height - 0.5 - places[..., 1], 0.0, height - 1.0)
    left, top = (np.minimum(value.astype(np.intp), most) for value, most in ((x, width - 2), (y, height - 2)))
    u, v = (x - left)[..., None], (y - top)[..., None]
    colours = rgba[..., :3]
    upper = (1.0 - u) * colours[top, left] + u * colours[top, left + 1]
    lower = (1.0 - u) * colours[top + 1, left] + u * colours[top + 1, left + 1]
    return np.asarray((1.0 - v) * upper + v * lower)
