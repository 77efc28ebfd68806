# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of test cards: one page makes a card, the other keeps the settings of its best field."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui as Gui

from BalloonWorkbench.app.api import making
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.machines.machine import bed_text
from BalloonWorkbench.core.test_cards.files import CARD_FILE
from BalloonWorkbench.gui.panels.making.card_page import CardPage
from BalloonWorkbench.gui.panels.making.field_page import FieldPage
from BalloonWorkbench.gui.panels.widgets.narrow import Message
from BalloonWorkbench.gui.panels.widgets.pages import Pages
from BalloonWorkbench.gui.qt import QtGui, QtWidgets, icon, translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated


class TestCardPanel(TaskPanel):
    """OK does what the page in front says."""

    def __init__(self):
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("TestCardPanel")
        self.form.setWindowTitle(translate("Test card"))
        self.form.setWindowIcon(QtGui.QIcon(icon("test_card")))
        kinds = {translate("Make a card"): CardPage, translate("Keep the best"): self._field_page}
        self.pages = Pages(kinds.items())
        self.message = Message("Message")
        column = QtWidgets.QVBoxLayout(self.form)
        column.addWidget(self.pages)
        column.addWidget(self.message)
        column.addStretch(1)
        self.pages.setCurrentIndex(0)
        self.pages.currentChanged.connect(lambda _index: self.message.setText(""))

    def _field_page(self):
        page = FieldPage()
        page.refused.connect(self.message.setText)
        return page

    def accept(self):
        """Write the card, or the machine; the panel stays with the reason when that fails."""
        page = self.pages.currentWidget()
        try:
            sentence = self._make(page) if isinstance(page, CardPage) else self._keep(page)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return False
        if not sentence:
            return False
        self.close()
        Gui.getMainWindow().statusBar().showMessage(sentence, 8000)
        return True

    def _make(self, page) -> str:
        objection = page.objection()
        if objection:
            self.message.setText(objection)
            return ""
        machine, folder = page.machine, page.folder.path
        written = {"bed": bed_text(machine.bed)} if page.own_bed else {}
        written |= page.tried()
        files = making.test_card(machine.name, folder, **written)
        named = {name: macro_recorder.text(text) for name, text in written.items()}
        words = macro_recorder.text(machine.name), macro_recorder.text(folder)
        macro_recorder.call("test_card", *words, result=files, **named)
        preferences.put_recent_card(folder / CARD_FILE)
        return translate("Test card written to {}").format(folder)

    def _keep(self, page) -> str:
        card, field, name = page.card, page.field.currentText(), page.name.text()
        path = making.keep_field(card, field, name)
        macro_recorder.call("keep_field", *map(macro_recorder.text, (card, field, name)), result=path)
        preferences.forget_bed(Path(path).stem)
        return translate("{} is among the machines of Export pattern").format(name.strip())

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        Gui.Control.closeDialog()
