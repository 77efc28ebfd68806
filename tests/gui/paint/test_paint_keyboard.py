# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window without a mouse, for screen readers, and on a small screen."""

import os

import FreeCADGui as Gui
import hands
import pytest
from brush import BLACK, RED, Qt, close_window, colour_at, ink, key, open_window, press, rgba
from cut_off import faults
from pictures import framed

from BalloonWorkbench.gui.paint.painting.layers import SHAPE, SIDE
from BalloonWorkbench.gui.paint.painting.tools import MORE_TOOLS, TOOLS

QtCore, QtWidgets = hands.QtCore, hands.QtWidgets
LANGUAGES = os.environ.get("BALLOON_LANGUAGES", "German").split(",")
_LEAST = 300  # px, of the paper's side on a small screen


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


def go(canvas, place):
    """Move the pointer of the arrow keys to a place of the paper (x, y), 0 to 1."""
    goal = canvas.paper.to_screen(QtCore.QPointF(place[0] * SIDE, place[1] * SIDE))
    key(canvas, Qt.Key_Right)
    for far, shift in ((10, Qt.NoModifier), (1, Qt.ShiftModifier)):
        for forth, back, along in ((Qt.Key_Right, Qt.Key_Left, "x"), (Qt.Key_Down, Qt.Key_Up, "y")):
            way = getattr(goal, along)() - getattr(canvas._keys.place, along)()
            for _ in range(int(abs(way) // far)):
                key(canvas, forth if way > 0 else back, modifiers=shift)


def enter(canvas):
    key(canvas, Qt.Key_Return, "\r")


def test_strokes_fills_and_lines_by_keys(window):
    canvas = window.canvas
    go(canvas, (0.3, 0.3))
    enter(canvas)
    for place in ((0.6, 0.3), (0.6, 0.6), (0.3, 0.6), (0.3, 0.31)):
        go(canvas, place)
    enter(canvas)
    assert [step.tool for step in window.painting.steps] == ["pen"]
    key(canvas, Qt.Key_F, "f")
    key(canvas, Qt.Key_3, "3")
    go(canvas, (0.45, 0.45))
    enter(canvas)
    assert colour_at(window, 0.45, 0.45) == rgba(RED)
    key(canvas, Qt.Key_L, "l")
    key(canvas, Qt.Key_1, "1")
    go(canvas, (0.1, 0.8))
    enter(canvas)
    go(canvas, (0.5, 0.8))
    enter(canvas)
    go(canvas, (0.3, 0.7))
    enter(canvas)
    assert [step.tool for step in window.painting.steps] == ["pen", "fill", "line"]
    assert colour_at(window, 0.3, 0.7) == rgba(BLACK)
    go(canvas, (0.7, 0.7))
    enter(canvas)
    go(canvas, (0.9, 0.7))
    key(canvas, Qt.Key_Escape)
    enter(canvas)
    key(canvas, Qt.Key_Escape)
    assert len(window.painting.steps) == 3


def test_the_other_tools_by_keys(window):
    canvas = window.canvas
    key(canvas, Qt.Key_S, "s")
    assert hands.find("PaintStampHeart").isVisible()
    go(canvas, (0.5, 0.5))
    enter(canvas)
    go(canvas, (0.7, 0.5))
    enter(canvas)
    assert [step.tool for step in window.painting.steps] == ["stamp"]
    key(canvas, Qt.Key_R, "r")
    go(canvas, (0.2, 0.2))
    enter(canvas)
    go(canvas, (0.8, 0.8))
    enter(canvas)
    assert canvas.selection.box == pytest.approx((200, 200, 600, 600), abs=4)
    key(canvas, Qt.Key_X, "\x18", Qt.ControlModifier)
    key(canvas, Qt.Key_V, "\x16", Qt.ControlModifier)
    key(canvas, Qt.Key_Left)
    key(canvas, Qt.Key_Minus, "-")
    enter(canvas)
    assert [step.tool for step in window.painting.steps] == ["stamp", "cut", "picture"]
    assert ink(window).any()
    key(canvas, Qt.Key_M, "m")
    key(canvas, Qt.Key_Period, ".")
    key(canvas, Qt.Key_Period, ".")
    assert (window.hand.symmetry.fold, window.hand.symmetry.mirror) == (3, True)
    key(canvas, Qt.Key_A, "a")
    go(canvas, (0.5, 0.5))
    enter(canvas)
    go(canvas, (0.6, 0.5))
    enter(canvas)
    assert window.hand.symmetry.x == pytest.approx(600, abs=4)
    key(canvas, Qt.Key_C, "c")
    key(canvas, Qt.Key_D, "d")
    assert window.hand.layer != SHAPE
    key(canvas, Qt.Key_Q, "q")
    assert not window.extras.bar.isVisible()


def test_tab_reaches_everything_and_everything_has_a_name(window):
    press("PaintMore")
    window.choose(next(tool for tool in MORE_TOOLS if tool.name == "stamps"))
    hands.find("PaintMirror").setFocus()
    names = []
    for _ in range(80):
        widget = QtWidgets.QApplication.focusWidget()
        names.append(widget.objectName())
        if widget is window.form.make_button:
            break
        hands.key(widget, Qt.Key_Tab, "\t")
    stops = ["PaintMirror", "PaintMore", "PaintStamps", "PaintFold", "PaintStampHeart", "Canvas", "PaintMake"]
    assert [name for name in names if name in stops] == stops, names
    for each in window.findChildren(QtWidgets.QWidget):
        if each.focusPolicy() & Qt.TabFocus and each.isVisible() and each.objectName().startswith("Paint"):
            said = each.accessibleName() or getattr(each, "text", str)() or each.toolTip()
            assert said, each.objectName()
    assert window.canvas.accessibleName() == "Paper"
    assert window.canvas.accessibleDescription() == "Stamp. You paint on: Shape"


def test_a_mouse_leaves_the_keys_with_the_canvas(window):
    for tool in TOOLS:
        press(f"Paint{tool.name.title()}")
        assert window.canvas.hasFocus()
    letters = [tool.key for tool in (*TOOLS, *MORE_TOOLS)]
    assert len(set(letters)) == len(letters)
    for tool in (*TOOLS, *MORE_TOOLS):
        key(window.canvas, 0, tool.key.lower())
        assert window.hand.tool is tool
        assert f"({tool.key})" in hands.find(f"Paint{tool.name.title()}").toolTip()


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_it_fits_on_a_small_screen(doc, language):
    Gui.setLocale(language)
    hands.wait(0.3)
    try:
        with framed((1366, 768)):
            window = open_window()
            press("PaintMore")
            for tool in (*TOOLS, *MORE_TOOLS):
                window.choose(tool)
                hands.wait(0.2)
                hands.screenshot(f"small-paint-{tool.name}-{language}")
                assert not faults(window), tool.name
                assert min(window.canvas.width(), window.canvas.height()) >= _LEAST
            close_window()
    finally:
        Gui.setLocale("English")
        hands.wait(0.3)
