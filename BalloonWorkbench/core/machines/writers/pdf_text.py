# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of text in a PDF of reportlab: Helvetica's, or drawn where they have Japanese letters."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.language.fonts import drawn, is_wide

_POINT = 72.0 / 25.4  # points per mm
_NON_ZERO = 1  # reportlab's name for how overlapping outlines are filled


def write(
    canvas: Any, at: tuple[float, float], text: str, size: float, room: float, bold: bool = False
) -> None:
    """A line from a place [mm] at a size in points; smaller where it would be wider than the room [mm]."""
    x, y, most = at[0] * _POINT, at[1] * _POINT, room * _POINT
    if is_wide(text):
        _draw(canvas, (x, y), drawn(text, bold), size, most)
        return
    font = "Helvetica-Bold" if bold else "Helvetica"
    wide = canvas.stringWidth(text, font, size)
    canvas.setFont(font, size * min(1.0, most / wide))
    canvas.drawString(x, y, text)


def _draw(canvas: Any, at: tuple[float, float], path: Any, size: float, most: float) -> None:
    size = min(size, most / float(np.max(path.vertices[:, 0])))
    course, end = canvas.beginPath(), np.zeros(2)
    for points, code in path.iter_segments():
        corners = size * np.reshape(points, (-1, 2)) + at
        if code == path.MOVETO:
            course.moveTo(*corners[0].tolist())
        elif code == path.LINETO:
            course.lineTo(*corners[0].tolist())
        elif code == path.CURVE3:  # the same curve as a cubic one
            near = [(end + 2.0 * corners[0]) / 3.0, (corners[1] + 2.0 * corners[0]) / 3.0]
            course.curveTo(*np.concatenate([*near, corners[1]]).tolist())
        elif code == path.CURVE4:
            course.curveTo(*corners.ravel().tolist())
        else:
            course.close()
        end = corners[-1]
    canvas.setFillColor("#000000")
    canvas.drawPath(course, stroke=0, fill=1, fillMode=_NON_ZERO)
