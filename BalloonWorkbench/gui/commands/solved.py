# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which balloon a command about results is for."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui


def is_offered() -> bool:
    """There is a balloon with a result, and no panel open."""
    return App.ActiveDocument is not None and not Gui.Control.activeDialog() and bool(_solved())


def chosen():
    """The parts of the selected balloon, else of the first one that has a result."""
    from BalloonWorkbench.app.document.parts import parts_of

    selected = [parts for parts in map(parts_of, Gui.Selection.getSelection()) if parts]
    ready = [parts for parts in selected if parts.balloon.SolvedFor]
    return (ready or [parts_of(obj) for obj in _solved()])[0]


def _solved() -> list:
    from BalloonWorkbench.app.document.parts import parts_of, patterns

    found = [parts_of(pattern) for pattern in patterns(App.ActiveDocument)]
    return [parts.balloon for parts in found if parts and parts.balloon.SolvedFor]
