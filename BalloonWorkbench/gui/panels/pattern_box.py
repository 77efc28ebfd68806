# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the pattern: weld, allowance and air intake."""

from __future__ import annotations

from BalloonWorkbench.gui.panels.fields import Fields
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate


class PatternBox(QtWidgets.QWidget):
    """Edits a pattern. `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, pattern):
        super().__init__()
        self.pattern = pattern
        self.setWindowTitle(translate("Pattern"))
        self.fields = Fields(pattern, self)
        form = QtWidgets.QFormLayout(self)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        form.addRow(translate("Seal width"), self.fields.quantity("SealWidth", "mm"))
        form.addRow(translate("Allowance"), self.fields.quantity("Allowance", "mm"))
        form.addRow(self.fields.check("Intake", translate("Air intake")))
        form.addRow(translate("Width"), self.fields.quantity("IntakeWidth", "mm"))
        form.addRow(translate("Length"), self.fields.quantity("IntakeLength", "mm"))
        form.addRow(self.fields.check("IntakeAuto", translate("Find its direction")))
        form.addRow(translate("Direction"), self.fields.quantity("IntakeAngle", "deg", 5.0))
        self.fields.changed.connect(lambda name: self.changed.emit())

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.fields.release()

    def refresh(self) -> None:
        self.fields.refresh()
        for name in ("IntakeWidth", "IntakeLength", "IntakeAuto"):
            self.fields.widget(name).setEnabled(self.pattern.Intake)
        automatic = self.pattern.IntakeAuto or not self.pattern.Intake
        self.fields.widget("IntakeAngle").setEnabled(not automatic)
