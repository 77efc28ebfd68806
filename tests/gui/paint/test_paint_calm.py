# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview does not jump: colours leave the balloon alone, a known shape comes back at once, and the rest
moves smoothly."""

from dataclasses import replace
from pathlib import Path

import hands
import numpy as np
import pytest
from brush import (
    BLUE,
    RED,
    YELLOW,
    arc,
    click,
    close_window,
    draw,
    ellipse,
    is_closed,
    open_window,
    press,
)
from pictures import framed, silhouette_jump

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.preview.scene import begun, texels

QtGui = hands.QtGui
FIRST = "Draw a closed line"
MESH = 0.014  # m


@pytest.fixture
def window(doc):
    with framed():
        opened = open_window()
        opened._is_sized = True  # the card would be in the way
        opened.live.settings = replace(opened.live.settings, mesh_size=MESH)
        yield opened
        close_window()


class Watch:
    """What the window shows from now on, while it lives."""

    def __init__(self, window):
        self.window, self.looks, self.texts, self.moving = window, [], set(), []
        window.live.shown.connect(self._found)

    def _found(self, look):
        self.looks.append(look)
        self.texts.add(self.window.form.numbers.text())
        self.moving.append(self.window.scene.is_moving())

    def until_settled(self):
        live = self.window.live
        hands.wait_until(lambda: live.is_settled() and not self.window.scene.is_moving(), 60)


def oval(window):
    press(f"PaintColour{BLUE}")
    draw(window.canvas, ellipse(0.5, 0.45, 0.33, 0.2))
    Watch(window).until_settled()


def view_picture(window):
    hands.wait(0.3)
    area = hands.Gui.getMainWindow().centralWidget()
    at = area.mapToGlobal(hands.QtCore.QPoint(0, 0))
    screen = hands.QtWidgets.QApplication.primaryScreen()
    return screen.grabWindow(0, at.x(), at.y(), area.width(), area.height()).toImage()


def fill(window):
    press("PaintFill")
    press(f"PaintColour{YELLOW}")
    click(window.canvas, (0.5, 0.45))
    press("PaintPen")


def inner_line(window):
    press(f"PaintColour{RED}")
    draw(window.canvas, [(0.35, 0.45), (0.5, 0.5), (0.65, 0.45)])


def rub_out_the_colour(window):
    inner_line(window)
    press("PaintEraser")
    draw(window.canvas, [(0.4, 0.45), (0.5, 0.5), (0.6, 0.45)])
    press("PaintPen")


def undo_and_redo(window):
    fill(window)
    press("PaintUndo")
    press("PaintRedo")


def colour_of_the_line(window):
    press("PaintFill")
    press(f"PaintColour{RED}")
    click(window.canvas, (0.5, 0.25))
    press("PaintPen")


@pytest.mark.slow
def test_what_leaves_the_outline_alone_leaves_the_balloon_alone(window):
    """Each change on the bare oval, which is had back after it."""
    oval(window)
    for change in (fill, inner_line, rub_out_the_colour, undo_and_redo, colour_of_the_line):
        shown, text = window.live.latest, window.form.numbers.text()
        before = view_picture(window)
        watch = Watch(window)
        change(window)
        until_shown(window, watch)
        assert silhouette_jump(before, view_picture(window)) < 0.005, change
        watch.until_settled()
        assert watch.texts == {text}, change
        assert all(look.skins is shown.skins for look in watch.looks), change
        assert silhouette_jump(before, view_picture(window)) < 0.005, change
        hands.screenshot(f"calm-{change.__name__}")
        kept = QtGui.QImage(str(window.live.latest.file))
        assert (pixels(kept) == pixels(window.painting.image)).all(), change
        watch = Watch(window)
        while len(window.painting.steps) > 1:
            press("PaintUndo")
        until_shown(window, watch)
        watch.until_settled()


def until_shown(window, watch):
    revision = window.painting.revision
    hands.wait_until(lambda: any(look.revision == revision for look in watch.looks), 30)


@pytest.mark.slow
@pytest.mark.works_out
def test_an_inner_line_that_touches_the_rim_shows_no_draft(window):
    oval(window)
    shown, before = window.live.latest, view_picture(window)
    watch = Watch(window)
    draw(window.canvas, [(0.6, 0.45), (0.7, 0.5), (0.836, 0.45)])
    watch.until_settled()
    assert not window.live.latest.is_of(shown.traced, shown.width), "the outline is another one"
    assert all(look.skins is shown.skins for look in watch.looks if not look.fitted)
    assert not watch.looks[0].fitted
    assert window.live.latest.skins is not shown.skins
    assert silhouette_jump(before, view_picture(window)) < 0.01


@pytest.mark.slow
def test_the_document_gets_the_new_painting(doc, window):
    oval(window)
    fill(window)
    press("PaintMake")
    hands.wait_until(is_closed, 60)
    kept = Painting()
    kept.load(Path(doc.Outline.Drawing))
    assert [step.tool for step in kept.steps] == ["pen", "fill"]
    assert not [text for text in doc.Balloon.Warnings if "pen drawing" in text]


@pytest.mark.slow
@pytest.mark.works_out
def test_a_known_shape_comes_back_at_once(window):
    oval(window)
    first = window.live.latest
    draw(window.canvas, ellipse(0.5, 0.72, 0.12, 0.14))
    Watch(window).until_settled()
    second = window.live.latest
    assert second.size[1] > 1.1 * first.size[1]
    width = window.live.width
    for change, known in (
        (lambda: press("PaintUndo"), first),
        (lambda: press("PaintRedo"), second),
        (lambda: window.set_width(2.0 * width), None),
        (lambda: window.set_width(width), second),
    ):
        watch = Watch(window)
        change()
        hands.wait_until(lambda seen=watch.looks: bool(seen), 10)
        assert known is None or watch.looks[0].skins is known.skins
        assert window.form.numbers.text().startswith("about") == (known is None)
        watch.until_settled()


@pytest.mark.slow
@pytest.mark.works_out
def test_a_draft_is_said_to_be_one_and_is_near(window):
    watch = Watch(window)
    press(f"PaintColour{BLUE}")
    draw(
        window.canvas,
        [*arc(0.35, 0.4, 0.2, 180, 360), *arc(0.7, 0.4, 0.15, 180, 360), (0.5, 0.8), (0.15, 0.4)],
    )
    watch.until_settled()
    drafts = [look for look in watch.looks if not look.fitted and look.revision == window.painting.revision]
    fitted = window.live.latest
    assert drafts
    for draft in drafts:
        assert draft.volume == pytest.approx(fitted.volume, rel=0.1)
        assert draft.size == pytest.approx(fitted.size, rel=0.1)
    said = [text for text in watch.texts if text.startswith("about ")]
    assert said
    assert not any("e+" in text or "." in text.split(",")[0] for text in said)
    assert not window.form.numbers.text().startswith("about")


@pytest.mark.works_out
def test_the_film_moves_from_the_draft_to_the_fitted_balloon(window):
    """It begins where the draft was: nothing of it is farther away than a few millimetres."""
    watch = Watch(window)
    press(f"PaintColour{BLUE}")
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.wait_until(lambda: any(look.fitted for look in watch.looks), 60)
    first = next(number for number, look in enumerate(watch.looks) if look.fitted)
    assert watch.moving[first]
    draft = [look for look in watch.looks if not look.fitted][-1]
    fitted = window.live.latest
    (skin,), (last,) = fitted.skins, draft.skins
    start = begun(skin, last)
    assert np.ptp(start, axis=0) == pytest.approx(np.ptp(last.positions, axis=0), rel=0.03)
    hands.wait_until(lambda: not window.scene.is_moving(), 10)


@pytest.mark.slow
@pytest.mark.works_out
def test_a_cleared_sheet_says_what_to_do_first(window):
    left, right = arc(0.3, 0.5, 0.18, 3, 357), arc(0.75, 0.5, 0.15, 178, -178)
    arm = [(0.46, 0.496), (0.60, 0.496)]
    for take_off in ("PaintClear", "PaintUndo"):
        draw(window.canvas, [*arm, *right, (0.60, 0.504), (0.46, 0.504), *left])
        hands.wait_until(lambda: bool(window.canvas.thin.remarks), 60)
        assert not window.form.hint.text().startswith(FIRST)
        press(take_off)
        hands.wait(0.05)
        assert window.form.hint.text().startswith(FIRST)
        assert window.form.numbers.text() == ""
        assert not window.canvas.thin.remarks
        assert not window.scene.is_shown()
        watch = Watch(window)
        hands.wait(1.0)
        assert not watch.looks


def test_paint_reaches_over_the_rim_of_the_film():
    """At its outline paint is half transparent; what is seen there has to be its colour all the same."""
    image = QtGui.QImage(1000, 1000, QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(0)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setBrush(QtGui.QColor(RED))
    painter.setPen(hands.QtCore.Qt.NoPen)
    painter.drawEllipse(hands.QtCore.QPointF(500, 500), 300, 300)
    painter.setCompositionMode(QtGui.QPainter.CompositionMode_Clear)
    painter.drawRect(450, 450, 100, 100)  # bare film inside, which stays bare
    painter.end()
    shown = texels(image).astype(int)
    colour = QtGui.QColor(RED)
    turn = np.linspace(0.0, 2.0 * np.pi, 400)
    for radius in (297.0, 300.0, 303.0):
        x, y = (0.512 * (500.0 + radius * way(turn)) for way in (np.cos, np.sin))
        at_rim = shown[np.floor(y).astype(int), np.floor(x).astype(int)]
        away = np.abs(at_rim - (colour.red(), colour.green(), colour.blue())).max()
        assert away < 30
    assert (shown[248:264, 248:264] > 230).all()
