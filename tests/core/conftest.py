# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures are drawn without smooth edges, in a third of the time, but where pictures are what is tested."""

from __future__ import annotations

import pytest

from BalloonWorkbench.core import memoize
from BalloonWorkbench.core.pictures import render

_LOOKED_AT = {"test_export_preview", "test_assembly", "test_house"}


@pytest.fixture(autouse=True, scope="module")
def rough_pictures(request: pytest.FixtureRequest) -> None:
    if request.module.__name__ not in _LOOKED_AT:
        patch = pytest.MonkeyPatch()
        patch.setattr(render, "_OVERSAMPLING", 1)
        request.addfinalizer(patch.undo)


@pytest.fixture(autouse=True)
def nothing_known() -> None:
    """Each test works out what it asks for."""
    memoize.forget()
