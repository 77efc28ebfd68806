# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever the engine raises in a recompute: the object keeps what it had and says why; the next one works.

BALLOON_FAULTS sets how many faults are tried (`make fuzz`: 200).
"""

import os
from pathlib import Path

import FreeCAD as App
import injected
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import InputError, ProgramFault

pytestmark = pytest.mark.works_out

COUNT = max(10, int(os.environ.get("BALLOON_FAULTS", "0")) // 2)
SAID = ("This is a fault of the program", "There is too little memory")
#: What is changed, and the object that it belongs to; each makes the engine work anew.
CHANGES = {
    "outline": ("Balloon", "MeshSize", (12.0, 13.0)),
    "weld": ("Balloon", "SealWidth", (5.0, 6.0)),
    "pattern": ("Pattern", "Notches", (3, 5)),
    "gas": ("Balloon", "Altitude", (100.0, 200.0)),
}


@pytest.fixture
def made(doc):
    return create.balloon_from_sketch(doc, sketches.rectangle(doc, 90, 60), mesh_size=11, correct=False)


def state(doc):
    """What must not change while it says that it is stale."""
    balloon, pattern, outline = doc.Balloon, doc.Pattern, doc.Outline
    return {
        "Outline": (outline.LoopPoints, outline.Shape.hashCode(), outline.SizeX.Value),
        "Balloon": (
            balloon.Mesh.Volume,
            balloon.SeamPoints,
            balloon.FilmPoints,
            balloon.SolvedFor,
            balloon.Report,
        ),
        "Pattern": (pattern.Shape.hashCode(), pattern.Roles, pattern.SeamLength.Value, pattern.HowToFill),
    }


@pytest.mark.slow
def test_a_fault_in_a_recompute_keeps_what_was(made):
    doc, reports = made.balloon.Document, set()
    with injected.Engine() as engine:
        places = []
        for kind, (name, key, values) in CHANGES.items():
            engine.calls.clear()
            setattr(doc.getObject(name), key, values[0])
            doc.recompute()
            places += [(kind, *place) for place in injected.chosen(engine.calls, COUNT // 4 + 1, len(places))]
        for kind, place, nth, error in places:
            what = f"{kind}: {place}, call {nth}, {error.__name__}"
            name, key, values = CHANGES[kind]
            before, obj = state(doc), doc.getObject(name)
            engine.arm(place, nth, error)
            setattr(obj, key, values[getattr(obj, key) == values[0]])
            doc.recompute()
            engine.disarm()
            after = state(doc)
            for part in made:
                if not status.is_ready(part):
                    assert any(text in part.Status for text in SAID), f"{what}: {part.Status}"
                    reports |= {path.name for path in faults.own_folder().glob("fault-*.txt")}
                    new = after["Balloon"][3] != before["Balloon"][3]
                    if part.Name != "Balloon" or not new:  # its mesh and its seam, or the new ones of both
                        assert after[part.Name] == before[part.Name], what
            obj.touch()
            for part in made:
                part.touch()
            doc.recompute()
            assert [part.Status for part in made] == [status.READY] * 3, what
    assert len(reports) > 0.4 * len(places)


def test_half_a_result_is_none(made, monkeypatch):
    """The last step fails: nothing of the new balloon is there yet."""

    def broken(*given, **named):
        raise IndexError("put in by a test")

    before = state(made.balloon.Document)
    monkeypatch.setattr("BalloonWorkbench.app.engine.film_result.store", broken)
    made.balloon.MeshSize = 9
    made.balloon.Document.recompute()
    assert SAID[0] in made.balloon.Status
    assert state(made.balloon.Document) == before


def test_the_api_names_the_file(made, monkeypatch):
    def broken(*given, **named):
        raise ZeroDivisionError("nobody foresaw this")

    monkeypatch.setattr(create, "balloon_from_sketch", broken)
    (sketch,) = made.balloon.Document.findObjects("Sketcher::SketchObject")
    with pytest.raises(ProgramFault, match="This is a fault of the program") as caught:
        BalloonWorkbench.from_sketch(made.balloon.Document, sketch)
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    told = Path(caught.value.file).read_text(encoding="utf-8")
    assert "nobody foresaw this" in told
    assert f"FreeCAD {App.Version()[0]}." in told
    with pytest.raises(TypeError):
        BalloonWorkbench.from_sketch()
    with pytest.raises(InputError):
        BalloonWorkbench.parts(sketch)


def test_what_freecad_calls_never_raises(made, monkeypatch):
    """A change that nobody foresaw is taken; FreeCAD would print a traceback else."""
    monkeypatch.setattr("BalloonWorkbench.app.balloon.follow_load", lambda obj: {}[obj.Name])
    made.balloon.Load = "Volume"
    assert made.balloon.Load == "Volume"
    (report,) = [
        path for path in faults.own_folder().glob("*.txt") if "KeyError: 'Balloon'" in path.read_text()
    ]
    assert "BalloonProxy.onChanged" in report.read_text()


def test_too_little_memory_says_so(made, monkeypatch):
    def too_much(*given, **named):
        raise MemoryError

    monkeypatch.setattr("BalloonWorkbench.app.engine.solve.design_outline", too_much)
    made.balloon.MeshSize = 9
    made.balloon.Document.recompute()
    assert "too little memory" in made.balloon.Status
    assert "coarser mesh" in made.balloon.Status
