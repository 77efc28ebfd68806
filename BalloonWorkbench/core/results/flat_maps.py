# SPDX-License-Identifier: LGPL-2.1-or-later
"""A result as colours on the flat panel: a picture of it, for what draws panels flat."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.raster import covered
from BalloonWorkbench.core.results.colour_map import colours
from BalloonWorkbench.core.types import Floats, Ints

#: Pixels along the longer side of a panel.
_PIXELS = 400


@dataclass(frozen=True)
class FlatPicture:
    """A picture in the plane of a panel.

    pixels     (h, w, 4) red, green, blue, alpha; the first row is the upper one
    low, high  (2,) m, its lower left and upper right corner
    """

    pixels: NDArray[np.uint8]
    low: Floats
    high: Floats

    def moved(self, shift: Floats) -> FlatPicture:
        """Elsewhere, by a shift (2,) [m]."""
        return FlatPicture(self.pixels, self.low + shift, self.high + shift)

    def mirrored(self) -> FlatPicture:
        """About the y axis."""
        flip = np.array([-1.0, 1.0])
        low = np.array([self.high[0], self.low[1]]) * flip
        return FlatPicture(self.pixels[:, ::-1], low, np.array([self.low[0], self.high[1]]) * flip)


def flat_map(points: Floats, triangles: Ints, shares: Floats) -> FlatPicture:
    """A map on one flat panel: points (n, 2) m, triangles (m, 3), and the shares (m, 3) of their corners, see
    `ColourMap`. Transparent beside the triangles."""
    low, high = bounds(points)
    pixel = float(np.max(high - low)) / _PIXELS
    width, height = (max(2, int(np.ceil(size / pixel - 1e-6))) for size in (high - low).tolist())
    x, y = (start + pixel * (0.5 + np.arange(count)) for start, count in zip(low, (width, height)))
    pixels = np.zeros((height, width, 4), dtype=np.uint8)
    for cover in covered(points, triangles, x, y):
        values = (shares[cover.number] * cover.shares).sum(axis=1)
        pixels[cover.rows, cover.columns, :3] = colours(values)
        pixels[cover.rows, cover.columns, 3] = 255
    return FlatPicture(pixels[::-1], low, low + pixel * np.array([width, height]))
