# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that are being typed: a click says where, and they stay to be pulled until they are painted."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.canvas.floating import FloatingPicture
from BalloonWorkbench.gui.paint.canvas.inputs import ToolInput
from BalloonWorkbench.gui.paint.canvas.stroke_input import StrokeInput
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.words import picture_of
from BalloonWorkbench.gui.qt import QtCore

_HEIGHT = 200.0  # px of the paper
_WIDEST = 0.9 * SIDE  # px, that typed words become by themselves


class WordsInput(ToolInput):
    """Lays words on the paper.

    words, family, joined  what is written, in which font, and whether on a ground that joins the letters
    `asked` comes when the words have their place: they can be typed.
    """

    asked = QtCore.Signal()

    def __init__(self, floating: FloatingPicture, hand: StrokeInput, parent=None):
        super().__init__(hand, parent)
        self._floating = floating
        self.words, self.family, self.joined = "", "", False
        self._height = _HEIGHT
        self._is_placed = False
        floating.changed.connect(self._look)

    def begin(self, at, zoom: float, shift: bool) -> None:
        self.words = ""
        self._floating.lay(self._picture(self._height), at, self._sized)
        self._is_placed = True
        self.asked.emit()

    def show(self) -> None:
        """The words, their font or colour are others."""
        if self._is_placed:
            self._floating.show(self._picture(self._height, _WIDEST))

    def cancel(self) -> None:
        self._is_placed = False
        super().cancel()

    def _look(self) -> None:
        self._is_placed &= self._floating.is_there()

    def _sized(self, height: float):
        self._height = height
        return self._picture(height)

    def _picture(self, height: float, widest: float = 2.0 * SIDE):
        return picture_of(self.words or " ", self.family, height, self.hand.colour, self.joined, widest)
