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


def ezdxf() -> Any:
    """The package ezdxf. Raises MissingPackageError."""
    try:
        import ezdxf as package
    except ImportError as error:
        raise MissingPackageError(
            "Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file."
        ) from error
    return package


def reportlab_canvas() -> Any:
    """The class Canvas of the package reportlab. Raises MissingPackageError."""
    try:
        from reportlab.pdfgen.canvas import Canvas
    except ImportError as error:
        raise MissingPackageError(
            "Writing PDF needs reportlab: install it with pip install reportlab, or use the SVG file."
        ) from error
    return Canvas


def matplotlib_text() -> Any:
    """A function (text, size) that gives a text as outlines in DejaVu Sans. Raises MissingPackageError."""
    try:
        from matplotlib.font_manager import FontProperties
        from matplotlib.textpath import TextPath
    except ImportError as error:
        raise MissingPackageError(
            "Labels need matplotlib: install it with pip install matplotlib, or leave the label empty."
        ) from error
    font = FontProperties(family="DejaVu Sans")
    return lambda text, size: TextPath((0.0, 0.0), text, size=size, prop=font).to_polygons(closed_only=True)
