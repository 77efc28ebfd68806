# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a test does not look at is made quickly, or not at all: pictures, fonts of pages, documents."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.pages import pdf
from BalloonWorkbench.core.pictures import bag_preview, preview, render

_LOOKED_AT = {"test_export_preview", "test_assembly", "test_house", "test_absence"}
_SMALL = 1_000_000  # bytes of a font that is quicker to write whole


@pytest.fixture(autouse=True, scope="module")
def rough_pictures(request: pytest.FixtureRequest) -> Iterator[None]:
    """No preview beside the files of a job, pictures without smooth edges, whole fonts in pages: in less than
    half of the time, but where they are what is tested."""
    with pytest.MonkeyPatch.context() as patch:
        if request.module.__name__ not in _LOOKED_AT:
            patch.setattr(preview, "preview_png", lambda *_given: b"no preview")
            patch.setattr(bag_preview, "bag_preview_png", lambda *_given: b"no preview")
            patch.setattr(render, "_OVERSAMPLING", 1)
            _whole_fonts(patch)
        yield


def _whole_fonts(patch: pytest.MonkeyPatch) -> None:
    """To choose the letters that a page needs takes longer than all the rest."""
    load = pdf.matplotlib_pdf

    def loaded() -> Any:
        backend = load()
        fonts = backend._backend_pdf_ps
        if hasattr(fonts, "font_as_file"):  # Matplotlib 3.10 has a font there, not a file
            return backend
        choose = fonts.get_glyphs_subset

        def whole(font: str, letters: str) -> Any:
            path = Path(font)
            return BytesIO(path.read_bytes()) if path.stat().st_size < _SMALL else choose(font, letters)

        if choose.__name__ != whole.__name__:
            patch.setattr(fonts, "get_glyphs_subset", whole)
        return backend

    patch.setattr(pdf, "matplotlib_pdf", loaded)


@pytest.fixture(autouse=True, scope="module")
def no_document() -> Iterator[None]:
    """FreeCAD makes the command line's document in a process of its own, in more time than all the rest."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "FreeCAD", None)
        yield
