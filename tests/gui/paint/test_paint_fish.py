# SPDX-License-Identifier: LGPL-2.1-or-later
"""As used: a fish is drawn with the mouse, becomes a balloon, is made smaller, saved, opened again and cut,
while the window answers throughout."""

import os
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from brush import (
    BLACK,
    BLUE,
    RED,
    click,
    close_window,
    colour_at,
    draw,
    draw_for_real,
    is_closed,
    open_window,
    press,
    rgba,
)
from heartbeat import Heartbeat
from pictures import framed, picture
from pointer import Pointer
from read_back import pages_of

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.drawings.drawing_file import is_painting
from BalloonWorkbench.app.drawings.painting import artwork
from BalloonWorkbench.gui.paint.preview.live_preview import LivePreview

sys.path.append(str(Path(__file__).resolve().parents[3] / "tools"))

import fish_painting as fish

pytestmark = pytest.mark.works_out


@pytest.fixture
def window(doc):
    with framed():
        yield open_window()
        close_window()


@pytest.fixture
def beat():
    heart = Heartbeat()
    yield heart
    heart.stop()


@pytest.fixture
def pointer():
    mouse = Pointer()
    yield mouse
    mouse.close()


@pytest.fixture
def studied(monkeypatch):
    """Processor time of each full design, beside those of the quick previews in `LivePreview.delays`."""
    found, done = [], LivePreview._full_design_done

    def listen(live, worker):
        if worker.design is not None:
            found.append(worker.work)
        done(live, worker)

    monkeypatch.setattr(LivePreview, "_full_design_done", listen)
    return found


@pytest.mark.slow
def test_a_fish_from_the_first_stroke_to_the_cutter(doc, window, beat, pointer, studied, tmp_path):
    glances = paint(window, beat, pointer)
    record("painting", beat, glances, new_view=True)
    # coarse and quick, then fine: what the user waits for is a small part of the work
    assert sorted(work for _, work in glances)[len(glances) // 2] < 0.2 * min(studied)

    press("PaintMake")
    hands.wait_until(is_closed, 60)
    hands.wait_until(hands.panel_is_seen)
    record("making", beat, new_view=True)  # the first pictures of the objects
    assert doc.UndoNames == ["Paint a balloon"]
    assert_made(doc, 250)
    assert is_painting(doc.Outline.Drawing)
    hands.wait(0.5)
    hands.type_into(hands.find("File"), "fish.pdf", confirm=False)
    image = picture("tutorial-made")
    assert painted_in_view(image, image.width() // 4)
    beat.skip()
    print_on_a4(tmp_path / "fish.pdf")
    doc.undo()
    assert doc.Objects == []
    doc.redo()
    assert_made(doc, 250)

    doc.Balloon.ViewObject.Proxy.doubleClicked(doc.Balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    picture("tutorial-panel")
    beat.skip()
    hands.type_into(hands.find("Width"), "200 mm")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    record("another width", beat)
    assert_made(doc, 200)
    for step, width in ((doc.undo, 250), (doc.redo, 200)):
        step()
        hands.wait(0.05)
        doc.recompute()
        hands.wait(0.05)
        assert_made(doc, width)
    record("undone and redone", beat)

    doc = reopened(doc, str(tmp_path / "fish.FCStd"), beat)
    assert_made(doc, 200)
    assert doc.Balloon.ViewObject.DisplayMode == "Painted"
    hands.wait(0.5)
    record("saved and opened", beat, new_view=True)
    image = picture("reopened")
    assert painted_in_view(image, image.width() // 4)
    the_artwork_lies_on_the_outline(doc)
    beat.skip()
    cut(doc, tmp_path / "fish.dxf", beat)
    record("export", beat)


def paint(window, beat, pointer):
    """The fish of the examples, stroke by stroke; returns what each glance took, see `LivePreview.delays`."""
    beat.reset()
    canvas, live, doc = window.canvas, window.live, window.doc
    assert canvas.width() > 0.3 * Gui.getMainWindow().width()
    press(f"PaintColour{BLUE}")
    draw_for_real(pointer, canvas, fish.RIM)
    hands.wait_until(window.scene.is_shown, 30)
    assert live.latest.solved is None  # a glance; nothing was waited for
    hands.wait_until(window.card.isVisible, 30)
    assert canvas.scale.is_visible
    picture("tutorial-first-stroke")
    beat.skip()
    hands.type_into(window.card.field, "25")
    press("PaintSizeDone")
    assert not window.card.isVisible()
    assert live.width == pytest.approx(250)
    draw_for_real(pointer, canvas, fish.TAIL_LINE)
    press("PaintFill")
    for x, y, colour in fish.FILLS:
        press(f"PaintColour{colour}")
        click(canvas, (x, y))
        assert colour_at(window, x, y) == rgba(colour)
    press("PaintBrush")
    press(f"PaintColour{RED}")
    for stripe in fish.STRIPES:
        before = len(live.delays)
        draw_for_real(pointer, canvas, stripe)
        hands.wait_until(lambda before=before: len(live.delays) > before, 30)
    press("PaintPen")
    press(f"PaintColour{BLACK}")
    for line in (fish.EYE, fish.PUPIL, fish.MOUTH):
        draw(canvas, line)
    hands.wait_until(live.is_settled, 60)
    image = picture("tutorial-painted")
    beat.skip()
    assert painted_in_view(image, window.mapToGlobal(window.rect().topRight()).x() + 20)
    assert doc.Objects == []  # the document waits
    assert len(live.delays) >= len(fish.STRIPES)
    return list(live.delays)


def assert_made(doc, width):
    """Outline, mesh and pattern are there and so wide in mm."""
    assert [obj.Status for obj in (doc.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    assert doc.Balloon.isDerivedFrom("Mesh::Feature")
    assert doc.Balloon.Mesh.isSolid()
    assert doc.Outline.SizeX.Value == pytest.approx(width, abs=1)
    assert doc.Balloon.InflatedWidth.Value == pytest.approx(width, rel=0.02)
    assert doc.Balloon.ResidualMean.Value < 0.01 * width


def print_on_a4(path):
    """The panel that opens by itself writes the pattern in real size on A4."""
    assert hands.find("Pages").currentText() == "A4"
    hands.type_into(hands.find("File"), str(path), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    count, size = pages_of(path)
    assert count >= 2
    assert sorted(size) == pytest.approx([210, 297], abs=0.05)


def reopened(doc, path, beat):
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    hands.wait(0.2)
    beat.reset()  # FreeCAD writes, reads and shows a file in one go
    return again


def the_artwork_lies_on_the_outline(doc):
    """Colours painted inside are kept, with their place: those of the body and the tail."""
    art = artwork(doc.Outline)
    height, width = art.rgba.shape[:2]
    points = [(0.24 * 200, 0.3 * doc.Outline.SizeY.Value), (0.9 * 200, 0.5 * doc.Outline.SizeY.Value)]
    for place, (_, _, colour) in zip(art.places(points), fish.FILLS, strict=True):
        x, y = int(place[0] * width), int((1 - place[1]) * height)
        assert tuple(art.rgba[y, x]) == rgba(colour)
    assert art.pixel * width > 200


def cut(doc, path, beat):
    """The pattern as DXF, through the command and its panel."""
    Gui.Selection.addSelection(doc.Pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    Gui.Selection.clearSelection()
    hands.type_into(hands.find("File"), path.name, confirm=False)
    picture("tutorial-export")
    beat.skip()
    hands.type_into(hands.find("File"), str(path), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    text = path.read_text().split("\n")
    layer, xs = "", []
    for code, value in zip(text[::2], text[1::2]):
        if code.strip() == "8":
            layer = value.strip()
        elif code.strip() == "10" and layer == "CUT":
            xs.append(float(value))
    assert max(xs) - min(xs) == pytest.approx(doc.Pattern.PatternWidth.Value, abs=1)


def record(what, beat, glances=(), new_view=False):
    """The window has answered all the time; what was measured is kept beside the screenshots."""
    others = os.getloadavg()[0] / (os.cpu_count() or 1)
    work, most, own, clock = (round(1e3 * x) for x in (beat.work, beat.most, beat.own, beat.longest))
    line = f"{what}: {work} ms of work at a time (once {most}), deaf for {own} ms by us, {clock} by the clock"
    line += f"; {others:.1f} programs for each core"
    if glances:
        line += "; glances: " + ", ".join(f"{1e3 * a:.0f} ms, work {1e3 * b:.0f} ms" for a, b in glances)
    hands.SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    with (hands.SCREENSHOTS / "paint.txt").open("a") as file:
        file.write(line + "\n")
    assert beat.answers(new_view), line
    beat.reset()


def painted_in_view(image, left):
    """The balloon in the 3D view has the colours of the painting."""
    colours = [
        hands.QtGui.QColor(image.pixel(x, y))
        for x in range(left, image.width() - 20, 4)
        for y in range(150, image.height() - 150, 4)
    ]
    yellow = sum(c.red() > 150 and c.green() > 120 and c.blue() < 110 for c in colours)
    red = sum(c.red() > 120 and c.green() < 70 and c.blue() < 100 for c in colours)
    return yellow > 150 and red > 40
