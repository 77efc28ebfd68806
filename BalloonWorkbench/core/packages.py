# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages that not every FreeCAD brings along, with advice where one is missing."""

from __future__ import annotations

from typing import Any

from BalloonWorkbench.core.errors import MissingPackageError


def shapely() -> Any:
    """The package shapely. Raises MissingPackageError."""
    try:
        import shapely as package
    except ImportError as error:
        raise MissingPackageError("Patterns need shapely: install it with pip install shapely.") from error
    return package
