# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture to silhouette: the drawn part, pen drawings filled from outside in."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError, PictureError
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.tracing.background import coverage
from BalloonWorkbench.core.tracing.pen_drawing import Strokes, close_gaps, draw_line, join_near, strokes
from BalloonWorkbench.core.tracing.raster import Pixels, label, neighbours
from BalloonWorkbench.core.types import Bools, Floats
from BalloonWorkbench.core.units import percent_text

#: How a picture is drawn: told by its lines; as a filled shape, whose holes are holes; by pen, with lines
#: that are filled inside.
AUTO, SHAPE, PEN = "auto", "shape", "pen"
DRAWN_AS = (AUTO, SHAPE, PEN)
#: Part of what is said where holes were filled.
KEEP_HOLES = "choose Drawn as filled shape"
#: Said of a picture; who paints a closed line means its inside.
AS_PEN = "The picture was read as a pen drawing: the inside of its lines is filled."
# Of the drawn area; what is smaller and filled is not worth a remark.
_TOLD_FROM = 5e-4
# Of the rim of a hole, this part must be thin lines for the hole to be the inside of a drawn line.
_DRAWN_ROUND = 0.5


def segment(
    rgba: NDArray[np.uint8], drawn_as: str = AUTO, tracing: TracingOptions = USUAL_TRACING
) -> tuple[Pixels, list[str]]:
    """Coverage (h, w), 0 to 1, of the silhouette in a picture (h, w, 4), and remarks for the user.

    Holes that are left are meant: the inside of lines is filled, but not in a picture drawn as a SHAPE.
    PictureError where no shape is found.
    """
    if drawn_as not in DRAWN_AS:
        raise InputError(f'A picture cannot be drawn as "{drawn_as}": choose {", ".join(DRAWN_AS)}.')
    silhouette = coverage(rgba, tracing.threshold)
    drawn = silhouette > 0.5
    if not drawn.any():
        raise PictureError(
            "No shape stands out in the picture. Use stronger colours or a plainer background."
        )
    if drawn_as == SHAPE:
        return silhouette, []
    lines = strokes(drawn, tracing.line_width)
    if lines.pen or drawn_as == PEN:
        return _pen_drawing(silhouette, replace(lines, pen=True))
    filled = _inside_of_lines(drawn, lines)
    notes = _filled_note(filled, drawn) if filled.any() else []
    return _with_filled(silhouette, filled), notes


def _pen_drawing(silhouette: Pixels, lines: Strokes) -> tuple[Pixels, list[str]]:
    """The silhouette of a pen drawing, whose lines are closed and filled, and remarks for the user."""
    silhouette, notes = _close(_without_dots(silhouette, lines), lines)
    filled = _inside_of_lines(silhouette > 0.5, lines)
    silhouette = _with_filled(silhouette, filled)
    silhouette, joined = _draw(silhouette, join_near(silhouette > 0.5, lines), lines)
    if joined:
        notes.append("Loose ends of lines were joined to the drawing.")
    if not filled.any():
        note = "The lines of the drawing do not close around anything: the outline follows the lines."
        return silhouette, [*notes, note]
    silhouette, loose = _without_loose(silhouette, filled, lines)
    if loose:
        notes.append("Lines that close around nothing beside the shapes were left out.")
    return silhouette, [*notes, AS_PEN]


def _with_filled(silhouette: Pixels, filled: Bools) -> Pixels:
    """The silhouette with regions filled, up to the soft edges of what is drawn round them."""
    inside = neighbours(filled) & ((silhouette > 0.5) | filled)
    return np.where(inside, 1, silhouette).astype(np.float32)


def _filled_note(filled: Bools, drawn: Bools) -> list[str]:
    """The remark that holes with thin lines round them were filled, and how they are had back."""
    labels, count = label(filled)
    sizes = np.bincount(labels.ravel(), minlength=count + 1)[1:]
    large = int((sizes >= _TOLD_FROM * drawn.sum()).sum())
    if not large:
        return []
    return [
        f"{large} holes with a thin line round them were filled, as a pen's: choose Drawn as filled shape"
        " to keep them."
        if large > 1
        else f"{large} hole with a thin line round it was filled, as a pen's: choose Drawn as filled shape"
        " to keep it."
    ]


def _without_dots(silhouette: Pixels, lines: Strokes) -> Pixels:
    """The silhouette without spots much smaller than its lines are wide: they would pass for line ends."""
    labels, count = label(silhouette > 0.5)
    dots = np.bincount(labels.ravel(), minlength=count + 1) < 0.5 * lines.width**2
    dots[0] = False
    return np.where(neighbours(dots[labels]), 0, silhouette).astype(np.float32)


def _without_loose(silhouette: Pixels, filled: Bools, lines: Strokes) -> tuple[Pixels, bool]:
    """The silhouette without what has no filled inside, and whether that was more than dots."""
    labels, count = label(silhouette > 0.5)
    solid = np.zeros(count + 1, dtype=np.bool_)
    solid[labels[filled]] = True
    solid[0] = True
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    loose = ~solid & (sizes > 4.0 * lines.width**2)
    gone = neighbours(~solid[labels]) & ~(solid[labels] & (labels > 0))  # with its soft edge
    return np.where(gone, 0, silhouette).astype(np.float32), bool(loose.any())


def _close(silhouette: Pixels, lines: Strokes) -> tuple[Pixels, list[str]]:
    """The silhouette with the gaps in its lines closed, and what to say about it."""
    bridges = close_gaps(silhouette > 0.5, lines)
    closed, count = _draw(silhouette, bridges, lines)
    if not count:
        return closed, []
    width = np.ptp(np.flatnonzero((closed > 0.5).any(axis=0))) + 1
    widest = max(float(np.linalg.norm(other - one)) for one, other in bridges) / float(width)
    return closed, [
        f"{count} gap{'s' * (count > 1)} between the lines closed, "
        f"the widest {percent_text(widest)} of the drawing's width."
    ]


def _draw(silhouette: Pixels, bridges: list[tuple[Floats, Floats]], lines: Strokes) -> tuple[Pixels, int]:
    silhouette = silhouette.copy()
    for one, other in bridges:
        draw_line(silhouette, one, other, lines.width)
    return silhouette, len(bridges)


def _inside_of_lines(drawn: Bools, lines: Strokes) -> Bools:
    """Enclosed regions that are to be filled: all in a pen drawing, else those with thin lines around."""
    labels, count = label(np.pad(~drawn, 1, constant_values=True))
    inside = np.ones(count + 1, dtype=np.bool_)
    inside[[0, labels[0, 0]]] = False
    if not lines.pen:
        thin = np.pad(lines.thin, 1)
        around = np.zeros((2, count + 1))
        for axis in (0, 1):
            for step in (-1, 1):
                beside = np.roll(labels, step, axis=axis)
                rim = (labels == 0) & (beside > 0)
                around[0] += np.bincount(beside[rim], minlength=count + 1)
                around[1] += np.bincount(beside[rim & thin], minlength=count + 1)
        inside &= around[1] > _DRAWN_ROUND * around[0]
    return np.asarray(inside[labels][1:-1, 1:-1])
