# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users do in several scenes: open a panel, wait for its balloon, point into the 3D view, leave."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import view_port
from user import show

from BalloonWorkbench.app import balloon
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_balloon
from BalloonWorkbench.gui.paint import window as paint_window

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets


def paper():
    """The paint window, once it is on the screen."""
    hands.wait_until(lambda: bool(paint_window._open))
    window = paint_window._open[0]
    hands.wait_until(lambda: window.canvas.isVisible() and window.canvas.width() > 300)
    hands.wait(0.5)
    return window


def is_ready():
    """All balloons of the document in front are up to date."""
    balloons = [obj for obj in App.ActiveDocument.Objects if is_balloon(obj)]
    return bool(balloons) and all(obj.Status == status.READY for obj in balloons)


def inflated(seconds=90):
    """Wait until the open panel has nothing more to work out: it follows a change a moment later."""
    hands.wait_until(lambda: _is_current() and is_ready() and hands.find("Apply").isVisible(), seconds)
    hands.wait(0.3)


def _is_current():
    """The balloons are what their properties ask for."""
    balloons = [obj for obj in App.ActiveDocument.Objects if is_balloon(obj)]
    return all(obj.SolvedFor == balloon.request(obj).key() for obj in balloons)


def command(user, name, *selected):
    """A command of ours on what is selected in the tree; its panel is on the screen afterwards."""
    for obj in selected:
        user.select(obj)
    user.command(f"BalloonWorkbench_{name}")
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.3)


def leave(user, button="Ok"):
    """A button of the open panel's row closes it."""
    user.panel(button)
    hands.wait_until(hands.panel_is_closed, 90)
    hands.wait(0.3)


def in_view(point):
    """The pixel of the screen at a point (3,) mm of the model."""
    port = view_port.view_area().viewport()
    x, y = view_port.pixel(port, App.Vector(*point))
    return port.mapToGlobal(QtCore.QPoint(round(x), round(y)))


def look_at_all(user, direction="top"):
    """The 3D view from above (0: from the corner) with all in it, by FreeCAD's own keys."""
    user.key({"top": "2", "corner": "0"}[direction])
    hands.wait(1.5)  # the camera flies
    user.key("v")
    user.key("f")
    hands.wait(0.5)


def to_view(user):
    """The keys go to the 3D view: a click into its empty corner."""
    port = view_port.view_area().viewport()
    user.click(port.mapToGlobal(QtCore.QPoint(port.width() - 12, port.height() - 12)))


def said():
    """All that our widgets on the screen say."""
    return " | ".join(label.text() for label in hands.visible(QtWidgets.QLabel))


def status_text():
    return Gui.getMainWindow().statusBar().currentMessage()


def tick(user, box):
    """Click a check box where its mark is."""
    show(box)
    user.click(box.mapToGlobal(QtCore.QPoint(8, box.height() // 2)))
