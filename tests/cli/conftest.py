# SPDX-License-Identifier: LGPL-2.1-or-later
"""For all tests of the command line."""

from __future__ import annotations

import sys

import pytest
from quick import no_document, rough_pictures  # noqa: F401 - fixtures


@pytest.fixture
def with_freecad(monkeypatch: pytest.MonkeyPatch) -> None:
    """FreeCAD is looked for: the document is made where it is installed."""
    monkeypatch.delitem(sys.modules, "FreeCAD")
