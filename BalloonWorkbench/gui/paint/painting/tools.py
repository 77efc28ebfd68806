# SPDX-License-Identifier: LGPL-2.1-or-later
"""What there is to paint with: tools, colours, thicknesses."""

from __future__ import annotations

from typing import NamedTuple

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.gui.paint.painting.strokes import BRUSH, ERASER, FILL, LINE, PEN

MOVE = "move"
TEXT, STAMP, SELECT, PIPETTE, AXIS = "text", "stamps", "select", "pipette", "axis"


class Tool(NamedTuple):
    """One tool: its icon is resources/icons/paint_<name>.svg.

    widening  of the chosen thickness
    pressure  part of the width that the pressure of a tablet's pen decides
    """

    name: str
    key: str
    text: str
    tooltip: str
    widening: float = 1.0
    pressure: float = 0.0


TOOLS = (
    Tool(
        PEN,
        "P",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Pen"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Draw lines. A closed line becomes a balloon."),
        1.0,
        0.5,
    ),
    Tool(
        BRUSH,
        "B",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Brush"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Paint broad, soft strokes: what is painted becomes a balloon."
        ),
        4.0,
        0.8,
    ),
    Tool(
        ERASER,
        "E",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Eraser"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Take paint off"),
        3.0,
        0.5,
    ),
    Tool(
        FILL,
        "F",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Fill"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Fill a closed line, or give an area another colour"),
    ),
    Tool(
        LINE,
        "L",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Line"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench",
            "Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.",
        ),
    ),
    Tool(
        MOVE,
        "H",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Move"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench",
            "Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.",
        ),
    ),
)

#: In the second row.
MORE_TOOLS = (
    Tool(
        TEXT,
        "T",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Text"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench",
            "Click and type; pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.",
        ),
    ),
    Tool(
        STAMP,
        "S",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Stamp"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench",
            "Pull a shape to its size, up or down to turn it; Shift keeps it upright.",
        ),
    ),
    Tool(
        SELECT,
        "R",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Select"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench",
            "Pull a rectangle to copy (Ctrl+C) or cut (Ctrl+X); without one that is all. Ctrl+V pastes.",
        ),
    ),
    Tool(
        PIPETTE,
        "C",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Pipette"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Take a colour from the painting, or the picture under it"),
    ),
    Tool(
        AXIS,
        "A",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Axis"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Pull the centre of the symmetry to its place, and turn its axis by the ring"
        ),
    ),
)

COLOURS = (
    ("#1c1c22", QT_TRANSLATE_NOOP("BalloonWorkbench", "Black")),
    ("#ffffff", QT_TRANSLATE_NOOP("BalloonWorkbench", "White")),
    ("#e01b3c", QT_TRANSLATE_NOOP("BalloonWorkbench", "Red")),
    ("#ff8c1a", QT_TRANSLATE_NOOP("BalloonWorkbench", "Orange")),
    ("#ffd21f", QT_TRANSLATE_NOOP("BalloonWorkbench", "Yellow")),
    ("#2fa84f", QT_TRANSLATE_NOOP("BalloonWorkbench", "Green")),
    ("#1f78d8", QT_TRANSLATE_NOOP("BalloonWorkbench", "Blue")),
    ("#8e44ad", QT_TRANSLATE_NOOP("BalloonWorkbench", "Violet")),
)

THINNEST, THICKEST, USUAL = 3, 60, 12  # px
