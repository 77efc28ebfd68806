# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document for each test."""

import FreeCAD as App
import pytest


@pytest.fixture
def doc():
    """An empty document that remembers undo steps."""
    document = App.newDocument("Test")
    document.UndoMode = 1
    name = document.Name
    yield document
    if name in App.listDocuments():
        App.closeDocument(name)
