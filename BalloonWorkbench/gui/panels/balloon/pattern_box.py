# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the pattern: weld and cut, air intake, marks."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.pattern import choose_kind
from BalloonWorkbench.app.shapes.pattern_shape import PLACE
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.pattern.sheet import MOST_COPIES
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm
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
        self.form = NarrowForm(self)
        self._labels: dict[str, QtWidgets.QWidget] = {}
        self._heading(translate("Weld and cut"))
        seal = fields.quantity("SealWidth", "mm", free=lambda: pattern.Balloon.SealWidth.Value)
        self._row("SealWidth", translate("Seal width"), seal)
        self._row("Allowance", translate("Allowance"), fields.quantity("Allowance", "mm"))
        self._row("CornerRadius", translate("Corner relief"), fields.quantity("CornerRadius", "mm"))
        self._row("Mirror", "", fields.check("Mirror", translate("Second panel, mirrored")))
        self._row("Copies", translate("Copies"), fields.whole("Copies", 1, MOST_COPIES))
        self._heading(translate("Intake"))
        self._row("Intake", "", fields.check("Intake", translate("Air intake")))
        self._row("IntakeKind", translate("Kind"), fields.choice("IntakeKind"))
        self.note = QtWidgets.QLabel()
        self.note.setObjectName("HowToFill")
        self.note.setWordWrap(True)
        self.form.addRow(self.note)
        self._row("IntakeWidth", translate("Width"), fields.quantity("IntakeWidth", "mm"))
        self._row("IntakeLength", translate("Length"), fields.quantity("IntakeLength", "mm"))
        self._row("IntakeAuto", "", fields.check("IntakeAuto", translate("Find its place")))
        self._row("IntakeAutoPlace", translate("Place"), fields.choice("IntakeAutoPlace"))
        self._row("IntakeBy", translate("Place by"), fields.choice("IntakeBy"))
        self._row("IntakeAngle", translate("Direction"), fields.quantity("IntakeAngle", "deg", 5.0))
        self._row("IntakeAlong", translate("Along the seam"), fields.quantity("IntakeAlong", "mm", 5.0))
        self.drag = QtWidgets.QPushButton(translate("Drag in the view"))
        self.drag.setObjectName("DragIntake")
        self.drag.setCheckable(True)
        self.drag.setToolTip(translate("While this is pressed, the ring in the 3D view moves the intake"))
        self.form.addRow(self.drag)
        self.advice = QtWidgets.QLabel()
        self.advice.setObjectName("PatternAdvice")
        self.advice.setWordWrap(True)
        self.form.addRow(self.advice)
        self._heading(translate("Marks"))
        self._row("Notches", translate("Notches"), fields.whole("Notches", 0, 1000))
        self._row("NotchDepth", translate("Their depth"), fields.quantity("NotchDepth", "mm", 0.5))
        self._row("TieTab", "", fields.check("TieTab", translate("Tab to tie it to")))
        self._row("TieTabAuto", "", fields.check("TieTabAuto", translate("Opposite the intake")))
        self._row("TieTabAngle", translate("Direction"), fields.quantity("TieTabAngle", "deg", 5.0))
        self._row("LabelText", translate("Label"), fields.text("LabelText"))
        self._row("LabelHeight", translate("Letter height"), fields.quantity("LabelHeight", "mm"))
        self.sketch = QtWidgets.QPushButton(translate("Make a sketch of the cuts"))
        self.sketch.setObjectName("MakeSketch")
        self.sketch.setToolTip(translate("A new Sketcher sketch of lines and arcs, to go on with in FreeCAD"))
        self.form.addRow(self.sketch)
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
        self.fields.refresh()
        for name, label in self._labels.items():
            shown = "Hidden" not in pattern.getEditorMode(name)
            self.fields.widget(name).setVisible(shown)
            label.setVisible(shown)
        self.note.setText(tell(pattern.HowToFill))
        self.note.setVisible(bool(pattern.HowToFill))
        self.advice.setText("\n".join(tell(text) for text in pattern.Warnings))
        self.advice.setVisible(bool(pattern.Warnings))
        self.drag.setVisible(pattern.Intake)
        self.drag.setEnabled(bool(pattern.Roles))
        self.sketch.setEnabled(status.is_ready(pattern))
        if self.handle is not None:
            self.handle.follow()

    def _heading(self, text: str) -> None:
        label = QtWidgets.QLabel(f"<b>{text}</b>")
        self.form.addRow(label)

    def _row(self, name: str, text: str, widget) -> None:
        label = QtWidgets.QLabel(text)
        if text:
            label.setBuddy(widget)
            self.form.addRow(label, widget)
        else:
            self.form.addRow(widget)
        self._labels[name] = label

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
