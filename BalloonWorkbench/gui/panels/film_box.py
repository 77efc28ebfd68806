# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the film and what happens to it."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.fields import Fields
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate


class FilmBox(QtWidgets.QWidget):
    """Edits a balloon's film, pressure and solver. `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, balloon):
        super().__init__()
        self.setWindowTitle(translate("Film"))
        self.fields = Fields(balloon, self)
        film = self.fields.choice("Film")
        _describe(film)
        form = QtWidgets.QFormLayout(self)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        form.addRow(translate("Film"), film)
        form.addRow(translate("Young's modulus"), self.fields.quantity("YoungModulus", "kPa", 1e5))
        form.addRow(translate("Poisson's ratio"), self.fields.number("PoissonRatio", 0.01, 3))
        form.addRow(translate("Thickness"), self.fields.quantity("Thickness", "mm", 0.005))
        form.addRow(translate("Pressure"), self.fields.quantity("Pressure", "kPa", 0.1))
        form.addRow(translate("Mode"), self.fields.choice("Mode"))
        form.addRow(translate("Mesh size"), self.fields.quantity("MeshSize", "mm", 1.0))
        form.addRow(translate("Solver"), self.fields.choice("Backend"))
        self.fields.changed.connect(lambda name: self.changed.emit())

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.fields.release()

    def refresh(self) -> None:
        self.fields.refresh()


def _describe(combo) -> None:
    """The full names of the materials as tooltips."""
    from BalloonWorkbench.core.film.library import films

    known = films()
    for index in range(combo.count()):
        if combo.itemText(index) in known:
            combo.setItemData(index, known[combo.itemText(index)].title, QtCore.Qt.ToolTipRole)
