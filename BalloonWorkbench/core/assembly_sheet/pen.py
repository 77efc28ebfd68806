# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the page is written with: a language, fonts, and axes in millimetres from the lower left corner."""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.assembly_sheet.texts import broken
from BalloonWorkbench.core.pages.fonts import Fonts
from BalloonWorkbench.core.pages.pdf import write
from BalloonWorkbench.core.types import Say

INK, SOFT, RULE, BAND, ACCENT = "#1f2937", "#5b6b82", "#d3d9e3", "#f2f4f8", "#c81e4a"
_BODY, _HEADING = 8.0, 9.0  # points


class Pen:
    """Writes texts that are already in the language of the page; `say` brings them there."""

    def __init__(self, axes: Any, say: Say, fonts: Fonts) -> None:
        self.axes, self.say, self.fonts = axes, say, fonts

    def text(
        self, x: float, y: float, text: str, size: float = _BODY, room: float = 0.0, **look: Any
    ) -> None:
        """A line; smaller where it would be wider than the room."""
        write(self.axes, self.fonts, (x, y), text, size, room, **{"color": INK, **look})

    def heading(self, x: float, y: float, text: str, room: float = 0.0) -> None:
        """The name of a part of the page."""
        self.text(x, y, text, _HEADING, room, bold=True, color=ACCENT)

    def width(self, text: str, size: float = _BODY, bold: bool = False) -> float:
        """Width of a line [mm]."""
        return self.fonts.width(text, size, bold)

    def lines(self, text: str, room: float) -> list[str]:
        """Lines of the body's size that are not wider than the room."""
        return broken(text, lambda line: self.width(line) <= room)
