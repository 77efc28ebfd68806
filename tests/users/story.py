# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's way through the workbench: a picture and the checks at each step; its end tells all faults."""

import os
import time
from pathlib import Path

import checks
import FreeCAD as App
import hands
import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.tracing.raster import label

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets
#: Part of the view that may change its silhouette when only colours change.
JUMP = 0.02
_DIFFERENT = 24  # of 255, from the background
_QUIET = 4  # looks at a view that has settled


def variant():
    """FreeCAD, size of the screen and theme that this runs with."""
    size = QtWidgets.QApplication.primaryScreen().size()
    version = ".".join(App.Version()[:2])
    return f"{version}-{size.width()}x{size.height()}-{os.environ.get('THEME') or 'light'}"


class Story:
    """The steps of one user."""

    def __init__(self, name):
        self.name = name
        self.faults: list[str] = []
        self.folder = Path("build/users") / variant()
        self.folder.mkdir(parents=True, exist_ok=True)
        self._number = 0
        self._told: set[str] = set()
        for old in self.folder.glob(f"{name}-*.png"):
            old.unlink()

    def step(self, what, ours=True):
        """Take a picture of the screen, and look for faults that were not there before, where it is ours."""
        hands.wait(0.4)
        self._number += 1
        step = f"{self.name}-{self._number:02d}-{what}"
        image = screen(self.folder / f"{step}.png")
        faults = checks.all_of(image) if ours else []
        if faults:  # a panel may be laying itself out: what stays is a fault
            hands.wait(0.5)
            faults = [fault for fault in checks.all_of(screen()) if fault in faults]
        for fault in faults:
            if fault not in self._told:
                self._told.add(fault)
                self.faults.append(f"{step}: {fault}")
        return image

    def fault(self, text):
        """Something is not as it should be; the user goes on."""
        self.faults.append(f"{self.name}-{self._number:02d}: {text}")

    def expect(self, so, text):
        if not so:
            self.fault(text)

    def end(self):
        screen(self.folder / f"{self.name}-end.png")
        with (self.folder / f"{self.name}.txt").open("w", encoding="utf-8") as file:
            file.write("\n".join(self.faults) + "\n" if self.faults else "")
        assert not self.faults, "\n" + "\n".join(self.faults)


def screen(path=None):
    """What is on the screen, as a picture."""
    picture = QtWidgets.QApplication.primaryScreen().grabWindow(0)
    assert path is None or picture.save(str(path))
    return picture.toImage()


def view_box():
    """Where FreeCAD draws the 3D view, on the screen."""
    for area in hands.visible(QtWidgets.QAbstractScrollArea):
        kind = area.metaObject().className()
        if "View3DInventorViewer" in kind or "Quarter" in kind:
            port = area.viewport()  # belongs to the area: gone with it
            return QtCore.QRect(port.mapToGlobal(QtCore.QPoint(0, 0)), port.size())
    raise AssertionError("there is no 3D view")


def silhouette():
    """Where something stands in the 3D view (h, w): its background has one colour along each row.

    What a line goes round belongs to it, whatever its colour: bare foil may be as light as the background.
    """
    picture = QtWidgets.QApplication.primaryScreen().grabWindow(0, *view_box().getRect())
    rgb = pixels(picture.toImage())[..., :3].astype(int)
    stands = (abs(rgb - rgb[:, 4:5]) > _DIFFERENT).any(axis=2)
    bare, _ = label(np.pad(~stands, 1, constant_values=True))
    return (bare != bare[0, 0])[1:-1, 1:-1]


def most_change(action, settled, seconds=8.0):
    """The largest part of the view that changes while and after something is done, until that has settled."""
    before, most, quiet = silhouette(), 0.0, 0
    action()
    end = time.monotonic() + seconds
    while quiet < _QUIET and time.monotonic() < end:
        now = silhouette()
        most = max(most, float((now ^ before).mean()) if now.shape == before.shape else 1.0)
        quiet = quiet + 1 if settled() else 0
        hands.wait(0.1)
    return most
