# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any drawing file as outlines."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.user_file import read_user_file
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.readers.vector import read_vector, vector_kind
from BalloonWorkbench.core.tracing.picture import Decode, picture_drawing
from BalloonWorkbench.core.tracing.picture_file import is_picture
from BalloonWorkbench.core.tracing.segment import AUTO

_PICTURE_SUFFIXES = {".png", ".jpg", ".jpeg", ".bmp", ".webp"}


def read_outline(
    path: str | Path, width: float | None = None, height: float | None = None, decode: Decode | None = None
) -> tuple[Outline, str]:
    """The largest shape of `read_drawing` alone, and what the file is."""
    drawing, kind = read_drawing(path, width, height, decode)
    return drawing.largest, kind


def read_drawing(
    path: str | Path,
    width: float | None = None,
    height: float | None = None,
    decode: Decode | None = None,
    drawn_as: str = AUTO,
    tracing: TracingOptions = USUAL_TRACING,
) -> tuple[Drawing, str]:
    """The shapes in a file, in metres, and what the file is: 'picture', 'svg', 'dxf' or 'json'.

    The kind is told by the content, and by the name only where that says nothing. A picture needs a width or
    a height [m] of all of it; the others have their own size, which these override. With both, the drawing
    fits inside.

    decode    reads pictures instead of OpenCV, see `picture_drawing`
    drawn_as, tracing  how a picture is read, see `segment`
    Errors: InputError and its kinds (no such file, not a drawing, no shape, size, too much of something, see
    `Budget`), MissingPackageError
    """
    path = Path(path)
    budget = Budget()
    head = read_user_file(path, 4096)
    if not head:
        raise InputError(f"'{path.name}' is empty. Choose another file.")
    kind = None if is_picture(head) else vector_kind(path, head)
    if kind:
        return read_vector(path, width, height, budget), kind
    if is_picture(head) or path.suffix.lower() in _PICTURE_SUFFIXES:
        return picture_drawing(path, width, height, decode, drawn_as, budget, tracing), "picture"
    raise InputError(
        f"'{path.name}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON."
    )
