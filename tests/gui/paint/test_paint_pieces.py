# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any colour, stamps, text, the pen of a tablet, and long paintings."""

from pathlib import Path

import hands
import numpy as np
import pytest
from brush import (
    BLACK,
    BLUE,
    RED,
    QEvent,
    Qt,
    box_of,
    click,
    colour_at,
    draw,
    ink,
    key,
    mouse,
    press,
    rgba,
    tablet,
)

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.painting.layers import SHAPE, SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.stamps import stamps
from BalloonWorkbench.gui.paint.painting.words import picture_of

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets
HEART = Path("resources/examples/pictures/heart.png").resolve()
CTRL = Qt.ControlModifier


# colours


def test_any_colour_is_chosen_beside_the_window_and_remembered(window):
    press("PaintAnyColour")
    dialog = window.extras._dialog
    hands.wait_until(dialog.isVisible)
    assert not dialog.isModal()
    lines = dialog.findChildren(QtWidgets.QLineEdit)
    (field,) = [line for line in lines if line.text().startswith("#")]
    field.selectAll()
    for letter in "#12ab9f":
        hands.key(field, 0, letter)
    box = dialog.findChild(QtWidgets.QDialogButtonBox)
    hands.click(box.button(QtWidgets.QDialogButtonBox.Ok))
    hands.wait_until(lambda: not dialog.isVisible())
    draw(window.canvas, [(0.3, 0.3), (0.5, 0.3)], let_live=False)
    assert colour_at(window, 0.4, 0.3) == rgba("#12ab9f")
    assert not any(hands.find(f"PaintColour{value}").isChecked() for value in (BLACK, BLUE, RED))
    press(f"PaintColour{RED}")
    assert window.hand.colour == RED
    assert hands.find(f"PaintColour{RED}").isChecked()
    press("PaintRecent1")
    assert window.hand.colour == "#12ab9f"


def test_the_pipette_takes_a_colour_and_gives_the_tool_back(window):
    press("PaintBrush")
    press(f"PaintColour{BLUE}")
    draw(window.canvas, [(0.3, 0.5), (0.5, 0.5)], let_live=False)
    press(f"PaintColour{RED}")
    key(window.canvas, Qt.Key_C, "c")
    click(window.canvas, (0.4, 0.5))
    assert window.hand.colour == BLUE
    assert window.hand.tool.name == "brush"
    assert len(window.painting.steps) == 1
    window.pictures.lay_under(HEART)
    key(window.canvas, Qt.Key_C, "c")
    click(window.canvas, (0.5, 0.6))
    assert window.hand.colour == QtGui.QImage(str(HEART)).scaled(10, 10).pixelColor(5, 6).name()
    key(window.canvas, Qt.Key_C, "c")
    click(window.canvas, (1.2, 0.5))  # beside the paper: nothing is taken
    assert window.hand.tool.name == "pipette"


# stamps


def test_stamps_fill_their_place(window):
    press("PaintStamps")
    for number, stamp in enumerate(stamps()):
        press(f"PaintStamp{stamp.name.title()}")
        draw(window.canvas, [(0.5, 0.5), (0.7, 0.5)], let_live=False)
        _, _, width, height = box_of(ink(window))
        assert max(width, height) == pytest.approx(400, abs=4), stamp.name
        assert 0.3 < ink(window).sum() / (width * height) <= 1.0, stamp.name
        if number == 0:
            hands.screenshot("paint-stamp")
        press("PaintUndo")
    assert len(stamps()) >= 7


def test_a_stamp_is_turned_by_the_pull_and_kept_upright_by_shift(window):
    press("PaintStamps")
    press("PaintStampRectangle")
    draw(window.canvas, [(0.5, 0.5), (0.5, 0.7)], let_live=False)  # down: a quarter turn
    _, _, width, height = box_of(ink(window))
    assert height > 1.3 * width
    press("PaintUndo")
    for kind, place in (
        (QEvent.MouseButtonPress, (0.5, 0.5)),
        (QEvent.MouseMove, (0.5, 0.7)),
        (QEvent.MouseButtonRelease, (0.5, 0.7)),
    ):
        mouse(window.canvas, kind, place, modifiers=Qt.ShiftModifier)
    _, _, width, height = box_of(ink(window))
    assert width > 1.3 * height
    mouse(window.canvas, QEvent.MouseButtonPress, (0.2, 0.2))
    mouse(window.canvas, QEvent.MouseMove, (0.4, 0.2), Qt.NoButton)
    key(window.canvas, Qt.Key_Escape)
    mouse(window.canvas, QEvent.MouseButtonRelease, (0.4, 0.2), held=Qt.NoButton)
    assert len(window.painting.steps) == 1


# tablet


def test_the_tilt_of_a_pen_changes_nothing(window):
    steps = []
    for tilt in (0, 55):
        for kind, x, pressure in (
            (QEvent.TabletPress, 0.2, 0.7),
            (QEvent.TabletMove, 0.4, 0.3),
            (QEvent.TabletMove, 0.6, 1.0),
            (QEvent.TabletRelease, 0.6, 0.0),
        ):
            tablet(window.canvas, kind, (x, 0.3), pressure, tilt=tilt)
        steps.append(window.painting.steps[-1])
    assert steps[0] == steps[1]
    widths = [width for *_, width in steps[0].points]
    assert widths[1] < widths[0] < widths[2]


def test_a_pen_works_with_every_tool(window):
    press("PaintStamps")
    for kind, x in ((QEvent.TabletPress, 0.5), (QEvent.TabletMove, 0.6), (QEvent.TabletRelease, 0.6)):
        tablet(window.canvas, kind, (x, 0.5), 0.5)
    assert [step.tool for step in window.painting.steps] == ["stamp"]
    for kind, x in ((QEvent.TabletPress, 0.5), (QEvent.TabletMove, 0.55), (QEvent.TabletRelease, 0.55)):
        tablet(window.canvas, kind, (x, 0.5), 0.5, rubber=True)
    assert [step.tool for step in window.painting.steps] == ["stamp", "eraser"]


# text


def test_text_is_typed_pulled_sized_and_painted(window):
    canvas = window.canvas
    press("PaintText")
    press(f"PaintColour{RED}")
    click(canvas, (0.3, 0.5))
    field = hands.find("PaintWords")
    assert field.hasFocus()
    for letter in "Mia":
        hands.key(field, 0, letter)
    floating = canvas.floating
    assert floating.is_there()
    assert not window.painting.steps
    before = QtCore.QRectF(floating.box)
    hands.screenshot("paint-text")
    middle = before.center() / SIDE
    draw(canvas, [(middle.x(), middle.y()), (middle.x() + 0.1, middle.y())], let_live=False)
    assert floating.box.left() == pytest.approx(before.left() + 100, abs=3)
    corner = floating.box.bottomRight() / SIDE
    draw(
        canvas,
        [(corner.x(), corner.y()), (corner.x() + 0.1, corner.y() + 0.1)],
        let_live=False,
    )
    assert floating.box.height() > before.height() + 50
    wide = box_of(pixels(floating.image)[..., 3] > 127)
    hands.key(field, Qt.Key_Return, "\r")
    assert [step.tool for step in window.painting.steps] == ["picture"]
    assert canvas.hasFocus()
    painted = box_of(ink(window))
    assert painted[2:] == pytest.approx(wide[2:], abs=1)
    press("PaintUndo")
    assert window.painting.is_empty()
    click(canvas, (0.4, 0.4))
    for letter in "no":
        hands.key(field, 0, letter)
    hands.key(field, Qt.Key_Escape)
    click(canvas, (0.4, 0.4))
    hands.key(field, Qt.Key_Return, "\r")  # nothing typed
    assert window.painting.is_empty()
    assert not window.painting.steps


@pytest.mark.parametrize(
    "words", ["\N{BALLOON}\N{PARTY POPPER}", "שלום", "مرحبا", "漢字", "a" * 80, "\t", "fi\u0301\u202e"]
)
def test_words_of_any_script(window, words):
    """They are painted, or are nothing where the system has no font for them; nothing breaks."""
    press("PaintText")
    click(window.canvas, (0.5, 0.5))
    hands.find("PaintWords").setText(words)
    assert window.canvas.floating.box.right() <= SIDE
    assert window.canvas.floating.box.width() <= 0.92 * SIDE
    hands.key(hands.find("PaintWords"), Qt.Key_Return, "\r")
    assert len(window.painting.steps) == int(words != "\t")
    for height in (0.0, 1.0, 1e9):
        for joined in (False, True):
            image = picture_of(words, "no such font", height, RED, joined)
            assert 0 < image.width() <= 2 * SIDE
            assert 0 < image.height() <= 2 * SIDE


def test_words_go_to_the_layer_that_is_chosen_while_they_are_typed(window):
    draw(window.canvas, [(0.1, 0.5), (0.9, 0.5)], let_live=False)
    press("PaintText")
    click(window.canvas, (0.3, 0.5))
    hands.find("PaintWords").setText("Mia")
    press("PaintLayerDecoration")
    assert window.canvas.floating.is_there()
    hands.key(hands.find("PaintWords"), Qt.Key_Return, "\r")
    assert [step.layer for step in window.painting.steps] == ["shape", "decoration"]


def test_joined_letters_are_one_shape(window):
    from BalloonWorkbench.core.tracing.raster import label

    press("PaintText")
    click(window.canvas, (0.5, 0.5))
    hands.find("PaintWords").setText("il")
    hands.tick(hands.find("PaintJoined"))
    hands.key(hands.find("PaintWords"), Qt.Key_Return, "\r")
    assert label(ink(window))[1] == 1


# long paintings


def test_two_hundred_steps_are_taken_back_and_done_again(window):
    painting = window.painting
    press("PaintStamps")
    for number in range(200):
        click(window.canvas, (0.1 + 0.04 * (number % 20), 0.1 + 0.08 * (number // 20)))
    whole = pixels(painting.image)
    for _ in range(200):
        key(window.canvas, Qt.Key_Z, modifiers=CTRL)
    assert painting.is_empty()
    assert not painting.can_undo()
    for _ in range(200):
        key(window.canvas, Qt.Key_Y, modifiers=CTRL)
    assert (pixels(painting.image) == whole).all()


def test_a_painting_that_is_too_long_for_a_file_stays_one(tmp_path):
    """Many pictures in it: its layers are kept as they are, and can be painted on."""
    from BalloonWorkbench.gui.paint.painting.pieces import PastedPicture, packed

    noise = np.random.default_rng(1).integers(0, 255, (SIDE, SIDE, 4), dtype=np.uint8)
    noise[..., 3] = 255
    image = QtGui.QImage(noise.tobytes(), SIDE, SIDE, QtGui.QImage.Format_RGBA8888)
    painting = Painting()
    painting.do(PastedPicture(packed(image.convertToFormat(QtGui.QImage.Format_RGB32)), (0, 0, 500, 500)))
    for _ in range(3):
        painting.do(PastedPicture(packed(image), (100, 100, 300, 300)))
    assert painting.file_image().save(str(tmp_path / "long.png"))
    again = Painting()
    again.load(tmp_path / "long.png")
    assert len(again.steps) == 2
    assert np.abs(pixels(again.layers[SHAPE]).astype(int) - pixels(painting.layers[SHAPE])).max() <= 1
