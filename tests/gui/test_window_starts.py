# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window stands and draws."""

import FreeCAD
import FreeCADGui
import Part
import pytest
from PySide import QtGui


@pytest.fixture
def document():
    document = FreeCAD.newDocument("WindowStarts")
    yield document
    FreeCAD.closeDocument(document.Name)


def test_window_is_visible() -> None:
    assert FreeCADGui.getMainWindow().isVisible()


def test_view_draws_an_object(document, tmp_path) -> None:
    box = document.addObject("Part::Feature", "Box")
    box.Shape = Part.makeBox(10, 10, 10)
    box.ViewObject.ShapeColor = (1.0, 0.0, 0.0)
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).ActiveView
    view.fitAll()
    picture = tmp_path / "view.png"
    view.saveImage(str(picture), 100, 100, "White")
    image = QtGui.QImage(str(picture))
    colours = [QtGui.QColor(image.pixel(x, y)) for x in range(0, 100, 5) for y in range(0, 100, 5)]
    # FreeCAD 1.0 has so much light that pure red comes out as #ff9999
    assert any(colour.red() > 1.5 * max(colour.green(), colour.blue()) for colour in colours)
