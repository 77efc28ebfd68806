# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings in what takes a while to load and stops everything meanwhile: not during the first stroke."""

from __future__ import annotations

from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.outline.raster import opencv
from BalloonWorkbench.core.types import no_progress
from BalloonWorkbench.gui.paint.painting import SIDE, Painting
from BalloonWorkbench.gui.paint.requests import Counsel, Glance
from BalloonWorkbench.gui.paint.strokes import PEN, Stroke
from BalloonWorkbench.gui.qt import QtCore, QtWidgets
from BalloonWorkbench.gui.sentences import tell


def load() -> None:
    """Look at a dot once, from the picture to the coach."""
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    opencv()
    import MeshGui  # noqa: F401
    import PartGui  # noqa: F401
    from pivy import coin  # noqa: F401

    from BalloonWorkbench.gui import balloon_view  # noqa: F401

    dot = Painting()
    dot.do(Stroke(PEN, "#000000", points=[(SIDE / 2, SIDE / 2, SIDE / 2)]))
    look = Glance(dot.image, 0, 100.0, Settings()).solve(no_progress)
    Counsel(look, Settings()).solve(no_progress)
    tell("")
    QtWidgets.QApplication.restoreOverrideCursor()
