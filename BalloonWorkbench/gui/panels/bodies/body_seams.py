# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a divided body: merged, cut and moved with the mouse in the 3D view, or from a list."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app import target as target_object
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.seam_edits.apply_edits import with_edit
from BalloonWorkbench.core.seam_edits.read_seams import edit_text
from BalloonWorkbench.core.targets.symmetry_planes import symmetry_planes
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.seam_colours import seam_colour
from BalloonWorkbench.gui.bags.seam_list import swatch
from BalloonWorkbench.gui.bodies.body_surface import BodySurface
from BalloonWorkbench.gui.bodies.picked_edits import cut_edit, merge_edit, move_edit
from BalloonWorkbench.gui.bodies.seam_mouse import SeamMouse, SeamTool
from BalloonWorkbench.gui.panels.widgets.fields import ReturnKey
from BalloonWorkbench.gui.panels.widgets.narrow import FullList, WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text
from BalloonWorkbench.gui.wrapped_check import WrappedCheck

_HIGHEST = 1_000_000  # px: the panel scrolls, not what is in it


class BodySeams(QtWidgets.QWidget):
    """Edits the seams of a Target object; `edited` is called after each edit, `refuse` with why not."""

    def __init__(self, target, balloon, edited, refuse):
        super().__init__()
        self._obj, self._balloon, self._edited, self._refuse = target, balloon, edited, refuse
        self._mouse: SeamMouse | None = None
        self._made: Division | None = None
        self._symmetry: tuple | None = None
        self._objection = ""  # why the last change was not made
        self._surface: BodySurface | None = None
        self.tools = {tool: QtWidgets.QToolButton() for tool in SeamTool}
        self.hint, self.list = WrappedLabel(), _SeamRows(_HIGHEST)
        self.mirrored = WrappedCheck(translate("Also on the other side"))
        self.places, self.back = QtWidgets.QLineEdit(), QtWidgets.QPushButton(translate("Take back"))
        self._build()

    def _build(self) -> None:
        texts = {
            SeamTool.MERGE: (translate("Merge"), translate("Click a seam: the panels beside it become one")),
            SeamTool.CUT: (translate("Cut"), translate("Click two places: a seam runs between them")),
            SeamTool.MOVE: (translate("Move"), translate("Drag a seam: it runs through the place")),
        }
        tools = QtWidgets.QGridLayout()
        for number, (tool, button) in enumerate(self.tools.items()):
            button.setObjectName(f"Seam{tool.name.title()}")
            button.setText(texts[tool][0])
            button.setToolTip(texts[tool][1])
            button.setCheckable(True)
            button.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
            button.clicked.connect(partial(self.take, tool))
            tools.addWidget(button, *divmod(number, 2))
        tools.addWidget(self.back, 1, 1)
        self.mirrored.setObjectName("SeamMirrored")
        self.mirrored.setChecked(True)
        self.mirrored.setToolTip(
            translate("On a symmetric body a change is repeated where its mirror image lies")
        )
        self.hint.setObjectName("BodySeamHint")
        self.list.setObjectName("BodySeams")
        self.list.setAccessibleName(translate("Seams"))
        self.places.setObjectName("SeamPlaces")
        self.places.setAccessibleName(translate("Places of a seam"))
        self.places.setToolTip(
            translate("Places on the body in mm: two for a cut, one for the chosen seam to be moved to")
        )
        self.back.setObjectName("TakeBackSeam")
        self.back.setToolTip(translate("Take the last change of a seam back (Ctrl+Z in the 3D view)"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(tools)
        for widget in (self.hint, self.mirrored, self.places, self.list):
            column.addWidget(widget)
        self.list.currentRowChanged.connect(self._chosen)
        self.list.deleted.connect(self.merge)
        self.back.clicked.connect(self.take_back)
        ReturnKey(self.places, self._typed)

    def refresh(self) -> None:
        """Show the seams as they are."""
        known = bool(self._obj.TargetPoints)
        self.setVisible(known)
        if not known:
            self.release()
            return
        self._objection = ""
        made = self._made = target_object.division(self._obj)
        self._symmetry = None
        self._surface = BodySurface.of(made)
        blocked = self.list.blockSignals(True)
        row = self.list.currentRow()
        self.list.clear()
        for number, seam in enumerate(made.seams):
            names = " \N{EN DASH} ".join(made.names[panel] for panel in seam.panels)
            text = length_text(to_mm(length(made.target.points[seam.vertices])))
            entry = QtWidgets.QListWidgetItem(f"{number + 1}: {names}, {text}")
            entry.setIcon(swatch(seam_colour(number)))
            self.list.addItem(entry)
        self.list.setCurrentRow(row if row < self.list.count() else -1)
        self.list.blockSignals(blocked)
        self.list.fit()
        self.back.setVisible(bool(self._obj.SeamEdits))
        if self._mouse is not None:
            self._mouse.follow(self._surface)
        self._show_hint()

    def release(self) -> None:
        """The panel closes, or the body is gone."""
        if self._mouse is not None:
            self._mouse.remove()
            self._mouse.deleteLater()
            self._mouse = None
        for button in self.tools.values():
            button.setChecked(False)

    def take(self, tool: SeamTool, taken: bool = True) -> None:
        """Take a tool in the hand, or lay it down."""
        self.release()
        self._objection = ""
        view = Gui.getDocument(self._obj.Document.Name).activeView()
        if taken and not hasattr(view, "graphicsView"):
            self._refuse(translate("Bring the 3D view of the document to the front first."))
        elif taken and self._surface is not None:
            self.tools[tool].setChecked(True)
            mouse = self._mouse = SeamMouse(self._obj, self._balloon, tool, self._preview)
            mouse.merged.connect(self.merge)
            mouse.cut.connect(self.cut)
            mouse.moved.connect(self.move)
            mouse.chosen.connect(self.list.setCurrentRow)
            mouse.progressed.connect(self._show_hint)
            mouse.left.connect(self.release)
            mouse.left.connect(self._show_hint)
            mouse.took_back.connect(self.take_back)
            mouse.follow(self._surface)
        self._show_hint()

    def merge(self, seam: int) -> None:
        """Both panels of a seam become one."""
        self._edit(lambda made: merge_edit(made, seam))

    def cut(self, start: Floats, end: Floats) -> None:
        """A seam from place to place (3,) mm of the body."""
        self._edit(lambda made: cut_edit(made, [start, end]))

    def move(self, seam: int, start: Floats | None, end: Floats) -> None:
        """A seam is dragged from a place (3,) mm on it, None for its middle, to another one."""
        self._edit(lambda made: move_edit(made, seam, start, end))

    def take_back(self, _checked: bool = False) -> None:
        """The last change is no more."""
        if self._obj.SeamEdits:
            self._obj.SeamEdits = self._obj.SeamEdits[:-1]
            self._edited()

    def _edit(self, edit_of) -> None:
        """Keep an edit that can be made; say why of one that cannot."""
        try:
            edit = replace(edit_of(self._made), mirrored=self.mirrored.isChecked())
            with_edit(self._made, edit, self._planes(), alone=self._obj.Panels == 1)
        except BalloonError as error:
            self._object(translated(str(error)))
            return
        self._obj.SeamEdits = [*self._obj.SeamEdits, edit_text(edit)]
        self._edited()

    def _planes(self) -> tuple:
        """The planes of symmetry of the body; they are looked for once."""
        if self._symmetry is None:
            target = self._made.target
            self._symmetry = tuple(symmetry_planes(target.points, target.triangles))
        return self._symmetry

    def _preview(self, seam: int | None, places: list[Floats]) -> list[Floats]:
        """The seams (k, 3) mm that a cut, or a seam that is dragged, would make."""
        made, surface = self._made, self._surface
        edit = cut_edit(made, places) if seam is None else move_edit(made, seam, *places)
        try:
            edit = replace(edit, mirrored=self.mirrored.isChecked())
            changed, _ = with_edit(made, edit, self._planes(), alone=self._obj.Panels == 1)
        except BalloonError as error:
            self.hint.setText(translated(str(error)))
            return []
        self._show_hint()
        return surface.new_lines(BodySurface.of(changed))

    def _chosen(self, row: int) -> None:
        if self._mouse is not None:
            self._mouse.mean(row if row >= 0 else None)

    def _typed(self) -> None:
        """Places were typed: two cut, one is where the chosen seam shall run."""
        places, row = _places(self.places.text()), self.list.currentRow()
        if places is not None and len(places) == 2:
            self.cut(*places)
        elif places is not None and len(places) == 1 and row >= 0:
            self.move(row, None, places[0])
        else:
            self._object(
                translate(
                    "Type two places for a cut, such as 10 0 50; 10 20 50, or choose a seam and type one."
                )
            )

    def _object(self, sentence: str) -> None:
        """Say why nothing changes: also here, where the user looks, as the panel may be scrolled."""
        self._objection = sentence
        self._refuse(sentence)
        self._show_hint()

    def _show_hint(self) -> None:
        """What a click does now."""
        if self._mouse is None:
            text = translate("Take a tool to change the seams, or choose one and press Delete to merge.")
        elif self._mouse.tool is SeamTool.CUT:
            begun = translate("Click where the seam ends. Esc: another start.")
            text = begun if self._mouse.is_begun else translate("Click where the new seam begins. Esc: done.")
        elif self._mouse.tool is SeamTool.MERGE:
            text = translate("Click a seam: its panels become one. Esc: done.")
        else:
            text = translate("Drag a seam to where it shall run. Esc: done.")
        self.hint.setText("\n".join(filter(None, (self._objection, text))))


class _SeamRows(FullList):
    """A list whose chosen row is deleted by its key: `deleted` carries its number."""

    deleted = QtCore.Signal(int)

    def event(self, event):
        """The key is ours: FreeCAD would delete the selected objects."""
        kinds = QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress
        if event.type() not in kinds or event.key() != QtCore.Qt.Key_Delete or self.currentRow() < 0:
            return super().event(event)
        event.accept()
        if event.type() == QtCore.QEvent.KeyPress:
            self.deleted.emit(self.currentRow())
        return True


def _places(text: str) -> list[Floats] | None:
    """Places (3,) mm as they are typed: x y z; x y z. None where that is no number."""
    try:
        rows = [[float(part) for part in row.replace(",", " ").split()] for row in text.split(";")]
    except ValueError:
        return None
    return [np.array(row) for row in rows] if all(len(row) == 3 for row in rows) else None
