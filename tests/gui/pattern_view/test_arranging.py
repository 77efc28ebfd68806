# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces in the tab are dragged, turned and mirrored; the document keeps it, step by step."""

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import pytest
import view_port
from flat_hands import at, click, drag, key, lit, middle, open_tab, settled

from BalloonWorkbench.app import film_sheet
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.shapes import piece_places
from BalloonWorkbench.core.arrangement.arrangement import names_of
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.gui.pattern_view import tab as tabs
from BalloonWorkbench.gui.window import macro_recorder

Kind, Qt, QPointF = hands.QtCore.QEvent, hands.QtCore.Qt, hands.QtCore.QPointF
ANEW = "Lay out anew"


def film_of(tab, number):
    """A place amid the film of a piece [m], away from its edges."""
    return np.array(tab.view.laid.places[number].middle)


def places(tab):
    return list(tab.view.laid.places)


def gap(tab, one, other):
    """How near the cuts of two pieces come to each other [m]."""
    cuts = [
        [cut.points for cut in tab.view.pieces.pieces[number].pattern.of(Role.CUT)] for number in (one, other)
    ]
    return min(
        nearest_on_loops(cuts[0], np.concatenate(cuts[1])).distance.min(),
        nearest_on_loops(cuts[1], np.concatenate(cuts[0])).distance.min(),
    )


def pixels(tab, metres):
    return 1e3 * metres * tab.view.zoom


@pytest.fixture
def tab(made):
    opened = open_tab(made.pattern)
    settled(opened)
    return opened


def test_a_drag_moves_one_piece_and_is_one_step(tab, made):
    doc, before = made.pattern.Document, places(tab)
    start = at(tab, film_of(tab, 0))
    drag(tab, start, start + QPointF(-60, -90), Qt.ShiftModifier)
    after = places(tab)
    assert after[1:] == before[1:]
    moved = 1e3 * (np.array(after[0].middle) - before[0].middle) * tab.view.zoom
    assert moved == pytest.approx([-60.0, 90.0], abs=2.0)
    assert doc.UndoNames == ["Move piece"]
    assert "Touched" not in made.pattern.State
    assert np.allclose(
        tab.view.pieces.edges[0].line.mean(axis=0) - after[0].middle,
        tab.view.laid.base.edges[0].line.mean(axis=0) - before[0].middle,
    )
    key(tab, Qt.Key_Z, "\x1a", Qt.ControlModifier)
    hands.wait_until(lambda: places(tab) == before, 5)
    doc.redo()
    hands.wait_until(lambda: places(tab) == after, 5)
    click(tab, tab.view.pieces.edges[0].line.mean(axis=0))  # where it lies now
    assert lit(tab) == 2


def test_a_piece_touches_the_one_it_comes_near_to(tab):
    front, back = at(tab, film_of(tab, 0)), at(tab, film_of(tab, 1))
    beside = abs((front - back).x()) > abs((front - back).y())
    toward = QPointF(np.sign((front - back).x()), 0) if beside else QPointF(0, np.sign((front - back).y()))
    drag(tab, back, back + toward * (pixels(tab, gap(tab, 0, 1)) - 5))
    assert gap(tab, 0, 1) == pytest.approx(0.0, abs=1e-9)
    there = at(tab, film_of(tab, 1))
    drag(tab, there, there - toward * 40, Qt.ShiftModifier)
    assert pixels(tab, gap(tab, 0, 1)) == pytest.approx(40.0, abs=1.5)
    drag(tab, there - toward * 40, there - toward * 5, Qt.ShiftModifier)
    assert pixels(tab, gap(tab, 0, 1)) == pytest.approx(5.0, abs=1.5)


def test_the_handle_turns_and_snaps(tab, made):
    drag(tab, at(tab, film_of(tab, 0)), at(tab, film_of(tab, 0)) + QPointF(-10, -60), Qt.ShiftModifier)
    view = tab.view
    centre, handle = at(tab, film_of(tab, 0)), QPointF(view.handle_at())
    arm = handle - centre
    for degrees, modifiers, turned in ((31.0, Qt.NoModifier, 30.0), (37.5, Qt.ShiftModifier, 67.5)):
        angle = -np.radians(degrees)  # y of the screen is down
        arm = QPointF(view.handle_at()) - centre
        goal = centre + QPointF(
            arm.x() * np.cos(angle) - arm.y() * np.sin(angle),
            arm.x() * np.sin(angle) + arm.y() * np.cos(angle),
        )
        drag(tab, centre + arm, goal, modifiers)
        assert np.degrees(places(tab)[0].angle) == pytest.approx(turned, abs=0.7)
    assert made.pattern.Document.UndoNames[:2] == ["Turn piece", "Turn piece"]
    assert tab.line.text().startswith("front, turned by 6")
    hands.screenshot("pattern-view-turned")


def test_keys_turn_mirror_and_nudge_the_chosen_piece(tab, made):
    doc = made.pattern.Document
    tab.view.setFocus()
    hands.key(tab.view, Qt.Key_Tab, "\t")
    hands.key(tab.view, Qt.Key_Tab, "\t")
    assert tab.view.piece == 1
    first = places(tab)[1]
    key(tab, Qt.Key_R, "r")
    assert np.degrees(places(tab)[1].angle) == pytest.approx(15.0)
    key(tab, Qt.Key_R, "R", Qt.ShiftModifier)
    assert places(tab)[1] == first
    key(tab, Qt.Key_H, "h")
    assert places(tab)[1].mirrored
    assert "mirrored: its other side is up" in tab.line.text()
    for _ in range(3):  # held down: one step
        brush.key(tab.view, Qt.Key_Right)
    key(tab, Qt.Key_Up, "", Qt.ShiftModifier)
    assert np.array(places(tab)[1].middle) - first.middle == pytest.approx([3e-3, 10e-3])
    assert doc.UndoNames == ["Move piece", "Mirror piece", "Turn piece", "Turn piece"]
    key(tab, Qt.Key_Return, "\r")
    assert lit(tab) == 2
    assert tab.view.pieces.edges[tab.view.edge].piece == 1
    hands.click(
        next(each for each in hands.visible(hands.QtWidgets.QToolButton) if each.text() == "Lay out anew")
    )
    assert not made.pattern.ArrangedPieces
    hands.wait_until(lambda: places(tab)[1] == first, 5)


def test_escape_takes_a_drag_back(tab, made):
    before, start = places(tab), at(tab, film_of(tab, 0))
    drag(tab, start, start + QPointF(-60, -50), let_go=False)
    key(tab, Qt.Key_Escape)
    brush.mouse_at(tab.view.viewport(), Kind.MouseButtonRelease, start, held=Qt.NoButton)
    assert places(tab) == before
    assert tab.view.scene().items_of_pieces[0].pos().x() == pytest.approx(1e3 * before[0].middle[0])
    assert made.pattern.Document.UndoCount == 0


def test_it_is_saved_and_copied(tab, made):
    tab.view.choose(0)
    key(tab, Qt.Key_H, "h")
    key(tab, Qt.Key_R, "r")
    wanted, doc = places(tab), made.pattern.Document
    doc.save()
    file = doc.FileName
    App.closeDocument(doc.Name)
    doc = App.openDocument(file)
    kept = piece_places.laid(doc.Pattern).places
    assert [place.mirrored for place in kept] == [True, False]
    for one, other in zip(kept, wanted, strict=True):
        assert one.middle == pytest.approx(other.middle, abs=1e-9)
        assert one.angle == pytest.approx(other.angle, abs=1e-9)
    copied = doc.copyObject(doc.Pattern, True)
    assert list(copied.ArrangedPieces) == list(doc.Pattern.ArrangedPieces) == ["front", "back"]
    assert [str(each) for each in copied.PiecePlaces] == [str(each) for each in doc.Pattern.PiecePlaces]


def test_the_macro_lays_them_the_same(tab, made, stand_in):
    lines, run = [], Gui.doCommand
    stand_in.setattr(macro_recorder.Gui, "doCommand", lambda line: (lines.append(line), run(line)))
    tab.view.choose(0)
    key(tab, Qt.Key_R, "r")
    key(tab, Qt.Key_H, "h")
    drag(tab, at(tab, film_of(tab, 1)), at(tab, film_of(tab, 1)) + QPointF(35, 20))
    after = places(tab)
    hands.click(next(each for each in hands.visible(hands.QtWidgets.QToolButton) if each.text() == ANEW))
    hands.wait_until(lambda: not made.pattern.ArrangedPieces, 5)
    assert lines[-1] == 'BalloonWorkbench.arrange(App.ActiveDocument.getObject("Pattern"))'
    exec("\n".join(lines[:-2]), {"App": App})
    hands.wait_until(lambda: tab.view.laid.places[0].mirrored, 5)
    for one, other in zip(places(tab), after, strict=True):
        assert one.middle == pytest.approx(other.middle, abs=1e-8)
        assert (one.angle, one.mirrored) == (pytest.approx(other.angle), other.mirrored)


def test_a_panel_that_is_open_keeps_pieces_where_they_are(tab, opened):
    before = places(tab)
    tab.view.choose(0)
    key(tab, Qt.Key_R, "r")
    assert places(tab) == before
    assert not opened.pattern.ArrangedPieces


@pytest.mark.slow
def test_gores_that_come_and_go(doc):
    gores = create.balloon_from_profile(doc, None, gores=6, gore_length="400 mm", mesh_size="40 mm")
    tab = open_tab(gores.pattern)
    settled(tab)
    tab.view.choose(5)
    key(tab, Qt.Key_R, "r")
    tab.view.choose(0)
    key(tab, Qt.Key_H, "h")
    names = names_of(tab.view.laid.base)
    gores.outline.Gores = 5
    doc.recompute()
    hands.wait_until(lambda: len(tab.view.pieces.pieces) < len(names), 20)
    assert "No longer in the pattern, with their places: " in tab.line.text()
    assert names[5] in tab.line.text()
    assert tab.view.laid.places[0].mirrored
    gores.outline.Gores = 7
    doc.recompute()
    hands.wait_until(lambda: len(tab.view.pieces.pieces) > len(names), 20)
    assert "New, laid beside the others: " in tab.line.text()
    boxes = [piece.pattern.bounds for piece in tab.view.pieces.pieces]
    assert boxes[6][0][0] > max(box[1][0] for box in boxes[:5])


def test_a_seam_is_lit_on_the_balloon_and_picked_there(doc):
    box = create.balloon_from_panels(doc, "Box", mesh_size="30 mm")
    tab = open_tab(box.pattern)
    root = box.balloon.ViewObject.RootNode
    bare = root.getNumChildren()
    click(tab, middle(tab.view.pieces.edges[4]))
    assert root.getNumChildren() == bare + 1
    seams = tab.lights._seams(tab.view.laid.base)
    assert len(seams.lines) == 12
    before = seams.lines[1].copy()
    box.balloon.Pressure = 3.0 * box.balloon.Pressure.Value
    doc.recompute()
    hands.wait_until(lambda: not np.allclose(tab.lights._seams(tab.view.laid.base).lines[1], before), 20)
    hands.wait(0.2)
    seams = tab.lights._seams(tab.view.laid.base)
    seam = tab.view.pieces.edges[tab.view.edge].seam
    (places_of_node,) = [each for each in tab.lights._shown[1] if hasattr(each, "point")]
    shown = np.array([tuple(point) for point in places_of_node.point.getValues()])
    assert shown == pytest.approx(seams.lines[seam], abs=1e-3)
    assert root.getNumChildren() == bare + 1
    key(tab, Qt.Key_Escape)
    assert root.getNumChildren() == bare
    assert lit(tab) == 0
    for number in (3, 11):  # a place of a seam on the balloon
        line = seams.lines[number]
        x, y, z = line[len(line) // 2].tolist()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(doc.Name, box.balloon.Name, "", x, y, z)
        assert lit(tab) == 2
        assert tab.view.pieces.edges[tab.view.edge].seam == number
    middles = seams.middles
    inner = np.linalg.norm(middles - middles.mean(axis=0), axis=1).argmin()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.Name, box.balloon.Name, "", *middles[inner].tolist())
    assert lit(tab) == 0
    assert tab.view.piece == seams.piece_of[int(seams.panels[inner])]
    tab.parentWidget().close()
    hands.wait(0.1)
    assert root.getNumChildren() == bare


def test_a_click_in_the_3d_view_lights_the_seam(doc):
    box = create.balloon_from_panels(doc, "Box", mesh_size="30 mm")
    tab = open_tab(box.pattern)
    seams = tab.lights._seams(tab.view.laid.base)
    area = Gui.getMainWindow().findChild(hands.QtWidgets.QMdiArea)
    (view,) = [each for each in area.subWindowList() if each is not tab.parentWidget()]
    area.setActiveSubWindow(view)
    for obj in doc.Objects:
        obj.Visibility = obj is box.balloon
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.3)
    shown = view_port.view_area()  # kept: its view port goes with what Python knows of it
    port = shown.viewport()
    toward = np.array(Gui.activeDocument().activeView().getViewDirection())
    nearest = min(seams.lines, key=lambda number: float(seams.lines[number].mean(axis=0) @ toward))
    line = seams.lines[nearest]
    place = box.balloon.Placement.multVec(App.Vector(*line[len(line) // 2].tolist()))
    view_port.click(port, view_port.pixel(port, place))
    assert tab.view.edge is not None
    assert tab.view.pieces.edges[tab.view.edge].seam == nearest
    assert tab.line.text().startswith(f"Seam {nearest}: ")
    hands.screenshot("pattern-view-seam-on-balloon")


def test_a_drag_is_dropped_when_its_pattern_goes(tab, made):
    start = at(tab, film_of(tab, 0))
    drag(tab, start, start + QPointF(-60, -50), let_go=False)
    made.pattern.SealWidth = "9 mm"
    made.pattern.Document.recompute()
    hands.wait_until(lambda: tab.view._drag is None, 5)
    brush.mouse_at(tab.view.viewport(), Kind.MouseButtonRelease, start, held=Qt.NoButton)
    assert not made.pattern.ArrangedPieces
    drag(tab, start, start + QPointF(-60, -50), let_go=False)
    made.pattern.Document.removeObject(made.pattern.Name)
    brush.mouse_at(tab.view.viewport(), Kind.MouseButtonRelease, start, held=Qt.NoButton)
    hands.wait_until(lambda: not tabs._tabs, 5)


def test_pieces_of_a_film_sheet_stay_where_they_are(made):
    sheet = film_sheet.make(made.pattern.Document, [made.pattern])
    made.pattern.Document.recompute()
    tab = open_tab(sheet)
    settled(tab)
    before, start = places(tab), at(tab, film_of(tab, 0))
    click(tab, film_of(tab, 0))
    assert tab.view.piece == 0
    assert tab.view.handle_at() is None
    drag(tab, start, start + QPointF(60, 30))
    tab.view.choose(0)
    hands.key(tab.view, Qt.Key_R, "r")
    hands.wait(0.05)
    assert places(tab) == before
    assert tab.looks.list.count() == 1


def test_an_edge_of_two_panels_is_lit_where_it_is(made):
    tab = open_tab(made.pattern)
    settled(tab)
    tab.pick(0)
    lines = tab.lights._seams(tab.view.laid.base).lines
    edges = [edge for edge in tab.view.laid.base.edges if edge.piece == 0]
    assert len(lines) == len(edges) == 4
    rim = made.balloon.Mesh.BoundBox
    for edge in edges:  # a side of a rectangle: its place on the balloon is at that side
        line = lines[edge.seam]
        side = edge.line[-1] - edge.line[0]
        along = int(abs(side[1]) > abs(side[0]))
        assert np.ptp(line[:, along]) > 3.0 * np.ptp(line[:, 1 - along])
        centre = (rim.Center.x, rim.Center.y)[1 - along]
        lies = edge.line.mean(axis=0)[1 - along] * 1e3
        assert (line[:, 1 - along].mean() > centre) == (lies > centre)
