# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the file in an Outline object."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path

from BalloonWorkbench.app.properties.quantities import metres
from BalloonWorkbench.core.recent import Recent
from BalloonWorkbench.core.tracing.segment import AS_PEN, AUTO

_LONGEST_SIDE = 1600  # px; as fine as the engine looks
#: Name of the text in a PNG file that holds the strokes of a painting.
KEY = "FilmBalloonPainting"
_HEAD = 4096  # bytes in which its name appears, before the pixels
_read = Recent(8)  # shapes of pictures by their content: tracing takes a good part of a second
_places = Recent(8)  # where the shapes are in those


def read_drawing(
    path: str, width, height, keep_aspect: bool = True, symmetry: str = "auto", drawn_as: str = AUTO
):
    """The shapes in a file and its kind; width and height are length properties or mm, 0 when free.

    symmetry is a choice of core/outline/symmetry.py, drawn_as of segment.py. Raises BalloonError when there
    is no usable shape in the file.
    """
    wanted = metres(width) or None, metres(height) or None
    drawing, kind = shapes_in(path, wanted, symmetry, drawn_as)
    if None in wanted or keep_aspect:
        return drawing, kind
    factors = [want / have for want, have in zip(wanted, drawing.size, strict=True)]
    return drawing.map(lambda loop: loop * factors), kind


def is_painting(path) -> bool:
    """Whether a file comes from the paint window: its strokes can be edited again."""
    try:
        with open(path, "rb") as file:
            return KEY.encode() in file.read(_HEAD)
    except OSError:
        return False


def is_known(path: str, wanted, symmetry: str, drawn_as: str) -> bool:
    """The picture was read lately, or the file is none: reading it takes no time."""
    suffix = Path(path).suffix.lower()
    return suffix in (".svg", ".dxf", ".json") or _key(Path(path), wanted, symmetry, drawn_as) in _read


def _key(path: Path, *choices):
    """What a picture is remembered by; None for a file that cannot be read: the reader says what is wrong."""
    try:
        return hashlib.sha256(path.read_bytes()).digest(), *choices
    except OSError:
        return None


def shapes_in(path: str, wanted, symmetry: str, drawn_as: str):
    """The shapes in a file at their size [m] and its kind; a picture read lately is not traced again."""
    from BalloonWorkbench.core.outline.symmetry import evened
    from BalloonWorkbench.core.outline.validity import scale_to
    from BalloonWorkbench.core.readers import read

    key = _key(Path(path), wanted, symmetry, drawn_as)
    if key in _read:
        return _read[key]
    drawing, kind = read.read_drawing(Path(path), *wanted, decode=_decoder(), drawn_as=drawn_as)
    drawing = scale_to(evened(drawing, symmetry, drawn=kind == "picture"), *wanted)
    if is_painting(path):
        first, *others = drawing.parts
        first = replace(first, notes=tuple(note for note in first.notes if note != AS_PEN))
        drawing = replace(drawing, parts=(first, *others))
    if kind == "picture":
        _read[key] = drawing, kind
    return drawing, kind


def _decoder():
    """None for OpenCV, which the engine prefers; FreeCAD's own Qt where that does not work."""
    from BalloonWorkbench.core.tracing.raster import opencv

    if opencv() is not None:
        return None
    from BalloonWorkbench.app.drawings.qt_picture import decode

    return decode


def place_in_picture(path: str, drawn_as: str = AUTO) -> tuple[float, float, float, float] | None:
    """Where the shape lies in a picture: left, bottom, right and top in parts of its width and height.

    For showing the outline over the picture; None where there is no picture or no shape.
    """
    from BalloonWorkbench.app.border import hooks

    key = _key(Path(path), drawn_as)
    if key not in _places:
        _places[key] = hooks.work("Looking at the picture", lambda progress: _found_in(path, drawn_as))
    return _places[key]


def _found_in(path: str, drawn_as: str) -> tuple[float, float, float, float] | None:
    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.tracing.contour import contours
    from BalloonWorkbench.core.tracing.picture_file import decode, picture_size
    from BalloonWorkbench.core.tracing.segment import segment

    try:
        step = -(-max(picture_size(Path(path))) // _LONGEST_SIDE)
        silhouette, _ = segment((_decoder() or decode)(Path(path))[::step, ::step], drawn_as)
    except BalloonError:
        return None
    loop, _ = max(contours(silhouette), key=lambda item: item[1])
    height, width = silhouette.shape
    (left, low), (right, high) = loop.min(axis=0), loop.max(axis=0)
    return left / width, low / height, right / width, high / height
