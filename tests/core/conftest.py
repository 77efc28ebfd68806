# SPDX-License-Identifier: LGPL-2.1-or-later
"""For all tests of the core."""

from __future__ import annotations

import pytest
from quick import no_document, rough_pictures  # noqa: F401 - fixtures

from BalloonWorkbench.core import memoize


@pytest.fixture(autouse=True)
def nothing_known() -> None:
    """Each test works out what it asks for."""
    memoize.forget()
