# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloons of sketches: on their sketches, and beside each other where these lie on each other."""

from __future__ import annotations

import FreeCAD as App
import sketches
from test_arrange import QUICK, grid, meetings

from BalloonWorkbench.app.document import create


def test_sketches_at_one_place(doc):
    """The first balloon lies on its sketch, the second beside it, wherever its sketch is moved to."""
    first, sheet = grid(doc)
    sketch = sketches.rectangle(doc, 50, 40)
    second = create.balloon_from_sketch(doc, sketch, **QUICK)
    assert first.outline.Placement.isIdentity()
    assert not meetings(doc)
    aside = second.outline.Placement.Base
    assert aside.x > 50.0
    assert second.balloon.Placement.Base == aside
    doc.recompute()
    assert second.outline.Placement.Base == aside
    sheet.set("A1", "=130 mm")
    doc.recompute()
    assert not meetings(doc)
    aside = second.outline.Placement.Base
    sketch.Placement.Base = App.Vector(0, 500, 0)
    doc.recompute()
    assert (second.outline.Placement.Base - aside - App.Vector(0, 500, 0)).Length < 1e-6


def test_sketches_above_each_other_stay(doc):
    create.balloon_from_sketch(doc, sketches.rectangle(doc, 50, 40), **QUICK)
    upper = sketches.rectangle(doc, 50, 40)
    upper.Placement.Base.z = 300.0
    made = create.balloon_from_sketch(doc, upper, **QUICK)
    assert made.outline.Placement.Base == App.Vector(0, 0, 300)
