# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown on the flat pieces: their film alone, their print, or a result as colours with its legend."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.artwork import of_balloon
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.engine import film_result, piece_pictures
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.gui.pattern_view.piece_scene import PieceScene
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate
from BalloonWorkbench.gui.view3d.film_map import FLAT_CHOICES, choice_title, film_colours
from BalloonWorkbench.gui.view3d.legend import drawn
from BalloonWorkbench.gui.window.sentences import translated

FILM, ARTWORK = "Film", "Artwork"


class PieceLooks(QtCore.QObject):
    """A list for the bar and a legend beside the pieces; `said` carries why something cannot be shown."""

    said = QtCore.Signal(str)

    def __init__(self, scene: PieceScene):
        super().__init__(scene)
        self._scene = scene
        self._obj = None
        self._shown: tuple = ()  # what the pictures belong to
        self.list = QtWidgets.QComboBox()
        self.list.setObjectName("PieceLook")
        self.list.setAccessibleName(translate("Shown on the pieces"))
        self.list.setToolTip(translate("Shown on the pieces"))
        self.list.currentIndexChanged.connect(lambda _index: self._show())
        self.legend = QtWidgets.QLabel()
        self.legend.setObjectName("PieceLegend")
        self.legend.setAlignment(QtCore.Qt.AlignTop)
        self.legend.hide()
        self._pieces: PatternPieces | None = None

    def follow(self, obj, pieces: PatternPieces) -> None:
        """Offer what there is for the pieces of an object, as the pattern lays them, and show it anew."""
        self._obj, self._pieces = obj, pieces
        chosen, offered = self.list.currentData(), self._offered()
        if [self.list.itemData(row) for row in range(self.list.count())] != offered:
            blocked = self.list.blockSignals(True)
            self.list.clear()
            for choice in offered:
                self.list.addItem(_title(choice), choice)
            self.list.setCurrentIndex(offered.index(chosen) if chosen in offered else 0)
            self.list.blockSignals(blocked)
        self.list.setEnabled(len(offered) > 1)
        self._show()

    @property
    def artwork(self):
        """The Artwork object that is shown on the pieces; None where they show something else."""
        shown = self.list.currentData() == ARTWORK and self._obj is not None
        return of_balloon(self._obj.Balloon) if shown else None

    def forget(self) -> None:
        """The print is another one now."""
        self._shown = ()

    def _offered(self) -> list[str]:
        if not is_pattern(self._obj) or self._obj.Balloon is None:
            return [FILM]
        balloon, offered = self._obj.Balloon, [FILM]
        artwork = of_balloon(balloon)
        if artwork is not None and artwork.Pattern == self._obj and status.is_ready(artwork):
            offered.append(ARTWORK)
        return [*offered, *(FLAT_CHOICES if film_result.is_known(balloon) else [])]

    def _show(self) -> None:
        if self._obj is None:
            return
        choice = self.list.currentData()
        balloon = getattr(self._obj, "Balloon", None)
        key = (choice, getattr(balloon, "SolvedFor", ""), self._pieces)
        if self._shown[:2] == key[:2] and self._shown[2] is self._pieces:
            return
        self._shown = key
        pictures, legend = {}, None
        try:
            if choice == ARTWORK:
                pictures = piece_pictures.of_print(of_balloon(balloon), self._pieces)
            elif choice != FILM:
                shown = film_colours(balloon, choice)
                pictures = piece_pictures.of_shares(self._obj, self._pieces, shown.map.shares)
                legend = shown.legend
        except BalloonError as error:
            self.said.emit(translated(str(error)))
        self._scene.show_pictures(
            {number: (_image(each.pixels), each.low, each.high) for number, each in pictures.items()}
        )
        self.legend.setVisible(legend is not None)
        if legend is not None:
            self.legend.setPixmap(QtGui.QPixmap.fromImage(drawn(legend)))
            self.legend.setAccessibleName(
                ", ".join(
                    (legend.title, *(text for _, text in (*legend.ticks, *legend.entries)), *legend.notes)
                )
            )


def _title(choice: str) -> str:
    if choice == FILM:
        return translate("Film")
    return translate("Artwork") if choice == ARTWORK else choice_title(choice)


def _image(pixels: np.ndarray):
    """Pixels (h, w, 4) as a QImage of its own."""
    height, width = pixels.shape[:2]
    lines = np.ascontiguousarray(pixels)
    image = QtGui.QImage(lines.data, width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
    return image.convertToFormat(QtGui.QImage.Format_ARGB32_Premultiplied)
