# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture and where it lies in the plane of the drawing, with its colours carried on past its edge."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.tracing.picture import placed_drawing, shrunk
from BalloonWorkbench.core.tracing.raster import ndimage, opencv
from BalloonWorkbench.core.tracing.segment import AUTO, segment
from BalloonWorkbench.core.types import Bools, Floats

Pixels = NDArray[np.uint8]

#: Pixels at the edge of a shape that are mixed with its background: they are replaced too.
_SOFT = 2


@dataclass(frozen=True)
class Picture:
    """A picture in the plane of the drawing.

    pixels  (h, w, 4) red, green, blue, alpha; the first row is the upper one
    low     (2,) m, lower left corner
    pixel   (2,) m, width and height of a pixel
    """

    pixels: Pixels
    low: Floats
    pixel: Floats

    def columns_rows(self, points: Floats) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Where points (..., 2) m lie in the picture, in pixels; whole numbers are the middles of pixels."""
        at = (points - self.low) / self.pixel
        height = len(self.pixels)
        return (at[..., 0] - 0.5).astype(np.float32), (height - at[..., 1] - 0.5).astype(np.float32)


def of_drawing(
    pixels: Pixels,
    low: Floats,
    size: Floats,
    drawn_as: str = AUTO,
    tracing: TracingOptions = USUAL_TRACING,
    shape: Pixels | None = None,
) -> Picture:
    """The picture that was traced, in its place: its shapes fill the box `size` (2,) m from `low` (2,) m.

    What is not part of a shape takes the colour of the nearest place that is. Raises PictureError where there
    is no shape, MissingPackageError without OpenCV and SciPy.

    shape  pixels of the same picture that were traced, where these have more on them
    """
    small = shrunk(pixels if shape is None else shape)
    step = max(pixels.shape[:2]) // max(small.shape[:2])
    drawing, corner = placed_drawing(small, drawn_as=drawn_as, tracing=tracing)
    pixel = size / (np.array(drawing.size) * step)
    # `shrunk` leaves out rows at the lower edge that do not make a whole block
    rest = len(pixels) - step * len(small)
    origin = low - (corner * step + (0.0, rest)) * pixel
    drawn = np.repeat(np.repeat(segment(small, drawn_as, tracing)[0] > 0.5, step, axis=0), step, axis=1)
    inside = np.zeros(pixels.shape[:2], dtype=np.bool_)
    inside[: drawn.shape[0], : drawn.shape[1]] = drawn
    return Picture(carried_on(pixels, _thinner(inside)), origin, pixel)


def covering(pixels: Pixels, low: Floats, size: Floats) -> Picture:
    """Any picture, as large as it must be to cover the box `size` (2,) m from `low` (2,) m, in its middle.

    What is transparent takes the colour of the nearest place that is not.
    """
    height, width = pixels.shape[:2]
    scale = float(np.max(size / (width, height)))
    corner = low + 0.5 * (size - scale * np.array([width, height]))
    return placed(pixels, corner, scale * width)


def placed(pixels: Pixels, low: Floats, width: float) -> Picture:
    """Any picture from a lower left corner (2,) m on, so wide [m]; transparent parts as in `covering`."""
    pixel = width / pixels.shape[1]
    opaque = pixels[..., 3] > 127
    filled = carried_on(pixels, opaque) if opaque.any() and not opaque.all() else pixels
    return Picture(filled, np.asarray(low, dtype=np.float64), np.array([pixel, pixel]))


def mirrored(picture: Picture) -> Picture:
    """The picture seen from behind, in the same place."""
    return Picture(np.ascontiguousarray(picture.pixels[:, ::-1]), picture.low, picture.pixel)


def carried_on(pixels: Pixels, inside: Bools) -> Pixels:
    """The picture with each pixel that is not inside (h, w) replaced by the nearest one that is.

    MissingPackageError without OpenCV and SciPy.
    """
    if not inside.any():
        return pixels
    if cv2 := opencv():
        _, labels = cv2.distanceTransformWithLabels(
            (~inside).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5, labelType=cv2.DIST_LABEL_PIXEL
        )
        source = np.zeros(int(labels.max()) + 1, dtype=np.intp)
        source[labels[inside]] = np.flatnonzero(inside)
        return np.asarray(pixels.reshape(-1, 4)[source[labels]])
    nearest = ndimage().distance_transform_edt(~inside, return_distances=False, return_indices=True)
    rows, columns = nearest
    return np.asarray(pixels[rows, columns])


def _thinner(inside: Bools) -> Bools:
    """Without a rim of a few pixels, where that leaves anything."""
    inner = inside
    for _ in range(_SOFT):
        padded = np.pad(inner, 1, constant_values=True)
        inner = inner & padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
    return inner if inner.any() else inside
