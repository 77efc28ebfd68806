# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening documents of older releases: objects lack what this release reads until they are up to date, and
FreeCAD calls their views before that."""

from pathlib import Path

import FreeCAD as App
import hands
import pytest

from BalloonWorkbench.app import artwork, film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.examples import EXAMPLES, open_copy
from BalloonWorkbench.gui.view import PatternView
from BalloonWorkbench.gui.view3d.balloon_display import MODES

KEPT = sorted(Path("tests/resources/documents").glob("*.FCStd"))
#: As old as their kinds, like links and hidden lists of points: by these an object is known, or drawn.
OLDEST = ("SchemaVersion", "Status", "SolvedFor", "KeepAspect", "IntakeKind", "Bleed", "LaidOutFor")
OLDEST += ("Drawing", "Kind")


@pytest.mark.parametrize("path", KEPT, ids=lambda path: path.stem)
def test_document_of_an_older_release_opens_without_a_fault(path):
    doc = App.openDocument(str(path.resolve()))
    hands.wait(0.2)  # the fixture no_fault looks whether one is told
    assert all(obj.ViewObject.Proxy is not None for obj in (doc.Outline, doc.Balloon, doc.Pattern))


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
def test_any_option_may_be_missing(mode, tmp_path):
    doc = open_copy(next(each for each in EXAMPLES if each.name == "painted-fish"))
    printed, sheet = artwork.make(doc.Pattern), film_sheet.make(doc, [doc.Pattern])
    doc.recompute()
    assert (printed.Status, sheet.Status) == (status.READY, status.READY)
    doc.Balloon.ViewObject.DisplayMode = mode
    hands.wait(0.1)
    names = [obj.Name for obj in (doc.Outline, doc.Balloon, doc.Pattern, printed, sheet)]
    for name in names:
        obj = doc.getObject(name)
        for item in type(obj.Proxy).properties:
            if item.name not in OLDEST and "Link" not in item.type and not item.hidden:
                obj.removeProperty(item.name)
    doc.saveAs(str(tmp_path / "older.FCStd"))
    App.closeDocument(doc.Name)
    doc = App.openDocument(str(tmp_path / "older.FCStd"))
    hands.wait(0.3)
    for name in names:
        obj = doc.getObject(name)
        assert not {item.name for item in type(obj.Proxy).properties} - set(obj.PropertiesList)


def test_lines_that_were_marks_take_their_new_colours(tmp_path, made):
    pattern = made.pattern
    pattern.Notches = 8
    pattern.Document.recompute()
    roles, colours = list(pattern.Roles), pattern.ViewObject.LineColorArray
    assert "NOTCH" in roles
    pattern.Roles = ["MARK" if role in ("NOTCH", "FOLD", "PEN") else role for role in roles]
    pattern.SchemaVersion = 1
    assert pattern.ViewObject.LineColorArray != colours
    pattern.Document.saveAs(str(tmp_path / "older.FCStd"))
    App.closeDocument(pattern.Document.Name)
    doc = App.openDocument(str(tmp_path / "older.FCStd"))
    hands.wait(0.1)
    assert isinstance(doc.Pattern.ViewObject.Proxy, PatternView)
    assert doc.Pattern.ViewObject.LineColorArray == colours
