# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choosing one of FreeCAD's materials as the film: in its material tree, or before 1.0 in a list."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.host import material_tree
from BalloonWorkbench.app.properties import material
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate


class CardBox(QtWidgets.QWidget):
    """Gives the numbers of a card to a balloon; `changed` follows, or `refused` with the reason."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, balloon):
        super().__init__()
        self._balloon = balloon
        self._tree = None
        self.choice = None
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._make_tree() or self._make_list())

    def _make_tree(self):
        """FreeCAD's own widget, with a button for its material editor; None where there is none."""
        kind = material_tree()
        if kind is None:
            return None
        widget = Gui.UiLoader().createWidget("MatGui::MaterialTreeWidget")
        widget.setObjectName("MaterialTree")
        self._tree = kind(widget)
        self._tree.setFilter(material.filters(translate("Films"), translate("Elastic materials")))
        QtCore.QObject.connect(widget, QtCore.SIGNAL("onMaterial(QString)"), self._take_uuid)
        for button in widget.findChildren(QtWidgets.QPushButton):
            if not button.text():  # an arrow
                button.setAccessibleName(translate("Choose a material card"))
        return widget

    def _make_list(self):
        self.choice = _CardList()
        self.choice.setObjectName("MaterialCard")
        self.choice.setToolTip(translate("Take the numbers of one of FreeCAD's material cards"))
        self.choice.activated.connect(lambda index: self._take(self.choice.itemData(index)))
        return self.choice

    def refresh(self) -> None:
        """Show the card that the present numbers are from."""
        if self.choice is not None and self._balloon is not None:
            self.choice.show_name(self._balloon.Material)

    def release(self) -> None:
        """The panel closes."""
        self._balloon = None

    def _take_uuid(self, uuid: str) -> None:
        self._take(material.card_with(uuid))

    def _take(self, card) -> None:
        if self._balloon is None or card is None:
            return
        try:
            material.take(self._balloon, card)
        except InputError as error:
            self.refused.emit(str(error))
            return
        self.changed.emit()


class _CardList(ElidedCombo):
    """Looks for cards when it is used: a panel opens without reading them."""

    def __init__(self):
        super().__init__()
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(12)

    def show_name(self, name: str) -> None:
        """Show a card's name, or that there is none."""
        text = name or translate("Choose a material card")
        index = self.findText(text)
        if index < 0:
            self.clear()
            self.addItem(text)
            index = 0
        self.setCurrentIndex(index)

    def focusInEvent(self, event):
        self._fill()
        super().focusInEvent(event)

    def showPopup(self):
        self._fill()
        super().showPopup()

    def _fill(self) -> None:
        if self.count() > 1:
            return
        current, library = self.itemText(0), ""
        self.clear()
        if not any(card.name == current for card in material.cards()):
            self.addItem(current)
        for card in material.cards():
            if card.library != library and self.count():
                self.insertSeparator(self.count())
            library = card.library
            self.addItem(card.name, card)
        self.setCurrentIndex(self.findText(current))
