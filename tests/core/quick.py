# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a test does not look at is made quickly, or not at all: smooth pictures, FreeCAD's documents."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pytest

from BalloonWorkbench.core.pictures import render

_LOOKED_AT = {"test_export_preview", "test_assembly", "test_house"}


@pytest.fixture(autouse=True, scope="module")
def rough_pictures(request: pytest.FixtureRequest) -> None:
    """Pictures are drawn without smooth edges, in a third of the time, but where they are what is tested."""
    if request.module.__name__ not in _LOOKED_AT:
        patch = pytest.MonkeyPatch()
        patch.setattr(render, "_OVERSAMPLING", 1)
        request.addfinalizer(patch.undo)


@pytest.fixture(autouse=True, scope="module")
def no_document() -> Iterator[None]:
    """FreeCAD makes the command line's document in a process of its own, in more time than all the rest."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "FreeCAD", None)
        yield
