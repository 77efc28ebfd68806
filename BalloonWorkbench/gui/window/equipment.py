# SPDX-License-Identifier: LGPL-2.1-or-later
"""What there is to work with: the solver in use, the packages that are missing and what that costs."""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench import __version__
from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import BalloonError, FetchError
from BalloonWorkbench.core.solver.native import library


def report_missing() -> None:
    """A line in the report view for each package that is missing, and for a damaged library; loads none."""
    for sentence in [*packages.missing(), *library.damaged()]:
        App.Console.PrintMessage(f"Film Balloon: {sentence}\n")


def described() -> list[str]:
    """Paragraphs about this installation."""
    paragraphs = [f"Film Balloon {__version__} in FreeCAD {'.'.join(App.Version()[:3])}", _solver()]
    why = _unusable_library()
    paragraphs += [library.unusable(why), _not_fetchable() or library.SLOWER] if why else []
    return [*paragraphs, *(packages.missing() or ["All packages are installed."])]


def can_be_fetched() -> bool:
    """Whether the native solver is not in use, but could be fetched."""
    return _unusable_library() is not None and not _not_fetchable()


def _not_fetchable() -> str:
    """Why the native solver cannot be fetched; empty where it can."""
    from BalloonWorkbench.core.solver.native import native_wheel

    try:
        native_wheel.wheel()
    except FetchError as error:
        return str(error)
    return ""


def _solver() -> str:
    try:
        from BalloonWorkbench.core.solver import backend

        return f"Solver: {backend.active_backend()}."
    except ImportError:  # without NumPy; that it is missing is said on its own
        return "No solver works here."
    except BalloonError as error:
        return str(error)


def _unusable_library() -> str | None:
    try:
        from BalloonWorkbench.core.solver.native import load
    except ImportError:
        return None
    return load.problem_with_library()
