# SPDX-License-Identifier: LGPL-2.1-or-later
"""A photograph of a balloon, or a scan of a panel, as an outline in metres."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.as_made.photo_edge import at_half
from BalloonWorkbench.core.as_made.photo_scale import PhotoScale
from BalloonWorkbench.core.as_made.shadows import without_shadows
from BalloonWorkbench.core.errors import InputError, PictureError
from BalloonWorkbench.core.files.foreign_reader import foreign_reader
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.tracing.picture import Decode, damaged, placed_drawing, shrunk
from BalloonWorkbench.core.tracing.picture_file import decode as decode_with_opencv
from BalloonWorkbench.core.tracing.picture_file import picture_size
from BalloonWorkbench.core.tracing.segment import SHAPE

#: Of the area that stands out, what is left without shadows is the balloon; less of it, and it is grey.
_COLOURED, _UNSHADED = 0.5, 0.995
#: For reading it: a shape on a plain background takes a tenth of it [s].
_SECONDS = 3.0
#: A shape nearer than this to the border is cut off there [px].
_BESIDE = 1.0


@dataclass(frozen=True)
class SeenShape:
    """The largest shape of a picture.

    outline  in metres, y up; in pixels where the scale is not known
    scale    None where the size is to be fitted
    remarks  on shadows, a sentence each
    """

    outline: Outline
    scale: PhotoScale | None
    remarks: tuple[str, ...] = ()


def read_photograph(path: str | Path, scale: PhotoScale | None, decode: Decode | None = None) -> SeenShape:
    """The largest shape in a picture file.

    decode  pixels (h, w, 4) of a file; OpenCV's without it
    Raises InputError (file), PictureError (no shape, cut off at the border), MissingPackageError.
    """
    path = Path(path)
    longest = max(picture_size(path))
    with foreign_reader(lambda _: damaged(path.name)):
        pixels = (decode or decode_with_opencv)(path)
    small = shrunk(pixels)
    factor = -(-max(pixels.shape[:2]) // max(small.shape[:2])) * round(longest / max(pixels.shape[:2]))
    seen = shape_of(small)
    pixel = factor * (1.0 if scale is None else scale.pixel)
    return SeenShape(seen.map(lambda loop: loop * pixel), scale, seen.notes)


def shape_of(rgba: NDArray[np.uint8]) -> Outline:
    """The largest shape in pixels (h, w, 4), in pixels, with notes on shadows."""
    outline, corner = _largest(rgba)
    if (rgba[..., 3] < 128).any():  # cut out by a program: there are no shadows, and the edge is known
        _check_border(outline, corner, rgba.shape[:2])
        return outline
    note = ""
    try:
        lit, lit_corner = _largest(without_shadows(rgba))
    except PictureError:
        lit = None
    if lit is None or lit.area < _COLOURED * outline.area:
        note = "The shape has the colour of a shadow: shadows on the background count as part of it."
    elif lit.area < _UNSHADED * outline.area:
        outline, corner, note = lit, lit_corner, "Shadows on the background were taken off."
    _check_border(outline, corner, rgba.shape[:2])
    sharp = outline.map(lambda loop: at_half(rgba, at_half(rgba, loop + corner)) - corner)
    return replace(sharp, notes=(note,) if note else ())


def _largest(rgba: NDArray[np.uint8]) -> tuple[Outline, NDArray[np.float64]]:
    """The largest shape, and where its origin lies in the picture."""
    try:
        drawing, corner = placed_drawing(rgba, drawn_as=SHAPE, budget=Budget(_SECONDS))
    except PictureError:
        raise
    except InputError as error:
        raise PictureError(
            "The photograph shows too many shapes: take one of the balloon alone, on a plain background."
        ) from error
    return replace(drawing.largest, notes=()), corner


def _check_border(outline: Outline, corner: NDArray[np.float64], shape: tuple[int, ...]) -> None:
    """Raise PictureError where the shape is cut off."""
    (left, low), (right, high) = bounds(outline.outer + corner)
    margins = {"left": left, "right": shape[1] - right, "upper": shape[0] - high, "lower": low}
    sides = [side for side, away in margins.items() if away < _BESIDE]
    if sides:
        raise PictureError(
            f"The shape touches the {' and the '.join(sides)} border of the photograph: take one that shows"
            " all of it on a plain background."
        )
