# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many panels: the intake at a seam of the user's choice, and advice that has its places on the balloon."""

import json

import pytest

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import advice
from BalloonWorkbench.core.units import to_mm


@pytest.fixture
def made(doc):
    return BalloonWorkbench.from_panels(doc, "Box", mesh_size=60)


def opened(pattern):
    return [step for step in pattern.Order if "with the opening" in step]


def test_the_intake_goes_through_the_seam_that_is_chosen(made):
    assert made.pattern.getEditorMode("Opening") == []
    BalloonWorkbench.change(made, opening="7", opening_share=0.3)
    assert made.pattern.Status == status.READY
    assert [step.split(":")[0] for step in opened(made.pattern)] == ["Seam 7"]
    BalloonWorkbench.change(made, opening="70")
    assert "no seam 70" in made.pattern.Status


def test_a_nozzle_sits_in_the_middle_of_a_panel(made):
    name = json.loads(made.balloon.FlatPanels)["panels"][0]["name"]
    BalloonWorkbench.change(made, opening=name, intake_kind="Nozzle with flange")
    assert made.pattern.Status == status.READY
    assert not opened(made.pattern)


def test_advice_is_measured_on_the_balloon(made):
    BalloonWorkbench.change(made, pressure="40 kPa")
    (found,) = [each for each in advice.findings(made) if each.rule == "pressure"]
    box = made.balloon.Mesh.BoundBox
    x, y, z = (to_mm(value) for value in found.place)
    assert box.XMin - 1 < x < box.XMax + 1
    assert box.YMin - 1 < y < box.YMax + 1
    assert box.ZMin - 1 < z < box.ZMax + 1
