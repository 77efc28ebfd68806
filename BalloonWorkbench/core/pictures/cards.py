# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cards of a preview picture: a sheet of 1800 x 1000 pixels, and what stands on it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from BalloonWorkbench.core.geometry.vectors import perpendicular
from BalloonWorkbench.core.pictures.canvas import PreviewCanvas
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

WIDTH, HEIGHT = 1800, 1000
PAPER, CARD, EDGE = "#eef0f4", "#ffffff", "#d5d9e1"
INK, SOFT = "#232a36", "#5f6877"
#: Length of an arrow's head, and half its width [pixels].
_HEAD = 5.6, 2.8


def cards_png(draw: Callable[[PreviewCanvas], None]) -> bytes:
    """The PNG of what is drawn on a sheet, the same bytes for the same. MissingPackageError."""
    canvas = PreviewCanvas(WIDTH, HEIGHT, PAPER)
    draw(canvas)
    return canvas.png()


class PreviewCard:
    """A card with a title; places are pixels from its lower left corner."""

    def __init__(self, canvas: PreviewCanvas, x: int, y: int, width: int, height: int, title: str) -> None:
        self._canvas, self._corner = canvas, np.array([x, y])
        self.width, self.height = width, height
        canvas.box((x + 1, y + 1), (x + width - 1, y + height - 1), CARD, EDGE)
        self.text(24, height - 36, title, 14, INK, bold=True)

    def area(self, loops: Sequence[Floats], colour: str, opacity: float = 1.0) -> None:
        """A filled shape: a loop (n, 2), and holes in it."""
        self._canvas.area([loop + self._corner for loop in loops], colour, opacity)

    def lines(self, lines: Sequence[Floats], colour: str, width: float, **style: Any) -> None:
        """Lines (n, 2), so many points wide; see `PreviewCanvas.lines`."""
        self._canvas.lines([line + self._corner for line in lines], colour, width, **style)

    def text(self, x: float, y: float, text: str, size: float, colour: str = SOFT, **style: Any) -> None:
        """A text of a size in points; see `PreviewCanvas.text`."""
        left, bottom = self._corner.tolist()
        self._canvas.text((left + x, bottom + y), text, size, colour, **style)

    def picture(self, pixels: Floats, left: int, bottom: int) -> None:
        """A picture (h, w, 3 or 4) of values from 0 to 1, with its lower left corner there."""
        x, y = self._corner.tolist()
        self._canvas.picture(pixels, x + left, y + bottom)

    def inside(self, left: float, bottom: float, right: float, top: float) -> tuple[float, ...]:
        """Left, lower, right and upper end of the card without its margins."""
        return left, bottom, self.width - right, self.height - top

    def caption(self, text: str, colour: str = SOFT) -> None:
        """A line at the foot, smaller where the card is too narrow for it."""
        wide = self._canvas.text_width(text, 11.0)
        self.text(24, 30, text, 11.0 * min(1.0, (self.width - 48.0) / max(wide, 1.0)), colour)


class CardFrame:
    """Millimetres to pixels: a box of the drawing fitted into a box of the card."""

    def __init__(self, low: Floats, high: Floats, box: tuple[float, ...]) -> None:
        left, bottom, right, top = box
        self.scale = float(min((right - left) / (high[0] - low[0]), (top - bottom) / (high[1] - low[1])))
        self.shift = np.array([0.5 * (left + right), 0.5 * (bottom + top)]) - 0.5 * self.scale * (low + high)

    def __call__(self, points: Floats) -> Floats:
        """Points (n, 2) mm in pixels of the card."""
        return points * self.scale + self.shift


def dimension(card: PreviewCard, start: tuple[float, float], end: tuple[float, float], text: str) -> None:
    """An arrow with two heads and its length, which runs upward beside an upright one."""
    ends = np.array([start, end])
    way = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    card.lines([ends], SOFT, 0.8)
    for tip, back in ((ends[0], way), (ends[1], -way)):
        across = perpendicular(back)
        foot = tip + _HEAD[0] * back
        card.area([np.stack([tip, foot + _HEAD[1] * across, foot - _HEAD[1] * across])], SOFT)
    x, y = ends.mean(axis=0)
    card.text(x, y, text, 11, INK, centre=0.5, upright=abs(way[1]) > 0.5, paper=CARD)


def scale_bar(card: PreviewCard, scale: float) -> None:
    """100 mm where that fits, else the nearest power of ten."""
    length = 100.0
    while length * scale > 240.0:
        length /= 10.0
    while length * scale < 24.0:
        length *= 10.0
    right, y = card.width - 30, 62
    left = right - length * scale
    bar = [(left, y - 6), (left, y + 6), (left, y), (right, y), (right, y + 6), (right, y - 6)]
    card.lines([np.array(bar)], INK, 1.4)
    card.text(0.5 * (left + right), y + 16, length_text(from_mm(length)), 10, INK, centre=0.5)
