# SPDX-License-Identifier: LGPL-2.1-or-later
"""For all tests of the command line."""

from __future__ import annotations

import sys

import pytest
from quick import no_document, rough_pictures  # noqa: F401 - fixtures

from BalloonWorkbench.core import job


@pytest.fixture
def with_freecad(monkeypatch: pytest.MonkeyPatch) -> None:
    """FreeCAD is looked for: the document is made where it is installed."""
    monkeypatch.delitem(sys.modules, "FreeCAD")


@pytest.fixture
def blank_sheets(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the sheet there are files, and nothing in them: for what looks at the report."""
    monkeypatch.setattr(job, "machine_file", lambda *_given: b"")
