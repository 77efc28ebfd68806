# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the pattern: weld and cut, air intake, marks."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.pattern import PROPERTIES, choose_kind
from BalloonWorkbench.app.shapes.pattern_shape import PLACE
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.view3d.intake_handle import IntakeHandle
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapping import PushButton


class PatternBox(PropertyPage):
    """Edits a pattern."""

    def __init__(self, pattern):
        super().__init__(pattern)
        self.handle: IntakeHandle | None = None
        form = self.form
        self.note, self.advice = WrappedLabel(), WrappedLabel()
        self.note.setObjectName("HowToFill")
        self.advice.setObjectName("PatternAdvice")
        self.drag = PushButton(translate("Drag in the view"))
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
        self.sketch = PushButton(translate("Make a sketch of the cuts"))
        self.sketch.setObjectName("MakeSketch")
        self.sketch.setToolTip(translate("A new Sketcher sketch of lines and arcs, to go on with in FreeCAD"))
        form.addRow(self.sketch)
        self.sketch.clicked.connect(self._make_sketch)
        self.drag.toggled.connect(self._follow_drag)

    def release(self) -> None:
        self.drag.setChecked(False)
        self._remove_handle()
        super().release()

    def refresh(self) -> None:
        super().refresh()
        pattern = self.obj
        self.note.setText(translated(pattern.HowToFill))
        self.note.setVisible(bool(pattern.HowToFill))
        self.advice.setText("\n".join(translated(text) for text in pattern.Warnings))
        self.advice.setVisible(bool(pattern.Warnings))
        self.drag.setVisible(pattern.Intake and not has_many_panels(pattern.Balloon))
        self.drag.setEnabled(bool(pattern.Roles))
        self.sketch.setEnabled(status.is_ready(pattern))
        if self.handle is not None:
            self.handle.follow()

    def _without(self, item):
        """What a value of 0 comes to, where the balloon has that."""
        balloon, option = self.obj.Balloon, item.option
        known = option is not None and option.default is None and item.name in balloon.PropertiesList
        return (lambda: getattr(balloon, item.name).Value) if known else None

    def edited(self, name: str) -> None:
        if name == "IntakeKind":
            choose_kind(self.obj, self.obj.IntakeKind)
        super().edited(name)

    def _follow_drag(self, pressed: bool) -> None:
        self._remove_handle()
        if pressed and self.obj is not None and self.obj.Roles:
            self.handle = IntakeHandle(self.obj, self._dropped)

    def _dropped(self, along: float) -> None:
        """The intake was put to a place along the seam [mm]."""
        self.obj.IntakeAuto, self.obj.IntakeBy = False, PLACE
        self.obj.IntakeAlong = along
        self.changed.emit()

    def _make_sketch(self, _checked: bool = False) -> None:
        from BalloonWorkbench.app.shapes.pattern_sketch import make_sketch

        self.finish_typing()
        try:
            sketch = make_sketch(self.obj)
        except BalloonError as error:
            self.advice.setText(translated(str(error)))
            self.advice.setVisible(True)
            return
        sketch.recompute()
        text = translate("{} is in the tree").format(sketch.Label)
        Gui.getMainWindow().statusBar().showMessage(text, 8000)

    def _remove_handle(self) -> None:
        if self.handle is not None:
            self.handle.remove()
            self.handle = None
