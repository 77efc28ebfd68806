# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, as the source of an outline."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.gui.qt import QtCore

_LATER = 500  # ms in which its tree has taken a selection over
_restoring: list[QtCore.QTimer] = []


def selected_source():
    """(object, elements) of the first selected thing that has a flat shape to follow; None without one.

    A face picked in the 3D view counts by itself; a picked edge or corner stands for its whole object.
    """
    for picked in Gui.Selection.getSelectionEx():
        obj = picked.Object
        if getattr(obj, "Shape", None) is not None and parts_of(obj) is None:
            return obj, [name for name in picked.SubElementNames if name.startswith("Face")][:1]
    return None


def selected_panels() -> list:
    """(object, names of faces) of all that is selected and may be panels of a bag; ("",) is the whole."""
    panels = []
    for picked in Gui.Selection.getSelectionEx():
        obj = picked.Object
        if getattr(obj, "Shape", None) is not None and parts_of(obj) is None:
            faces = [name for name in picked.SubElementNames if name.startswith("Face")]
            if not faces and len(obj.Shape.Faces) > 1:  # a body: all its faces
                faces = [f"Face{number + 1}" for number in range(len(obj.Shape.Faces))]
            panels.append((obj, tuple(faces) or ("",)))
    return panels


def selected_body():
    """The first selected object with a body or a mesh; None without one."""
    for picked in Gui.Selection.getSelectionEx():
        obj = picked.Object
        has_body = getattr(obj, "Shape", None) is not None or getattr(obj, "Mesh", None) is not None
        if has_body and parts_of(obj) is None:
            return obj
    return None


def select_behind(obj) -> None:
    """Select an object alone; the tab in front stays there, whatever FreeCAD does with what is selected."""
    if not _restoring:
        _restoring.append(QtCore.QTimer())
        _restoring[0].setSingleShot(True)
        _restoring[0].timeout.connect(_restore)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(
            lambda: _restore() if _restoring[0].isActive() else None
        )
    if _restoring[0].isActive() or preferences.syncs_views():
        preferences.put_syncs_views(False)
        _restoring[0].start(_LATER)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def _restore() -> None:
    preferences.put_syncs_views(True)


class SelectionWatch(Guarded):
    """Calls `changed` whenever the selection has changed, until removed."""

    def __init__(self, changed):
        self._changed = changed
        Gui.Selection.addObserver(self)

    def remove(self) -> None:
        Gui.Selection.removeObserver(self)

    def addSelection(self, *place):
        self._changed()

    def setSelection(self, *place):
        self._changed()
