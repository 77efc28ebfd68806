# SPDX-License-Identifier: LGPL-2.1-or-later
"""A side band between front and back of a drawing: another property, another balloon, and back again."""

from pathlib import Path

import FreeCAD as App
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import bag_result, film_result

HEART = Path("resources/examples/pictures/heart.png").resolve()
QUICK = {"mesh_size": 14}


@pytest.fixture(scope="module")
def solved():
    document = App.newDocument("Band")
    document.UndoMode = 1
    yield BalloonWorkbench.from_sketch(document, sketches.rectangle(document, 200, 60), band="30 mm", **QUICK)
    App.closeDocument(document.Name)


def test_a_letter_with_a_band(parts):
    assert parts.balloon.PanelCount >= 3
    assert parts.balloon.InflatedThickness.Value > 30
    assert parts.balloon.ResidualMean.Value < 0.005 * 200
    assert "band" in " ".join(parts.pattern.Pieces)
    assert bag_result.has_many_panels(parts.balloon)


def test_without_the_band_there_are_two_panels(parts):
    BalloonWorkbench.change(parts, band=0)
    assert [obj.Status for obj in parts] == [status.READY] * 3
    assert parts.balloon.PanelCount == 0
    assert parts.pattern.Pieces == []
    assert not bag_result.has_many_panels(parts.balloon)
    inflation, _ = film_result.stored(parts.balloon)
    assert inflation.assembly.mirror


def test_the_result_of_round_shapes_is_read_again(doc):
    """A coarse mesh cuts off more of one side of a seam than of the other."""
    made = BalloonWorkbench.from_sketch(doc, sketches.ring(doc), band=20, mesh_size=12)
    inflation, _ = film_result.stored(made.balloon)
    assert inflation.assembly.surface.euler_number == 0
    assert max(made.balloon.SeamEase) > 0


def test_the_band_is_offered_for_outlines_only(parts, doc):
    assert parts.balloon.getEditorMode("Band") == []
    assert parts.balloon.getEditorMode("BandPiece") == []
    other = BalloonWorkbench.from_panels(doc, "Tetrahedron", mesh_size=60)
    assert other.balloon.getEditorMode("Band") == ["Hidden"]


def test_weight_and_lift_are_those_of_all_panels(parts):
    density = 0.034  # kg/m2, about that of the film
    area = parts.balloon.FilmArea.getValueAs("m^2").Value
    assert parts.balloon.Weight > 0.5 * 1e3 * density * area
    assert parts.balloon.Lift < 1.05 * 1e3 * parts.balloon.Volume.getValueAs("m^3").Value


def test_the_assembly_sheet(parts, tmp_path):
    written = BalloonWorkbench.assembly_sheet(parts, tmp_path / "letter.pdf").read_bytes()
    assert written.startswith(b"%PDF")
    assert (
        written.count(b"/Type /Page\n") + written.count(b"/Type /Page ") > 2
    )  # steps, and the table of seams


def test_a_picture_is_printed_on_all_panels(parts, tmp_path):
    """Once, with the lines that cutters read beside it."""
    made = BalloonWorkbench.artwork(parts.pattern, picture=str(HEART), resolution=30)
    assert made.Status == status.READY
    assert made.Roles.count("CUT") == parts.balloon.PanelCount
    BalloonWorkbench.export(made, tmp_path / "prints")
    names = {file.name for file in (tmp_path / "prints").iterdir()}
    assert {"artwork.png", "artwork.pdf", "print-pattern.dxf", "print-pattern.svg"} <= names
    parts.balloon.Document.removeObject(made.Name)
