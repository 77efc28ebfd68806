# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages that not every FreeCAD brings along, with advice where one is missing."""

from __future__ import annotations

import importlib.util
from typing import Any

from BalloonWorkbench.core.errors import MissingPackageError

#: What does not work without a package, and what remains; by the name it is imported under.
ABSENCES = {
    "numpy": "Nothing can be computed without it; documents open and keep their shapes.",
    "scipy": "No balloon can be inflated anew without it; patterns can be changed and written.",
    "shapely": "No pattern can be drawn anew without it; documents keep theirs.",
    "cv2": "Pictures are read by Qt and traced with SciPy instead, a little slower.",
    "ezdxf": "DXF files can be neither read nor written without it; SVG files can.",
    "svgelements": "SVG files can be written but not read without it; pictures, DXF and JSON can be read.",
    "pythoncdt": "SciPy triangulates instead, a little slower.",
    "matplotlib": "PDF files, previews and labels need it; DXF, SVG and HPGL can be written.",
    "spyrrow": "Panels are laid on the film in rows instead of closely; nothing else changes.",
}
#: One sentence for a Python that was built or packed without it, as in some Snaps.
NO_CTYPES = (
    "This Python has no working ctypes module, which SciPy and the native solver need: patterns can be "
    "changed and written, but no balloon can be inflated anew. Take another build of FreeCAD or of Python."
)
_TO_INSTALL = {"cv2": "opencv-python-headless"}


def missing() -> list[str]:
    """A sentence for each package that is not installed: what that costs, what remains, how to get it."""
    sentences = [NO_CTYPES] if lacks_ctypes() else []
    return sentences + [
        f"The Python package {name} is missing. {cost} To get it: pip install {_TO_INSTALL.get(name, name)}"
        for name, cost in ABSENCES.items()
        if importlib.util.find_spec(name) is None
    ]


def lacks_ctypes() -> bool:
    """Whether Python's ctypes is missing or does not load."""
    try:
        import ctypes  # noqa: F401
    except ImportError:
        return True
    return False


def without_scipy(text: str) -> MissingPackageError:
    """What to raise where scipy does not load: `text`, unless installing it would be of no use."""
    return MissingPackageError(NO_CTYPES if lacks_ctypes() else text)


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


def matplotlib_pdf() -> Any:
    """What matplotlib writes PDF with, its backend_pdf. Raises MissingPackageError."""
    try:
        from matplotlib.backends import backend_pdf
    except ImportError as error:
        raise MissingPackageError(
            "Writing PDF needs matplotlib: install it with pip install matplotlib, or use the SVG file."
        ) from error
    return backend_pdf


def matplotlib_text() -> Any:
    """What matplotlib draws letters with, its `text_to_path`. Raises MissingPackageError."""
    try:
        from matplotlib.textpath import text_to_path
    except ImportError as error:
        raise MissingPackageError(
            "Labels need matplotlib: install it with pip install matplotlib, or leave the label empty."
        ) from error
    return text_to_path
