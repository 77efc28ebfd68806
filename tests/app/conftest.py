# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document for each test."""

import sys
from pathlib import Path

import FreeCAD as App
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1] / "core"))  # for counting.py

from BalloonWorkbench.app.border import status
from BalloonWorkbench.core import memoize


@pytest.fixture(autouse=True)
def nothing_known():
    """Each test works out what it asks for."""
    memoize.forget()


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
