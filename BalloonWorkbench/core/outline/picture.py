# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture as an outline: unpacked, told from its background, traced, brought to size."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError, PictureError
from BalloonWorkbench.core.outline.contour import contours
from BalloonWorkbench.core.outline.crossings import contains, first_crossing
from BalloonWorkbench.core.outline.decode import decode as decode_with_opencv
from BalloonWorkbench.core.outline.decode import picture_size
from BalloonWorkbench.core.outline.loops import check, scale_to
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.segment import segment
from BalloonWorkbench.core.outline.trace import STEP, trace
from BalloonWorkbench.core.types import Floats

Decode = Callable[[Path], NDArray[np.uint8]]

_LONGEST_SIDE = 1600  # px; more detail than this is below a fifth of a millimetre on a 300 mm balloon
_SMALLEST_SIDE = 16  # px
_MOST_BOUNDARY = 40  # times the longest side; a hundred fingers side by side have half of it
# Relative to the area of the shape:
_SMALLEST_HOLE = 0.005
_SPECK = 0.01  # a separate part below this is a speck, above it another shape
_GRAIN = 1e-4  # below this it is noise, which is not worth a remark


def read_picture(
    path: str | Path, width: float | None, height: float | None, decode: Decode | None = None
) -> Outline:
    """The silhouette in a picture file, `width` or `height` m large (inside both where both are given).

    The lower left corner of its bounding box is the origin. Remarks on what was left out or closed are in the
    outline's notes.

    decode  pixels (h, w, 4) uint8 as red, green, blue, alpha of a file; OpenCV's without it
    Errors: InputError (file, size), PictureError (no shape), MissingPackageError (neither OpenCV nor decode)
    """
    path = Path(path)
    if width is None and height is None:
        raise InputError("A picture has no size of its own. Give the width or the height of the balloon.")
    picture_size(path)
    outline = outline_of(_shrink((decode or decode_with_opencv)(path)))
    return check(scale_to(outline, width, height))


def outline_of(rgba: NDArray[np.uint8]) -> Outline:
    """The silhouette in pixels (h, w, 4) with the pixel as unit and its lower left corner as origin."""
    if min(rgba.shape[:2]) < _SMALLEST_SIDE:
        raise PictureError(
            f"The picture is too small to see a shape. Use {_SMALLEST_SIDE} pixels or more across."
        )
    silhouette, notes = segment(rgba)
    loops = contours(silhouette)
    if not loops:
        raise PictureError(
            "No shape stands out in the picture. Use stronger colours or a plainer background."
        )
    loops.sort(key=lambda item: -abs(item[1]))
    main, area = next((loop, area) for loop, area in loops if area > 0)
    if len(main) > _MOST_BOUNDARY * max(rgba.shape[:2]):
        raise PictureError("The shape in the picture is too frayed to trace. Use a clearer picture.")
    seen = [(loop, own) for loop, own in loops if abs(own) >= _GRAIN * area and loop is not main]
    parts = [loop for loop, own in seen if own > 0]
    holes = _holes_of(main, parts, [loop for loop, own in seen if own < 0])
    large = [hole for hole in holes if _area(hole) >= _SMALLEST_HOLE * area]
    notes += _notes(main, area, parts, len(holes) - len(large), rgba.shape)
    traced = _simple([main, *large], STEP * max(rgba.shape[:2]))
    corner = traced[0].min(axis=0)
    return Outline(traced[0] - corner, tuple(hole - corner for hole in traced[1:]), tuple(notes))


def _holes_of(main: Floats, parts: list[Floats], holes: list[Floats]) -> list[Floats]:
    """The holes that lie in the main shape and not in a part that lies in another hole of it."""
    if not holes:
        return []
    points = np.array([hole[0] for hole in holes])
    width = np.array([np.ptp(hole[:, 0]) for hole in holes])
    own = contains(main, points)
    for part in parts:
        own &= ~(contains(part, points) & (np.ptp(part[:, 0]) > width))
    return [hole for hole, mine in zip(holes, own) if mine]


def _simple(boundaries: list[Floats], radius: float) -> list[Floats]:
    """The traced loops; where smoothing would make thin parts touch, with less of it."""
    for ripple, tolerance in ((1.0, 0.2), (0.5, 0.1)):
        traced = [trace(boundary, radius, ripple, tolerance) for boundary in boundaries]
        if first_crossing(traced) is None:
            return traced
    return [trace(boundary, radius, 0.0, 0.0) for boundary in boundaries]


def _shrink(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture with its longest side at most _LONGEST_SIDE px, by means over whole blocks of pixels."""
    step = -(-max(rgba.shape[:2]) // _LONGEST_SIDE)
    if step <= 1:
        return rgba
    height, width = rgba.shape[0] // step, rgba.shape[1] // step
    blocks = rgba[: height * step, : width * step].reshape(height, step, width, step, 4)
    total = blocks.sum(axis=(1, 3), dtype=np.uint32)
    return np.asarray((total + step * step // 2) // (step * step), dtype=np.uint8)


def _notes(main: Floats, area: float, parts: list[Floats], filled: int, shape: tuple[int, ...]) -> list[str]:
    """Remarks on what the outline leaves out of the picture."""
    notes = []
    (left, low), (right, high) = main.min(axis=0), main.max(axis=0)
    at_border = zip(
        ("left", "right", "upper", "lower"), (left, shape[1] - right, shape[0] - high, low), strict=True
    )
    sides = [side for side, away in at_border if away < 0.25]
    if sides:
        notes.append(
            f"The shape touches the {' and the '.join(sides)} border of the picture; "
            "if it was cut off there, leave more margin."
        )
    others = [part for part in parts if _area(part) >= _SPECK * area]
    if others:
        places = ", ".join(_place(other, shape) for other in others[:5]) + (
            ", ..." if len(others) > 5 else ""
        )
        count = f"{len(others)} other shape{'s are' if len(others) > 1 else ' is'}"
        notes.append(f"The largest shape is used; {count} left out ({places}).")
    specks = len(parts) - len(others)
    if specks:
        notes.append(f"{specks} small speck{'s were' if specks > 1 else ' was'} dropped.")
    if filled:
        notes.append(f"{filled} tiny hole{'s were' if filled > 1 else ' was'} filled.")
    return notes


def _area(loop: Floats) -> float:
    x, y = loop.T
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y)))


def _place(loop: Floats, shape: tuple[int, ...]) -> str:
    x, y = 0.5 * (loop.min(axis=0) + loop.max(axis=0))
    across = ("left", "", "right")[min(2, int(3 * x / shape[1]))]
    up = ("lower", "", "upper")[min(2, int(3 * y / shape[0]))]
    return f"{up} {across}".strip() or "middle"
