# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse over the 3D view."""

import FreeCADGui as Gui
import hands

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets


def view_area():
    """The widget in whose view port FreeCAD draws the 3D view and takes the mouse."""
    areas = [
        area
        for area in hands.visible(QtWidgets.QAbstractScrollArea)
        if "View3DInventorViewer" in area.metaObject().className()
        or "Quarter" in area.metaObject().className()
    ]
    return areas[0]


def move(widget, place):
    """Move the mouse there, no button pressed: what is under it lights up."""
    at = QtCore.QPointF(*place)
    none = QtCore.Qt.NoButton
    there = QtCore.QPointF(widget.mapToGlobal(at.toPoint()))
    event = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, at, at, there, none, none, QtCore.Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(widget, event)
    hands.wait(0.05)


def pixel(port, point):
    """Where a point of the model is in the view port, whose pixels need not be those of the drawing."""
    view = Gui.activeDocument().activeView()
    ratio = view.getSize()[0] / port.width()
    x, y = view.getPointOnScreen(point)
    return x / ratio, port.height() - 1 - y / ratio


def click(port, place):
    """Press and release the left button there, after what is under it has lit up."""
    move(port, place)
    hands.drag(port, place, place, 1)
