# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon whose size follows from a volume or a lift; what it weighs and carries."""

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.film.filling import Filling, gas


@pytest.fixture(scope="module")
def solved():
    document = App.newDocument("Sized")
    document.UndoMode = 1
    name = document.Name
    sketch = sketches.rectangle(document, 120, 80)
    yield create.balloon_from_sketch(document, sketch, mesh_size=15, correct=False)
    App.closeDocument(name)


def width_of(balloon):
    xs = [point.x for point in balloon.SeamPoints]
    return max(xs) - min(xs)


def test_volume_decides_the_size_and_the_outline_stays(parts):
    outline, balloon, pattern = parts
    volume, width = balloon.Volume.Value, width_of(balloon)
    balloon.SizeGoal = "Volume"
    balloon.GoalVolume = 8 * volume
    balloon.Document.recompute()
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert balloon.Volume.Value == pytest.approx(8 * volume, rel=5e-3)
    assert width_of(balloon) == pytest.approx(2 * width, rel=0.02)
    assert outline.SizeX.Value == pytest.approx(120)
    assert pattern.PatternWidth.Value > 2 * width


def test_lift_decides_the_size(parts):
    balloon = parts.balloon
    assert not balloon.Floats
    assert balloon.Lift < 0
    assert balloon.FloatsFrom.Value > balloon.InflatedWidth.Value
    foretold = balloon.FloatsFrom.Value
    balloon.MeshSize = 60
    balloon.SizeGoal = "Lift"
    balloon.GoalLift = 0
    balloon.Document.recompute()
    assert balloon.Status == status.READY
    assert balloon.Lift == pytest.approx(0.0, abs=0.01 * balloon.Weight)
    # what one small balloon foretells for a large one whose film is softer beside it
    assert balloon.InflatedWidth.Value == pytest.approx(foretold, rel=0.03)


def test_weight_and_lift_follow_the_film_and_the_gas_without_a_solve(parts):
    balloon = parts.balloon
    label, weight = balloon.SolvedFor, balloon.Weight
    lightness = Filling().lightness(2000.0)
    assert balloon.Lift == pytest.approx(1e-6 * balloon.Volume.Value * lightness - weight, rel=1e-6)
    area = (0.12 + 0.014) * (0.08 + 0.014) + 0.03 * 0.024
    assert weight == pytest.approx(2e3 * area * balloon.ArealDensity, rel=0.03)
    balloon.Gas = "Hydrogen"
    balloon.Document.recompute()
    hydrogen = Filling(gas("hydrogen")).lightness(2000.0)
    assert balloon.Lift == pytest.approx(1e-6 * balloon.Volume.Value * hydrogen - weight, rel=1e-6)
    balloon.Film = "Custom"
    balloon.ArealDensity = 2 * balloon.ArealDensity
    balloon.Document.recompute()
    assert balloon.Weight == pytest.approx(2 * weight)
    assert balloon.SolvedFor == label


def test_the_valve_weighs(parts):
    """Two strips of the intake's own film, 34 x 100 mm; they make a balloon that shall float larger."""
    balloon, pattern = parts.balloon, parts.pattern
    straw, label = balloon.Weight, balloon.SolvedFor
    pattern.IntakeKind = "Self-sealing film valve"
    pattern.IntakeWidth = 24
    balloon.Document.recompute()
    assert balloon.SolvedFor == label
    grams = 2 * (0.024 + 2 * balloon.SealWidth.Value * 1e-3) * 0.1 * 36.8
    wider = 2e3 * balloon.ArealDensity * (0.038 * 0.042 - 0.024 * 0.032)  # the neck itself, roughly
    assert balloon.Weight == pytest.approx(straw + grams + wider, abs=0.06)
    balloon.MeshSize = 60
    balloon.SizeGoal, balloon.GoalLift = "Lift", 0
    balloon.Document.recompute()
    with_valve = balloon.InflatedWidth.Value
    pattern.IntakeKind = "Straw neck"
    pattern.IntakeWidth = 10
    balloon.Document.recompute()
    assert balloon.Lift == pytest.approx(0.0, abs=0.01 * balloon.Weight)
    assert balloon.InflatedWidth.Value < 0.995 * with_valve


def test_only_what_has_an_effect_is_offered(parts):
    balloon = parts.balloon
    hidden = {name: "Hidden" in balloon.getEditorMode(name) for name in ("GoalVolume", "GoalLift")}
    assert hidden == {"GoalVolume": True, "GoalLift": True}
    balloon.SizeGoal = "Volume"
    assert "Hidden" not in balloon.getEditorMode("GoalVolume")
    assert balloon.GoalVolume.Value == pytest.approx(balloon.Volume.Value)
    balloon.Gas = "Warm air"
    assert "Hidden" not in balloon.getEditorMode("GasTemperature")


@pytest.mark.parametrize(
    ("values", "word"),
    [
        ({"SizeGoal": "Volume", "GoalVolume": 0}, "A volume of 0 ml"),
        ({"SizeGoal": "Lift", "GoalLift": -5.0}, "lift"),
        ({"SizeGoal": "Lift", "Gas": "Warm air", "GasTemperature": 10.0}, "never floats"),
        ({"SizeGoal": "Lift", "GoalLift": 1e12}, "lighter film"),
        ({"AirTemperature": -270.0}, "temperature"),
        ({"SizeGoal": "Volume", "Load": "Volume"}, "exclude"),
    ],
)
def test_a_senseless_goal_keeps_the_last_balloon(parts, values, word):
    balloon = parts.balloon
    volume = balloon.Volume.Value
    for name, value in values.items():
        setattr(balloon, name, value)
    balloon.Document.recompute()
    assert balloon.Status.startswith(status.STALE), balloon.Status
    assert word in balloon.Status
    assert balloon.Volume.Value == volume


def test_a_goal_survives_the_file(parts, tmp_path):
    balloon = parts.balloon
    balloon.SizeGoal = "Volume"
    balloon.GoalVolume = 2 * balloon.Volume.Value
    balloon.Document.recompute()
    label = balloon.SolvedFor
    path = str(tmp_path / "sized.FCStd")
    balloon.Document.saveCopy(path)
    again = App.openDocument(path)
    try:
        found = again.getObject(balloon.Name)
        found.touch()
        again.recompute()
        assert (found.SizeGoal, found.SolvedFor, found.Status) == ("Volume", label, status.READY)
        assert found.GoalVolume.Value == pytest.approx(balloon.GoalVolume.Value)
    finally:
        App.closeDocument(again.Name)
