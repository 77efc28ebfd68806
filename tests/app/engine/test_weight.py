# SPDX-License-Identifier: LGPL-2.1-or-later
"""The weight of a balloon follows its pattern, whichever of its values changes."""

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app import pattern
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import film, size_goal
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.design.size_goal import Buoyancy, Scaling
from BalloonWorkbench.core.making.weight import film_and_valve
from BalloonWorkbench.core.units import to_grams

EDITABLE = [item for item in pattern.PROPERTIES if not item.result]
#: Other values for those that are not simply switched over or made larger, and what they need to matter.
OTHERS = {
    "SealWidth": 9.0,
    "CornerRadius": 2.0,
    "IntakeLength": 55.0,
    "IntakeAngle": 200.0,
    "IntakeAlong": 137.0,
    "Opening": "1",
    "OpeningShare": 0.3,
    "Notches": 4,
    "NotchDepth": 1.0,
    "TieTabAngle": 100.0,
    "LabelText": "A",
    "Copies": 2,
}
NEEDS = {
    "IntakeBy": {"IntakeAuto": False, "IntakeAngle": 200.0},
    "IntakeAngle": {"IntakeAuto": False},
    "IntakeAlong": {"IntakeAuto": False, "IntakeBy": pattern.PLACE},
    "TieTabAuto": {"TieTab": True, "TieTabAngle": 100.0},
    "TieTabAngle": {"TieTab": True, "TieTabAuto": False},
    "NotchDepth": {"Notches": 4},
    "LabelHeight": {"LabelText": "A"},
}


@pytest.fixture(scope="module")
def solved():
    document = App.newDocument("Weighed")
    document.UndoMode = 1
    name = document.Name
    sketch = sketches.rectangle(document, 120, 80)
    yield create.balloon_from_sketch(document, sketch, mesh_size=15, correct=False)
    App.closeDocument(name)


def weighed(balloon, wanted) -> float:
    """In grams, from nothing that was computed before."""
    seam, own = part_shapes.stored(balloon, "Seam"), film.read(balloon)
    area, valve = film_and_valve(seam, own, wanted)
    scaling = Scaling(1.0, 1.0, seam.area, area - seam.area)
    return to_grams(scaling.weight_at(1.0, Buoyancy(1.0, own.areal_density, lambda seam: area, valve)))


def other(obj, item):
    if item.name in OTHERS:
        return OTHERS[item.name]
    if item.type == "Enumeration":
        entries = obj.getEnumerationsOfProperty(item.name)
        return next(entry for entry in entries if entry != getattr(obj, item.name))
    value = getattr(obj, item.name)
    return not value if item.type == "Bool" else 1.3 * value.Value


@pytest.mark.parametrize("item", EDITABLE, ids=lambda item: item.name)
def test_weight_follows_every_value_of_the_pattern(parts, item):
    balloon, obj = parts.balloon, parts.pattern
    if item.name == "Balloon":
        obj.TieTab = True
        balloon.Document.recompute()
        obj.Balloon = None
    else:
        for name, value in NEEDS.get(item.name, {}).items():
            setattr(obj, name, value)
            balloon.Document.recompute()
        setattr(obj, item.name, other(obj, item))
    balloon.Document.recompute()
    assert balloon.Weight == pytest.approx(weighed(balloon, size_goal.pattern_options(balloon)), rel=1e-9)
    if item.name == "Balloon":
        obj.Balloon = balloon
        balloon.Document.recompute()
        assert balloon.Weight == pytest.approx(weighed(balloon, pattern.values(obj)), rel=1e-9)


def test_what_weighs_nothing_leaves_the_balloon_alone(parts):
    """A label, notches and copies are not weighed, and the balloon has nothing to do."""
    balloon, obj = parts.balloon, parts.pattern
    for name, value in {"LabelText": "A", "Notches": 4, "Copies": 2, "Mirror": True, "Arcs": False}.items():
        setattr(obj, name, value)
        assert "Touched" not in balloon.State, name
