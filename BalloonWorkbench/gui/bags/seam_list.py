# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a bag as a list: the colour and number of each, its panels, and how long both sides are."""

from __future__ import annotations

from BalloonWorkbench.gui.bags.bag_edges import BagEdges
from BalloonWorkbench.gui.bags.seam_colours import WRONG, seam_colour
from BalloonWorkbench.gui.panels.widgets.narrow import FullList
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate
from BalloonWorkbench.gui.window.user_units import lengths_text

_HIGHEST = 1_000_000  # px: the panel scrolls, not what is in it
_SWATCH = 12  # px


class SeamList(FullList):
    """A row for each seam; `chosen` carries the number of the one in front, -1 for none."""

    chosen = QtCore.Signal(int)

    def __init__(self):
        super().__init__(_HIGHEST)
        self.setObjectName("Seams")
        self.setAccessibleName(translate("Seams"))
        self.currentRowChanged.connect(self.chosen)

    def show_bag(self, shown: BagEdges | None) -> None:
        """Show the seams of a bag; those that cannot be sealed as they are are marked."""
        row = self.currentRow()
        blocked = self.blockSignals(True)
        self.clear()
        for number in range(0 if shown is None else len(shown.lengths)):
            wrong = number in shown.wrong
            entry = QtWidgets.QListWidgetItem(_text(shown, number))
            entry.setIcon(swatch(WRONG if wrong else seam_colour(number)))
            if wrong:
                font = entry.font()
                font.setBold(True)  # the sentence says what is wrong; red text cannot be read in every theme
                entry.setFont(font)
                entry.setToolTip(translate("Both sides of a seam must be equally long"))
            self.addItem(entry)
        if self.count():
            self.setCurrentRow(row if row < self.count() else -1)
        self.blockSignals(blocked)
        self.setVisible(bool(self.count()))
        self.fit()

    def choose(self, seam: int | None) -> None:
        """Bring a seam to the front; says so once."""
        self.setCurrentRow(-1 if seam is None else seam)


def _text(shown: BagEdges, number: int) -> str:
    names = [shown.bag.panels[side.panel].name for side in shown.bag.seams[number].sides]
    one, other = shown.lengths[number]
    first, second, apart = lengths_text(one, other, abs(one - other))
    lengths = first if first == second else f"{first} | {second}"
    text = f"{number + 1}: {names[0]} \N{EN DASH} {names[1]}, {lengths}"
    return translate("{}: they differ by {}").format(text, apart) if number in shown.wrong else text


def swatch(rgb) -> QtGui.QIcon:
    """A small square of a colour."""
    pixmap = QtGui.QPixmap(_SWATCH, _SWATCH)
    pixmap.fill(QtGui.QColor.fromRgbF(*rgb))
    return QtGui.QIcon(pixmap)
