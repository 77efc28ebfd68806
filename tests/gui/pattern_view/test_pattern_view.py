# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab with the flat pieces: opened, picked in, measured in; it follows its document and goes with it."""

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
from flat_hands import click, lit, middle, open_tab

from BalloonWorkbench.app import film_sheet
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.gui.pattern_view import tab as tabs

Kind, Qt = hands.QtCore.QEvent, hands.QtCore.Qt


@pytest.fixture
def box(doc):
    """A ready box of few triangles: six panels, twelve seams."""
    return create.balloon_from_panels(doc, "Box", mesh_size="30 mm")


def closed():
    return not tabs._tabs


def test_a_seam_is_picked_on_both_panels(box):
    tab = open_tab(box.balloon)
    pieces = tab.view.pieces
    assert len(pieces.pieces) == box.balloon.PanelCount == 6
    number = 5
    click(tab, middle(pieces.edges[number]))
    partner = pieces.partner(number)
    owners = [pieces.pieces[pieces.edges[each].piece].name for each in (number, partner)]
    assert lit(tab) == 2
    assert tab.line.text().startswith(f"Seam {pieces.edges[number].seam}: {owners[0]}, ")
    assert f"; {owners[1]}, " in tab.line.text()
    (chosen,) = Gui.Selection.getSelection()
    assert (chosen.PanelName, chosen.Pattern) == (owners[0], box.pattern)
    hands.wait(0.6)  # FreeCAD's tree has followed, and would bring the 3D view to the front
    assert tab.isVisible()
    hands.screenshot("pattern-view")
    click(tab, pieces.pieces[0].pattern.bounds[0] - 0.004)  # beside all film
    assert lit(tab) == 0
    assert open_tab(box.pattern) is tab  # the same one again


def test_corner_to_corner_is_measured(made):
    tab = open_tab(made.pattern)
    front, back = ([edge for edge in tab.view.pieces.edges if edge.piece == piece] for piece in range(2))
    assert len(front) == len(back) == 4  # 90 x 60 mm as drawn, whichever is cut
    brush.key(tab.view, Qt.Key_M, "m")
    assert tab.measuring.isChecked()
    away = 3.0 / tab.view.zoom * 1e-3  # three pixels beside
    for place in (front[0].line[0], front[0].line[-1]):
        click(tab, place + away)
    wide = np.linalg.norm(front[0].line[-1] - front[0].line[0])
    measured = float(tab.line.text().split()[1])
    assert measured == pytest.approx(1e3 * wide, abs=0.06)
    brush.key(tab.view, Qt.Key_Escape)
    assert not tab.view.measuring
    click(tab, middle(back[2]))
    assert lit(tab) == 2
    assert Gui.Selection.getSelection() == [made.pattern]


def test_wheel_keys_and_drag_move_the_view(made):
    tab = open_tab(made.pattern)
    view, whole = tab.view, tab.view.zoom
    brush.key(view, Qt.Key_Plus, "+")
    assert view.zoom == pytest.approx(1.25 * whole)
    beside = view.viewport().rect().bottomLeft() + hands.QtCore.QPoint(4, -4)
    before = view.mapToScene(beside)
    hands.drag(view.viewport(), (beside.x(), beside.y()), (beside.x() + 60, beside.y() - 40))
    after = view.mapToScene(beside + hands.QtCore.QPoint(60, -40))
    assert (after.x(), after.y()) == pytest.approx((before.x(), before.y()), abs=2.0 / view.zoom)
    assert lit(tab) == 0  # that was no click
    brush.key(view, Qt.Key_0, "0")
    assert view.zoom == pytest.approx(whole)


def test_it_follows_recomputes_and_keeps_what_it_had(made):
    tab = open_tab(made.pattern)
    doc, before = made.pattern.Document, tab.view.pieces
    made.pattern.SealWidth = "9 mm"
    doc.recompute()
    hands.wait_until(lambda: tab.view.pieces is not before, 5)
    assert tab.view.pieces.pieces[0].pattern.seal_width == pytest.approx(9e-3)
    kept = tab.view.pieces
    made.pattern.SealWidth = "2 m"  # more than can be
    doc.recompute()
    hands.wait_until(lambda: tab.line.text() == status.problem(made.pattern), 5)
    assert tab.view.pieces is kept
    made.pattern.Document.removeObject(made.pattern.Name)
    hands.wait_until(closed, 5)


@pytest.mark.slow
def test_two_documents_have_a_tab_each(made, box):
    one, other = open_tab(made.pattern), open_tab(box.pattern)
    assert one is not other
    area = Gui.getMainWindow().findChild(hands.QtWidgets.QMdiArea)
    for tab in (one, other, one):
        area.setActiveSubWindow(tab.parentWidget())
        hands.wait_until(lambda tab=tab: tab.isVisible() and tab.parentWidget().isMaximized(), 5)
        click(tab, middle(tab.view.pieces.edges[0]))
        assert lit(tab) == 2
        hands.wait(0.6)  # FreeCAD has followed
        assert tab.isVisible(), "also in the tab of a document that is not the active one"
    App.closeDocument(box.pattern.Document.Name)
    hands.wait_until(lambda: tabs._tabs == [one], 5)
    App.closeDocument(made.pattern.Document.Name)
    hands.wait_until(closed, 5)


def test_nothing_solved_yet_and_a_sheet_of_film(made):
    sheet = film_sheet.make(made.pattern.Document, [made.pattern])
    tab = open_tab(sheet)
    assert tab.view.pieces is None
    assert tab.line.text() == "Film sheet is not worked out yet: recompute the document."
    click_all = (tab.view.fit, lambda: tab.view.zoom_by(2.0), lambda: tab.pick(None))
    for each in click_all:
        each()
    brush.mouse_at(tab.view.viewport(), Kind.MouseButtonPress, hands.QtCore.QPointF(50, 50))
    brush.mouse_at(tab.view.viewport(), Kind.MouseButtonRelease, hands.QtCore.QPointF(50, 50))
    made.pattern.Document.recompute()
    hands.wait_until(lambda: tab.view.pieces is not None, 20)
    assert len(tab.view.pieces.pieces) == sheet.Pieces
    for edge in tab.view.pieces.edges:  # all are seen, however often nothing was zoomed
        assert tab.view.viewport().rect().contains(tab.view.place_of(edge.line[0]))
    click(tab, tab.view.pieces.edges[0].line[0])
    assert tab.line.text().startswith("Weld: piece 1, ")
