# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 1: a child paints a fish, has a thin arm widened, says how wide, makes it, and paints on."""

import re

import fish_painting as fish
import FreeCAD as App
import hands
import steps
from brush import BLUE, RED, arc, colour_at, is_closed
from story import JUMP, most_change
from user import on_paper

from BalloonWorkbench.app.drawings.qt_picture import pixels

#: A thread from the back of the fish with a bobble at its end, in one stroke.
_BOBBLE = [(0.436, 0.22), (0.436, 0.14), *arc(0.44, 0.09, 0.05, 95, 445), (0.444, 0.14), (0.444, 0.22)]


def test_scene_1_paint(user, story, tmp_path):
    user.command("BalloonWorkbench_Paint")
    window = steps.paper()
    story.step("paper")
    _first_stroke(user, story, window)
    _thin_arm(user, story, window)
    _colours(user, story, window)
    _made(user, story, tmp_path / "fish.pdf")
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
    story.expect(canvas.scale.is_visible, "no hand shows the scale while the width is asked for")
    user.replace(window.card.field, "25", confirm=False)
    user.button("PaintSizeDone")
    story.expect(not window.card.isVisible(), "the question for the width stays after its answer")
    hands.wait_until(live.is_settled, 60)
    story.expect(abs(live.width - 250) < 1, f"the width is {live.width}, not 250 mm")
    story.step("width")


def _thin_arm(user, story, window):
    canvas, live = window.canvas, window.live
    user.paint(canvas, _BOBBLE)
    hands.wait_until(lambda: live.is_settled() and canvas.thin.asked() is not None, 60)
    hands.wait(0.3)
    story.step("thin-arm")
    remark = canvas.thin.remarks[canvas.thin.asked()]
    story.expect("mm" in remark.question, f"the question names no width: {remark.question}")
    before = (pixels(window.painting.image)[..., 3] > 127).sum()
    user.click(canvas.mapToGlobal(canvas.thin.question_place().toPoint()))
    hands.wait_until(live.is_settled, 60)
    hands.wait(0.5)
    story.step("arm-widened")
    story.expect(canvas.thin.asked() is None, "the arm is asked about once more")
    after = (pixels(window.painting.image)[..., 3] > 127).sum()
    story.expect(after > before, "a click on the question does not widen the arm")
    user.key("Ctrl", "z")
    user.key("Ctrl", "z")
    hands.wait_until(live.is_settled, 60)
    story.expect(len(window.painting.steps) == 1, "widening and arm are not a step each")


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


def _made(user, story, file):
    user.button("PaintMake")
    hands.wait_until(is_closed, 60)
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.5)
    story.step("made")
    story.expect(hands.find("Pages").currentText() == "A4", "the pattern is not tiled on A4")
    user.replace(hands.find("File"), str(file), confirm=False)
    steps.leave(user)
    story.step("in-the-document")
    pages = len(re.findall(rb"/Type */Page\b", file.read_bytes()))
    story.expect(pages > 1, f"the pattern is on {pages} pages of A4")
    story.expect(str(file) in steps.status_text(), "nothing tells where the pattern was written")
    story.expect(len(App.ActiveDocument.UndoNames) == 1, "making it is more than one step to undo")


def _painted_on(user, story):
    user.open_in_tree(App.ActiveDocument.Outline)
    window = steps.paper()
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
