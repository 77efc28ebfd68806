# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture that is traced, and what mouse and keys do in the tab of its nodes."""

import brush
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
    return hands.open_flat(obj, "EditOutline", tabs._tabs)


def seen(obj):
    return hands.flat_tab(obj.Document, tabs._tabs)


def open_in_panel(doc, folder):
    """The tab of a new picture in its panel, before anything is inflated."""
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    hands.click(hands.find("Live"), x=8)
    hands.type_into(hands.find("Drawing"), str(picture(folder)))
    hands.type_into(hands.find("Width"), "240 mm")
    hands.click(hands.find("EditNodes"))
    return seen(doc.Outline)


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
