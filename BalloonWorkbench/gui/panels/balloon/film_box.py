# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the film and what happens to it."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import VOLUME
from BalloonWorkbench.app.properties import film as film_values
from BalloonWorkbench.app.properties import size_goal
from BalloonWorkbench.app.properties.film import CUSTOM
from BalloonWorkbench.gui.panels.balloon.card_box import CardBox
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import tell


class FilmBox(QtWidgets.QWidget):
    """Edits a balloon's film, pressure and size. `changed` follows each edit, `refused` carries a message."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, balloon):
        super().__init__()
        self.balloon = balloon
        self.fields = Fields(balloon, self)
        film_values.offer(balloon)
        film = self.fields.choice("Film")
        _describe(film)
        form = NarrowForm(self)
        form.addRow(translate("Film"), film)
        self.card = CardBox(balloon)
        self.card.changed.connect(self.changed)
        self.card.refused.connect(self.refused)
        form.addRow(QtWidgets.QLabel(translate("Material")))
        form.addRow(self.card)
        form.addRow(translate("Young's modulus"), self.fields.quantity("YoungModulus", "kPa", 1e5))
        form.addRow(translate("Poisson's ratio"), self.fields.number("PoissonRatio", 0.01, 3))
        form.addRow(translate("E across the grain"), self.fields.quantity("YoungModulusAcross", "kPa", 1e5))
        form.addRow(translate("Grain"), self.fields.quantity("GrainAngle", "deg", 5.0))
        self._form = form
        form.addRow(translate("Thickness"), self.fields.quantity("Thickness", "mm", 0.005))
        form.addRow(translate("Pressure"), self.fields.quantity("Pressure", "kPa", 0.1))
        form.addRow(translate("Mode"), self.fields.choice("Mode"))
        form.addRow(translate("Size from"), self.fields.choice("SizeGoal"))
        form.addRow(translate("Volume"), self.fields.quantity("GoalVolume", "l", 1e5))
        form.addRow(translate("Lift in g"), self.fields.number("GoalLift", 1.0, 1, 1e7))
        form.addRow(translate("Gas"), self.fields.choice("Gas"))
        self.fields.changed.connect(lambda name: self.changed.emit())

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.card.release()
        self.fields.release()

    def refresh(self) -> None:
        self.fields.refresh()
        self.card.refresh()
        own = self.balloon.Film == CUSTOM  # the library's films have no grain
        shown = dict.fromkeys(("YoungModulusAcross", "GrainAngle"), own)
        shown["GoalVolume"] = self.balloon.SizeGoal == size_goal.VOLUME
        shown["GoalLift"] = self.balloon.SizeGoal == size_goal.LIFT
        for name, visible in shown.items():
            field = self.fields.widget(name)
            field.setVisible(visible)
            self._form.labelForField(field).setVisible(visible)
        if self.balloon.Load == VOLUME:
            self.fields.widget("Pressure").setEnabled(False)


def _describe(combo) -> None:
    """Films by their titles; the names that commands and macros take as tooltips."""
    known = film_values.known_films()
    for index in range(combo.count()):
        name = combo.itemData(index)
        if name in known:
            combo.setItemText(index, tell(known[name].title))
            combo.setItemData(index, name, QtCore.Qt.ToolTipRole)
