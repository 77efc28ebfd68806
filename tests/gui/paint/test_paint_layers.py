# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two layers: a decoration is seen on the shape alone, and leaves the outline as it is."""

from pathlib import Path

import FreeCAD as App
import hands
import numpy as np
import pytest
from brush import (
    BLACK,
    BLUE,
    RED,
    YELLOW,
    Qt,
    click,
    close_window,
    colour_at,
    draw,
    ellipse,
    is_closed,
    key,
    open_window,
    press,
    rgba,
)

from BalloonWorkbench.app.drawings.drawing_file import drawn_pixels_of, file_of, pixels_of
from BalloonWorkbench.app.drawings.painting import artwork
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.paint.painting.layers import DECORATION, SHAPE
from BalloonWorkbench.gui.paint.painting.painted import Painting


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


def alpha(image):
    return pixels(image)[..., 3]


def test_a_decoration_is_clipped_to_the_shape_and_has_its_own_steps(window):
    painting = window.painting
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2), let_live=False)
    before = pixels(painting.image)
    assert not window.extras.note.isVisible()
    press("PaintMore")
    assert window.extras.note.text() == "You paint on: Shape"
    press("PaintLayerDecoration")
    assert window.extras.note.isVisible()
    assert window.extras.note.text() == "You paint on: Decoration"
    press(f"PaintColour{RED}")
    press("PaintBrush")
    draw(window.canvas, [(0.1, 0.5), (0.9, 0.5)], let_live=False)
    assert colour_at(window, 0.5, 0.5) == rgba(RED)  # bare film inside the line
    assert colour_at(window, 0.2, 0.5) == rgba(RED)  # on the line
    assert colour_at(window, 0.12, 0.5)[3] == 0  # beside the shape
    assert (alpha(painting.layers[SHAPE]) == before[..., 3]).all()
    press("PaintFill")
    press(f"PaintColour{YELLOW}")
    click(window.canvas, (0.5, 0.4))
    assert colour_at(window, 0.5, 0.4) == rgba(YELLOW)
    assert colour_at(window, 0.5, 0.6)[3] == 0  # the other side of the stripe
    assert colour_at(window, 0.5, 0.5) == rgba(RED)
    press("PaintEraser")
    draw(window.canvas, [(0.2, 0.5), (0.5, 0.5)], let_live=False)
    assert colour_at(window, 0.5, 0.5)[3] == 0  # film, but the line stays
    assert colour_at(window, 0.2, 0.5) == rgba(BLACK)
    after = pixels(painting.image)
    for _ in range(3):
        press("PaintUndo")
    assert (pixels(painting.image) == before).all()
    for _ in range(3):
        press("PaintRedo")
    assert (pixels(painting.image) == after).all()
    key(window.canvas, Qt.Key_D, "d")
    assert window.hand.layer == SHAPE
    press("PaintClear")
    assert painting.is_empty()
    assert not alpha(painting.layers[DECORATION]).any()


def test_without_a_shape_it_says_that_there_is_nothing_to_decorate(window):
    key(window.canvas, Qt.Key_D, "d")
    assert window.form.hint.text().startswith("Paint a shape first")
    draw(window.canvas, [(0.3, 0.5), (0.6, 0.5)], let_live=False)
    assert window.painting.is_empty()
    press("PaintMake")
    assert not window.making


@pytest.mark.slow
@pytest.mark.works_out
def test_the_outline_in_the_document_does_not_see_the_decoration(doc, window, tmp_path):
    """A ring drawn with the pen, whose inside is bare, is decorated so that it would be another drawing."""
    window._is_sized = True
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.wait_until(window.live.is_settled, 60)
    plain = window.live.latest
    key(window.canvas, Qt.Key_D, "d")
    press("PaintBrush")
    press(f"PaintColour{BLUE}")
    window.actions.thickness.setValue(50)
    draw(window.canvas, ellipse(0.5, 0.5, 0.2, 0.12))
    hands.wait_until(window.live.is_settled, 60)
    decorated = window.live.latest
    assert decorated.skins is plain.skins
    assert all((a == b).all() for a, b in zip(plain.loops, decorated.loops, strict=True))
    seen = pixels(window.painting.image)
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    file = file_of(doc.Outline.Drawing)
    assert (pixels_of(file) == seen).all()
    assert (drawn_pixels_of(file)[..., 3] != seen[..., 3]).any()
    assert doc.Outline.SizeY.Value == pytest.approx(decorated.size[1], rel=0.01)
    assert len(doc.Outline.LoopCounts) == 1
    assert (artwork(doc.Outline).rgba == seen).all()
    hands.press("Cancel")
    path = str(tmp_path / "decorated.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    doc.Outline.touch()
    doc.recompute()
    assert len(doc.Outline.LoopCounts) == 1
    again = Painting()
    again.load(Path(doc.Outline.Drawing))
    assert (pixels(again.image) == seen).all()
    assert [step.layer for step in again.steps] == [SHAPE, DECORATION]
    doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    assert (pixels(paint_window._open[0].painting.image) == seen).all()


def test_widening_moves_the_decoration_too():
    from BalloonWorkbench.gui.paint.painting.strokes import PEN, PaintStroke
    from BalloonWorkbench.gui.paint.painting.widen import Widen

    painting = Painting()
    painting.do(PaintStroke(PEN, BLUE, points=[(200.0, 500.0, 20.0), (800.0, 500.0, 20.0)]))
    painting.do(PaintStroke(PEN, RED, points=[(200.0, 500.0, 20.0), (800.0, 500.0, 20.0)], layer=DECORATION))
    painting.do(Widen([(300.0, 500.0), (700.0, 500.0)], 20.0, 60.0))
    for layer in painting.layers.values():
        assert (alpha(layer)[:, 500] > 127).sum() == pytest.approx(60, abs=2)
    assert np.array_equal(pixels(painting.image)[520, 500], rgba(RED))
