# SPDX-License-Identifier: LGPL-2.1-or-later
"""One declaration for each option: the fields of panels follow."""

from dataclasses import dataclass

import hands

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.properties.property_table import add_missing, offer_choices, properties_of
from BalloonWorkbench.core.options.option import Kind, Section
from BalloonWorkbench.gui.panels.balloon import pattern_box

MARKS = Section("Marks")


@dataclass(frozen=True)
class MoreOptions:
    """Options that nobody has declared."""

    sparkle: float = MARKS(Kind.LENGTH, 0.0025, "How wide the glitter is strewn", label="Glitter", step=0.5)
    grains: int = MARKS(Kind.COUNT, 3, "How many grains", label="Grains", least=1, most=9)
    glow: str = MARKS(Kind.CHOICE, "dim", "How it glows", label="Glow", choices={"dim": "Dim", "hot": "Hot"})


def test_every_option_with_a_label_has_a_field(opened):
    labelled = [item for module in (balloon, pattern) for item in module.PROPERTIES if item.label]
    assert labelled
    for item in labelled:
        field = hands.find(item.name)
        hands.show_tab(field)
        assert field.toolTip() == item.tooltip, item.name


def test_an_entry_is_a_field_that_writes(opened, stand_in):
    """With its label, tooltip, unit, range and choices."""
    more = properties_of(MoreOptions)
    obj = opened.pattern
    add_missing(obj, more)
    offer_choices(obj, more)
    stand_in.setattr(pattern_box, "PROPERTIES", (*pattern_box.PROPERTIES, *more))
    sparkle, grains, glow = (hands.find(item.name) for item in more)
    hands.show_tab(sparkle)
    assert sparkle.toolTip() == "How wide the glitter is strewn"
    assert "Glitter" in [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]
    assert sparkle.property("rawValue") == 2.5
    assert (grains.minimum(), grains.maximum(), grains.value()) == (1, 9, 3)
    assert [glow.itemText(row) for row in range(glow.count())] == ["Dim", "Hot"]
    hands.type_into(sparkle, "0.4 cm")
    grains.setValue(5)
    hands.choose(glow, "Hot")
    assert (obj.Sparkle.Value, obj.Grains, obj.Glow) == (4.0, 5, "Hot")
