# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture that is traced, and what mouse and keys do in the tab of its nodes."""

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
from drawn_pictures import any_of, coloured, disc, drawn, png, ring

from BalloonWorkbench.gui.outline_editor import tab as tabs

Kind, Qt = hands.QtCore.QEvent, hands.QtCore.Qt


def picture(folder):
    """A body with a wide hole and an ear, 300 x 200 px."""
    shape = any_of(ring(150, 90, 80, 30), disc(215, 150, 32))
    path = folder / "body.png"
    path.write_bytes(png(coloured(drawn(shape, 300, 200, fine=3))[..., :3]))
    return path


def open_tab(obj):
    App.setActiveDocument(obj.Document.Name)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    hands.wait(0.3)  # from FreeCAD 1.0 on that brings the 3D view to the front
    Gui.runCommand("BalloonWorkbench_EditOutline")
    return seen(obj)


def seen(obj):
    (tab,) = [each for each in tabs._tabs if each.obj.Document == obj.Document]
    hands.wait_until(lambda: tab.isVisible() and tab.frame.isMaximized(), 5)
    size = None
    while size != tab.view.size():
        size = tab.view.size()
        hands.wait(0.1)
    return tab


def press(tab, kind, place, held=Qt.LeftButton, by=(0, 0), button=Qt.LeftButton):
    at = hands.QtCore.QPointF(tab.view.place_of(place)) + hands.QtCore.QPointF(*by)
    assert tab.view.viewport().rect().contains(at.toPoint())
    brush.mouse_at(tab.view.viewport(), kind, at, button, held)


def click(tab, place):
    press(tab, Kind.MouseButtonPress, place)
    press(tab, Kind.MouseButtonRelease, place, Qt.NoButton)
    hands.wait(0.05)


def drag(tab, place, by, let_go=True):
    """By so many pixels."""
    press(tab, Kind.MouseButtonPress, place)
    for share in (0.3, 0.7, 1.0):
        press(tab, Kind.MouseMove, place, by=(share * by[0], share * by[1]))
        hands.wait(0.02)
    if let_go:
        press(tab, Kind.MouseButtonRelease, place, Qt.NoButton, by=by)
        hands.wait(0.05)


def key(tab, code, modifier=Qt.NoModifier):
    for kind in (Kind.ShortcutOverride, Kind.KeyPress):
        event = hands.QtGui.QKeyEvent(kind, code, modifier)
        hands.QtWidgets.QApplication.sendEvent(tab.view, event)
    hands.wait(0.05)


def nodes(tab, loop=0):
    own = tab.state.nodes.loops[loop]
    return own.points[own.nodes]


def highest(tab):
    return nodes(tab)[np.argmax(nodes(tab)[:, 1])]
