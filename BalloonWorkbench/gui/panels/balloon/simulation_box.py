# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the simulation: how fine, what is given, which solver, what is simulated."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import VOLUME
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate


class SimulationBox(QtWidgets.QWidget):
    """Edits how a balloon is simulated; nobody has to. `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, balloon):
        super().__init__()
        self.balloon = balloon
        self.fields = Fields(balloon, self)
        form = NarrowForm(self)
        form.addRow(translate("Mesh size"), self.fields.quantity("MeshSize", "mm", 1.0))
        form.addRow(translate("Given"), self.fields.choice("Load"))
        form.addRow(translate("Volume"), self.fields.quantity("TargetVolume", "l", 1e5))
        form.addRow(translate("Solver"), self.fields.choice("Backend"))
        form.addRow(translate("Model"), self.fields.choice("Model"))
        form.addRow(self.fields.check("Bending", translate("Bending stiffness")))
        form.addRow(self.fields.check("TwoPanels", translate("Both panels")))
        self.fields.changed.connect(self._changed)

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.fields.release()

    def refresh(self) -> None:
        self.fields.refresh()
        if self.balloon.Load != VOLUME:
            self.fields.widget("TargetVolume").setEnabled(False)

    def _changed(self, _name: str) -> None:
        self.changed.emit()
