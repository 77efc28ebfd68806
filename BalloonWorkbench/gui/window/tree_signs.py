# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signs on the icons in the tree, and why they are there, as tooltips."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.balloon import FIT
from BalloonWorkbench.app.border import status
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated

#: Ends of the names of icons: all is well; the result is not what was asked for; there is none to rely on.
CALM, WARNING, ERROR = "", "_warning", "_error"
_watched: dict[int, _TreeTips] = {}


def sign(obj) -> str:
    """The sign on the icon of one of our objects; a group has the worst of its members'."""
    if getattr(obj, "Status", None) is None:
        signs = {sign(member) for member in getattr(obj, "Group", []) if hasattr(member, "Status")}
        return next((worst for worst in (ERROR, WARNING) if worst in signs), CALM)
    if obj.Status.startswith((status.EMPTY, status.UNSURE)):
        return ERROR
    if obj.Status not in ("", status.READY) or _is_off(obj):
        return WARNING
    return CALM


def remark(obj) -> str:
    """Why an icon has a sign, in a sentence; empty where it has none."""
    if not hasattr(obj, "Status"):
        reasons = [f"{member.Label}: {remark(member)}" for member in obj.Group if remark(member)]
        return "\n".join(reasons)
    if sign(obj) == CALM:
        return ""
    if obj.Status == status.READY:
        away = obj.ResidualMax.UserString
        return translate(
            "The drawing cannot be reached everywhere: the silhouette is up to {} off it."
        ).format(away)
    return translated(obj.Status)


def watch_trees() -> None:
    """Show the remarks in FreeCAD's trees."""
    for tree in Gui.getMainWindow().findChildren(QtWidgets.QTreeWidget):
        if tree.metaObject().className() == "Gui::TreeWidget" and id(tree) not in _watched:
            _watched[id(tree)] = _TreeTips(tree)


class _TreeTips(QtCore.QObject):
    """Tooltips of a tree."""

    def __init__(self, tree):
        super().__init__(tree)
        self._tree = tree
        tree.viewport().installEventFilter(self)

    def eventFilter(self, watched, event):
        if event.type() != QtCore.QEvent.ToolTip:
            return False
        reason = self._remark(event.pos())
        if reason:
            QtWidgets.QToolTip.showText(event.globalPos(), reason, watched)
        return bool(reason)

    def _remark(self, position) -> str:
        """About the object at a place: the tree tells labels only."""
        index = self._tree.indexAt(position)
        if not index.isValid():
            return ""
        label = index.sibling(index.row(), 0).data()
        above = []
        while index.parent().isValid():
            index = index.parent()
            above.append(index.sibling(index.row(), 0).data())
        documents = [doc for doc in App.listDocuments().values() if doc.Label in above]
        ours = [obj for doc in documents for obj in doc.getObjectsByLabel(label) if _is_ours(obj)]
        return remark(ours[0]) if ours else ""


def _is_ours(obj) -> bool:
    return type(getattr(obj, "Proxy", None)).__module__.startswith("BalloonWorkbench.")


def _is_off(obj) -> bool:
    """A fitted balloon that does not reach its drawing."""
    return getattr(obj, "Mode", "") == FIT and bool(obj.SolvedFor) and not obj.Reached
