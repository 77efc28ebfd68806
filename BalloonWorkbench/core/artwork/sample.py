# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of a picture between its pixels."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.tracing.raster import ndimage, opencv

Pixels = NDArray[np.uint8]
Places = NDArray[np.float32]

#: OpenCV's remap takes pictures smaller than that.
_MOST_SIDE = 32_000


def sampled(pixels: Pixels, columns: Places, rows: Places) -> Pixels:
    """Colours (h, w, 4) of a picture at columns and rows (h, w), whole numbers being the middles of pixels.

    Between pixels the four around are mixed, weighted by their opacity; past the edge the edge goes on.
    """
    if (cv2 := opencv()) and max(*pixels.shape[:2], *columns.shape) < _MOST_SIDE:
        mix = {"interpolation": cv2.INTER_LINEAR, "borderMode": cv2.BORDER_REPLICATE}
        if pixels[..., 3].min() == 255:
            return np.asarray(cv2.remap(pixels, columns, rows, **mix))
        return _unweighted(cv2.remap(_weighted(pixels), columns, rows, **mix))
    mix_plain = partial(ndimage().map_coordinates, coordinates=(rows, columns), order=1, mode="nearest")
    return _unweighted(
        np.stack([mix_plain(channel) for channel in np.moveaxis(_weighted(pixels), 2, 0)], axis=-1)
    )


def _weighted(pixels: Pixels) -> NDArray[np.float32]:
    values = pixels.astype(np.float32)
    values[..., :3] *= values[..., 3:] / 255.0
    return values


def _unweighted(values: NDArray[np.float32]) -> Pixels:
    alpha = values[..., 3:]
    colour = values[..., :3] * (255.0 / np.maximum(alpha, 1e-3))
    return np.asarray(np.clip(np.rint(np.concatenate([colour, alpha], axis=-1)), 0, 255), dtype=np.uint8)
