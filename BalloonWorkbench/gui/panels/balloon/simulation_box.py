# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the simulation: how fine, what is given, which solver, what is simulated."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import PROPERTIES
from BalloonWorkbench.gui.panels.widgets.fields import Fields, PropertyForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets


class SimulationBox(QtWidgets.QWidget):
    """Edits how a balloon is simulated; nobody has to. `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, balloon):
        super().__init__()
        self.balloon = balloon
        self.fields = Fields(balloon, self)
        self.form = PropertyForm(self.fields, self)
        for item in PROPERTIES:
            if item.label and item.page == "Solver":
                self.form.add(item)
        self.fields.changed.connect(self._changed)

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.fields.release()

    def refresh(self) -> None:
        self.form.refresh()

    def _changed(self, _name: str) -> None:
        self.changed.emit()
