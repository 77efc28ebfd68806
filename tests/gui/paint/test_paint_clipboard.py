# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces that are copied within the program, to other documents and from other programs."""

import io
import struct
import zlib
from pathlib import Path

import FreeCAD as App
import hands
import pytest
from brush import BLUE, RED, YELLOW, Qt, box_of, colour_at, draw, ellipse, ink, key, open_window, press, rgba

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.painting.layers import SIDE

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets
HEART = Path("resources/examples/pictures/heart.png").resolve()
CTRL = Qt.ControlModifier


@pytest.fixture(autouse=True)
def clipboard():
    board = QtWidgets.QApplication.clipboard()
    yield board
    board.clear()


def offer(board, kind, content):
    mime = QtCore.QMimeData()
    mime.setData(kind, QtCore.QByteArray(content))
    board.setMimeData(mime)


def content_of(image, kind):
    buffer = QtCore.QBuffer()
    buffer.open(QtCore.QIODevice.WriteOnly)
    assert image.save(buffer, kind)
    return bytes(buffer.data())


def test_a_piece_is_cut_pasted_and_pulled(window, clipboard):
    canvas = window.canvas
    draw(canvas, ellipse(0.3, 0.3, 0.1, 0.1), let_live=False)
    press("PaintSelect")
    draw(canvas, [(0.15, 0.15), (0.45, 0.45)], let_live=False)
    assert canvas.selection.box == pytest.approx((150, 150, 300, 300), abs=3)
    whole = pixels(window.painting.image)
    key(canvas, Qt.Key_C, "\x03", CTRL)
    assert len(window.painting.steps) == 1
    assert clipboard.mimeData().hasFormat("image/png")
    key(canvas, Qt.Key_X, "\x18", CTRL)
    assert window.painting.is_empty()
    key(canvas, Qt.Key_V, "\x16", CTRL)
    assert canvas.floating.is_there()
    assert len(window.painting.steps) == 2
    hands.screenshot("paint-paste")
    key(canvas, Qt.Key_Escape)
    assert not canvas.floating.is_there()
    key(canvas, Qt.Key_V, "\x16", CTRL)
    canvas.floating.box.moveTopLeft(QtCore.QPointF(canvas.selection.box[0], canvas.selection.box[1]))
    key(canvas, Qt.Key_Return, "\r")
    assert len(window.painting.steps) == 3
    assert (pixels(window.painting.image) == whole).all()
    press("PaintUndo")
    press("PaintUndo")
    assert (pixels(window.painting.image) == whole).all()


def test_a_piece_goes_into_another_document(doc, window):
    draw(window.canvas, ellipse(0.5, 0.5, 0.2, 0.2), let_live=False)
    key(window.canvas, Qt.Key_A, "\x01", CTRL)
    key(window.canvas, Qt.Key_C, "\x03", CTRL)
    area = ink(window).sum()
    other = App.newDocument("Other")
    second = open_window()
    assert second is not window
    key(second.canvas, Qt.Key_V, "\x16", CTRL)
    key(second.canvas, Qt.Key_Return, "\r")
    assert ink(second).sum() == area
    App.closeDocument(other.Name)
    hands.wait(0.1)


def test_pictures_of_other_programs_lose_their_background(window, clipboard):
    photo = QtGui.QImage(300, 300, QtGui.QImage.Format_RGB32)
    photo.fill(QtGui.QColor("#ffffff"))
    painter = QtGui.QPainter(photo)
    painter.setBrush(QtGui.QColor(RED))
    painter.drawEllipse(60, 60, 180, 180)
    painter.end()
    offer(clipboard, "image/jpeg", content_of(photo, "JPG"))
    key(window.canvas, Qt.Key_V, "\x16", CTRL)
    hands.wait_until(window.canvas.floating.is_there, 20)
    assert pixels(window.canvas.floating.image)[5, 5, 3] == 0
    key(window.canvas, Qt.Key_Escape)
    key(window.canvas, Qt.Key_D, "d")
    key(window.canvas, Qt.Key_V, "\x16", CTRL)
    assert pixels(window.canvas.floating.image)[5, 5, 3] == 255  # a print is as it is
    key(window.canvas, Qt.Key_Escape)


def test_a_large_picture_becomes_as_large_as_the_paper(window, clipboard):
    """Also one that is offered without the content of a file."""
    large = QtGui.QImage(5000, 2500, QtGui.QImage.Format_ARGB32)
    large.fill(QtGui.QColor(RED))
    large.setPixelColor(0, 0, QtGui.QColor(0, 0, 0, 0))
    bare = QtCore.QMimeData()
    bare.setImageData(large)
    for give in (
        lambda: clipboard.setMimeData(bare),
        lambda: offer(clipboard, "image/png", content_of(large, "PNG")),
    ):
        give()
        key(window.canvas, Qt.Key_V, "\x16", CTRL)
        hands.wait_until(window.canvas.floating.is_there, 20)
        box = window.canvas.floating.box
        assert (box.width(), box.height()) == (SIDE, SIDE / 2)
        key(window.canvas, Qt.Key_Escape)


def test_lines_of_other_programs_are_filled(window, clipboard):
    ring = b"""<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">
    <path d="M0 0 L100 0 L100 100 L0 100 Z M30 30 L30 70 L70 70 L70 30 Z" fill="#000"
    fill-rule="evenodd"/></svg>"""
    offer(clipboard, "image/svg+xml", ring)
    key(window.canvas, Qt.Key_V, "\x16", CTRL)
    hands.wait_until(window.canvas.floating.is_there, 20)
    key(window.canvas, Qt.Key_Return, "\r")
    _, _, width, height = box_of(ink(window))
    assert (width, height) == pytest.approx((600, 600), abs=3)
    assert ink(window).sum() == pytest.approx(360000 * (1 - 0.16), rel=0.02)


def test_what_cannot_be_pasted_is_said(window, clipboard):
    def said(kind, content):
        window.form.show_message("")
        offer(clipboard, kind, content)
        key(window.canvas, Qt.Key_V, "\x16", CTRL)
        hands.wait(0.05)
        assert not window.canvas.floating.is_there()
        return window.form.hint.text()

    huge = bytearray(content_of(QtGui.QImage(1, 1, QtGui.QImage.Format_RGB32), "PNG"))
    huge[16:24] = struct.pack(">II", 20_000, 20_000)
    huge[29:33] = struct.pack(">I", zlib.crc32(bytes(huge[12:29])))
    assert "20000 x 20000" in said("image/png", bytes(huge))
    assert "not a picture" in said("image/png", b"\x89PNG\r\n\x1a\nnothing")
    assert "no picture" in said("text/plain", b"hello")
    deep = b"<svg>" + b"<g>" * 5000 + b"</g>" * 5000 + b"</svg>"
    assert said("image/svg+xml", deep)
    assert "no picture" in said("image/svg+xml", b"") or window.form.hint.text()
    clipboard.clear()
    key(window.canvas, Qt.Key_V, "\x16", CTRL)
    assert "no picture" in window.form.hint.text()
    assert not window.painting.steps


def animated():
    """Two pictures one after the other: red, then blue."""
    from PIL import Image

    frames = [Image.new("RGB", (64, 64), colour) for colour in (RED, BLUE)]
    content = io.BytesIO()
    frames[0].save(content, "GIF", save_all=True, append_images=frames[1:], duration=100)
    return content.getvalue()


def test_of_an_animation_the_first_picture_is_pasted(window, clipboard):
    pytest.importorskip("PIL")
    key(window.canvas, Qt.Key_D, "d")
    offer(clipboard, "image/gif", animated())
    key(window.canvas, Qt.Key_V, "\x16", CTRL)
    assert tuple(pixels(window.canvas.floating.image)[30, 30, :3]) == pytest.approx(rgba(RED)[:3], abs=3)
    key(window.canvas, Qt.Key_Return, "\r")
    assert len(window.painting.steps) == 1


def test_a_file_is_dropped_on_the_paper(window):
    mime = QtCore.QMimeData()
    mime.setUrls([QtCore.QUrl.fromLocalFile(str(HEART))])
    place = window.canvas.paper.to_screen(QtCore.QPointF(0.4 * SIDE, 0.3 * SIDE)).toPoint()
    enter = QtGui.QDragEnterEvent(place, Qt.CopyAction, mime, Qt.LeftButton, Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(window.canvas, enter)
    assert enter.isAccepted()
    drop = QtGui.QDropEvent(QtCore.QPointF(place), Qt.CopyAction, mime, Qt.LeftButton, Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(window.canvas, drop)
    hands.wait_until(window.canvas.floating.is_there, 20)
    middle = window.canvas.floating.box.center()
    assert (middle.x(), middle.y()) == pytest.approx((400, 300), abs=3)
    press("PaintPen")  # another tool paints what is being placed
    assert [step.tool for step in window.painting.steps] == ["picture"]


def laid(window, width=200, height=60):
    """A red rectangle that is being placed, its right half yellow, in the middle of the paper."""
    image = QtGui.QImage(width, height, QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(QtGui.QColor(RED))
    painter = QtGui.QPainter(image)
    painter.fillRect(width // 2, 0, width, height, QtGui.QColor(YELLOW))
    painter.end()
    window.canvas.floating.lay(image, QtCore.QPointF(0.5 * SIDE, 0.5 * SIDE))
    return window.canvas.floating


def ring(window):
    """The place of the paper, 0 to 1, at which what is being placed is turned."""
    floating = window.canvas.floating
    place = floating._turned().map(floating._ring(window.canvas.paper.zoom)) / SIDE
    return place.x(), place.y()


def test_a_piece_is_turned_by_its_ring(window):
    """A quarter clockwise: what was right is below then, and nothing of it is lost."""
    floating = laid(window)
    draw(window.canvas, [ring(window), (0.7, 0.45), (0.7, 0.5)], let_live=False)
    assert floating.angle == pytest.approx(90.0, abs=0.2)
    hands.screenshot("paint-turned")
    key(window.canvas, Qt.Key_Return, "\r")
    assert box_of(ink(window)) == pytest.approx((470, 400, 60, 200), abs=2)
    assert colour_at(window, 0.5, 0.45) == rgba(RED)
    assert colour_at(window, 0.5, 0.55) == rgba(YELLOW)
    assert int(ink(window).sum()) == pytest.approx(200 * 60, rel=0.01)
    assert len(window.painting.steps) == 1
    press("PaintUndo")
    assert window.painting.is_empty()


def test_a_turned_piece_keeps_its_corner_while_it_is_sized(window):
    floating = laid(window)
    for letter in "]]]":
        key(window.canvas, Qt.Key_BracketRight, letter)
    key(window.canvas, Qt.Key_BracketLeft, "[")
    assert floating.angle == 30.0
    fixed = floating._turned().map(floating.box.topLeft())
    corner = floating._turned().map(floating.box.bottomRight()) / SIDE
    draw(window.canvas, [(corner.x(), corner.y()), (corner.x() + 0.08, corner.y() + 0.08)], let_live=False)
    assert floating.box.width() > 250
    after = floating._turned().map(floating.box.topLeft())
    assert (after.x(), after.y()) == pytest.approx((fixed.x(), fixed.y()), abs=1e-6)
    key(window.canvas, Qt.Key_Plus, "+")
    assert floating._turned().map(floating.box.topLeft()).x() == pytest.approx(fixed.x(), abs=1e-6)
    width, height = floating.box.width(), floating.box.height()
    key(window.canvas, Qt.Key_Return, "\r")
    assert int(ink(window).sum()) == pytest.approx(width * height, rel=0.02)
    laid(window)
    assert window.canvas.floating.angle == 0.0  # the next one lies straight


def test_a_piece_that_is_turned_beyond_the_paper_is_cut_off_there(window):
    floating = laid(window, 1000, 1000)
    floating.turn_by(45.0)
    floating.nudge(500.0, 500.0)
    key(window.canvas, Qt.Key_Return, "\r")
    assert int(ink(window).sum()) == pytest.approx(0.25 * 1e6, rel=0.1)
    for turn in range(30):
        floating = laid(window, 3, 900)
        floating.turn_by(13.0 * turn)
        window.canvas.floating.confirm()
    assert not window.painting.is_empty()
