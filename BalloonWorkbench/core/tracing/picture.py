# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture as outlines: unpacked, told from its background, traced, brought to size."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError, PictureError
from BalloonWorkbench.core.files.foreign_reader import foreign_reader
from BalloonWorkbench.core.geometry.crossings import contains, first_crossing
from BalloonWorkbench.core.geometry.polyline import bounds, extent, perimeter
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.options.option import options_of
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import SPECK, Drawing, checked, speck_note
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import scale_to
from BalloonWorkbench.core.tracing.contour import contours
from BalloonWorkbench.core.tracing.picture_file import decode_shape, picture_size
from BalloonWorkbench.core.tracing.segment import AUTO, segment
from BalloonWorkbench.core.tracing.trace import STEP, trace
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import number_text

Decode = Callable[[Path], NDArray[np.uint8]]

_LONGEST_SIDE = 1600  # px; more detail than this is below a fifth of a millimetre on a 300 mm balloon
_SMALLEST_SIDE = 16  # px
_MOST_BOUNDARY = 40  # times the longest side; a hundred fingers side by side have half of it
_OWNER = 0.005  # of the area of the largest shape; what is smaller has no holes of its own
_GRAIN = 1e-4  # of the area of the largest shape; below this it is noise, which is not worth a remark
_THIN = 0.01  # mean width of another shape, of the larger dimension, below which it is a line


def read_picture(
    path: str | Path, width: float | None, height: float | None, decode: Decode | None = None
) -> Outline:
    """The largest shape of `picture_drawing` alone."""
    return picture_drawing(path, width, height, decode).largest


def picture_drawing(
    path: str | Path,
    width: float | None,
    height: float | None,
    decode: Decode | None = None,
    drawn_as: str = AUTO,
    budget: Budget | None = None,
    tracing: TracingOptions = USUAL_TRACING,
) -> Drawing:
    """The shapes in a picture file, `width` or `height` m large (inside both where both are given).

    The lower left corner of their bounding box is the origin. Remarks on what was left out or closed are in
    the notes.

    decode    pixels (h, w, 4) uint8 as red, green, blue, alpha of a file; OpenCV's without it
    drawn_as  AUTO, SHAPE or PEN of segment.py
    Errors: InputError (file, size), PictureError (no shape), MissingPackageError (neither OpenCV nor decode)
    """
    path = Path(path)
    if width is None and height is None:
        raise InputError("A picture has no size of its own. Give the width or the height of the balloon.")
    budget = budget or Budget()
    picture_size(path)
    with foreign_reader(lambda _: damaged(path.name)):
        pixels = (decode or decode_shape)(path)
    drawing, _ = placed_drawing(shrunk(pixels), STEP, drawn_as, budget, tracing)
    return checked(scale_to(drawing, width, height), budget)


def damaged(name: str) -> PictureError:
    """What is said of a picture file of this name that cannot be unpacked."""
    return PictureError(f"'{name}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.")


def drawing_of(rgba: NDArray[np.uint8], drawn_as: str = AUTO) -> Drawing:
    """The shapes in pixels (h, w, 4) with the pixel as unit and their lower left corner as origin."""
    return placed_drawing(rgba, drawn_as=drawn_as)[0]


@memoized(most=4)
def placed_drawing(
    rgba: NDArray[np.uint8],
    step: float = STEP,
    drawn_as: str = AUTO,
    budget: Budget | None = None,
    tracing: TracingOptions = USUAL_TRACING,
) -> tuple[Drawing, Floats]:
    """The drawing of `drawing_of`, and where its origin lies in the picture (2,) px, y up.

    step  of the walk along the boundary, of the picture's longer side; 0 leaves it out, for a quick look
    """
    if min(rgba.shape[:2]) < _SMALLEST_SIDE:
        raise PictureError(
            f"The picture is too small to see a shape. Use {_SMALLEST_SIDE} pixels or more across."
        )
    _check_tracing(tracing)
    budget = budget or Budget()
    silhouette, notes = segment(rgba, drawn_as, tracing)
    budget.check_time()
    loops = contours(silhouette)
    if not loops:
        raise PictureError(
            "No shape stands out in the picture. Use stronger colours or a plainer background."
        )
    loops.sort(key=lambda item: -abs(item[1]))
    main, area = next((loop, area) for loop, area in loops if area > 0)
    if len(main) > _MOST_BOUNDARY * max(rgba.shape[:2]):
        raise PictureError("The shape in the picture is too frayed to trace. Use a clearer picture.")
    seen = [(loop, own) for loop, own in loops if abs(own) >= _GRAIN * area]
    shapes = [(loop, own) for loop, own in seen if own > 0]
    owners = [shape for shape in shapes if shape[1] >= _OWNER * area]
    parts = [shape for shape in shapes if shape[1] >= SPECK * area]
    large = max(extent(loop) for loop, _ in parts)
    lines = [loop for loop, own in parts if loop is not main and _mean_width(loop, own) < _THIN * large]
    parts = [(loop, own) for loop, own in parts if not any(loop is line for line in lines)]
    holes = []
    for loop, own in parts:
        budget.check_time()
        holes.append(_holes_of(loop, own, owners, seen))
    wide = [
        [hole for hole, size in mine if size >= tracing.smallest_hole * own]
        for (_, own), mine in zip(parts, holes)
    ]
    filled = sum(map(len, holes)) - sum(map(len, wide))
    notes += _notes(
        [loop for loop, _ in parts], lines, len(shapes) - len(parts) - len(lines), filled, rgba.shape
    )
    shapes_and_holes = [[loop, *mine] for (loop, _), mine in zip(parts, wide)]
    traced = _simple(shapes_and_holes, step * max(rgba.shape[:2]), tracing.smoothness, budget)
    corner = np.concatenate([loops[0] for loops in traced]).min(axis=0)
    outlines = [Outline(outer - corner, tuple(hole - corner for hole in inner)) for outer, *inner in traced]
    canvas = np.array([[0.0, 0.0], [rgba.shape[1], rgba.shape[0]]]) - corner
    return Drawing((replace(outlines[0], notes=tuple(notes)), *outlines[1:]), canvas), corner


def _check_tracing(tracing: TracingOptions) -> None:
    """InputError for what a picture cannot be traced with."""
    for option in options_of(TracingOptions):
        value = getattr(tracing, option.name)
        if not option.least <= value <= option.most:
            most = number_text(option.most)
            raise InputError(f"The {option.name.replace('_', ' ')} must be between 0 and {most}.")


def _holes_of(
    shape: Floats, area: float, owners: list[tuple[Floats, float]], seen: list[tuple[Floats, float]]
) -> list[tuple[Floats, float]]:
    """The holes that lie in a shape and not in a smaller one that lies in another hole of it, with areas."""
    holes = [(loop, -own) for loop, own in seen if own < 0 and -own < area]
    if not holes:
        return []
    points, sizes = np.array([loop[0] for loop, _ in holes]), np.array([own for _, own in holes])
    mine = contains(shape, points)
    for other, its in owners:
        if its < area and mine.any():
            mine &= ~(contains(other, points) & (its > sizes))
    return [hole for hole, own in zip(holes, mine) if own]


def _mean_width(loop: Floats, area: float) -> float:
    """Of a strip with this boundary and area."""
    return 2.0 * area / perimeter(loop)


def _simple(shapes: list[list[Floats]], radius: float, smooth: float, budget: Budget) -> list[list[Floats]]:
    """The traced loops; where smoothing would make thin parts touch, with less of it."""
    rough = 1.0 if radius > 0 else 2.5  # a quick look gets by with fewer points
    for ripple, tolerance in ((1.0, 0.2 * rough), (0.5, 0.1 * rough)):
        budget.check_time()
        traced = [[trace(loop, radius, smooth * ripple, tolerance) for loop in loops] for loops in shapes]
        if first_crossing([loop for loops in traced for loop in loops]) is None:
            return traced
    return [[trace(loop, radius, 0.0, 0.0) for loop in loops] for loops in shapes]


def shrunk(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture with its longest side at most _LONGEST_SIDE px, by means over whole blocks of pixels."""
    step = -(-max(rgba.shape[:2]) // _LONGEST_SIDE)
    if step <= 1:
        return rgba
    height, width = rgba.shape[0] // step, rgba.shape[1] // step
    blocks = rgba[: height * step, : width * step].reshape(height, step, width, step, 4)
    total = blocks.sum(axis=(1, 3), dtype=np.uint32)
    return np.asarray((total + step * step // 2) // (step * step), dtype=np.uint8)


def _notes(
    parts: list[Floats], lines: list[Floats], specks: int, filled: int, shape: tuple[int, ...]
) -> list[str]:
    """Remarks on what the outlines leave out of the picture."""
    notes = []
    points = np.concatenate(parts)
    (left, low), (right, high) = bounds(points)
    at_border = zip(
        ("left", "right", "upper", "lower"), (left, shape[1] - right, shape[0] - high, low), strict=True
    )
    sides = [side for side, away in at_border if away < 0.25]
    if sides:
        notes.append(
            f"The shape touches the {' and the '.join(sides)} border of the picture; "
            "if it was cut off there, leave more margin."
        )
    if lines:
        places = ", ".join(_place(line, shape) for line in lines[:5]) + (", ..." if len(lines) > 5 else "")
        count = f"{len(lines)} thin line{'s are' if len(lines) > 1 else ' is'}"
        notes.append(f"{count} left out ({places}).")
    notes += speck_note(specks)
    if filled:
        notes.append(f"{filled} tiny hole{'s were' if filled > 1 else ' was'} filled.")
    return notes


def _place(loop: Floats, shape: tuple[int, ...]) -> str:
    x, y = 0.5 * (loop.min(axis=0) + loop.max(axis=0))
    across = ("left", "", "right")[min(2, int(3 * x / shape[1]))]
    up = ("lower", "", "upper")[min(2, int(3 * y / shape[0]))]
    return f"{up} {across}".strip() or "middle"
