# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown on the flat pieces: results as colours with a legend, the print; and they go to paper."""

import hands
import numpy as np
import pytest
from flat_hands import at, key, open_tab, settled

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.api import making
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.results import colour_map
from BalloonWorkbench.gui.pattern_view import tab as tabs
from BalloonWorkbench.gui.pattern_view.looks import ARTWORK

Qt = hands.QtCore.Qt
FOUR = ((220, 0, 0), (0, 180, 0), (0, 0, 220), (230, 220, 0))  # red, green; below them blue, yellow


def choose(tab, data):
    box = tab.looks.list
    hands.choose(box, box.itemText(box.findData(data)))
    hands.wait(0.1)


def colour(tab, place):
    """The pixel (3,) of the view at a place of the pieces [m]."""
    there = at(tab, place).toPoint()
    picture = pixels(tab.view.viewport().grab().toImage())
    ratio = tab.view.devicePixelRatioF()
    return picture[round(there.y() * ratio), round(there.x() * ratio), :3].astype(int)


def middle_of(tab, number):
    return np.array(tab.view.laid.places[number].middle)


@pytest.fixture
def quarters(tmp_path):
    """A picture of four colours: red and green above, blue and yellow below."""
    picture = hands.QtGui.QImage(300, 200, hands.QtGui.QImage.Format_RGB32)
    painter = hands.QtGui.QPainter(picture)
    for number, rgb in enumerate(FOUR):
        row, column = divmod(number, 2)
        painter.fillRect(150 * column, 100 * row, 150, 100, hands.QtGui.QColor(*rgb))
    painter.end()
    path = tmp_path / "quarters.png"
    assert picture.save(str(path))
    return path


def test_results_lie_on_both_panels(made):
    tab = open_tab(made.pattern)
    settled(tab)
    assert not tab.looks.legend.isVisible()
    plain = colour(tab, middle_of(tab, 0))
    choose(tab, colour_map.TENSION)
    assert tab.looks.legend.isVisible()
    assert "N/m" in tab.looks.legend.accessibleName()
    scale = colour_map.colours(np.linspace(0.0, 1.0, 200)).astype(int)
    away = np.array([0.012, 0.007])
    first = colour(tab, middle_of(tab, 0) + away)
    assert np.abs(scale - first).sum(axis=1).min() < 20
    for x in np.linspace(-0.03, 0.03, 9):  # the back is the front's mirror image
        for y in (-0.018, -0.007, 0.007, 0.018):
            both = [
                colour(tab, middle_of(tab, number) + np.array([sign * x, y]))
                for number, sign in ((0, 1), (1, -1))
            ]
            assert np.abs(both[0] - both[1]).sum() < 15
    hands.screenshot("pattern-view-tension")
    tab.view.choose(1)
    key(tab, Qt.Key_R, "r")
    key(tab, Qt.Key_H, "h")  # it goes with the piece
    place = tab.view.laid.places[1]
    turned = (away * (-1.0, 1.0)) @ place.matrix
    assert np.abs(colour(tab, middle_of(tab, 1) + turned) - first).sum() < 12
    choose(tab, "Film")
    assert not tab.looks.legend.isVisible()
    assert (colour(tab, middle_of(tab, 0)) == plain).all()


def test_the_print_lies_on_both_panels(made, quarters):
    printed = artwork.make(made.pattern, str(quarters))
    made.pattern.Document.recompute()
    tab = open_tab(made.pattern)
    settled(tab)
    choose(tab, "Artwork")
    outline = made.outline.Shape.BoundBox
    centre = 1e-3 * np.array([outline.Center.x, outline.Center.y])
    red, _, blue, _ = map(np.array, FOUR)
    left, up = 0.015 * np.array([-1.0, 0.0]), 0.01 * np.array([0.0, 1.0])
    assert np.abs(colour(tab, centre + left + up) - red).sum() < 30
    assert np.abs(colour(tab, centre + left - up) - blue).sum() < 30
    edge, other = tab.view.laid.base.edges[0], tab.view.laid.base.edges[tab.view.pieces.partner(0)]
    back = other.line[0] - edge.line[0] * (-1.0, 1.0)  # from the front's mirror image to the back
    assert np.abs(colour(tab, (centre + left + up) * (-1.0, 1.0) + back) - red).sum() < 30
    hands.screenshot("pattern-view-print")
    made.pattern.Document.removeObject(printed.Name)
    hands.wait_until(lambda: tab.looks.list.findData("Artwork") < 0, 5)
    assert tab.looks.list.currentData() == "Film"


@pytest.mark.slow
def test_many_panels_have_print_and_results(doc, quarters):
    box = create.balloon_from_panels(doc, "Box", mesh_size="30 mm")
    artwork.make(box.pattern, str(quarters))
    doc.recompute()
    tab = open_tab(box.pattern)
    settled(tab)
    choose(tab, "Artwork")
    hues = [colour(tab, middle_of(tab, number) + 0.01) for number in range(6)]
    for hue in hues:
        assert np.abs(np.array(FOUR) - hue).sum(axis=1).min() < 60
    assert tab.view.pieces.pieces[0].name == "bottom"  # seen from outside it has all of the picture
    for rgb, x, y in zip(FOUR, (-0.05, 0.05, -0.05, 0.05), (0.03, 0.03, -0.03, -0.03)):
        assert np.abs(colour(tab, middle_of(tab, 0) + np.array([x, y])) - rgb).sum() < 60
    for x, y in ((-0.003, 0.003), (0.003, 0.003), (-0.003, -0.003), (0.003, -0.003)):  # they meet amid it
        rgb = FOUR[(x > 0) + 2 * (y < 0)]
        assert np.abs(colour(tab, middle_of(tab, 0) + np.array([x, y])) - rgb).sum() < 60
    hands.screenshot("pattern-view-print-of-many")
    choose(tab, colour_map.WRINKLES)
    scale = colour_map.colours(np.linspace(0.0, 1.0, 200)).astype(int)
    for number in range(6):
        assert np.abs(scale - colour(tab, middle_of(tab, number) + 0.01)).sum(axis=1).min() < 20
    hands.screenshot("pattern-view-wrinkles-of-many")


def test_they_go_to_paper_as_they_lie(made, quarters, tmp_path, stand_in):
    tab = open_tab(made.pattern)
    files = [tmp_path / "first.pdf", tmp_path / "turned.pdf", tmp_path / "printed.pdf"]
    for file in files:
        if file.name == "printed.pdf":
            making.artwork(made.pattern, picture=str(quarters), resolution=60)
            hands.wait_until(lambda: tab.looks.list.findData(ARTWORK) > 0)
            choose(tab, ARTWORK)
        stand_in.setattr(tabs, "ask_where_to_write", lambda *_asked, file=file: str(file))
        buttons = hands.visible(hands.QtWidgets.QToolButton)
        hands.click(next(each for each in buttons if tab.isAncestorOf(each) and each.text() == "Print"))
        hands.wait_until(lambda file=file: file.name in tab.line.text(), 20)
        tab.view.choose(0)
        key(tab, Qt.Key_R, "r")
    first, turned, printed = (file.read_bytes() for file in files)
    assert first.startswith(b"%PDF")
    assert first != turned
    assert [b"/Subtype /Image" in content for content in (first, turned, printed)] == [False, False, True]
