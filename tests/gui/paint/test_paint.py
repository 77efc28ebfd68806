# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tools of the paint window: what the hand does is on the paper, and can be taken back."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from brush import (
    BLACK,
    BLUE,
    RED,
    QEvent,
    Qt,
    arc,
    click,
    close_window,
    colour_at,
    draw,
    ellipse,
    fish_body,
    is_closed,
    key,
    mouse,
    mouse_at,
    open_window,
    press,
    rgba,
    tablet,
)
from pictures import framed, picture

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.paint.painting.layers import SIDE

HEART = Path("resources/examples/pictures/heart.png").resolve()


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


@pytest.fixture
def framed_window(doc):
    with framed():
        yield open_window()
        close_window()


def test_undo_redo_mirror_zoom_and_keys(window):
    canvas, painting = window.canvas, window.painting
    fish_body(window)
    before = pixels(painting.image)
    press("PaintMirror")
    draw(canvas, [(0.1, 0.2), (0.2, 0.1)])
    after = pixels(painting.image)
    assert colour_at(window, 0.1, 0.2) == colour_at(window, 0.9, 0.2) == rgba(BLUE)
    press("PaintUndo")
    assert (pixels(painting.image) == before).all()
    key(canvas, Qt.Key_Y, modifiers=Qt.ControlModifier)
    assert (pixels(painting.image) == after).all()
    key(canvas, Qt.Key_Z, modifiers=Qt.ControlModifier)
    key(canvas, Qt.Key_M, "m")
    key(canvas, Qt.Key_E, "e")
    assert canvas.hand.tool.name == "eraser"
    assert not canvas.hand.symmetry.mirror
    draw(canvas, [(0.14, 0.5), (0.15, 0.5)])
    assert colour_at(window, 0.14, 0.5)[3] == 0
    for _ in range(20):  # beyond the copies that undo begins from
        key(canvas, Qt.Key_P, "p")
        draw(canvas, [(0.5, 0.5), (0.55, 0.5)], let_live=False)
    for _ in range(22):
        press_undo(window)
    assert window.painting.is_empty()
    assert not hands.find("PaintUndo").isEnabled()
    place, zoom = hands.QtCore.QPointF(300, 200), canvas.paper.zoom
    fixed = canvas.paper.to_paper(place)
    wheel(canvas, place, 240)
    assert canvas.paper.zoom == pytest.approx(zoom * 1.5625)
    assert (canvas.paper.to_paper(place) - fixed).manhattanLength() < 1e-6
    held = canvas.paper.to_paper(place)
    for kind, at in (
        (QEvent.MouseButtonPress, 0.5),
        (QEvent.MouseMove, 0.6),
        (QEvent.MouseButtonRelease, 0.6),
    ):
        mouse(canvas, kind, (at, at), Qt.MiddleButton, Qt.MiddleButton)
    assert (canvas.paper.to_paper(place) - held).manhattanLength() > 50
    press("PaintFit")
    assert canvas.paper.zoom == pytest.approx(zoom)


def press_undo(window):
    window.actions.buttons["undo"].click()


def wheel(canvas, place, turn):
    there = hands.QtCore.QPointF(canvas.mapToGlobal(place.toPoint()))
    event = hands.QtGui.QWheelEvent(
        place,
        there,
        hands.QtCore.QPoint(0, 0),
        hands.QtCore.QPoint(0, turn),
        Qt.NoButton,
        Qt.NoModifier,
        Qt.NoScrollPhase,
        False,
    )
    hands.QtWidgets.QApplication.sendEvent(canvas, event)


def test_a_fill_does_not_run_out_and_a_line_bends(window):
    canvas = window.canvas
    press("PaintFill")
    click(canvas, (0.5, 0.5))
    assert window.painting.is_empty()
    assert "close the line" in window.form.hint.text()
    press("PaintLine")
    draw(canvas, [(0.2, 0.6), (0.5, 0.6), (0.8, 0.6)])
    assert canvas.hand.stroke is not None
    mouse(canvas, QEvent.MouseMove, (0.5, 0.3), Qt.NoButton, Qt.NoButton)
    click(canvas, (0.5, 0.3))
    assert canvas.hand.stroke is None
    assert colour_at(window, 0.5, 0.3) == rgba(BLACK)
    assert colour_at(window, 0.5, 0.6)[3] == 0
    hands.wait_until(lambda: "it is a line" in window.form.hint.text(), 30)
    assert not window.scene.is_shown()
    press("PaintMake")  # nothing can be made of it, and it says so
    hands.wait_until(lambda: not window.making, 20)
    assert App.ActiveDocument.Objects == []


def test_pressure_of_a_tablet_is_the_width(window):
    canvas, thickness = window.canvas, window.hand.thickness
    tablet(canvas, QEvent.TabletPress, (0.2, 0.3), 1.0)
    for x in range(220, 800, 20):
        tablet(canvas, QEvent.TabletMove, (x / SIDE, 0.3), 1.0 if x < 500 else 0.1)
    tablet(canvas, QEvent.TabletRelease, (0.78, 0.3), 0.0)
    assert len(window.painting.steps) == 1
    ink = pixels(window.painting.image)[..., 3] > 127
    assert ink[:, 300].sum() == pytest.approx(thickness, abs=1)
    assert ink[:, 700].sum() == pytest.approx(0.55 * thickness, abs=1)
    for kind, x in ((QEvent.TabletPress, 0.4), (QEvent.TabletMove, 0.5), (QEvent.TabletRelease, 0.5)):
        tablet(canvas, kind, (x, 0.3), 1.0, rubber=True)
    ink = pixels(window.painting.image)[..., 3] > 127
    assert not ink[:, 450].any()
    assert ink[:, 300].any()


def test_nothing_lies_over_the_canvas_of_a_small_window(doc):
    with framed((1280, 720)):
        canvas = open_window().canvas
        hands.wait(0.5)
        room = canvas.rect().adjusted(2, 2, -2, -2)
        for y in range(room.top(), room.bottom(), 4):
            place = canvas.mapToGlobal(hands.QtCore.QPoint(room.right(), y))
            assert hands.QtWidgets.QApplication.widgetAt(place) is canvas
        close_window()


@pytest.mark.slow
def test_a_click_widens_an_arm_that_is_too_thin(framed_window):
    window = framed_window
    canvas = window.canvas
    press(f"PaintColour{RED}")
    arm = [(0.46, 0.496), (0.60, 0.496)]
    left, right = arc(0.3, 0.5, 0.18, 3, 357), arc(0.75, 0.5, 0.15, 178, -178)
    draw(canvas, [*arm, *right, (0.60, 0.504), (0.46, 0.504), *left])
    hands.wait_until(window.card.isVisible, 30)
    press("PaintSizeDone")
    hands.wait_until(lambda: canvas.thin.asked() is not None, 30)
    remark = canvas.thin.remarks[canvas.thin.asked()]
    assert "too thin" in remark.question
    before = arm_width(window)
    assert abs(remark.step.was - before) < 4
    picture("tutorial-thin")
    steps = len(window.painting.steps)
    place = canvas.thin.question_place()
    mouse_at(canvas, QEvent.MouseButtonPress, place)
    mouse_at(canvas, QEvent.MouseButtonRelease, place, held=Qt.NoButton)
    assert len(window.painting.steps) == steps + 1
    assert arm_width(window) == pytest.approx(before + remark.step.widened - remark.step.was, abs=3)
    wide = pixels(window.painting.image)
    hands.wait_until(window.live.is_settled, 60)
    assert not [told for told in canvas.thin.remarks if told.step is not None]
    press("PaintUndo")
    assert arm_width(window) == before
    hands.wait_until(lambda: canvas.thin.asked() is not None, 30)
    hands.wait_until(lambda: not canvas.thin._cross.isEmpty(), 5)
    mouse_at(canvas, QEvent.MouseButtonPress, canvas.thin._cross.center())
    mouse_at(canvas, QEvent.MouseButtonRelease, canvas.thin._cross.center(), held=Qt.NoButton)
    assert canvas.thin.asked() is None  # no, thank you
    assert arm_width(window) == before
    press("PaintRedo")
    assert (pixels(window.painting.image) == wide).all()


def arm_width(window):
    """Of the arm in the middle, with its lines, in px."""
    inked = pixels(window.painting.image)[:, 540, 3] > 127
    rows = [row for row in range(300, 700) if inked[row]]
    return rows[-1] - rows[0] + 1


@pytest.mark.works_out
def test_making_is_stopped_and_the_painting_stays(window):
    press(f"PaintColour{RED}")
    draw(window.canvas, ellipse(0.5, 0.5, 0.35, 0.2))
    press("PaintMake")
    stop = "BalloonStop"
    hands.wait_until(
        lambda: any(b.objectName() == stop for b in hands.visible(hands.QtWidgets.QPushButton)), 30
    )
    button = next(b for b in hands.visible(hands.QtWidgets.QPushButton) if b.objectName() == stop)
    hands.click(button)
    hands.wait_until(lambda: not window.making, 10)
    assert "Stopped" in window.form.hint.text()
    assert not is_closed()
    assert len(window.painting.steps) == 1
    assert window.doc.Objects == []
    assert window.form.make_button.isEnabled()


def test_a_picture_is_paint_or_backdrop(window):
    window.pictures.lay_under(HEART)
    assert window.painting.is_empty()
    grabbed = window.canvas.grab().toImage()
    middle = hands.QtGui.QColor(grabbed.pixel(grabbed.width() // 2, grabbed.height() // 2))
    assert middle.green() < 230
    press("PaintBackdrop")
    assert window.painting.backdrop is None
    window.pictures.put_on(HEART)
    hands.wait_until(lambda: not window.painting.is_empty(), 30)
    assert colour_at(window, 0.02, 0.02)[3] == 0
    assert colour_at(window, 0.5, 0.5)[3] == 255
    hands.wait_until(window.scene.is_shown, 30)
    window.pictures.put_on(Path("README.md"))
    assert "not a picture" in window.form.hint.text()


@pytest.mark.slow
def test_painting_comes_back_by_double_click(doc, window, tmp_path):
    press(f"PaintColour{RED}")
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.type_into(window.form.width_field, "200 mm")
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    height = doc.Outline.SizeY.Value
    assert doc.Outline.SizeX.Value == pytest.approx(200, abs=1)
    path = str(tmp_path / "painted.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    assert doc.Balloon.ViewObject.DisplayMode == "Painted"
    assert doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    again = paint_window._open[0]
    hands.wait_until(again.scene.is_shown, 30)
    assert len(again.painting.steps) == 1
    assert again.live.width == pytest.approx(200)
    assert not doc.Balloon.ViewObject.Visibility
    draw(again.canvas, ellipse(0.5, 0.65, 0.12, 0.22))
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    assert doc.Outline.SizeY.Value > 1.1 * height
    assert doc.Balloon.ViewObject.Visibility
    assert [obj.Status for obj in (doc.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    doc.undo()
    doc.recompute()
    assert doc.Outline.SizeY.Value == pytest.approx(height, abs=0.1)
    doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    hands.wait_until(paint_window._open[0].scene.is_shown, 30)
    App.closeDocument(doc.Name)
    hands.wait_until(is_closed, 30)


def test_closing_keeps_the_painting_and_deleting_the_document_closes(doc, window):
    fish_body(window)
    window.close()
    assert not window.scene.is_shown()
    Gui.runCommand("BalloonWorkbench_Paint")
    assert paint_window._open == [window]
    assert len(window.painting.steps) == 1
    App.closeDocument(doc.Name)
    hands.wait_until(is_closed, 30)
