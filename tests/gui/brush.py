# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hand that paints in the tests: mouse, tablet and keys on the canvas, and what they leave there."""

import math
import time

import FreeCADGui as Gui
import hands
import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.paint.painting.layers import SIDE

Qt, QEvent = hands.QtCore.Qt, hands.QtCore.QEvent
BLUE, YELLOW, RED, BLACK, ORANGE = "#1f78d8", "#ffd21f", "#e01b3c", "#1c1c22", "#ff8c1a"


def open_window():
    """The paint window, opened by its command."""
    # FreeCAD 1.1 asks where the pointer really is, and gives events to what floats there
    hands.QtGui.QCursor.setPos(0, 0)
    Gui.runCommand("BalloonWorkbench_Paint")
    hands.wait_until(lambda: bool(paint_window._open))
    opened = paint_window._open[0]
    hands.wait_until(lambda: opened.canvas.isVisible() and opened.canvas.width() > 400)
    return opened


def close_window():
    if paint_window._open:
        paint_window._open[0].finish()


def is_closed():
    return not paint_window._open


def mouse_at(widget, kind, at, button=Qt.LeftButton, held=Qt.LeftButton, modifiers=Qt.NoModifier):
    """One mouse event, given to FreeCAD's window: it finds the widget under the pointer."""
    top = widget.window()
    there = hands.QtCore.QPointF(widget.mapToGlobal(at.toPoint()))
    inside = hands.QtCore.QPointF(top.mapFromGlobal(there.toPoint()))
    event = hands.QtGui.QMouseEvent(kind, inside, inside, there, button, held, modifiers)
    hands.QtWidgets.QApplication.sendEvent(top.windowHandle(), event)


def mouse(canvas, kind, place, button=Qt.LeftButton, held=Qt.LeftButton, modifiers=Qt.NoModifier):
    """One mouse event at a place of the paper, 0 to 1, y down."""
    at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    mouse_at(canvas, kind, at, button, held, modifiers)


def tablet(canvas, kind, place, pressure, rubber=False, tilt=0):
    """One event of a tablet's pen, or of its rubber end."""
    gui = hands.QtGui
    at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    there = hands.QtCore.QPointF(canvas.mapToGlobal(at.toPoint()))
    button = Qt.LeftButton if kind != QEvent.TabletMove else Qt.NoButton
    held = Qt.NoButton if kind == QEvent.TabletRelease else Qt.LeftButton
    if hasattr(gui, "QPointingDevice"):  # Qt 6
        types = gui.QPointingDevice.PointerType
        device = gui.QPointingDevice(
            "pen",
            1,
            gui.QInputDevice.DeviceType.Stylus,
            types.Eraser if rubber else types.Pen,
            gui.QInputDevice.Capability.Pressure,
            1,
            2,
        )
        event = gui.QTabletEvent(
            kind,
            device,
            at,
            there,
            pressure,
            float(tilt),
            float(-tilt),
            0.0,
            0.0,
            0.0,
            Qt.NoModifier,
            button,
            held,
        )
    else:
        end = gui.QTabletEvent.Eraser if rubber else gui.QTabletEvent.Pen
        event = gui.QTabletEvent(
            kind,
            at,
            there,
            gui.QTabletEvent.Stylus,
            end,
            pressure,
            tilt,
            -tilt,
            0.0,
            0.0,
            0,
            Qt.NoModifier,
            1,
            button,
            held,
        )
    hands.QtWidgets.QApplication.sendEvent(canvas, event)


def draw(canvas, places, let_live=True):
    """One stroke with the left button, as fast as a hand."""
    mouse(canvas, QEvent.MouseButtonPress, places[0])
    for place in places[1:]:
        mouse(canvas, QEvent.MouseMove, place, Qt.NoButton)
        if let_live:
            hands.wait(0.008)
    mouse(canvas, QEvent.MouseButtonRelease, places[-1], held=Qt.NoButton)


def on_screen(canvas, place):
    """The pixel of the X server's screen at a place of the paper."""
    at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    there, ratio = canvas.mapToGlobal(at.toPoint()), canvas.devicePixelRatioF()
    return there.x() * ratio, there.y() * ratio


def draw_for_real(pointer, canvas, places):
    """One stroke with the X server's own mouse."""
    steps = len(canvas.painting.steps)
    for number, place in enumerate(places):
        at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
        pointer.move(*on_screen(canvas, place))
        end = hands.at_latest(5.0)
        while canvas.pointer is None or (canvas.pointer - at).manhattanLength() > 4:
            assert time.monotonic() < end, "the pointer never came"
            hands.wait(0.004)
        if number == 0:
            pointer.press()
            hands.wait(0.02)
    pointer.release()
    hands.wait_until(lambda: len(canvas.painting.steps) > steps, 10)


def click(canvas, place):
    draw(canvas, [place])


def key(canvas, code, text="", modifiers=Qt.NoModifier):
    """A key the way the system sends it; FreeCAD must leave it to the canvas."""
    asked = hands.QtGui.QKeyEvent(QEvent.ShortcutOverride, code, modifiers, text)
    asked.ignore()
    hands.QtWidgets.QApplication.sendEvent(canvas, asked)
    assert asked.isAccepted()
    hands.QtWidgets.QApplication.sendEvent(
        canvas, hands.QtGui.QKeyEvent(QEvent.KeyPress, code, modifiers, text)
    )


def ellipse(x, y, a, b, count=40):
    turn = [2 * math.pi * k / count for k in range(count + 1)]
    return [(x + a * math.cos(angle), y + b * math.sin(angle)) for angle in turn]


def arc(x, y, r, start, end, count=30):
    """Part of a circle, angles in degrees, y down."""
    turns = [math.radians(start + (end - start) * k / count) for k in range(count + 1)]
    return [(x + r * math.cos(turn), y + r * math.sin(turn)) for turn in turns]


def colour_at(window, x, y):
    image = window.painting.image
    return tuple(pixels(image)[int(y * SIDE), int(x * SIDE)].tolist())


def ink(window):
    """Where there is paint (h, w)."""
    return pixels(window.painting.image)[..., 3] > 127


def box_of(mask):
    """Left, top, width and height of what is set in a mask (h, w)."""
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    return columns[0], rows[0], columns[-1] + 1 - columns[0], rows[-1] + 1 - rows[0]


def rgba(colour):
    return (*(int(colour[k : k + 2], 16) for k in (1, 3, 5)), 255)


def press(name):
    """Click a button of the paint window."""
    hands.click(hands.find(name))


def fish_body(window):
    press(f"PaintColour{BLUE}")
    draw(window.canvas, ellipse(0.44, 0.5, 0.30, 0.19))
