# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document for each test."""

import sys
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1] / "core"))  # for counting.py

from remembered import remembered

from BalloonWorkbench.app.border import status
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.nesting import nest


@pytest.fixture(autouse=True)
def known(request):
    """What tests before have worked out, but for those that look at the work itself."""
    with remembered(request.node):
        yield


@pytest.fixture(autouse=True, scope="session")
def short_layouts():
    """How closely panels can lie is looked at in tests of the engine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nest, "_LIMIT", 8)  # s
        yield


@pytest.fixture
def picture(tmp_path):
    """A file of a picture whose left half is blue, the right half red."""
    pixels = np.full((60, 80, 4), (20, 40, 200, 255), np.uint8)
    pixels[:, 40:] = (200, 30, 30, 255)
    path = tmp_path / "two colours.png"
    path.write_bytes(png_bytes(pixels, 100.0))
    return path


@pytest.fixture
def doc():
    """An empty document that remembers undo steps."""
    document = App.newDocument("Test")
    document.UndoMode = 1
    name = document.Name
    yield document
    if name in App.listDocuments():
        App.closeDocument(name)


@pytest.fixture
def parts(solved):
    """The objects that a module's `solved` makes once, as they were after each test."""
    doc = solved.balloon.Document
    doc.openTransaction("test")
    yield solved
    doc.abortTransaction()
    doc.recompute()
    assert [obj.Status for obj in solved] == [status.READY] * 3
