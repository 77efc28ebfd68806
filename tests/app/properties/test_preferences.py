# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences are kept in FreeCAD's parameters, and new balloons of the window begin with them."""

import math
from pathlib import Path

import FreeCAD as App
import pytest

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import machines


@pytest.fixture(autouse=True)
def usual():
    """As without the user, before and after."""
    group = App.ParamGet(preferences.PATH)
    group.Clear()
    yield group
    group.Clear()


def test_usual_values_are_those_of_new_objects(doc):
    made = create.make(doc)
    for item in (each for each in preferences.items().values() if each.prop):
        value = getattr(getattr(made, item.part), item.key)
        assert getattr(value, "Value", value) == pytest.approx(preferences.get(item.key)), item.key


def test_new_balloon_begins_with_them(doc):
    wanted = {
        "Film": "pe",
        "Width": 250.0,
        "Pressure": 1.5,
        "SealWidth": 7.0,
        "Allowance": 0.0,
        "Backend": "NumPy",
        "MeshSize": 9.0,
        "Live": False,
    }
    for key, value in wanted.items():
        preferences.put(key, value)
    made = create.make(doc)
    preferences.begin(made)
    assert made.balloon.Film == "pe"
    assert made.balloon.Thickness.Value == pytest.approx(0.05)
    assert made.outline.Width.Value == pytest.approx(250)
    assert made.balloon.Pressure.Value == pytest.approx(1.5)
    assert made.pattern.SealWidth.Value == pytest.approx(7)
    assert made.pattern.Allowance.Value == pytest.approx(0)
    assert made.balloon.Backend == "NumPy"
    assert made.balloon.MeshSize.Value == pytest.approx(9)
    assert made.balloon.Live is False


def test_engine_settings_are_the_same_as_those_of_the_objects(doc):
    """The paint window solves before there are objects."""
    from BalloonWorkbench.app.properties import film

    for key, value in {"Film": "pvc", "Pressure": 1.0, "MeshSize": 8.0, "Backend": "NumPy"}.items():
        preferences.put(key, value)
    made, settings = create.make(doc), preferences.settings()
    preferences.begin(made)
    own = film.read(made.balloon)
    assert settings.film.young_modulus == pytest.approx(own.young_modulus)
    assert settings.film.thickness == pytest.approx(own.thickness)
    assert settings.pressure == pytest.approx(1000.0)
    assert settings.mesh_size == pytest.approx(0.008)
    assert settings.backend == "numpy"


def test_usual_value_is_not_kept(usual):
    preferences.put("Width", 250.0)
    assert usual.GetFloats() == ["Width"]
    preferences.put("Width", 300.0)
    assert usual.GetFloats() == []


@pytest.mark.parametrize(
    ("kind", "key", "value"),
    [
        ("String", "Film", "a film that is gone"),
        ("String", "Backend", "Abacus"),
        ("String", "Machine", "guillotine"),
        ("Float", "Width", -3.0),
        ("Float", "Width", 0.0),
        ("Float", "Pressure", float("nan")),
        ("Float", "Allowance", -1.0),
    ],
)
def test_senseless_value_is_not_taken(usual, kind, key, value):
    getattr(usual, f"Set{kind}")(key, value)
    assert preferences.get(key) == preferences.items()[key].default


def test_a_bed_for_each_machine():
    """That of the machine's file is not kept; what makes no sense is not taken; none is no limit."""
    known = machines()
    laser, paper = known["lightburn"], known["paper"]
    assert preferences.bed(laser) == laser.bed
    preferences.put_bed(laser, (0.9, 0.6))
    preferences.put_bed(paper, (0.3, math.inf))
    assert preferences.bed(laser) == pytest.approx((0.9, 0.6))
    assert preferences.bed(paper) == (pytest.approx(0.3), math.inf)
    preferences.put_bed(laser, None)
    assert preferences.bed(laser) is None
    beds = App.ParamGet(f"{preferences.PATH}/Beds")
    preferences.put_bed(laser, laser.bed)
    assert beds.GetStrings() == ["paper"]
    beds.SetString("lightburn", "-3 x mm")
    assert preferences.bed(laser) == laser.bed


def test_where_files_go(doc, tmp_path):
    """The user's wish, the last folder for this document, beside it, the last one at all."""
    used, beside = tmp_path / "used", tmp_path / "beside"
    used.mkdir()
    beside.mkdir()
    preferences.put_export_folder(doc, used)
    assert preferences.export_folder(doc) == used
    other = App.newDocument("Other")
    try:
        assert preferences.export_folder(other) == used
        other.saveAs(str(beside / "other.FCStd"))
        assert preferences.export_folder(other) == beside
    finally:
        App.closeDocument(other.Name)
    preferences.put("ExportFolder", str(tmp_path / "wish"))
    assert preferences.export_folder(doc) == tmp_path / "wish"
    preferences.put("ExportFolder", "")
    used.rmdir()
    assert preferences.export_folder(doc) == Path.home()


def test_parameters_are_touched_in_one_place():
    """Apart from the registration of material cards, which is FreeCAD's own place."""
    package = Path(preferences.__file__).resolve().parents[2]
    found = {path.name for path in package.rglob("*.py") if "ParamGet(" in path.read_text(encoding="utf-8")}
    assert found == {"preferences.py", "material.py"}
