# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that keeps the best field of a test card: the card, the field, and what the machine is called."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.test_cards.keep import fields_of
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm, WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window import file_dialogs
from BalloonWorkbench.gui.window.sentences import translated


class FieldPage(QtWidgets.QWidget):
    """Which field of which card; `refused` carries the sentence on a file that is none."""

    refused = QtCore.Signal(str)

    def __init__(self):
        super().__init__()
        self.card = ""
        self.file = FileRow(
            "Card",
            translate("test-card.json"),
            translate("The file test-card.json that was written with the card"),
            file_dialogs.ask_for_card,
        )
        self.field = QtWidgets.QComboBox()
        self.field.setObjectName("CardField")
        self.tries = WrappedLabel()
        self.tries.setObjectName("CardTries")
        self.name = QtWidgets.QLineEdit()
        self.name.setObjectName("CardName")
        self.name.setMinimumWidth(60)
        self.name.setPlaceholderText(translate("Such as Tip for PE"))
        form = NarrowForm(self)
        for text, widget in (
            (translate("Card"), self.file),
            (translate("Best field"), self.field),
        ):
            form.addRow(QtWidgets.QLabel(text))
            form.addRow(widget)
        form.addRow(self.tries)
        form.addRow(QtWidgets.QLabel(translate("Name of the machine")))
        form.addRow(self.name)
        self._tried: dict[str, str] = {}
        self.file.chosen.connect(self._take)
        self.field.currentTextChanged.connect(lambda text: self.tries.setText(self._tried.get(text, "")))
        recent = preferences.recent_card()
        if recent:
            self._take(recent)

    def _take(self, path: str) -> None:
        """Offer the fields of a card."""
        self.card = path
        self.file.show_name(str(Path(path).parent.name or path))
        self.file.path.setToolTip(path)
        self.field.clear()
        try:
            self._tried = fields_of(Path(path))
        except BalloonError as error:
            self._tried = {}
            self.refused.emit(translated(str(error)))
            return
        self.refused.emit("")
        self.field.addItems(list(self._tried))
