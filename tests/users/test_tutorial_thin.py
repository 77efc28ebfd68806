# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorial about thin places, see test_tutorial.py."""

import hands
from brush import RED, arc
from steps import paper
from story import screen
from user import on_paper

from BalloonWorkbench.app.drawings.qt_picture import pixels


def test_tutorial_thin_arm(user, story, says):
    user.command("BalloonWorkbench_Paint")
    window = paper()
    canvas, live = window.canvas, window.live
    user.button(f"PaintColour{RED}")
    left, right = arc(0.3, 0.5, 0.18, 3, 357), arc(0.75, 0.5, 0.15, 178, -178)
    user.paint(canvas, [(0.46, 0.496), (0.60, 0.496), *right, (0.60, 0.504), (0.46, 0.504), *left])
    hands.wait_until(window.card.isVisible, 30)
    user.key("Return") if window.card.field.hasFocus() else user.button("PaintSizeDone")
    hands.wait_until(live.is_settled, 60)
    ask(user, story, says, window, "arm")


def test_tutorial_lone_stroke(user, story, says):
    """A thin place may be all there is."""
    user.command("BalloonWorkbench_Paint")
    window = paper()
    line = [(0.15 + 0.7 * k / 30, 0.5) for k in range(31)]
    user.button(f"PaintColour{RED}")
    user.paint(window.canvas, line)
    hands.wait_until(lambda: "it is a line" in window.form.hint.text(), 30)
    was_line = not window.scene.is_shown()
    story.step("line")
    user.button("PaintBrush")
    user.key("[")
    user.key("[")
    user.paint(window.canvas, line)
    hands.wait_until(window.live.is_settled, 60)
    says(
        "A lone thin line is no balloon yet: close it, or go over it with the brush.",
        was_line and window.scene.is_shown(),
    )
    user.replace(window.card.field, "25", confirm=False)  # at 300 mm it is as thin as just may be
    user.button("PaintSizeDone")
    hands.wait_until(window.live.is_settled, 60)
    ask(user, story, says, window, "stroke")


def ask(user, story, says, window, what):
    """The question about a thin place: yes, back again, no."""
    canvas, live, painting = window.canvas, window.live, window.painting
    hands.wait(0.5)
    story.step(f"thin-{what}")
    asked = canvas.thin.asked()
    says("Air does not get into an arm that is too thin.", asked is not None)
    if asked is None:
        return
    remark = canvas.thin.remarks[asked]
    at = on_paper(canvas, (remark.place[0], 1.0 - remark.place[1]))
    shown = pixels(screen())[at.y(), at.x(), :3].astype(int)
    says(
        "Such a place turns orange, and a question says how wide it should be.",
        shown[0] > 200 and shown[0] > shown[1] > shown[2] and "mm" in remark.question,
    )
    says("The dashed line shows what would come of it.", remark.step.widened > remark.step.was)
    before = pixels(painting.image)
    user.click(canvas.mapToGlobal(canvas.thin.question_place().toPoint()))
    wider = (pixels(painting.image)[..., 3] > 127).sum() > (before[..., 3] > 127).sum()
    hands.wait_until(live.is_settled, 60)
    gone = canvas.thin.asked() is None
    story.step(f"wider-{what}")
    user.key("Ctrl", "z")
    back = (pixels(painting.image) == before).all()
    hands.wait_until(lambda: canvas.thin.asked() is not None and live.is_settled(), 60)
    hands.wait(0.3)
    user.click(canvas.mapToGlobal(canvas.thin._cross.center().toPoint()))
    says(
        "A click on the question widens the arm, with everything painted on it; Ctrl+Z takes that back, and "
        "the little cross says that you like it as it is.",
        wider and gone and back and canvas.thin.asked() is None,
    )
