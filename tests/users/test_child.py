# SPDX-License-Identifier: LGPL-2.1-or-later
"""A child paints a fish, makes it, and paints on."""

import fish_painting as fish
import FreeCAD as App
import hands
from brush import BLUE, RED, colour_at, is_closed
from story import JUMP, most_change
from user import on_paper

from BalloonWorkbench.gui.paint import window as paint_window


def opened():
    hands.wait_until(lambda: bool(paint_window._open))
    window = paint_window._open[0]
    hands.wait_until(lambda: window.canvas.isVisible() and window.canvas.width() > 300)
    hands.wait(0.5)
    return window


def test_child(user, story):
    user.command("BalloonWorkbench_Paint")
    window = opened()
    story.step("paper")
    _first_stroke(user, story, window)
    _colours(user, story, window)
    _made(user, story)
    _painted_on(user, story)


def _first_stroke(user, story, window):
    canvas, live = window.canvas, window.live
    box = canvas.mapToGlobal(canvas.rect().topLeft()), canvas.size()

    user.button(f"PaintColour{BLUE}")
    user.paint(canvas, fish.RIM)
    hands.wait_until(window.scene.is_shown, 30)
    hands.wait_until(window.card.isVisible, 30)
    story.step("first-stroke")
    moved = (canvas.mapToGlobal(canvas.rect().topLeft()), canvas.size()) != box
    story.expect(not moved, "the paper moves while the first stroke is drawn")
    user.replace(window.card.field, "25", confirm=False)
    user.button("PaintSizeDone")
    story.expect(not window.card.isVisible(), "the question for the width stays after its answer")
    hands.wait_until(live.is_settled, 60)
    story.expect(abs(live.width - 250) < 1, f"the width is {live.width}, not 250 mm")
    story.step("width")


def _colours(user, story, window):
    canvas, live = window.canvas, window.live

    def only_colours(what, action):
        most = most_change(action, live.is_settled)
        hands.wait_until(live.is_settled, 60)
        story.step(what)
        story.expect(most <= JUMP, f"preview: {100 * most:.1f} % of the view jumps: {what}")

    only_colours("line-inside", lambda: user.paint(canvas, fish.TAIL_LINE))
    user.button("PaintFill")
    for number, (x, y, colour) in enumerate(fish.FILLS):
        user.button(f"PaintColour{colour}")
        only_colours(f"fill-{number + 1}", lambda x=x, y=y: user.click(on_paper(canvas, (x, y))))
    only_colours("undo-fill", lambda: user.key("Ctrl", "z"))
    only_colours("redo-fill", lambda: user.key("Ctrl", "y"))
    user.button("PaintBrush")
    user.button(f"PaintColour{RED}")
    only_colours("stripe", lambda: user.paint(canvas, fish.STRIPES[0]))


def _made(user, story):
    user.button("PaintMake")
    hands.wait_until(is_closed, 60)
    hands.wait_until(hands.panel_is_open)
    hands.wait(0.5)
    story.step("made")
    user.panel("Cancel")
    hands.wait_until(hands.panel_is_closed)
    story.step("in-the-document")
    story.expect(len(App.ActiveDocument.UndoNames) == 1, "making it is more than one step to undo")


def _painted_on(user, story):
    user.open_in_tree(App.ActiveDocument.Outline)
    window = opened()
    canvas = window.canvas
    hands.wait_until(window.live.is_settled, 60)
    story.step("paint-on")
    user.key("m")
    user.button(f"PaintColour{RED}")
    user.paint(canvas, [(0.2, 0.15), (0.25, 0.1), (0.3, 0.15)])
    story.step("mirrored")
    both = [colour_at(window, x, 0.15)[3] for x in (0.2, 0.8)]
    story.expect(both == [255, 255], "the stroke is not on both sides of the mirror")
    user.button("PaintClear")
    hands.wait_until(lambda: not window.scene.is_shown(), 10)
    story.step("cleared")
    left = [window.form.numbers.text(), *(remark.text for remark in canvas.thin.remarks)]
    story.expect(not any(left), f"on a cleared sheet is still said: {left}")
    story.expect("closed line" in window.form.hint.text(), f"a cleared sheet says: {window.form.hint.text()}")
    user.key("Ctrl", "z")
    hands.wait_until(window.live.is_settled, 60)
    story.step("back")
