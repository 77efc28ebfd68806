# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the film and what happens to it."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import PROPERTIES
from BalloonWorkbench.app.properties import film as film_values
from BalloonWorkbench.app.properties.film import CUSTOM
from BalloonWorkbench.app.properties.property_table import properties_of
from BalloonWorkbench.core.options.body import BandOptions
from BalloonWorkbench.gui.panels.balloon.card_box import CardBox
from BalloonWorkbench.gui.panels.bodies.band_choice import BandChoice
from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated


class FilmBox(PropertyPage):
    """Edits whether a balloon has a side band, its film, pressure and size."""

    def __init__(self, balloon):
        super().__init__(balloon)
        film_values.offer(balloon)
        self.card = CardBox(balloon)
        self.card.changed.connect(self.changed)
        self.card.refused.connect(self.refused)
        self.welding = WrappedLabel()
        self.welding.setObjectName("FirstWeld")
        self.band = BandChoice(self.form, balloon)
        self.band.changed.connect(self.changed)
        banded = {item.name for item in properties_of(BandOptions)}
        for item in PROPERTIES:
            if item.label and item.page != "Solver" and item.name not in banded:
                self.form.add(item, describe=_describe if item.name == "Film" else None)
            if item.name == "Film":
                self.form.addRow(QtWidgets.QLabel(translate("Material")))
                self.form.addRow(self.card)
                self.form.addRow(self.welding)

    def release(self) -> None:
        self.card.release()
        self.band.release()
        super().release()

    def refresh(self) -> None:
        super().refresh()
        self.card.refresh()
        self.band.refresh()
        known = film_values.known_films().get(self.obj.Film)
        self.welding.setText("" if known is None else known.first_weld(translated))
        if self.obj.Film != CUSTOM:  # the library's films have no grain, and welds of their own
            for name in ("YoungModulusAcross", "GrainAngle", "WeldRigidity"):
                self.form.show_row(name, False)


def _describe(combo) -> None:
    """Films by their titles; the names that commands and macros take as tooltips."""
    known = film_values.known_films()
    for index in range(combo.count()):
        name = combo.itemData(index)
        if name in known:
            combo.setItemText(index, translated(known[name].title))
            combo.setItemData(index, name, QtCore.Qt.ToolTipRole)
