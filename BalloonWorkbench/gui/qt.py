# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt of the running FreeCAD, and the texts and icons of the window."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import FreeCAD as App

import BalloonWorkbench
from BalloonWorkbench.app.host import qt

QtCore, QtGui, QtWidgets = qt()

_ROOT = Path(BalloonWorkbench.__file__).resolve().parent.parent
ICONS = str(_ROOT / "resources" / "icons")
TRANSLATIONS = _ROOT / "resources" / "translations"
HELP = _ROOT / "docs" / "help"


def translate(text: str, context: str = "BalloonWorkbench") -> str:
    """A text in the user's language."""
    return App.Qt.translate(context, text)


def icon(name: str) -> str:
    """Path of an icon of the workbench."""
    return f"{ICONS}/{name}.svg"


@cache
def drawn_icon(name: str, size: int = 96):
    """An icon of the workbench as a QIcon: drawn here, as Qt alone may lack its plugin for SVG icons."""
    from PySide import QtSvg

    pixmap = QtGui.QPixmap(size, size)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    QtSvg.QSvgRenderer(icon(name)).render(painter)
    painter.end()
    return QtGui.QIcon(pixmap)


@contextmanager
def painter_on(widget) -> Iterator:
    """A painter that ends with its block, not when Python forgets it."""
    painter = QtGui.QPainter(widget)
    try:
        yield painter
    finally:
        painter.end()


def widgets_of(kind) -> list:
    """All widgets of a kind. Python's collector waits: it would delete some that Qt has just listed."""
    collecting = gc.isenabled()  # not while a worker runs
    gc.disable()
    try:
        return [each for each in QtWidgets.QApplication.allWidgets() if isinstance(each, kind)]
    finally:
        if collecting:
            gc.enable()


def number_of(buttons) -> int:
    """Standard buttons as the number that FreeCAD asks a panel for; those of Qt 6 are no numbers."""
    return int(getattr(buttons, "value", buttons))


def position(event):
    """Where a mouse, wheel or tablet event happened in its widget (QPointF), under Qt 5 and 6."""
    for name in ("position", "localPos", "posF"):
        if hasattr(event, name):
            return getattr(event, name)()
    return QtCore.QPointF(event.pos())


def is_eraser(event) -> bool:
    """A tablet event comes from the rubber end of the pen."""
    kinds = getattr(QtGui, "QPointingDevice", None)
    eraser = kinds.PointerType.Eraser if kinds is not None else QtGui.QTabletEvent.Eraser
    return event.pointerType() == eraser
