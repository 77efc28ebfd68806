# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt of the running FreeCAD, and the texts and icons of the window."""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench
from BalloonWorkbench.app.host import qt

QtCore, QtGui, QtWidgets = qt()

_ICONS = Path(BalloonWorkbench.__file__).resolve().parent.parent / "resources" / "icons"


def translate(text: str) -> str:
    """A text in the user's language."""
    return App.Qt.translate("BalloonWorkbench", text)


def icon(name: str) -> str:
    """Path of an icon of the workbench."""
    return str(_ICONS / f"{name}.svg")
