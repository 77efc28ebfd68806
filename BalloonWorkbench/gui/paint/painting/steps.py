# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of steps that a painting consists of, by the name that their file has."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.painting.strokes import (
    BRUSH,
    ERASER,
    FILL,
    LINE,
    PEN,
    Clear,
    Fill,
    Picture,
    Stroke,
)
from BalloonWorkbench.gui.paint.painting.widen import WIDEN, Widen

KINDS = {
    PEN: Stroke,
    BRUSH: Stroke,
    ERASER: Stroke,
    LINE: Stroke,
    FILL: Fill,
    WIDEN: Widen,
    "picture": Picture,
    "clear": Clear,
}
