# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size by volume or lift, and symmetry, in the panel."""

import hands
import pytest

from BalloonWorkbench.app.border import status


def test_a_volume_decides_the_size(opened):
    balloon = opened.balloon
    hands.show_tab(hands.find("SizeGoal"))
    assert not hands.find("GoalVolume").isVisible()
    hands.choose(hands.find("SizeGoal"), "Volume")
    hands.wait_until(hands.find("GoalVolume").isVisible)
    wanted = 2.0 * balloon.Volume.Value
    hands.type_into(hands.find("GoalVolume"), f"{wanted * 1e-6:.6f} l")
    hands.screenshot("size-goal")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert balloon.Status == status.READY
    assert balloon.Volume.Value == pytest.approx(wanted, rel=5e-3)
    assert opened.outline.SizeX.Value == pytest.approx(90)
    balloon.Document.undo()
    assert balloon.SizeGoal == "Width"


def test_a_lift_decides_the_size(opened):
    balloon = opened.balloon
    hands.type_into(hands.find("MeshSize"), "80 mm")
    hands.choose(hands.find("SizeGoal"), "Lift")
    hands.wait_until(hands.find("GoalLift").isVisible)
    hands.type_into(hands.find("GoalLift"), "5")
    hands.choose(hands.find("Gas"), "Hydrogen")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert balloon.Status == status.READY
    assert balloon.Lift == pytest.approx(5.0, rel=6e-3)
    assert balloon.Floats


def test_symmetry_of_a_sketch_can_be_forced(opened):
    sketch = opened.outline.Source[0]
    hands.choose(hands.find("Symmetry"), "Forced")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert opened.outline.Symmetry == "Forced"
    assert len(opened.outline.LoopPoints) == 6  # the corners, and two points on the axis
    assert sketch.GeometryCount == 4
    assert [obj.Status for obj in opened] == [status.READY] * 3
