# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: how one opens; what is in them has rooms. Messages appear in them, not in front of them."""

from __future__ import annotations

from functools import partial

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.host import panels_are_hidden
from BalloonWorkbench.gui.qt import QtCore, translate
from BalloonWorkbench.gui.window import borders

_SHOWN = 300  # ms


def edit(obj) -> None:
    """Open the panel of the balloon that an object belongs to, in one undo step."""
    from BalloonWorkbench.app.document.parts import parts_of
    from BalloonWorkbench.gui.panels.balloon.balloon_panel import BalloonPanel

    parts = parts_of(obj)
    if parts is None or not is_free():
        return
    with borders.undo_step(obj.Document, translate("Edit balloon")):
        show(BalloonPanel(parts, start=obj))


def show(panel) -> None:
    """Show a panel that was just made: both take a moment, and the window answers between them."""
    from BalloonWorkbench.gui.long_work.blocking import breathe

    breathe()
    Gui.Control.showDialog(panel)
    borders.speaks(panel)
    if Gui.ActiveDocument is not None:
        # the panel comes to the screen a moment later
        QtCore.QTimer.singleShot(_SHOWN, partial(_keep_in_sight, Gui.ActiveDocument.Document.Name))


def show_alone(panel) -> None:
    """Show a panel that needs no document: where a panel cannot be seen without one, a new one is made."""
    show(panel)
    _keep_visible()


def _keep_visible() -> None:
    """While a panel is open; the user may close the last document meanwhile."""
    if not Gui.Control.activeDialog():
        return
    if App.ActiveDocument is None and panels_are_hidden(Gui.getMainWindow()):
        App.newDocument()
    QtCore.QTimer.singleShot(_SHOWN, _keep_visible)


def _keep_in_sight(name: str) -> None:
    """A panel that has opened over the 3D view does not hide what was in it; the document may be closed."""
    from BalloonWorkbench.gui.view3d.fit_view import keep_in_sight

    if Gui.Control.activeDialog() and name in App.listDocuments():
        keep_in_sight(Gui.getDocument(name))


def is_free() -> bool:
    """No other panel is open; says so in the status bar when one is."""
    if Gui.Control.activeDialog():
        Gui.getMainWindow().statusBar().showMessage(translate("Close the open task panel first."), 5000)
        return False
    return True
