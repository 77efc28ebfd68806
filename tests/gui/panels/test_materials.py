# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's materials as the film, chosen in the panel."""

import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.host import material_tree
from BalloonWorkbench.app.properties import film, material

OURS = "Polyethylene film (LDPE), 50 um"
has_tree = material_tree() is not None


@pytest.fixture
def balloon(doc):
    """Of a new balloon whose panel is open."""
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    yield next(obj for obj in doc.Objects if "Film" in obj.PropertiesList)
    hands.press("Cancel")


def check(balloon):
    assert balloon.Film == film.CUSTOM
    assert balloon.Material == OURS
    assert balloon.YoungModulus.getValueAs("MPa").Value == pytest.approx(200)
    assert balloon.Thickness.getValueAs("mm").Value == pytest.approx(0.05)
    assert hands.find("Film").currentData() == film.CUSTOM
    assert hands.find("Thickness").property("rawValue") == pytest.approx(0.05)


@pytest.mark.skipif(has_tree, reason="FreeCAD has a material tree of its own")
def test_card_is_chosen_from_a_list(balloon):
    cards = hands.find("MaterialCard")
    hands.show_tab(cards)
    assert cards.count() == 1, "cards are read when they are asked for"
    cards.setFocus()
    hands.wait(0.1)
    assert cards.count() > 20
    hands.choose(cards, OURS)
    check(balloon)
    hands.screenshot("material-card")
    hands.choose(hands.find("Film"), 'Aluminised PET ("Mylar"), 25 µm')
    assert not balloon.Material
    assert cards.currentText() != OURS


@pytest.mark.skipif(
    not (has_tree and hasattr(hands.QtCore, "Q_ARG")), reason="no material tree that can be told a choice"
)
def test_card_is_chosen_from_the_tree(balloon):
    """The tree tells the identity of what was clicked; here it is told without the click."""
    tree = hands.find("MaterialTree")
    hands.show_tab(tree)
    assert tree.metaObject().className() == "MatGui::MaterialTreeWidget"
    hands.screenshot("material-tree")
    import Materials

    known = Materials.MaterialManager().Materials
    uuid = next(identity for identity, each in known.items() if each.Name == OURS)
    hands.QtCore.QMetaObject.invokeMethod(
        tree, "onMaterial", hands.QtCore.Qt.DirectConnection, hands.QtCore.Q_ARG(str, uuid)
    )
    hands.wait(0.1)
    check(balloon)


def test_broken_card_is_refused_with_a_reason(balloon):
    from BalloonWorkbench.gui.panels.balloon.card_box import CardBox

    said = []
    box = CardBox(balloon)
    box.refused.connect(said.append)
    before = balloon.YoungModulus.Value
    box._take(material.Card("Broken", "User", {"YoungsModulus": "3 bananas"}))
    assert "correct the card" in said[0]
    assert balloon.YoungModulus.Value == before
    box.deleteLater()
