# SPDX-License-Identifier: LGPL-2.1-or-later
"""Symmetric painting: about any axis, up to twelve times around a centre, with every tool that paints."""

import base64
import json
import math
import zlib

import hands
import numpy as np
import pytest
from brush import (
    BLACK,
    RED,
    QEvent,
    Qt,
    click,
    colour_at,
    draw,
    key,
    mouse,
    press,
    rgba,
)

from BalloonWorkbench.app.drawings.drawing_file import KEY
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint.canvas.inputs import ring_of
from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.paint.painting.painted import Painting
from BalloonWorkbench.gui.paint.painting.pieces import Stamped
from BalloonWorkbench.gui.paint.painting.strokes import BRUSH, PEN, Fill, PaintStroke
from BalloonWorkbench.gui.paint.painting.symmetry import ONCE, Symmetry, mapped
from BalloonWorkbench.gui.paint.painting.widen import Widen


@pytest.mark.parametrize("fold", range(3, 13))
@pytest.mark.parametrize("mirror", [False, True])
def test_places_of_a_symmetry(fold, mirror):
    """All are equally far from the centre, none twice; each symmetry maps them onto each other."""
    symmetry = Symmetry(fold, mirror, 430.0, 610.0, 20.0)
    places = np.array([mapped(each, [(700.0, 550.0)])[0] for each in symmetry.transforms])
    assert len(places) == (2 * fold if mirror else fold)
    away = np.hypot(*(places - (430.0, 610.0)).T)
    assert np.ptp(away) < 1e-6
    gaps = np.linalg.norm(places[:, None] - places[None], axis=2) + 1e9 * np.eye(len(places))
    assert gaps.min() > 1.0
    for each in symmetry.transforms:
        images = mapped(each, places)
        assert np.linalg.norm(images[:, None] - places[None], axis=2).min(axis=1).max() < 1e-6
    assert np.allclose(places[0], (700.0, 550.0))
    assert len(symmetry.lines()) == (2 * fold if mirror else fold)


def test_a_mirror_about_any_axis():
    slanted = Symmetry(mirror=True, angle=45.0, x=500.0, y=500.0)
    (image,) = mapped(slanted.transforms[1], [(700.0, 500.0)])
    assert image == pytest.approx((500.0, 300.0))  # y is down
    assert Symmetry().is_none
    assert ONCE.lines() == []


def test_what_was_mirrored_in_older_files_is_the_same_to_the_pixel(tmp_path):
    """A file of the first version; what it makes was drawn with Qt's own mirror then."""
    points = [[120.5, 200.25, 14.0], [180.0, 420.0, 20.0], [260.0, 300.0, 9.0]]
    steps = [
        {"tool": "brush", "colour": RED, "mirror": True, "points": points},
        {"tool": "pen", "colour": BLACK, "mirror": False, "points": points},
        {"tool": "widen", "points": [[150, 300], [170, 380]], "was": 14.0, "wanted": 30.0, "mirror": True},
        {"tool": "clear"},
        {"tool": "brush", "colour": RED, "mirror": True, "points": points},
    ]
    text = json.dumps({"version": 1, "steps": steps, "backdrop": None})
    image = hands.QtGui.QImage(SIDE, SIDE, hands.QtGui.QImage.Format_ARGB32)
    image.fill(0)
    image.setText(KEY, base64.b64encode(zlib.compress(text.encode())).decode())
    assert image.save(str(tmp_path / "old.png"))
    painting = Painting()
    painting.load(tmp_path / "old.png")
    expected = hands.QtGui.QImage(SIDE, SIDE, hands.QtGui.QImage.Format_ARGB32_Premultiplied)
    expected.fill(0)
    stroke = PaintStroke(BRUSH, RED, points=[tuple(point) for point in points])
    assert painting.steps[4].symmetry.transforms[1] == hands.QtGui.QTransform(-1, 0, 0, 1, SIDE, 0)
    for number in range(len(points) + 1):
        piece, width = stroke._piece(number)
        painter = hands.QtGui.QPainter(expected)
        painter.setRenderHint(hands.QtGui.QPainter.Antialiasing)
        for transform in (hands.QtGui.QTransform(), hands.QtGui.QTransform(-1, 0, 0, 1, SIDE, 0)):
            painter.setTransform(transform)
            for opacity, extra in ((60, 3.0), (255, 0.0)):
                colour = hands.QtGui.QColor(RED)
                colour.setAlpha(opacity)
                pen = hands.QtGui.QPen(colour, width + extra, Qt.SolidLine, Qt.RoundCap, Qt.RoundJoin)
                painter.strokePath(piece, pen)
        painter.end()
    assert (pixels(painting.image) == pixels(expected)).all()


def test_a_stroke_a_fill_and_a_stamp_six_times_around(window):
    canvas = window.canvas
    window.extras.bar.fold.setValue(6)
    places = [(0.5 + 0.3 * math.cos(t), 0.5 + 0.3 * math.sin(t)) for t in (0.0, math.pi / 3, 2 * math.pi / 3)]
    draw(canvas, [places[0], places[1]], let_live=False)  # a sixth of a hexagon
    for k in range(6):
        turn = math.pi / 3 * k
        assert colour_at(window, 0.5 + 0.298 * math.cos(turn), 0.5 + 0.298 * math.sin(turn))[3] > 0
    press("PaintFill")
    press(f"PaintColour{RED}")
    click(canvas, (0.55, 0.5))
    assert colour_at(window, 0.5, 0.5) == rgba(RED)
    press("PaintStamps")
    press("PaintStampCircle")
    press("PaintColour#1f78d8")
    draw(canvas, [(0.7, 0.5), (0.73, 0.5)], let_live=False)
    assert len(window.painting.steps) == 3
    for k in range(6):
        turn = math.pi / 3 * k
        assert colour_at(window, 0.5 + 0.2 * math.cos(turn), 0.5 + 0.2 * math.sin(turn)) == rgba("#1f78d8")
    for _ in range(3):
        press("PaintUndo")
    assert window.painting.is_empty()


def test_the_axis_is_pulled_and_turned(window):
    canvas = window.canvas
    key(canvas, Qt.Key_M, "m")
    key(canvas, Qt.Key_A, "a")
    draw(canvas, [(0.5, 0.5), (0.4, 0.6)], let_live=False)
    symmetry = window.hand.symmetry
    assert (symmetry.x, symmetry.y) == pytest.approx((400.0, 600.0), abs=2)
    ring = ring_of(symmetry)
    start = (ring.x() / SIDE, ring.y() / SIDE)
    draw(canvas, [start, (0.6, 0.6)], let_live=False)  # to the right of the centre
    assert window.hand.symmetry.angle == pytest.approx(0.0, abs=1.0)
    assert not window.painting.steps
    mouse(canvas, QEvent.MouseButtonPress, (0.5, 0.5))
    mouse(canvas, QEvent.MouseMove, (0.8, 0.8), Qt.NoButton)
    key(canvas, Qt.Key_Escape)
    mouse(canvas, QEvent.MouseButtonRelease, (0.8, 0.8), held=Qt.NoButton)
    assert window.hand.symmetry.x == pytest.approx(400.0, abs=2)  # as before
    key(canvas, Qt.Key_P, "p")
    draw(canvas, [(0.5, 0.8), (0.6, 0.8)], let_live=False)
    assert colour_at(window, 0.55, 0.4) == rgba(BLACK)
    assert colour_at(window, 0.55, 0.8) == rgba(BLACK)


def test_strokes_that_leave_the_paper(window):
    """Off the paper, about a centre in its corner, twelve times and mirrored, with the widest brush."""
    canvas = window.canvas
    window.hand.symmetry = Symmetry(12, True, 10.0, 990.0, 33.0)
    window.hand.set_thickness(60)
    press("PaintBrush")
    draw(canvas, [(0.5, 0.5), (1.3, 0.4), (-0.3, 1.2), (0.2, 0.2)], let_live=False)
    assert len(window.painting.steps) == 1
    press("PaintFill")
    click(canvas, (0.5, 0.5))
    assert len(window.painting.steps) == 2
    again = Painting()
    for step in window.painting.steps:
        again.do(type(step).from_data(json.loads(json.dumps(step.data()))))
    assert (pixels(again.image) == pixels(window.painting.image)).all()


def test_widening_leaves_out_copies_that_touch():
    line = [(600.0, 300.0), (600.0, 400.0)]
    for symmetry, widened in (
        (Symmetry(mirror=True), [600, 400]),
        (Symmetry(mirror=True, x=610.0), [600]),
        (Symmetry(2), [600]),
    ):
        painting = Painting()
        for x in (600.0, 400.0):
            painting.do(PaintStroke(PEN, BLACK, points=[(x, 200.0, 12.0), (x, 500.0, 12.0)]))
        painting.do(Widen(line, 12.0, 30.0, symmetry))
        row = pixels(painting.image)[350, :, 3] > 127
        for x in (600, 400):
            wide = row[x - 40 : x + 40].sum()
            assert wide == pytest.approx(30 if x in widened else 12, abs=2), (symmetry, x)


def test_steps_of_all_kinds_come_back_from_their_data():
    symmetry = Symmetry(5, True, 123.0, 456.0, 78.0)
    for step in (
        PaintStroke(PEN, RED, symmetry, [(1.0, 2.0, 3.0)], "decoration"),
        Fill(RED, 10.0, 20.0, symmetry, "decoration"),
        Stamped(RED, [(1.0, 2.0), (3.0, 4.0), (5.0, 6.0)], symmetry, "decoration"),
        Widen([(1.0, 2.0), (3.0, 4.0)], 5.0, 6.0, symmetry),
    ):
        assert type(step).from_data(json.loads(json.dumps(step.data()))) == step
