# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the file in an Outline object."""

from __future__ import annotations

from BalloonWorkbench.app.quantities import metres


def read_drawing(path: str, width, height, keep_aspect: bool = True):
    """The outline in a file and its kind; width and height are length properties or mm, 0 when free.

    Raises BalloonError when there is no usable shape in the file.
    """
    from BalloonWorkbench.core.outline.read import read_outline

    wanted = metres(width) or None, metres(height) or None
    outline, kind = read_outline(path, *wanted, decode=_decoder())
    if None in wanted or keep_aspect:
        return outline, kind
    factors = [want / have for want, have in zip(wanted, outline.size, strict=True)]
    return outline.map(lambda loop: loop * factors), kind


def _decoder():
    """None for OpenCV, which the engine prefers; FreeCAD's own Qt where that is missing."""
    try:
        import cv2  # noqa: F401
    except ImportError:
        from BalloonWorkbench.app.qt_picture import decode

        return decode
    return None
