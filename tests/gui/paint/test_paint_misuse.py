# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two buttons, keys and mouse, another tool in the middle: what is seen is what the steps make."""

import hands
import numpy as np
import pytest
from brush import QEvent, Qt, draw, key, mouse, press

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.painting import tools


def is_honest(window):
    """The picture is that of the steps, and nothing is left at the pointer."""
    hands.wait(0.05)
    seen, canvas = pixels(window.painting.image), window.canvas
    window.painting.repaint()
    works = (canvas.hand, canvas.stamp, canvas.selection, canvas.pipette, canvas.axis)
    held = any(each.is_at_work() for each in works)
    return np.array_equal(seen, pixels(window.painting.image)) and not held


def begin(window, places):
    mouse(window.canvas, QEvent.MouseButtonPress, places[0])
    for place in places[1:]:
        mouse(window.canvas, QEvent.MouseMove, place)
        hands.wait(0.02)


def let_go(window, place, button=Qt.LeftButton, held=Qt.NoButton):
    mouse(window.canvas, QEvent.MouseButtonRelease, place, button, held)
    hands.wait(0.05)


LINE = [(0.3, 0.3), (0.4, 0.4), (0.5, 0.3)]


def test_the_middle_button_waits_until_the_pen_is_up(window):
    begin(window, LINE)
    before = window.canvas.paper.origin()
    both = Qt.LeftButton | Qt.MiddleButton
    mouse(window.canvas, QEvent.MouseButtonPress, LINE[-1], Qt.MiddleButton, both)
    let_go(window, LINE[-1], held=Qt.MiddleButton)
    let_go(window, LINE[-1], Qt.MiddleButton)
    assert window.canvas.paper.origin() == before
    assert len(window.painting.steps) == 1
    assert is_honest(window)


def test_a_stroke_whose_end_was_not_told_is_kept(window):
    begin(window, LINE)
    draw(window.canvas, [(0.6, 0.6), (0.7, 0.6)], let_live=False)
    assert len(window.painting.steps) == 2
    assert is_honest(window)


def test_the_mouse_takes_over_from_the_keys(window):
    window.canvas.setFocus()
    key(window.canvas, Qt.Key_Right)
    key(window.canvas, Qt.Key_Return)
    for _ in range(4):
        key(window.canvas, Qt.Key_Down)
    draw(window.canvas, [(0.2, 0.6), (0.3, 0.6)], let_live=False)
    assert len(window.painting.steps) == 2
    assert is_honest(window)


def test_redo_waits_until_the_pen_is_up(window):
    draw(window.canvas, [(0.2, 0.3), (0.8, 0.3)], let_live=False)
    window.painting.undo()
    begin(window, LINE)
    key(window.canvas, Qt.Key_Y, modifiers=Qt.ControlModifier)
    let_go(window, LINE[-1])
    assert len(window.painting.steps) == 1
    assert is_honest(window)


@pytest.mark.parametrize("tool", [tools.STAMP, tools.SELECT, tools.AXIS, tools.PIPETTE])
def test_another_tool_in_the_middle_leaves_nothing_behind(window, tool):
    press(f"Paint{tool.capitalize()}")
    begin(window, LINE)
    key(window.canvas, Qt.Key_B, "b")
    let_go(window, LINE[-1])
    assert window.canvas.stamp._step is None
    assert len(window.painting.steps) == (tool == tools.STAMP)
    assert is_honest(window)
