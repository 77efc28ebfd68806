# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two panels or a side band: one choice in the balloon's panel, with a picture of both."""

import hands
import pytest

from BalloonWorkbench.app.border import status


@pytest.fixture
def choice(opened):
    """The panel of a finished balloon of two panels, on the page with the choice."""
    opened.balloon.Live = False
    hands.find("Steps").setCurrentIndex(1)
    hands.wait_until(lambda: "about" in hands.find("SideBand").text(), 120)
    return opened


def about(name):
    """The thickness that a button tells [mm]."""
    return float(hands.find(name).text().split("about ")[1].split()[0])


def test_both_are_shown_before_one_is_chosen(choice):
    assert hands.find("TwoPanels").isChecked()
    assert not hands.find("Band").isVisible()
    assert not hands.find("SideBand").icon().isNull()
    assert about("TwoPanels") == pytest.approx(choice.balloon.InflatedThickness.Value, rel=0.25)
    hands.screenshot("band-choice")


def test_side_band_is_chosen_and_taken_back(choice):
    balloon = choice.balloon
    before, told = balloon.SolvedFor, about("SideBand")
    hands.click(hands.find("SideBand"))
    assert balloon.Band.Value > 0
    assert hands.find("Band").isVisible()
    hands.click(hands.find("Apply"))
    hands.wait_until(lambda: balloon.SolvedFor != before and hands.find("Apply").isVisible(), 120)
    assert balloon.Status == status.READY
    assert balloon.PanelCount >= 3
    assert balloon.InflatedThickness.Value == pytest.approx(told, rel=0.15)
    hands.screenshot("band-made")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 120)
    balloon.Document.undo()
    assert balloon.Band.Value == 0
    assert balloon.SolvedFor == before
    assert balloon.PanelCount == 0
