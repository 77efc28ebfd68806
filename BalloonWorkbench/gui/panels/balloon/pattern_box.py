# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the pattern: weld and cut, air intake, marks."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.pattern import PROPERTIES, choose_kind
from BalloonWorkbench.app.shapes.pattern_shape import PLACE
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.panels.widgets.fields import Fields, PropertyForm
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.view3d.intake_handle import IntakeHandle
from BalloonWorkbench.gui.window.sentences import tell


class PatternBox(QtWidgets.QWidget):
    """Edits a pattern. `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, pattern):
        super().__init__()
        self.pattern = pattern
        self.handle: IntakeHandle | None = None
        self.fields = fields = Fields(pattern, self)
        self.form = form = PropertyForm(fields, self)
        self.note, self.advice = WrappedLabel(), WrappedLabel()
        self.note.setObjectName("HowToFill")
        self.advice.setObjectName("PatternAdvice")
        self.drag = QtWidgets.QPushButton(translate("Drag in the view"))
        self.drag.setObjectName("DragIntake")
        self.drag.setCheckable(True)
        self.drag.setToolTip(translate("While this is pressed, the ring in the 3D view moves the intake"))
        headings = {
            "Pattern": translate("Weld and cut"),
            "Intake": translate("Intake"),
            "Marks": translate("Marks"),
        }
        for group, title in headings.items():
            form.addRow(QtWidgets.QLabel(f"<b>{title}</b>"))
            for item in PROPERTIES:
                if item.label and item.group == group:
                    form.add(item, self._without(item))
                    if item.name == "IntakeKind":
                        form.addRow(self.note)
            if group == "Intake":
                form.addRow(self.drag)
                form.addRow(self.advice)
        self.sketch = QtWidgets.QPushButton(translate("Make a sketch of the cuts"))
        self.sketch.setObjectName("MakeSketch")
        self.sketch.setToolTip(translate("A new Sketcher sketch of lines and arcs, to go on with in FreeCAD"))
        form.addRow(self.sketch)
        fields.changed.connect(self._edited)
        self.sketch.clicked.connect(self._make_sketch)
        self.drag.toggled.connect(self._follow_drag)

    def finish_typing(self) -> None:
        self.fields.finish_typing()

    def release(self) -> None:
        """The panel closes."""
        self.drag.setChecked(False)
        self._remove_handle()
        self.fields.release()

    def refresh(self) -> None:
        """Show the values, and only those that have an effect."""
        pattern = self.pattern
        self.form.refresh()
        self.note.setText(tell(pattern.HowToFill))
        self.note.setVisible(bool(pattern.HowToFill))
        self.advice.setText("\n".join(tell(text) for text in pattern.Warnings))
        self.advice.setVisible(bool(pattern.Warnings))
        self.drag.setVisible(pattern.Intake)
        self.drag.setEnabled(bool(pattern.Roles))
        self.sketch.setEnabled(status.is_ready(pattern))
        if self.handle is not None:
            self.handle.follow()

    def _without(self, item):
        """What a value of 0 comes to, where the balloon has that."""
        balloon, option = self.pattern.Balloon, item.option
        known = option is not None and option.default is None and item.name in balloon.PropertiesList
        return (lambda: getattr(balloon, item.name).Value) if known else None

    def _edited(self, name: str) -> None:
        if name == "IntakeKind":
            choose_kind(self.pattern, self.pattern.IntakeKind)
        self.changed.emit()

    def _follow_drag(self, pressed: bool) -> None:
        self._remove_handle()
        if pressed and self.pattern is not None and self.pattern.Roles:
            self.handle = IntakeHandle(self.pattern, self._dropped)

    def _dropped(self, along: float) -> None:
        """The intake was put to a place along the seam [mm]."""
        self.pattern.IntakeAuto, self.pattern.IntakeBy = False, PLACE
        self.pattern.IntakeAlong = along
        self.changed.emit()

    def _make_sketch(self, _checked: bool = False) -> None:
        from BalloonWorkbench.app.shapes.pattern_sketch import make_sketch

        self.finish_typing()
        try:
            sketch = make_sketch(self.pattern)
        except BalloonError as error:
            self.advice.setText(tell(str(error)))
            self.advice.setVisible(True)
            return
        sketch.recompute()
        text = translate("{} is in the tree").format(sketch.Label)
        Gui.getMainWindow().statusBar().showMessage(text, 8000)

    def _remove_handle(self) -> None:
        if self.handle is not None:
            self.handle.remove()
            self.handle = None
