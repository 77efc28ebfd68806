# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the file in an Outline object."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field, replace
from pathlib import Path

from BalloonWorkbench.app.properties.quantities import metres
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.tracing.segment import AS_PEN, AUTO

#: Name of the text in a PNG file that holds the strokes of a painting.
KEY = "FilmBalloonPainting"
_HEAD = 4096  # bytes in which its name appears, before the pixels


def read_drawing(
    path: str,
    width,
    height,
    keep_aspect: bool = True,
    symmetry: str = "auto",
    drawn_as: str = AUTO,
    tracing: TracingOptions = USUAL_TRACING,
):
    """The shapes in a file and its kind; width and height are length properties or mm, 0 when free.

    symmetry is a choice of core/outline/symmetry.py, drawn_as of segment.py. Raises BalloonError when there
    is no usable shape in the file.
    """
    size = metres(width) or None, metres(height) or None
    drawing, kind = shapes_in(file_of(path), size, symmetry, drawn_as, tracing)
    return (drawing if keep_aspect else stretched(drawing, size)), kind


def stretched(drawing, size: tuple):
    """A drawing that fills width and height [m] where both are known."""
    if None in size:
        return drawing
    factors = [want / have for want, have in zip(size, drawing.size, strict=True)]
    return drawing.map(lambda loop: loop * factors)


def trace(title: str, path: str, width, height, *reading) -> None:
    """Read a file beside the window: `read_drawing`, with or without the aspect, has it at once then.

    reading  symmetry, drawn_as and tracing
    """
    from BalloonWorkbench.app.border import hooks

    size = metres(width) or None, metres(height) or None
    hooks.ask(title, shapes_in, file_of(path), size, *reading)


def is_painting(path) -> bool:
    """Whether a file comes from the paint window: its strokes can be edited again."""
    try:
        with open(path, "rb") as file:
            return KEY.encode() in file.read(_HEAD)
    except OSError:
        return False


@dataclass(frozen=True)
class File:
    """A file, known by what is in it and how its name ends."""

    path: Path = field(compare=False)
    content: bytes
    suffix: str


def file_of(path) -> File:
    """A file as it is now; one that cannot be read is left to the reader, who says what is wrong."""
    path = Path(path)
    try:
        content = hashlib.sha256(path.read_bytes()).digest()
    except OSError:
        content = b""
    return File(path, content, path.suffix)


@memoized(most=8)  # tracing takes a good part of a second
def shapes_in(file: File, size: tuple, symmetry: str, drawn_as: str, tracing: TracingOptions = USUAL_TRACING):
    """The shapes in a file at their size [m], None where it is free, and its kind."""
    from BalloonWorkbench.core.outline.symmetry import evened
    from BalloonWorkbench.core.outline.validity import scale_to
    from BalloonWorkbench.core.readers import read

    painted = is_painting(file.path)
    decode = (lambda _path: drawn_pixels_of(file)) if painted else decoder()
    drawing, kind = read.read_drawing(file.path, *size, decode=decode, drawn_as=drawn_as, tracing=tracing)
    drawing = scale_to(evened(drawing, symmetry, drawn=kind == "picture"), *size)
    if painted:
        first, *others = drawing.parts
        first = replace(first, notes=tuple(note for note in first.notes if note != AS_PEN))
        drawing = replace(drawing, parts=(first, *others))
    return drawing, kind


@memoized(most=4)
def pixels_of(file: File):
    """Pixels (h, w, 4) of a picture file as red, green, blue, alpha, upright. Raises BalloonError."""
    from BalloonWorkbench.core.tracing.picture_file import decode, picture_size

    picture_size(file.path)
    return (decoder() or decode)(file.path)


@memoized(most=4)
def drawn_pixels_of(file: File):
    """The pixels of a picture file as `pixels_of` that its outline comes from: of a painting without its
    decoration. Raises BalloonError.
    """
    from BalloonWorkbench.core.tracing.picture_file import decode_shape, shape_in

    if decoder() is None:
        return decode_shape(file.path)
    from BalloonWorkbench.app.drawings.qt_picture import unpacked

    shape = shape_in(file.path)
    return pixels_of(file) if shape is None else unpacked(shape, file.path.name)


def decoder():
    """What reads pictures: None for OpenCV, which the engine prefers; FreeCAD's Qt where it does not work."""
    from BalloonWorkbench.core.tracing.raster import opencv

    if opencv() is not None:
        return None
    from BalloonWorkbench.app.drawings.qt_picture import decode

    return decode
