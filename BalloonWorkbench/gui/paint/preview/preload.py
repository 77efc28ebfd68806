# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings in what takes a while to load and stops everything meanwhile: piece by piece once the workbench is
there, not during the first stroke or while a panel opens."""

from __future__ import annotations

from contextlib import suppress
from importlib import import_module

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

_PAUSE = 50  # ms, in which the window answers
_PACKAGE = "BalloonWorkbench"
_MODULES = (
    "pivy.coin",
    "MeshGui",
    "PartGui",
    f"{_PACKAGE}.core.job",
    f"{_PACKAGE}.gui.view3d.balloon_display",
    f"{_PACKAGE}.gui.panels.balloon.balloon_panel",
    f"{_PACKAGE}.gui.panels.making.export",
    f"{_PACKAGE}.gui.paint.window",
)
_missing: list = []  # what is still to be done


def begin() -> None:
    """Load when the window has nothing else to do."""
    if not _missing:
        _missing.extend(
            [*(lambda name=name: import_module(name) for name in _MODULES), _opencv, _look, _fonts]
        )
        QtCore.QTimer.singleShot(_PAUSE, _go_on)


def load() -> None:
    """Load now what is not there yet."""
    if _missing:
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        while _missing:
            _do_next()
        QtWidgets.QApplication.restoreOverrideCursor()


def _go_on() -> None:
    if _missing:
        _do_next()
        QtCore.QTimer.singleShot(_PAUSE, _go_on)


def _do_next() -> None:
    """What fails here will fail again where it is needed, and be told there."""
    try:
        _missing.pop(0)()
    except faults.UNFORESEEN as error:
        hooks.report(faults.as_balloon_error(error, "loading"))


def _opencv() -> None:
    from BalloonWorkbench.core.tracing.raster import opencv

    opencv()


def _fonts() -> None:
    """Find the font of an assembly sheet in the user's language."""
    from BalloonWorkbench.core.pages.fonts import can_show

    can_show(translate("Assembly sheet"))


def _look() -> None:
    """Look at a dot once."""
    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.job import Settings
    from BalloonWorkbench.core.types import no_progress
    from BalloonWorkbench.gui.paint.painting.layers import SIDE
    from BalloonWorkbench.gui.paint.painting.painted import Painting
    from BalloonWorkbench.gui.paint.painting.strokes import PEN, PaintStroke
    from BalloonWorkbench.gui.paint.preview.requests import QuickPreview
    from BalloonWorkbench.gui.window.sentences import translated

    dot = Painting()
    dot.do(PaintStroke(PEN, "#000000", points=[(SIDE / 2, SIDE / 2, SIDE / 2)]))
    with suppress(BalloonError):  # what is missing is told when it is needed
        QuickPreview(dot.image, 0, 100.0, Settings()).solve(no_progress)
    translated("")
