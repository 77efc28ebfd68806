# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window: a fish drawn with the mouse becomes a balloon, while the window answers."""

import math
import os
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app import status
from BalloonWorkbench.app.painting import is_painting
from BalloonWorkbench.app.qt_picture import pixels
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.paint.painting import SIDE

Qt, QEvent = hands.QtCore.Qt, hands.QtCore.QEvent
HEART = Path("resources/examples/pictures/heart.png").resolve()
BLUE, YELLOW, RED, BLACK = "#1f78d8", "#ffd21f", "#e01b3c", "#1c1c22"


class Heartbeat:
    """How long the window was deaf at most, and how much of that by our own doing.

    Other programs of a busy machine make the wall clock run on; own is what this process did meanwhile, with
    all cores at its service.
    """

    def __init__(self):
        self._timer = hands.QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)
        self.reset()

    def _beat(self):
        now, done = time.perf_counter(), time.process_time()
        self.longest = max(self.longest, now - self._last)
        self._owns.append(min(now - self._last, (done - self._done) / (os.cpu_count() or 1)))
        self._last, self._done = now, done

    @property
    def own(self):
        """Of all beats but one in a hundred: the 3D view without a graphics card draws slowly at times."""
        return sorted(self._owns)[int(0.99 * len(self._owns))]

    def stop(self):
        self._timer.stop()

    def reset(self):
        self.longest, self._owns = 0.0, []
        self._last, self._done = time.perf_counter(), time.process_time()


@pytest.fixture
def beat():
    heart = Heartbeat()
    yield heart
    heart.stop()


@pytest.fixture
def window(doc):
    Gui.runCommand("BalloonWorkbench_Paint")
    hands.wait_until(lambda: bool(paint_window._open))
    opened = paint_window._open[0]
    hands.wait_until(lambda: opened.canvas.isVisible() and opened.canvas.width() > 500)
    yield opened
    if paint_window._open:
        paint_window._open[0].finish()


def mouse(canvas, kind, place, button=Qt.LeftButton, held=Qt.LeftButton):
    """One mouse event at a place of the paper, 0 to 1, y down."""
    at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    there = hands.QtCore.QPointF(canvas.mapToGlobal(at.toPoint()))
    event = hands.QtGui.QMouseEvent(kind, at, at, there, button, held, Qt.NoModifier)
    hands.QtWidgets.QApplication.sendEvent(canvas, event)


def tablet(canvas, kind, place, pressure, rubber=False):
    """One event of a tablet's pen, or of its rubber end."""
    gui = hands.QtGui
    at = canvas.paper.to_screen(hands.QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    there = hands.QtCore.QPointF(canvas.mapToGlobal(at.toPoint()))
    button = Qt.LeftButton if kind != QEvent.TabletMove else Qt.NoButton
    held = Qt.NoButton if kind == QEvent.TabletRelease else Qt.LeftButton
    if hasattr(gui, "QPointingDevice"):  # Qt 6
        types = gui.QPointingDevice.PointerType
        device = gui.QPointingDevice(
            "pen",
            1,
            gui.QInputDevice.DeviceType.Stylus,
            types.Eraser if rubber else types.Pen,
            gui.QInputDevice.Capability.Pressure,
            1,
            2,
        )
        event = gui.QTabletEvent(
            kind, device, at, there, pressure, 0.0, 0.0, 0.0, 0.0, 0.0, Qt.NoModifier, button, held
        )
    else:
        end = gui.QTabletEvent.Eraser if rubber else gui.QTabletEvent.Pen
        event = gui.QTabletEvent(
            kind,
            at,
            there,
            gui.QTabletEvent.Stylus,
            end,
            pressure,
            0,
            0,
            0.0,
            0.0,
            0,
            Qt.NoModifier,
            1,
            button,
            held,
        )
    hands.QtWidgets.QApplication.sendEvent(canvas, event)


def draw(canvas, places, let_live=True):
    """One stroke with the left button, as fast as a hand."""
    mouse(canvas, QEvent.MouseButtonPress, places[0])
    for place in places[1:]:
        mouse(canvas, QEvent.MouseMove, place, Qt.NoButton)
        if let_live:
            hands.wait(0.008)
    mouse(canvas, QEvent.MouseButtonRelease, places[-1], held=Qt.NoButton)


def click(canvas, place):
    draw(canvas, [place])


def key(canvas, code, text="", modifiers=Qt.NoModifier):
    """A key the way the system sends it; FreeCAD must leave it to the canvas."""
    asked = hands.QtGui.QKeyEvent(QEvent.ShortcutOverride, code, modifiers, text)
    asked.ignore()
    hands.QtWidgets.QApplication.sendEvent(canvas, asked)
    assert asked.isAccepted()
    hands.QtWidgets.QApplication.sendEvent(
        canvas, hands.QtGui.QKeyEvent(QEvent.KeyPress, code, modifiers, text)
    )


def ellipse(x, y, a, b, count=40):
    turn = [2 * math.pi * k / count for k in range(count + 1)]
    return [(x + a * math.cos(angle), y + b * math.sin(angle)) for angle in turn]


def colour_at(window, x, y):
    image = window.painting.image
    return tuple(pixels(image)[int(y * SIDE), int(x * SIDE)].tolist())


def rgba(colour):
    return (*(int(colour[k : k + 2], 16) for k in (1, 3, 5)), 255)


def press(name):
    hands.click(hands.find(name))


def fish_body(window):
    press(f"PaintColour{BLUE}")
    draw(window.canvas, ellipse(0.44, 0.5, 0.30, 0.19))


def settled(window):
    hands.wait_until(window.live.is_settled, 40)


def test_a_fish_is_painted_and_made(doc, window, beat):
    beat.reset()
    canvas, live = window.canvas, window.live
    assert canvas.width() > 0.3 * Gui.getMainWindow().width()
    fish_body(window)
    hands.wait_until(window.scene.is_shown, 5)
    assert live.latest.solved is None  # a glance; nothing was waited for
    body = live.latest.volume
    tail = [(0.70, 0.5), (0.88, 0.34), (0.85, 0.5), (0.88, 0.66), (0.70, 0.5)]
    draw(canvas, tail)
    hands.wait_until(lambda: live.latest.volume != body, 5)
    press("PaintFill")
    press(f"PaintColour{YELLOW}")
    click(canvas, (0.44, 0.5))
    press(f"PaintColour{RED}")
    click(canvas, (0.82, 0.5))
    assert colour_at(window, 0.44, 0.5) == rgba(YELLOW)
    assert colour_at(window, 0.82, 0.5) == rgba(RED)
    press("PaintPen")
    press(f"PaintColour{BLACK}")
    for x, y, r in ((0.26, 0.44, 0.022),):
        draw(canvas, ellipse(x, y, r, r, 12))
    draw(canvas, [(0.16, 0.55), (0.20, 0.57), (0.25, 0.57)])
    press("PaintBrush")
    press("PaintColour#ff8c1a")
    for x in (0.42, 0.52, 0.62):
        draw(canvas, [(x, 0.38 + 0.02), (x + 0.02, 0.5), (x, 0.6 - 0.02)])
        hands.wait(0.5)
    hands.wait_until(lambda: not live.is_settled() and live.latest is not None, 5)
    hands.screenshot("paint-glance")
    settled(window)
    image = hands.screenshot("paint-fish")
    assert painted_in_view(image, right_of(window))
    delays = list(live.delays)
    record("painting", beat, delays)
    assert doc.Objects == []
    assert beat.own < 0.1
    beat.reset()
    press("PaintMake")
    hands.wait_until(lambda: not paint_window._open, 40)
    record("making", beat)
    assert doc.UndoNames == ["Paint a balloon"]
    assert [obj.Status for obj in (doc.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    assert doc.Balloon.Mesh.isSolid()
    assert doc.Outline.SizeX.Value == pytest.approx(300, abs=1)
    assert doc.Balloon.ResidualMean.Value < 3
    assert is_painting(doc.Outline.Drawing)
    hands.wait(0.2)
    hands.wait(0.5)
    image = hands.screenshot("paint-made")
    assert painted_in_view(image, image.width() // 4)
    doc.undo()
    assert doc.Objects == []
    doc.redo()
    assert doc.Balloon.Mesh.isSolid()
    assert min(delays) < 0.15 * others()  # the others had to share the machine even more


def others():
    """How much longer everything takes because of what else the machine does: 1 on an idle one."""
    return max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))


def record(what, beat, delays=()):
    """Keep what was measured beside the screenshots."""
    line = f"{what}: deaf for {1e3 * beat.longest:.0f} ms at most, {1e3 * beat.own:.0f} ms by our own work;"
    line += f" glances after {[round(1e3 * delay) for delay in delays]} ms; {others():.1f} times as busy"
    with (hands.SCREENSHOTS / "paint.txt").open("a") as file:
        file.write(line + "\n")


def right_of(window):
    return window.mapToGlobal(window.rect().topRight()).x() + 20


def painted_in_view(image, left):
    """The balloon in the 3D view has the colours of the painting."""
    colours = [
        hands.QtGui.QColor(image.pixel(x, y))
        for x in range(left, image.width() - 20, 4)
        for y in range(150, image.height() - 150, 4)
    ]
    yellow = sum(c.red() > 150 and c.green() > 120 and c.blue() < 110 for c in colours)
    red = sum(c.red() > 120 and c.green() < 70 and c.blue() < 100 for c in colours)
    return yellow > 300 and red > 60


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
    assert not canvas.hand.mirror
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
    hands.wait_until(lambda: "it is a line" in window.form.hint.text(), 5)
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


def test_a_click_widens_an_arm_that_is_too_thin(window):
    canvas = window.canvas
    press(f"PaintColour{RED}")
    arm = [(0.46, 0.494), (0.60, 0.494)]
    left, right = dot(0.3, 0.5, 0.18, 3, 357), dot(0.75, 0.5, 0.15, 178, -178)
    draw(canvas, [*arm, *right, (0.60, 0.506), (0.46, 0.506), *left])
    hands.wait_until(lambda: canvas.thin.asked() is not None, 20)
    remark = canvas.thin.remarks[canvas.thin.asked()]
    assert "too thin" in remark.question
    before = arm_width(window)
    assert abs(remark.step.was - before) < 4
    image = hands.screenshot("paint-thin")
    steps = len(window.painting.steps)
    place = canvas.thin.question_place()
    for kind, held in ((QEvent.MouseButtonPress, Qt.LeftButton), (QEvent.MouseButtonRelease, Qt.NoButton)):
        there = hands.QtCore.QPointF(canvas.mapToGlobal(place.toPoint()))
        event = hands.QtGui.QMouseEvent(kind, place, place, there, Qt.LeftButton, held, Qt.NoModifier)
        hands.QtWidgets.QApplication.sendEvent(canvas, event)
    assert len(window.painting.steps) == steps + 1
    assert arm_width(window) == pytest.approx(before + remark.step.wanted - remark.step.was, abs=3)
    wide = pixels(window.painting.image)
    hands.wait_until(window.live.is_settled, 40)
    hands.screenshot("paint-widened")
    assert not [told for told in canvas.thin.remarks if told.step is not None]
    press("PaintUndo")
    assert arm_width(window) == before
    press("PaintRedo")
    assert (pixels(window.painting.image) == wide).all()
    assert image.width() > 0


def arm_width(window):
    """Of the arm in the middle, with its lines, in px."""
    inked = pixels(window.painting.image)[:, 540, 3] > 127
    rows = [row for row in range(300, 700) if inked[row]]
    return rows[-1] - rows[0] + 1


def dot(x, y, r, start, end, count=30):
    """Part of a circle, angles in degrees, y down."""
    turns = [math.radians(start + (end - start) * k / count) for k in range(count + 1)]
    return [(x + r * math.cos(turn), y + r * math.sin(turn)) for turn in turns]


def test_a_picture_is_paint_or_backdrop(window):
    window.pictures.lay_under(HEART)
    assert window.painting.is_empty()
    grabbed = window.canvas.grab().toImage()
    middle = hands.QtGui.QColor(grabbed.pixel(grabbed.width() // 2, grabbed.height() // 2))
    assert middle.green() < 230
    press("PaintBackdrop")
    assert window.painting.backdrop is None
    window.pictures.put_on(HEART)
    hands.wait_until(lambda: not window.painting.is_empty(), 10)
    assert colour_at(window, 0.02, 0.02)[3] == 0
    assert colour_at(window, 0.5, 0.5)[3] == 255
    hands.wait_until(window.scene.is_shown, 5)
    window.pictures.put_on(Path("README.md"))
    assert "not a picture" in window.form.hint.text()


def test_painting_comes_back_by_double_click(doc, window, tmp_path):
    press(f"PaintColour{RED}")
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.type_into(window.form.width_field, "200 mm")
    press("PaintMake")
    hands.wait_until(lambda: not paint_window._open, 40)
    height = doc.Outline.SizeY.Value
    assert doc.Outline.SizeX.Value == pytest.approx(200, abs=1)
    path = str(tmp_path / "painted.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    assert doc.Balloon.ViewObject.DisplayMode == "Painted"
    assert doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    again = paint_window._open[0]
    hands.wait_until(again.scene.is_shown, 10)
    assert len(again.painting.steps) == 1
    assert again.live.width == pytest.approx(200)
    assert not doc.Balloon.ViewObject.Visibility
    draw(again.canvas, ellipse(0.5, 0.65, 0.12, 0.22))
    press("PaintMake")
    hands.wait_until(lambda: not paint_window._open, 40)
    assert doc.Outline.SizeY.Value > 1.1 * height
    assert doc.Balloon.ViewObject.Visibility
    assert [obj.Status for obj in (doc.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    doc.undo()
    doc.recompute()
    assert doc.Outline.SizeY.Value == pytest.approx(height, abs=0.1)
    doc.Outline.ViewObject.Proxy.doubleClicked(doc.Outline.ViewObject)
    hands.wait_until(paint_window._open[0].scene.is_shown, 10)
    App.closeDocument(doc.Name)
    hands.wait_until(lambda: not paint_window._open, 5)


def test_closing_keeps_the_painting_and_deleting_the_document_closes(doc, window):
    fish_body(window)
    window.close()
    assert not window.scene.is_shown()
    Gui.runCommand("BalloonWorkbench_Paint")
    assert paint_window._open == [window]
    assert len(window.painting.steps) == 1
    App.closeDocument(doc.Name)
    hands.wait_until(lambda: not paint_window._open, 5)
