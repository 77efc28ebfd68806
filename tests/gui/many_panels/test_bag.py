# SPDX-License-Identifier: LGPL-2.1-or-later
"""New bag of panels: seams made with the mouse, shown by colour; ready bodies; what is wrong is told."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.border import status

COARSE = 25  # mm


def two_squares(doc, second=80):
    """Two squares of 80 mm beside each other, or one of another width."""
    one = sketches.rectangle(doc, 80, 80)
    other = sketches.rectangle(doc, second, 80)
    other.Placement.Base = App.Vector(120, 0, 0)
    doc.recompute()
    return one, other


def open_panel(*panels):
    for panel in panels:
        Gui.Selection.addSelection(panel)
    Gui.runCommand("BalloonWorkbench_FromPanels")
    hands.wait_until(hands.panel_is_seen)
    App.ActiveDocument.Balloon.MeshSize = COARSE
    return hands.find("FlatPanels")


def click_at(widget, place):
    """A click of the left button at a place of a widget, in px."""
    hands.drag(widget, (place.x(), place.y()), (place.x(), place.y()), 1)


def edge(flat, name):
    """The edge of this name as the flat picture has it."""
    return next(each for each in flat.shown.edges if name in each.names)


def join(flat, one, other):
    for name in (one, other):
        click_at(flat, flat.place_of(edge(flat, name)))
        hands.wait(0.05)


def test_seams_are_made_with_the_mouse(doc):
    one, other = two_squares(doc)
    flat = open_panel(one, other)
    bag = doc.Bag
    assert bag.PanelNames == [one.Label, other.Label]
    assert "Free edges: 8" in hands.find("SeamHint").text()
    # seen from outside, the second square is turned over: its edges run the other way round
    for k, partner in ((1, 1), (2, 4), (3, 3), (4, 2)):
        join(flat, f"{one.Name}.Edge{k}", f"{other.Name}.Edge{partner}")
        assert bag.Seams[-1] == f"{one.Name}.Edge{k}={other.Name}.Edge{partner}"
        assert hands.find("Seams").count() == k
    hands.click(hands.find("PickOpening"))
    click_at(flat, flat.place_of(edge(flat, f"{one.Name}.Edge1")))
    assert bag.OpeningAt == f"{one.Name}.Edge1"
    hands.wait_until(lambda: doc.Balloon.SolvedFor != "" and hands.find("Apply").isVisible(), 120)
    assert bag.Status == doc.Balloon.Status == status.READY
    hands.screenshot("bag-of-squares")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert doc.UndoNames[0] == "New bag of panels"
    assert doc.Balloon.Volume.Value > 0
    colours = bag.ViewObject.LineColorArray
    assert len(set(colours)) == 4
    assert len(colours) == 8


def test_wrong_lengths_are_marked_and_taken_apart(doc):
    one, other = two_squares(doc, 70)
    flat = open_panel(one, other)
    bag = doc.Bag
    join(flat, f"{one.Name}.Edge1", f"{other.Name}.Edge1")
    rows = hands.find("Seams")
    assert "10 mm" in rows.item(0).text()
    assert "80 mm" in rows.item(0).text()
    assert "70 mm" in rows.item(0).text()
    assert any("equally long" in problem for problem in bag.Problems)
    hands.screenshot("bag-wrong-lengths")
    hands.click(hands.find("RemoveSeam"))
    assert bag.Seams == []
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert doc.getObject("Bag") is None


def test_edge_and_partner_are_picked_in_the_view(doc):
    one, other = two_squares(doc)
    open_panel(one, other)
    Gui.Selection.addSelection(doc.Name, one.Name, "Edge1")
    hands.wait(0.05)
    assert f"partner of {one.Name}.Edge1" in hands.find("SeamHint").text()
    Gui.Selection.addSelection(doc.Name, other.Name, "Edge1")
    hands.wait(0.05)
    assert doc.Bag.Seams == [f"{one.Name}.Edge1={other.Name}.Edge1"]


@pytest.fixture
def box(doc):
    open_panel()
    hands.choose(hands.find("Ready"), "Box")
    hands.wait_until(lambda: doc.Balloon.SolvedFor != "" and hands.find("Apply").isVisible(), 120)
    return doc


def test_ready_box_follows_its_sizes(box):
    doc = box
    volume = doc.Balloon.Volume.Value
    assert doc.Bag.Status == doc.Balloon.Status == status.READY
    assert doc.Balloon.PanelCount == len(doc.Bag.PanelNames) == 6
    hands.type_into(hands.find("Height"), f"{1.5 * doc.Bag.Height.Value} mm")
    hands.wait_until(lambda: doc.Balloon.Volume.Value > 1.1 * volume, 120)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)


def test_a_seam_is_highlighted_on_panels_and_balloon(box):
    doc = box
    flat, roots = hands.find("FlatPanels"), [obj.ViewObject.RootNode for obj in (doc.Bag, doc.Balloon)]
    before = [root.getNumChildren() for root in roots]
    first = next(each for each in flat.shown.edges if each.seam == 4)
    click_at(flat, flat.place_of(first))
    assert hands.find("Seams").currentRow() == 4
    after = [root.getNumChildren() for root in roots]
    assert [a - b for a, b in zip(after, before)] == [2, 1]
    hands.screenshot("bag-seam")
    doc.Balloon.ViewObject.DisplayMode = "Panels"
    hands.screenshot("bag-panels-mode")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert [root.getNumChildren() for root in roots] == before
