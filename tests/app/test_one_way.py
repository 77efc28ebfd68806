# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way of the work: each change makes of trace, design, pattern and report what it changes, and once."""

from pathlib import Path

import FreeCAD as App
import pytest
import sketches
from counting import counted

from BalloonWorkbench.app.document import create

pytestmark = pytest.mark.works_out

PICTURE = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures" / "heart.png"
COARSE = {"mesh_size": 20, "correct": False}


@pytest.fixture(scope="module")
def solved():
    document = App.newDocument("OneWay")
    document.UndoMode = 1
    name = document.Name
    yield create.balloon_from_sketch(document, sketches.rectangle(document, 120, 80), **COARSE)
    App.closeDocument(name)


def test_a_balloon_from_a_picture(doc):
    with counted() as done:
        create.balloon_from_picture(doc, str(PICTURE), width=200, **COARSE)
    assert done == {"trace": 1, "design": 1, "pattern": 1, "report": 1}


def test_a_balloon_from_a_sketch(doc):
    with counted() as done:
        create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), **COARSE)
    assert done == {"design": 1, "pattern": 1, "report": 1}


@pytest.mark.parametrize(
    ("values", "work"),
    [
        ({"Pressure": 2.2}, {"design": 1, "pattern": 1, "report": 1}),
        ({"MeshSize": 18}, {"design": 1, "pattern": 1, "report": 1}),
        ({"Altitude": 500}, {"pattern": 1}),
        ({"Allowance": 3}, {"pattern": 1}),
        ({"Intake": False}, {"pattern": 1}),
        ({"LabelText": "A", "Notches": 4}, {"pattern": 1}),
        ({"Copies": 2}, {"pattern": 1}),
    ],
    ids=lambda each: "-".join(each) or "nothing",
)
def test_a_changed_value(parts, values, work):
    """What is known of the pattern was forgotten: the balloon has it made to weigh it, and nobody else."""
    with counted() as done:
        for name, value in values.items():
            setattr(parts.balloon if name in parts.balloon.PropertiesList else parts.pattern, name, value)
        parts.balloon.Document.recompute()
    assert done == work


def test_a_value_changed_and_changed_back(parts):
    doc, before = parts.balloon.Document, parts.balloon.Volume.Value
    parts.balloon.Pressure = 2.5
    doc.recompute()
    parts.balloon.Pressure = 2.0
    doc.recompute()
    with counted() as done:
        parts.balloon.Pressure = 2.5
        doc.recompute()
        parts.balloon.Pressure = 2.0
        doc.recompute()
    assert done == {"report": 2}
    assert parts.balloon.Volume.Value == before


def test_a_recompute_without_a_change(parts):
    doc = parts.balloon.Document
    with counted() as done:
        for obj in parts:
            obj.touch()
        doc.recompute()
    assert not done["trace"] + done["design"] + done["report"]
    assert done["pattern"] <= 1


def test_an_opened_document(parts, tmp_path):
    path = tmp_path / "one.FCStd"
    parts.balloon.Document.saveCopy(str(path))
    with counted() as done:
        opened = App.openDocument(str(path))
        opened.recompute()
    App.closeDocument(opened.Name)
    assert not done
