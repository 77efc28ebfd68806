# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making balloons from scripts: values, texts with units, and a document left alone when it fails."""

import json
import math
from pathlib import Path

import pytest
import sketches

from BalloonWorkbench.app.balloon import request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.engine.export import export_pattern
from BalloonWorkbench.app.group import name_group
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.job import Settings

HEART = Path("resources/examples/pictures/heart.png")


@pytest.mark.slow
def test_picture_to_pattern(doc):
    parts = create.balloon_from_picture(doc, HEART, width="12 cm", mesh_size="14 mm")
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert parts.outline.SizeX.Value == pytest.approx(120)
    group = parts.balloon.getParentGroup()
    assert group.Label == "heart"
    assert group.Group == list(parts)
    # the pattern lies to the right of the balloon, in the same plane
    assert parts.pattern.Shape.BoundBox.XMin > parts.balloon.Mesh.BoundBox.XMax
    assert parts.pattern.Shape.BoundBox.ZLength == pytest.approx(0, abs=1e-9)


def test_options(doc):
    stiff = Film("mine", 1.5e9, 0.4, 40e-6, 0.05, seal_width=8e-3)
    parts = create.balloon_from_sketch(
        doc,
        sketches.rectangle(doc, 60, 60),
        material=stiff,
        pressure="30 mbar",
        mesh_size=10,
        correct=False,
        backend="NumPy",
        intake=False,
    )
    balloon = parts.balloon
    assert balloon.Film == "Custom"
    assert balloon.YoungModulus.getValueAs("MPa").Value == pytest.approx(1500)
    assert balloon.Thickness.Value == pytest.approx(0.04)
    assert balloon.SealWidth.Value == pytest.approx(8)
    assert balloon.Pressure.Value == pytest.approx(3)
    assert balloon.ActiveBackend == "numpy"
    assert (balloon.Mode, balloon.Passes) == ("Inflate as drawn", 0)
    assert all(wire.isClosed() for wire in parts.pattern.Shape.Wires)


def test_defaults_are_those_of_the_command_line(doc):
    parts = create.make(doc)
    parts.outline.Source = sketches.rectangle(doc)
    parts.outline.recompute()
    own, wanted = request(parts.balloon).settings, Settings()
    for name in ("young_modulus", "poisson_ratio", "thickness", "areal_density", "seal_width", "max_stress"):
        assert getattr(own.film, name) == pytest.approx(getattr(wanted.film, name), rel=1e-12)
    assert own.pressure == pytest.approx(wanted.pressure)
    assert (own.mesh_size, own.backend, own.correct) == (wanted.mesh_size, wanted.backend, wanted.correct)
    assert parts.pattern.Intake == wanted.intake


def test_film_of_the_library_keeps_its_name(doc):
    parts = create.make(doc)
    create.configure(parts, material=film("pe"))
    assert parts.balloon.Film == "pe"
    create.configure(parts, material="Kraft paper")
    assert parts.balloon.Film == "kraft-paper"


@pytest.mark.slow
def test_several_shapes(doc):
    """Ring, L and S have their own names and do not disturb each other."""
    for make in (sketches.ring, sketches.rounded_l, sketches.letter_s):
        correct = make is sketches.rounded_l
        parts = create.balloon_from_sketch(doc, make(doc), mesh_size=14, correct=correct)
        assert parts.balloon.Mesh.isSolid()
        assert not correct or parts.balloon.ResidualMean.Value < 0.015 * parts.outline.SizeX.Value
    assert len({obj.Name for obj in doc.Objects}) == len(doc.Objects) == 3 * 5


def two_discs(path, larger=50):
    """A drawing of two discs, 40 mm apart."""
    loops = [
        [[x + r * math.cos(a), r * math.sin(a)] for a in (k * math.pi / 30 for k in range(60))]
        for x, r in ((0, 30), (70 + larger, larger))
    ]
    path.write_text(json.dumps({"unit": "mm", "parts": [{"outer": loop} for loop in loops]}))
    return path


@pytest.mark.slow
def test_each_shape_of_a_drawing_is_a_balloon(doc, tmp_path):
    parts = create.balloon_from_picture(
        doc, two_discs(tmp_path / "discs.json"), mesh_size=10, pressure=3, correct=False
    )
    (other,) = create.companions(parts)
    assert [obj.Status for obj in (*parts, *other)] == [status.READY] * 6
    assert parts.balloon.getParentGroup().Group == [*parts, *other]
    assert [each.outline.SizeX.Value for each in (parts, other)] == pytest.approx([100, 60], rel=0.01)
    assert other.balloon.Pressure == parts.balloon.Pressure
    # Mylar balloon: volume in proportion to the cube of the radius
    assert parts.balloon.Volume.Value / other.balloon.Volume.Value == pytest.approx((5 / 3) ** 3, rel=0.04)
    boxes = [each.pattern.Shape.BoundBox for each in (parts, other)]
    assert min(box.XMin for box in boxes) > max(each.outline.Shape.BoundBox.XMax for each in (parts, other))
    assert not boxes[0].intersect(boxes[1])
    sheet = export_pattern(parts.balloon.getParentGroup(), tmp_path / "both.svg").read_text()
    assert sheet.count("<path") == 4  # a cut and a weld for each
    # the drawing is shared
    parts.outline.Width = 0.5 * 200
    doc.recompute()
    assert [each.outline.SizeX.Value for each in (parts, other)] == pytest.approx([50, 30], rel=0.01)
    create.discard(parts)
    assert doc.Objects == []


def test_shape_that_is_gone_from_the_drawing(doc, tmp_path):
    parts = create.balloon_from_picture(doc, two_discs(tmp_path / "discs.json"), mesh_size=14, correct=False)
    (other,) = create.companions(parts)
    set_drawing(parts.outline, HEART)
    parts.outline.Width = 100
    doc.recompute()
    assert parts.outline.Status == status.READY
    assert "1 shape" in status.problem(other.outline)
    assert other.balloon.Volume.Value > 0  # is kept


def test_separate_loops_of_a_sketch(doc):
    loops = [*sketches.polygon((0, 0), (60, 0), (60, 60), (0, 60))]
    loops += sketches.polygon((90, 0), (130, 0), (130, 40), (90, 40))
    sketch = sketches.sketch(doc, *loops)
    sketch.Placement.Base.z = 7
    parts = create.balloon_from_sketch(doc, sketch, mesh_size=10, correct=False)
    (other,) = create.companions(parts)
    assert [each.outline.Shape.Area for each in (parts, other)] == pytest.approx([3600, 1600])
    assert other.outline.Shape.BoundBox.XMin == pytest.approx(90)
    assert other.outline.Placement.Base.z == pytest.approx(7)
    assert other.balloon.Status == status.READY


def failing(doc, words, make):
    before = [obj.Name for obj in doc.Objects]
    with pytest.raises(InputError, match=words):
        make()
    assert [obj.Name for obj in doc.Objects] == before


@pytest.mark.parametrize("width", [0, -5, "0 mm", "-3 cm", float("nan")])
def test_senseless_width(doc, width):
    failing(doc, "width", lambda: create.balloon_from_picture(doc, HEART, width=width))


def test_no_size(doc):
    failing(doc, "size", lambda: create.balloon_from_picture(doc, HEART))


def test_width_of_a_hundred_kilometres(doc):
    failing(doc, "width", lambda: create.balloon_from_picture(doc, HEART, width="100000 m"))


def test_text_that_is_no_length(doc):
    failing(doc, "length", lambda: create.balloon_from_picture(doc, HEART, width="wide"))


def test_no_such_file(doc):
    failing(doc, "no file", lambda: create.balloon_from_picture(doc, "nowhere/bear.png", width=100))


def test_no_picture(doc, tmp_path):
    path = tmp_path / "picture.png"
    path.write_bytes(b"no picture")
    failing(doc, "picture", lambda: create.balloon_from_picture(doc, path, width=100))


def test_unknown_material(doc):
    rectangle = sketches.rectangle(doc)
    failing(doc, "mylar", lambda: create.balloon_from_sketch(doc, rectangle, material="unobtainium"))


def test_unknown_backend(doc):
    rectangle = sketches.rectangle(doc)
    failing(doc, "backend", lambda: create.balloon_from_sketch(doc, rectangle, backend="abacus"))


@pytest.mark.parametrize("pressure", [0, -2, "0 kPa"])
def test_senseless_pressure(doc, pressure):
    rectangle = sketches.rectangle(doc)
    failing(doc, "pressure", lambda: create.balloon_from_sketch(doc, rectangle, pressure=pressure))


def test_open_sketch(doc):
    line = sketches.sketch(doc, sketches.line((0, 0), (50, 0)), name="Line")
    failing(doc, "open", lambda: create.balloon_from_sketch(doc, line))


@pytest.mark.parametrize("label", ["Film balloon", "Fish", "Balloon", "Pattern"])
def test_first_one_has_no_number(doc, label):
    """A group may not take the name of its own members, nor they its name."""
    parts = create.make(doc, label)
    group = parts.balloon.getParentGroup()
    assert [obj.Label for obj in parts] == ["Outline", "Balloon", "Pattern"]
    assert group.Label.startswith(label)
    assert not any(letter.isdigit() for letter in group.Label)
    second = create.make(doc, label).balloon.getParentGroup()
    assert second.Label == f"{group.Label} 2"
    name_group(second, label)
    assert second.Label == f"{group.Label} 2"
    name = group.Label
    create.discard(parts)
    name_group(second, label)
    assert second.Label == name
