# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the window for the tutorial: `make pictures` copies them to docs/images."""

import os
from contextlib import contextmanager
from pathlib import Path

import FreeCADGui as Gui
import hands
import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.tracing.raster import label

FOLDER = Path(f"build/pictures{os.environ.get('SUITE', '')}")
SIZE = 1400, 900  # px
_STANDS_OUT = 12  # difference from the background, of 255
_PANEL = 270  # px, width of tree and task panels


@contextmanager
def framed(size=SIZE):
    """FreeCAD's window in the size of the pictures, or another."""
    main = Gui.getMainWindow()
    before = main.geometry()
    main.showNormal()
    main.setGeometry(0, 0, *size)
    hands.wait(0.2)
    docks = [
        dock
        for dock in hands.visible(hands.QtWidgets.QDockWidget)
        if main.dockWidgetArea(dock) == hands.QtCore.Qt.LeftDockWidgetArea
    ]
    widths = [dock.width() for dock in docks]
    main.resizeDocks(docks, [_PANEL] * len(docks), hands.QtCore.Qt.Horizontal)
    hands.wait(0.2)
    yield
    main.setGeometry(before)
    main.resizeDocks(docks, widths, hands.QtCore.Qt.Horizontal)
    hands.wait(0.1)


def picture(name):
    """Take a picture of the window as it is now, and return it."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    Gui.getMainWindow().statusBar().clearMessage()
    hands.wait(0.3)
    taken = hands.QtWidgets.QApplication.primaryScreen().grabWindow(0, 0, 0, *SIZE)
    assert taken.save(str(FOLDER / f"{name}.png"), "PNG", 0)
    return taken.toImage()


def silhouette_jump(before, after):
    """The share of a picture in which its silhouettes differ, in two pictures of one view: whatever is
    enclosed by something that stands out from the background, of any colour.
    """
    one, other = (_silhouette(pixels(image)[..., :3].astype(int)) for image in (before, after))
    return float((one != other).mean())


def _silhouette(rgb):
    """Where (h, w) the background, a gradient from top to bottom, does not reach from the border."""
    behind = 0.5 * (rgb[:, :2].mean(axis=1) + rgb[:, -2:].mean(axis=1))
    bare = np.abs(rgb - behind[:, None]).max(axis=2) <= _STANDS_OUT
    labels, _ = label(np.pad(bare, 1, constant_values=True))
    return (labels != labels[0, 0])[1:-1, 1:-1]
