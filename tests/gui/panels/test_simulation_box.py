# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the simulation in the panel."""

import hands
import pytest

from BalloonWorkbench.app.border import status


def test_a_volume_instead_of_the_pressure(opened):
    balloon = opened.balloon
    assert hands.find("TargetVolume").isHidden()
    hands.choose(hands.find("Load"), "Volume")
    assert not hands.find("TargetVolume").isHidden()
    assert hands.find("Pressure").isHidden()
    assert hands.find("TargetVolume").property("rawValue") == pytest.approx(balloon.Volume.Value, rel=0.01)
    wanted = 1.05 * balloon.Volume.Value
    hands.type_into(hands.find("TargetVolume"), f"{wanted * 1e-6:.6f} l")
    hands.screenshot("simulation")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert balloon.Status == status.READY
    assert balloon.Volume.Value == pytest.approx(wanted, rel=2e-3)
    assert balloon.ActivePressure.Value > balloon.Pressure.Value
    balloon.Document.undo()
    assert balloon.Load == "Pressure"


def test_model_and_solver(opened):
    balloon = opened.balloon
    volume = balloon.Volume.Value
    hands.choose(hands.find("Backend"), "NumPy")  # first: FreeCAD 1.0 has a widget "Model" of its own
    hands.choose(hands.find("Model"), "Plain shell")
    hands.tick(hands.find("Bending"))
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (balloon.Model, balloon.Bending, balloon.ActiveBackend) == ("Plain shell", False, "numpy")
    assert balloon.Volume.Value < volume


def test_only_a_film_of_ones_own_has_a_grain(opened):
    hands.show_tab(hands.find("Film"))
    assert not hands.find("GrainAngle").isVisible()
    hands.choose(hands.find("Film"), "Custom")
    hands.wait_until(hands.find("GrainAngle").isVisible)
    hands.type_into(hands.find("YoungModulusAcross"), "2000000 kPa")
    hands.type_into(hands.find("GrainAngle"), "30")
    hands.screenshot("grain")
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert opened.balloon.Status == status.READY
    assert opened.balloon.GrainAngle.Value == pytest.approx(30)
    assert opened.balloon.YoungModulusAcross.getValueAs("GPa").Value == pytest.approx(2)
