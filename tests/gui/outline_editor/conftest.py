# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a picture whose nodes are edited."""

import pytest
from outline_hands import picture

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import set_drawing


@pytest.fixture
def made(doc, tmp_path):
    """A balloon that is not inflated yet: 240 mm wide, with a hole."""
    parts = create.make(doc)
    parts.outline.DrawnAs, parts.outline.Symmetry = "Filled shape", "Off"
    parts.outline.Width = 240
    set_drawing(parts.outline, picture(tmp_path))
    parts.balloon.Live = False
    doc.recompute([parts.outline])
    assert parts.outline.HoleCount == 1
    return parts
