# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams of a bag: an edge and its partner are picked in the flat picture, the list or the 3D view."""

from __future__ import annotations

import math

import FreeCADGui as Gui
import Part

from BalloonWorkbench.gui.bags.bag_edges import BagEdges, PanelEdge, edges_of
from BalloonWorkbench.gui.bags.flat_view import FlatView
from BalloonWorkbench.gui.bags.seam_list import SeamList
from BalloonWorkbench.gui.bags.seam_marks import SeamMarks
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.selection import SelectionWatch
from BalloonWorkbench.gui.wrapping import PushButton

_NEAR = 9.0  # px within which an edge is meant


class SeamEditor(QtWidgets.QWidget):
    """Edits the seams and the opening of a Bag object; `changed` follows each edit."""

    changed = QtCore.Signal()

    def __init__(self, bag_obj, balloon):
        super().__init__()
        self._obj = bag_obj
        self._shown: BagEdges | None = None
        self._waiting = ""  # the edge that waits for its partner
        self._marks = SeamMarks(bag_obj, balloon)
        self.flat, self.list, self.hint = FlatView(), SeamList(), WrappedLabel()
        self.hint.setObjectName("SeamHint")
        self.opening = PushButton(translate("Set the opening"))
        self.opening.setObjectName("PickOpening")
        self.opening.setCheckable(True)
        self.opening.setToolTip(
            translate("While this is pressed, the edge that you pick is where it is filled")
        )
        self.remove = PushButton(translate("Take seam apart"))
        self.remove.setObjectName("RemoveSeam")
        self.remove.setToolTip(translate("The edges of the chosen seam are free again"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.flat, self.hint, self.list, self.remove, self.opening):
            column.addWidget(widget)
        self.flat.clicked.connect(self._clicked)
        self.list.chosen.connect(self.choose)
        self.remove.clicked.connect(self._take_apart)
        self.opening.toggled.connect(self._show_hint)
        self._selection = SelectionWatch(self._selected)

    def refresh(self) -> None:
        """Show the seams as they are."""
        self._shown = edges_of(self._obj)
        names = {name for edge in self._shown.edges for name in edge.names} if self._shown else set()
        self._waiting = self._waiting if self._waiting in names else ""
        self.flat.show_bag(self._shown)
        self.list.show_bag(self._shown)
        self.setVisible(self._shown is not None)
        self.choose(self.list.currentRow())

    def release(self) -> None:
        """The panel closes."""
        self._selection.remove()
        self._marks.clear()

    def choose(self, number: int) -> None:
        """Highlight both edges of a seam everywhere; -1 for none."""
        seam = number if number >= 0 else None
        if self.list.currentRow() != number:
            self.list.setCurrentRow(number)  # comes here again
            return
        self.flat.choose(seam)
        self._marks.show(self._shown, seam)
        self.remove.setEnabled(self._text_of(seam) is not None)
        self._show_hint()

    def pick(self, name: str) -> None:
        """The user points at an edge, by what the object calls it."""
        if self.opening.isChecked():
            self._obj.OpeningAt = name
            self.opening.setChecked(False)
            self.changed.emit()
            return
        seam = next((edge.seam for edge in self._edges() if name in edge.names), None)
        if seam is not None:
            self.choose(seam)
        elif self._obj.Panels:
            self._join(name)

    def _join(self, name: str) -> None:
        """A free edge: the first one waits, the second one is its partner."""
        first, self._waiting = self._waiting, ""
        if first and first != name:
            self._obj.Seams = [*self._obj.Seams, f"{first}={name}"]
            self.changed.emit()
            self.choose(self._seam_with(name))
        elif not first:
            self._waiting = name
        self.flat.pick(self._waiting)
        self._show_hint()

    def _take_apart(self, _checked: bool = False) -> None:
        row = self.list.currentRow()
        text = self._text_of(row if row >= 0 else None)
        if text is not None:
            self._obj.Seams = [each for each in self._obj.Seams if each != text]
            self.list.setCurrentRow(-1)
            self.changed.emit()

    def _clicked(self, edge: PanelEdge, name: str) -> None:
        self.pick(name)

    def _selected(self) -> None:
        """An edge was picked in the 3D view, on the flat panels or in a sketch."""
        for picked in Gui.Selection.getSelectionEx():
            numbers = [int(each[4:]) for each in picked.SubElementNames if each.startswith("Edge")]
            if not numbers and picked.Object == self._obj and picked.PickedPoints:
                numbers = self._edge_at(picked.PickedPoints[0])
            if not numbers:
                continue
            if picked.Object == self._obj:
                self.pick(self._obj.EdgeNames[numbers[0] - 1])
            else:
                self._pick_in(picked.Object, f".Edge{numbers[0]}")
            Gui.Selection.clearSelection()
            return

    def _edge_at(self, place) -> list[int]:
        """The number of the edge that a click on a face has meant: since 1.1 FreeCAD takes the face where an
        edge is a few pixels away."""
        view = Gui.getDocument(self._obj.Document.Name).activeView()
        if not hasattr(view, "getPointOnScreen"):
            return []
        at = Part.Vertex(place)
        away = [edge.distToShape(at) for edge in self._obj.Shape.Edges]
        nearest = min(range(len(away)), key=lambda number: away[number][0])
        foot = away[nearest][1][0][0]
        near = math.dist(view.getPointOnScreen(foot), view.getPointOnScreen(place)) < _NEAR
        return [nearest + 1] if near else []

    def _pick_in(self, source, ending: str) -> None:
        """An edge of a sketch or body whose panels are in this bag."""
        known = {name for edge in self._edges() for name in edge.names}
        names = [name for name in sorted(known) if name.partition(".")[0] == source.Name]
        names = [name for name in names if name.endswith(ending)]
        if names:
            self.pick(names[0])

    def _edges(self) -> list[PanelEdge]:
        return [] if self._shown is None else self._shown.edges

    def _seam_with(self, name: str) -> int:
        return next((edge.seam for edge in self._edges() if name in edge.names and edge.seam is not None), -1)

    def _text_of(self, seam: int | None) -> str | None:
        """The text that makes a seam; None for those that come by themselves."""
        if seam is None or self._shown is None or not self._obj.Panels:
            return None
        names = {name for edge in self._shown.of_seam(seam) for name in edge.names}
        texts = (text for text in self._obj.Seams if names >= {part.strip() for part in text.split("=")})
        return next(texts, None)

    def _show_hint(self, _checked: bool = False) -> None:
        """What a click does now."""
        free = sum(edge.seam is None for edge in self._edges())
        if self.opening.isChecked():
            text = translate("Pick the edge at which it is filled.")
        elif self._waiting:
            text = translate("Now pick the partner of {}.").format(self._waiting)
        elif free and self._obj.Panels:
            text = translate("Pick an edge, then its partner, here or in the 3D view. Free edges: {}").format(
                free
            )
        else:
            text = translate("Pick an edge to see its partner.")
        self.hint.setText(text)
