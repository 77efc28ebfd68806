# SPDX-License-Identifier: LGPL-2.1-or-later
"""What works here."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.errors import FetchError
from BalloonWorkbench.gui.commands.command import Command
from BalloonWorkbench.gui.panels import show_alone
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, icon, number_of, translate
from BalloonWorkbench.gui.window import native_offer
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated


class Equipment(Command):
    """Opens a panel that tells which solver is used, and what missing packages cost."""

    drawing = "workbench"
    menu_text = QT_TRANSLATE_NOOP("BalloonWorkbench_Equipment", "What works here")
    tool_tip = QT_TRANSLATE_NOOP(
        "BalloonWorkbench_Equipment",
        "Show the solver in use, and which packages are missing and what that costs",
    )

    def Activated(self):
        show_alone(_Panel())


class _Panel(TaskPanel):
    """Text to read and to copy."""

    def __init__(self):
        from BalloonWorkbench.gui.window.equipment import can_be_fetched, described

        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("What works here"))
        self.form.setWindowIcon(QtGui.QIcon(icon("workbench")))
        self.message = text = QtWidgets.QLabel("\n\n".join(map(translated, described())))
        text.setObjectName("Equipment")
        text.setWordWrap(True)
        text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        column = QtWidgets.QVBoxLayout(self.form)
        column.addWidget(text)
        if can_be_fetched():
            fetch = QtWidgets.QPushButton(translate("Fetch the native solver ..."))
            fetch.setObjectName("FetchSolver")
            fetch.clicked.connect(self._fetch)
            column.addWidget(fetch)

    def _fetch(self) -> None:
        try:
            native_offer.ask()
        except FetchError as error:
            self.fail(error)

    def getStandardButtons(self):
        return number_of(QtWidgets.QDialogButtonBox.Close)

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        Gui.Control.closeDialog()
