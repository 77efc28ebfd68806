# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of an outline in their tab, with mouse and keys; one undo step for each edit."""

import brush
import FreeCAD as App
import hands
import numpy as np
import pytest
from outline_hands import click, drag, highest, key, nodes, open_in_panel, open_tab, picture, press

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.outline_edits.nodes import CORNER
from BalloonWorkbench.core.units import from_mm
from BalloonWorkbench.gui.outline_editor import tab as tabs

Kind, Qt = hands.QtCore.QEvent, hands.QtCore.Qt


def test_a_node_is_dragged_over_the_picture_and_undone(made):
    tab = open_tab(made.outline)
    before, count = made.outline.SizeY.Value, len(made.outline.Document.UndoNames)
    assert not tab.view._picture.isNull()
    top = highest(tab)
    drag(tab, top, (0, -40), let_go=False)
    hands.screenshot("outline-editor-drag")
    assert not made.outline.OutlineEdits  # it is only shown
    press(tab, Kind.MouseButtonRelease, top, Qt.NoButton, by=(0, -40))
    hands.wait(0.05)
    assert len(made.outline.OutlineEdits) == 1
    assert highest(tab)[1] - top[1] == pytest.approx(from_mm(40 / tab.view.zoom), rel=1e-3)
    assert made.outline.SizeY.Value > before + 25 / tab.view.zoom
    assert status.is_ready(made.outline)
    assert made.outline.Document.UndoNames[0] == "Edit outline"
    assert len(made.outline.Document.UndoNames) == count + 1
    hands.screenshot("outline-editor")
    key(tab, Qt.Key_Z, Qt.ControlModifier)
    hands.wait_until(lambda: np.allclose(highest(tab), top, atol=1e-6), 5)
    assert (list(made.outline.OutlineEdits), made.outline.SizeY.Value) == ([], pytest.approx(before))
    key(tab, Qt.Key_Z, Qt.ControlModifier | Qt.ShiftModifier)
    hands.wait_until(lambda: len(made.outline.OutlineEdits) == 1, 5)


def test_a_click_on_the_line_adds_a_node_and_delete_takes_it_away(made):
    tab = open_tab(made.outline)
    loop = tab.state.nodes.loops[0]
    first, second = loop.nodes[:2]
    place = loop.points[(first + second) // 2]
    count, area = len(loop.nodes), made.outline.Shape.Area
    click(tab, place)
    assert len(nodes(tab)) == count + 1
    assert made.outline.Shape.Area == pytest.approx(area, rel=1e-9)
    assert len(tab.view.chosen) == 1
    key(tab, Qt.Key_Delete)
    assert len(nodes(tab)) == count
    key(tab, Qt.Key_Delete)  # nothing is picked
    assert len(nodes(tab)) == count


def test_a_node_is_made_sharp_and_round(made):
    tab = open_tab(made.outline)
    top = nodes(tab)[np.argmin(nodes(tab)[:, 1])]
    click(tab, top)
    key(tab, Qt.Key_S)
    loop = tab.state.nodes.loops[0]
    at = np.argmin(np.linalg.norm(loop.points - top, axis=1))
    assert loop.kinds[at] == CORNER
    press(tab, Kind.MouseButtonDblClick, top)
    hands.wait(0.05)
    assert tab.state.nodes.loops[0].kinds.tolist().count(CORNER) == loop.kinds.tolist().count(CORNER) - 1
    assert len(made.outline.OutlineEdits) == 2


def test_arrow_keys_push_and_are_one_edit(made):
    tab = open_tab(made.outline)
    top = highest(tab)
    click(tab, top)
    for _ in range(5):
        key(tab, Qt.Key_Up, Qt.ShiftModifier)
    assert len(made.outline.OutlineEdits) == 1
    assert highest(tab)[1] - top[1] == pytest.approx(from_mm(50 / tab.view.zoom), rel=1e-3)


def test_a_hole_moves_as_a_whole_and_is_filled(made):
    tab = open_tab(made.outline)
    hole = nodes(tab, 1)
    low, high = (
        hands.QtCore.QPointF(tab.view.place_of(each)) for each in (hole.min(axis=0), hole.max(axis=0))
    )
    corner = hands.QtCore.QPointF(low.x() - 15, high.y() - 15)
    view = tab.view.viewport()
    brush.mouse_at(view, Kind.MouseButtonPress, corner)
    for at in (hands.QtCore.QPointF(low.x(), low.y()), hands.QtCore.QPointF(high.x() + 15, low.y() + 15)):
        brush.mouse_at(view, Kind.MouseMove, at)
    brush.mouse_at(view, Kind.MouseButtonRelease, at, held=Qt.NoButton)
    hands.wait(0.05)
    assert len(tab.view.chosen) == len(hole)
    area = made.outline.Shape.Area
    drag(tab, hole[0], (-25, 0))
    assert len(tab.view.chosen) == len(hole)
    assert made.outline.Shape.Area == pytest.approx(area, rel=1e-3)
    assert hole[0][0] - nodes(tab, 1)[:, 0].max() > from_mm(20 / tab.view.zoom) - np.ptp(hole[:, 0])
    key(tab, Qt.Key_Delete)
    assert made.outline.HoleCount == 0
    key(tab, Qt.Key_Z, Qt.ControlModifier)
    hands.wait_until(lambda: made.outline.HoleCount == 1, 5)


def test_what_crosses_is_refused_in_a_sentence(made):
    tab = open_tab(made.outline)
    points, top = list(made.outline.LoopPoints), highest(tab)
    low = nodes(tab)[np.argmin(nodes(tab)[:, 1])]
    reach = tab.view.place_of(low).y() - tab.view.place_of(top).y()
    drag(tab, top, (-40, reach * 0.9))
    assert "cross" in tab.line.text() or "meets" in tab.line.text() or "outside" in tab.line.text()
    assert not made.outline.OutlineEdits
    assert list(made.outline.LoopPoints) == points
    assert np.allclose(highest(tab), top)
    hands.screenshot("outline-editor-refused")


def test_escape_lets_go_and_leaves(made):
    tab = open_tab(made.outline)
    top = highest(tab)
    drag(tab, top, (0, -40), let_go=False)
    key(tab, Qt.Key_Escape)
    press(tab, Kind.MouseButtonRelease, top, Qt.NoButton, by=(0, -40))
    assert not made.outline.OutlineEdits
    assert tab.view._shown is None
    key(tab, Qt.Key_Escape)
    assert tab in tabs._tabs
    key(tab, Qt.Key_Escape)
    hands.wait_until(lambda: not tabs._tabs, 5)


@pytest.mark.slow
def test_the_balloon_follows_when_the_tab_closes(doc, tmp_path):
    made = create.balloon_from_picture(
        doc, picture(tmp_path), width=200, mesh_size="20 mm", mode="Inflate as drawn", drawn_as="Filled shape"
    )
    before = made.balloon.InflatedHeight.Value
    tab = open_tab(made.outline)
    drag(tab, highest(tab), (0, -60))
    assert made.balloon.InflatedHeight.Value == before
    hands.find("OutlineTab").close_tab()
    hands.wait_until(lambda: made.balloon.InflatedHeight.Value > before + 5, 60)
    assert [obj.Status for obj in made] == [status.READY] * 3
    doc.undo()
    assert made.balloon.InflatedHeight.Value == pytest.approx(before)


def test_the_tab_goes_with_its_document(doc, tmp_path, made):
    tab = open_tab(made.outline)
    drag(tab, highest(tab), (0, -30))
    App.closeDocument(doc.Name)
    hands.wait_until(lambda: not tabs._tabs, 5)


def test_in_the_panel_before_anything_is_inflated(doc, tmp_path):
    """Edits are part of the panel's step; Ctrl+Z takes the last one back alone, Cancel all."""
    tab = open_in_panel(doc, tmp_path)
    top, height = highest(tab), doc.Outline.SizeY.Value
    drag(tab, top, (0, -30))
    once = highest(tab)
    drag(tab, once, (0, -30))
    assert not np.allclose(highest(tab), once)
    assert doc.Outline.SizeY.Value > height + 30 / tab.view.zoom
    hands.screenshot("outline-editor-panel")
    key(tab, Qt.Key_Z, Qt.ControlModifier)
    assert np.allclose(highest(tab), once, atol=1e-6)
    assert hands.panel_is_open()
    key(tab, Qt.Key_Escape)
    hands.wait_until(lambda: not tabs._tabs, 5)
    assert len(doc.Outline.OutlineEdits) == 1
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert not doc.Objects


def slide(slider, to, let_go=True):
    """Take the handle of a slider to a part of its way."""
    style = hands.QtWidgets.QStyle
    option = hands.QtWidgets.QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(style.CC_Slider, option, style.SC_SliderHandle, slider)
    start = hands.QtCore.QPointF(handle.center())
    end = hands.QtCore.QPointF(to * slider.width(), start.y())
    brush.mouse_at(slider, Kind.MouseButtonPress, start)
    for share in (0.5, 1.0):
        brush.mouse_at(slider, Kind.MouseMove, start + share * (end - start))
    if let_go:
        brush.mouse_at(slider, Kind.MouseButtonRelease, end, held=Qt.NoButton)
    return end


def test_a_slider_shows_at_once_and_is_kept_when_it_is_let_go(made):
    """The hole of the body is 30 of 300 px wide: a slider fills it, and Ctrl+Z has it back."""
    tab = open_tab(made.outline)
    drag(tab, highest(tab), (0, -30))
    steps, height = len(made.outline.Document.UndoNames), made.outline.SizeY.Value
    slider = hands.find("SmallestHole")
    end = slide(slider, 0.9, let_go=False)
    hands.wait_until(lambda: tab.view._shown is not None, 20)
    assert len(tab.view._shown.loops) == 1
    assert made.outline.HoleCount == 1
    hands.screenshot("outline-editor-slider")
    brush.mouse_at(slider, Kind.MouseButtonRelease, end, held=Qt.NoButton)
    hands.wait_until(lambda: made.outline.HoleCount == 0, 20)
    assert made.outline.SizeY.Value == pytest.approx(height)  # the edit stays
    assert len(made.outline.Document.UndoNames) == steps + 1
    tab.view.setFocus()
    key(tab, Qt.Key_Z, Qt.ControlModifier)
    hands.wait_until(lambda: made.outline.HoleCount == 1 and slider.value() < 30, 5)
    slide(hands.find("Smoothness"), 0.95)
    hands.wait_until(lambda: made.outline.Smoothness > 10, 20)
    hands.click(hands.find("UsualTracing"))
    hands.wait_until(lambda: made.outline.Smoothness == 1, 20)
