# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorial, step by step: each of its sentences is said here and found true.

tests/tools/test_tutorial_promises.py sees to it that no sentence is left out.
"""

import re
from pathlib import Path

import fish_painting as fish
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import sketches
from brush import BLACK, BLUE, RED, QEvent, colour_at, is_closed, rgba, tablet
from pointer import MIDDLE
from promises import BEYOND, TUTORIAL, sentences
from steps import paper
from story import screen, view_box
from user import on_paper

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.drawings.drawing_file import is_painting
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.view3d.fit_view import is_whole

HEART = Path("resources/examples/pictures/heart.png").resolve()


def in_view():
    """Pixels (n, 2) of the 3D view that are red, magenta, grey, yellow and orange, as rows and columns."""
    rgb = pixels(screen().copy(view_box()))[..., :3].astype(int)
    r, g, b = np.moveaxis(rgb, 2, 0)
    return {
        "cut": np.argwhere((r > 200) & (g < 60) & (b < 60)),
        "seal": np.argwhere((r > 200) & (g < 60) & (b > 200)),
        "grey": np.argwhere((abs(r - g) < 12) & (abs(g - b) < 12) & (r > 120)),
        "yellow": np.argwhere((r > 140) & (g > 110) & (b < 90)),
        "red": np.argwhere((r > 110) & (g < 70) & (b < 100)),
        "orange": np.argwhere((r > 150) & (g > 60) & (g < 150) & (b < 60)),
    }


def test_tutorial_fish(user, story, says, tmp_path):
    window = _first_stroke(user, story, says)
    _width(user, says, window)
    _colours(user, story, says, window)
    _made(user, story, says, tmp_path)
    _painted_on(user, story, says)
    _changed(user, story, says)


def _first_stroke(user, story, says):
    bar = next(b for b in hands.visible(hands.QtWidgets.QToolBar) if b.windowTitle() == "Film Balloon")
    first = next(action for action in bar.actions() if not action.isSeparator())
    user.click(bar.widgetForAction(first))
    says(
        "Choose the workbench Film Balloon and press Paint a balloon, the first button with a heart.",
        Gui.activeWorkbench().MenuText == "Film Balloon"
        and "Paint a balloon" in first.text().replace("&", ""),
    )
    window = paper()
    canvas = window.canvas
    place = hands.QtCore.QRect(canvas.mapToGlobal(canvas.rect().topLeft()), canvas.size())
    says(
        "A sheet of paper opens beside the 3D view.", not place.intersects(view_box()) and place.width() > 300
    )
    user.button(f"PaintColour{BLUE}")
    user.paint(canvas, fish.RIM)
    hands.wait_until(window.scene.is_shown, 30)
    hands.wait(0.3)
    says(
        "Choose a colour, and draw the outline of a fish in one stroke that ends where it began.",
        len(window.painting.steps) == 1,
    )
    seen = in_view()
    says(
        "At once a grey balloon stands in the 3D view, and under it the pattern that it is cut from: "
        "red is where you cut, magenta where you seal.",
        len(seen["grey"]) > 1000
        and min(len(seen["cut"]), len(seen["seal"])) > 100
        and seen["cut"][:, 0].mean() > seen["grey"][:, 0].mean() + 50,
    )
    says(
        "The outline that was found is drawn round your stroke, with its width below.",
        not canvas.overlay._path.isEmpty() and "mm" in canvas.overlay._width,
    )
    hands.wait_until(window.card.isVisible, 30)
    story.step("first-stroke")
    return window


def _width(user, says, window):
    live = window.live
    hand_is_there = window.canvas.scale.is_visible
    user.replace(window.card.field, "25", confirm=False)
    user.button("PaintSizeDone")
    says(
        "The hand in the corner is as large as a grown-up's: type 25 and press That wide.",
        hand_is_there and live.width == pytest.approx(250),
    )
    for width in ("260 mm", "250 mm"):
        user.replace(window.form.width_field, width)
    says("You can change it later in the field Width.", live.width == pytest.approx(250))


def _colours(user, story, says, window):
    canvas, live = window.canvas, window.live
    user.paint(canvas, fish.TAIL_LINE)
    user.button("PaintFill")
    truth = []
    for x, y, colour in fish.FILLS:
        user.button(f"PaintColour{colour}")
        user.click(on_paper(canvas, (x, y)))
        truth.append(colour_at(window, x, y) == rgba(colour))
    says("Take the bucket and click into the body: it becomes yellow.", truth[0])
    says("Draw a line between body and tail with the pen, and fill the tail with orange.", truth[1])
    user.button("PaintBrush")
    user.button(f"PaintColour{RED}")
    for stripe in fish.STRIPES:
        user.paint(canvas, stripe)
    user.button("PaintPen")
    user.button(f"PaintColour{BLACK}")
    for line in (fish.EYE, fish.MOUTH):
        user.paint(canvas, line)
    widths = [
        max(point[2] for point in step.points) for step in window.painting.steps if hasattr(step, "points")
    ]
    says(
        "The broad brush is for the stripes, the pen for eye and mouth.",
        min(widths[2:5]) > 2 * max(widths[5:]),
    )
    hands.wait_until(live.is_settled, 60)
    hands.wait(0.5)
    story.step("painted")
    says("How wide shall it be? is asked once.", not window.card.isVisible())
    seen = in_view()
    says("What you paint is on the balloon.", min(len(seen[c]) for c in ("yellow", "red", "orange")) > 60)
    says(
        "When the pen rests for a moment, the workbench works out the pattern with care, so that the "
        "inflated fish is as large as the drawn one: the foil gets its real folds, and the line under the "
        "canvas says when it is ready to make, or what to change.",
        live.latest.solved is not None
        and live.latest.size[0] == pytest.approx(250, rel=0.01)
        and "Ready to make" in window.form.hint.text(),
    )


def _made(user, story, says, folder):
    user.button("PaintMake")
    hands.wait_until(is_closed, 60)
    hands.wait_until(hands.panel_is_seen)
    doc = App.ActiveDocument
    ready = [obj.Status for obj in (doc.Outline, doc.Balloon, doc.Pattern)] == [status.READY] * 3
    says("Press Make it!", ready)
    story.step("made")
    says(
        "Outline, balloon and pattern are in the document now, in one step that Undo takes back, and the "
        "panel for printing is open: real size, on as many sheets of A4 as it takes.",
        ready and doc.UndoCount == 1 and hands.find("Pages").currentText() == "A4",
    )
    user.replace(hands.find("File"), str(folder / "fish.pdf"), confirm=False)
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed)
    says("OK writes a PDF.", (folder / "fish.pdf").read_bytes().startswith(b"%PDF"))


def _painted_on(user, story, says):
    doc = App.ActiveDocument
    user.open_in_tree(doc.Outline)
    window = paper()
    says(
        "To paint on, double-click Outline in the tree: your strokes are all still there.",
        len(window.painting.steps) == 9 and is_painting(doc.Outline.Drawing),
    )
    window.close()
    hands.wait(0.5)
    story.expect(is_whole(Gui.ActiveDocument), "the view does not show all when the paper is closed")


def _changed(user, story, says):
    doc = App.ActiveDocument
    user.open_in_tree(doc.Balloon)
    hands.wait_until(hands.panel_is_seen)
    says("Double-click Balloon in the tree.", hands.panel_is_open())
    story.step("panel")
    pages = hands.find("Steps")
    titles = [pages.tabText(k) for k in range(pages.count())]
    said = {label.text() for label in hands.visible(hands.QtWidgets.QLabel)}
    says(
        "The panel has outline, film and pressure, pattern and solver; below are the size, the volume, the "
        "weight and how far the balloon is off the drawing.",
        titles == ["Outline", "Film", "Pattern", "Solver"]
        and {"Size", "Volume", "Weight", "Off the drawing"} <= said
        and hands.find("Pressure") is not None,
    )
    widths = doc.Balloon.InflatedWidth.Value, doc.Pattern.PatternWidth.Value
    user.replace(hands.find("Width"), "8in")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    says(
        "Change the width, press OK: balloon and pattern follow.",
        doc.Balloon.InflatedWidth.Value < 0.9 * widths[0]
        and doc.Pattern.PatternWidth.Value < 0.9 * widths[1],
    )
    doc.Outline.setExpression("Width", "150 mm + 50 mm")
    doc.recompute()
    says(
        "Every number takes a unit (8in) and an expression (the blue sign in the field).",
        doc.Outline.Width.Value == pytest.approx(200),
    )


def test_tutorial_tools(user, story, says):
    user.command("BalloonWorkbench_Paint")
    window = paper()
    _steps_and_view(user, story, says, window)
    _mirror_and_thickness(user, says, window)
    _tablet(says, window)
    _photos(user, story, says, window)


def _steps_and_view(user, story, says, window):
    canvas, painting = window.canvas, window.painting
    user.paint(canvas, [(0.2, 0.3), (0.3, 0.3), (0.4, 0.35)])
    user.paint(canvas, [(0.2, 0.6), (0.3, 0.6), (0.4, 0.65)])
    user.key("Ctrl", "z")
    one = len(painting.steps)
    user.key("Ctrl", "y")
    says("Ctrl+Z takes a step back, Ctrl+Y does it again.", (one, len(painting.steps)) == (1, 2))
    whole = canvas.paper.zoom
    user.turn_wheel(canvas, 2)
    zoomed, before = canvas.paper.zoom, canvas.paper.origin()
    pulled = [on_paper(canvas, place) for place in ((0.5, 0.5), (0.55, 0.5), (0.6, 0.55))]
    user.drag(pulled, MIDDLE)
    moved = (canvas.paper.origin() - before).manhattanLength()
    story.step("zoomed")
    user.key("0")
    ends = [canvas.mapFromGlobal(on_paper(canvas, place)) for place in ((0, 0), (1, 1))]
    says(
        "The wheel zooms; the middle button moves the paper, 0 shows all of it.",
        zoomed > 1.2 * whole and moved > 20 and all(canvas.rect().contains(end) for end in ends),
    )


def _mirror_and_thickness(user, says, window):
    user.key("m")
    user.paint(window.canvas, [(0.1, 0.2), (0.15, 0.15), (0.2, 0.1)])
    both = [colour_at(window, x, 0.15)[3] for x in (0.15, 0.85)]
    says("M paints both sides at once, mirrored.", both == [255, 255])
    user.key("m")
    thickness = [window.hand.thickness]
    for letter in ("]", "]", "[", "[", "["):
        user.key(letter)
        thickness.append(window.hand.thickness)
    says(
        "[ and ] make the pen thinner and thicker.",
        thickness[2] > thickness[1] > thickness[0] > thickness[-1],
    )


def _tablet(says, window):
    canvas, painting = window.canvas, window.painting
    for kind, pressure in ((QEvent.TabletPress, 1.0), (QEvent.TabletMove, 1.0), (QEvent.TabletRelease, 0.0)):
        tablet(canvas, kind, (0.5 if kind == QEvent.TabletPress else 0.6, 0.8), pressure)
    for kind, pressure in ((QEvent.TabletPress, 0.1), (QEvent.TabletMove, 0.1), (QEvent.TabletRelease, 0.0)):
        tablet(canvas, kind, (0.5 if kind == QEvent.TabletPress else 0.6, 0.9), pressure)
    ink = pixels(painting.image)[..., 3] > 127
    side = ink.shape[0]
    column = ink[:, int(0.55 * side)]
    thick, thin = (column[int((y - 0.04) * side) : int((y + 0.04) * side)].sum() for y in (0.8, 0.9))
    for kind in (QEvent.TabletPress, QEvent.TabletMove, QEvent.TabletRelease):
        tablet(canvas, kind, (0.52 if kind == QEvent.TabletPress else 0.58, 0.8), 1.0, rubber=True)
    says(
        "A tablet's pen draws thicker the harder you press, and its rubber end erases.",
        thick > thin > 0 and colour_at(window, 0.55, 0.8)[3] == 0,
    )


def _photos(user, story, says, window):
    painting = window.painting
    user.button("PaintClear")
    with user.answering(HEART):
        user.button("PaintPicture")
    hands.wait_until(lambda: not painting.is_empty(), 30)
    photo = colour_at(window, 0.02, 0.02)[3] == 0 and colour_at(window, 0.5, 0.5)[3] == 255
    user.button("PaintClear")
    with user.answering(HEART):
        user.button("PaintBackdrop")
    hands.wait_until(lambda: painting.backdrop is not None, 10)
    story.step("backdrop")
    says(
        "The button with the mountains puts a photo on the paper, without its background; the one beside it "
        "lays a picture under the paper for tracing.",
        photo and painting.is_empty(),
    )


def test_tutorial_sketch(user, story, says, tmp_path):
    _example(user, story, says)
    _exported(user, story, says, tmp_path)
    _own_sketch(user, says)


def _example(user, story, says):
    user.menu("Examples", "Heart from a spreadsheet")
    hands.wait_until(lambda: App.ActiveDocument is not None, 20)
    hands.wait(1.0)
    doc = App.ActiveDocument
    says(
        "Menu Film Balloon > Examples > Heart from a spreadsheet opens a copy of a finished balloon.",
        doc.FileName == "" and doc.Balloon.Status == status.READY,
    )
    story.step("heart")
    driven = {
        path
        for obj in (doc.Outline.Source[0], doc.Balloon)
        for path, text in obj.ExpressionEngine
        if "Sizes" in text
    }
    says(
        "Its sketch takes its dimensions from the spreadsheet Sizes, and so does the pressure.",
        any("Constraints" in path for path in driven) and "Pressure" in driven,
    )
    doc.Sizes.set("height", "=300 mm")
    doc.recompute()
    hands.wait(0.5)
    says(
        "Change the cell of the height to =300 mm, recompute:",
        doc.Outline.SizeY.Value == pytest.approx(300, abs=0.5)
        and doc.Balloon.InflatedHeight.Value == pytest.approx(300, rel=0.03),
    )
    story.step("long-heart")
    menu = next(a for a in Gui.getMainWindow().menuBar().actions() if "Balloon" in a.text()).menu()
    examples = next(a for a in menu.actions() if "Examples" in a.text()).menu()
    titles = " ".join(action.text().lower() for action in examples.actions())
    says("The other examples are a letter and a ring.", "letter" in titles and "ring" in titles)


def _exported(user, story, says, folder):
    user.select(App.ActiveDocument.Pattern)
    user.command("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    says("Select the pattern and press Export pattern.", "Pattern" in hands.find("Pattern").currentText())
    user.choose(hands.find("Machine"), "LightBurn (laser)")
    listed = [hands.find("Preflight").item(row).text() for row in range(hands.find("Preflight").count())]
    story.step("export")
    says(
        "Choose your program or machine: the pattern is checked for it, and what would go wrong is listed "
        "and marked in the view.",
        bool(listed) and all(listed),
    )
    user.replace(hands.find("File"), str(folder / "heart.dxf"), confirm=False)
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed)
    says("OK writes the file.", (folder / "heart.dxf").exists())


def _own_sketch(user, says):
    own = sketches.rectangle(App.newDocument("Own"), 90, 60)
    hands.wait(0.5)
    user.select(own)
    user.command("BalloonWorkbench_FromSketch")
    hands.wait_until(lambda: hands.panel_is_seen() and hands.find("Stop").isVisible(), 20)
    said = [
        bar
        for bar in hands.visible(hands.QtWidgets.QProgressBar)
        if Gui.getMainWindow().statusBar().isAncestorOf(bar)
    ]
    buttons = [button.objectName() for button in hands.visible(hands.QtWidgets.QPushButton)]
    balloon = App.ActiveDocument.Balloon
    user.key("Escape")
    hands.wait_until(lambda: not hands.panel_is_open() or hands.find("Apply").isVisible(), 20)
    says("For a sketch of your own, select it and press New balloon from sketch.", balloon is not None)
    says(
        "Work that takes longer than a moment is shown at the bottom of the window, with a button that stops "
        "it; so does Esc.",
        bool(said) and "BalloonStop" in buttons,
    )
    says("What was there before stays.", App.ActiveDocument.Rectangle.Name == own.Name)


def test_tutorial_pictures(says):
    tests = Path(__file__).resolve().parents[1] / "gui"
    code = "".join(path.read_text(encoding="utf-8") for path in tests.rglob("test_*.py"))
    pictures = re.findall(r"images/([\w-]+)\.png", TUTORIAL.read_text(encoding="utf-8"))
    taken = [picture for picture in pictures if f'"{picture}"' in code]
    says("All pictures below were taken by the tests.", bool(pictures) and taken == pictures)
    says(
        "The README has what every command and option does, and the same from the command line and in "
        "scripts.",
        all(text in Path("README.md").read_text(encoding="utf-8") for text in ("command-line.md", "api.md")),
    )
    assert set(BEYOND) <= set(sentences())
