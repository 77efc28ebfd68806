# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coach in a document: what it says, and repairs that are ordinary edits."""

import json

import FreeCAD as App
import numpy as np
import pytest
import shapely
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine import advice, repairs
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.advice.findings import Repair, RepairKind

ARM = 8.0  # mm
#: A body of 60 x 60 mm with an arm to the right.
OUTLINE = [(0, 0), (60, 0), (60, 26), (120, 26), (120, 26 + ARM), (60, 26 + ARM), (60, 60), (0, 60)]


def drawing(folder):
    path = folder / "arm.json"
    path.write_text(json.dumps({"unit": "mm", "outer": OUTLINE, "holes": []}))
    return path


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    document = App.newDocument("Advice")
    document.UndoMode = 1
    name = document.Name
    path = drawing(tmp_path_factory.mktemp("advice"))
    yield create.balloon_from_picture(document, path, width=120, mesh_size=6, correct=False)
    App.closeDocument(name)


def arm_of(found):
    return next(finding for finding in found if finding.rule == "thin_arm")


def arm_width(outline, x=92.0):
    """Width of the arm half way along it [mm]."""
    area = shapely.Polygon(1e3 * part_shapes.stored(outline, "Loop").outer)
    return area.intersection(shapely.LineString([(x, -500), (x, 500)])).length


def test_result_tells_of_the_arm(parts):
    arm = arm_of(advice.findings(parts))
    assert 65 < 1e3 * arm.place[0] < 118
    assert 1e3 * arm.place[1] == pytest.approx(26 + ARM / 2, abs=1)
    assert f"serious: {arm.text}" in parts.balloon.Advice or f"warning: {arm.text}" in parts.balloon.Advice
    assert json.loads(parts.balloon.Report)["advice"][0]["at_mm"]


def test_repair_is_one_undo_step(solved):
    doc = solved.outline.Document
    before = part_shapes.stored(solved.outline, "Loop").outer
    repair = arm_of(advice.findings(solved)).repair
    doc.openTransaction("repair")
    repairs.take(solved, repair)
    solved.outline.recompute()
    doc.commitTransaction()
    assert solved.outline.Status == status.READY
    assert arm_width(solved.outline) == pytest.approx(1e3 * repair.size, rel=0.02)
    assert not [finding for finding in advice.predicted(solved) if finding.rule == "thin_arm"]
    doc.undo()
    assert not solved.outline.Repairs
    assert np.array_equal(part_shapes.stored(solved.outline, "Loop").outer, before)


def test_repair_grows_with_the_drawing(parts):
    repair = arm_of(advice.findings(parts)).repair
    repairs.take(parts, repair)
    parts.outline.recompute()
    width = arm_width(parts.outline)
    parts.outline.Width = 240
    parts.outline.recompute()
    assert arm_width(parts.outline, 184.0) == pytest.approx(2 * width, rel=0.01)


def test_repair_that_does_not_fit_is_told(parts):
    repairs.take(parts, arm_of(advice.findings(parts)).repair)
    entry = json.loads(parts.outline.Repairs[0])
    entry["points_mm"] = [[5000.0, 5000.0], [5001.0, 5000.0]]
    parts.outline.Repairs = [json.dumps(entry), "nonsense"]
    parts.outline.recompute()
    assert parts.outline.Status == status.READY
    assert arm_width(parts.outline) == pytest.approx(ARM)
    told = " ".join(parts.outline.Notes)
    assert "no longer fits" in told
    assert "Repair 2 cannot be read" in told


def test_sketch_stays_as_it_is(doc):
    sketch = sketches.sketch(doc, *sketches.polygon(*OUTLINE))
    parts = create.balloon_from_sketch(doc, sketch, mesh_size=6, correct=False)
    before = sketch.Shape.BoundBox.DiagonalLength
    repairs.take(parts, arm_of(advice.predicted(parts)).repair)
    parts.outline.recompute()
    assert arm_width(parts.outline) > 1.2 * ARM
    assert sketch.Shape.BoundBox.DiagonalLength == before
    assert "Up-to-date" in sketch.State


def test_intake_moves(parts):
    repairs.take(parts, Repair(RepairKind.MOVE_INTAKE, np.zeros((1, 2)), np.pi))
    assert not parts.pattern.IntakeAuto
    assert parts.pattern.IntakeAngle.Value == pytest.approx(180)
    parts.pattern.recompute()
    assert parts.pattern.Status == status.READY


@pytest.mark.parametrize("kind", [kind for kind in RepairKind if kind.is_of_intake])
def test_each_repair_of_the_intake_makes_a_pattern(parts, kind):
    """Also one that nothing in these tests happens to be advised."""
    before = parts.pattern.IntakeAngle.Value
    repairs.take(parts, Repair(kind, np.zeros((1, 2)), 1.0))
    parts.balloon.Document.recompute()
    assert parts.pattern.Status == status.READY
    assert parts.pattern.IntakeAngle.Value != before
