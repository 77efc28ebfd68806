# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films from FreeCAD's material cards and from the user's own files."""

import json
import shutil
from pathlib import Path

import FreeCAD as App
import pytest
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import film, material
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import films

OURS = "Aluminised PET (Mylar), 25 um"


@pytest.fixture
def balloon(doc):
    return create.make(doc).balloon


def test_our_films_are_cards_of_freecad(balloon):
    """Every number that the engine uses comes through FreeCAD unchanged."""
    by_name = {card.name: card for card in material.cards()}
    material.register()
    for known in films().values():
        names = [name for name, card in by_name.items() if "Thickness" in card.values and fits(card, known)]
        assert len(names) == 1, known.name
        balloon.Film = "mylar" if known.name != "mylar" else "pe"
        material.take(balloon, by_name[names[0]])
        taken = film.read(balloon)
        for value in (
            "young_modulus",
            "poisson_ratio",
            "thickness",
            "areal_density",
            "seal_width",
            "weld_rigidity",
        ):
            assert getattr(taken, value) == pytest.approx(getattr(known, value), rel=1e-9)
        assert taken.max_stress == pytest.approx(known.max_stress, rel=1e-9)
        assert taken.title == names[0]
        for value in ("joining", "one_side", "laser"):
            assert getattr(taken, value) == getattr(known, value)


def fits(card, known):
    """By its weight, which no two of our films share."""
    return App.Units.Quantity(card.values["ArealDensity"]).getValueAs("kg/m^2").Value == pytest.approx(
        known.areal_density
    )


def test_a_material_of_freecad_keeps_the_thickness(balloon):
    balloon.Film = film.CUSTOM
    balloon.Thickness = "40 um"
    material.take(balloon, material.card_named("PET-Generic"))
    assert balloon.YoungModulus.getValueAs("MPa").Value == pytest.approx(3150)
    assert balloon.PoissonRatio == pytest.approx(0.36)
    assert balloon.Thickness.getValueAs("mm").Value == pytest.approx(0.04)
    assert balloon.ArealDensity == pytest.approx(1380 * 40e-6)
    assert balloon.Strength.getValueAs("MPa").Value == pytest.approx(38.8)
    taken = film.read(balloon)
    assert (taken.joining, taken.one_side, taken.laser) == ("", False, None)


def test_card_survives_save_and_reopen(doc, tmp_path):
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc, 90, 60), mesh_size=15, correct=False)
    material.take(parts.balloon, material.card_named(OURS))
    doc.recompute()
    solved = parts.balloon.SolvedFor
    path = tmp_path / "card.FCStd"
    doc.saveAs(str(path))
    copy = App.openDocument(str(shutil.copy(path, tmp_path / "again.FCStd")))
    reopened = copy.getObject(parts.balloon.Name)
    assert reopened.Material == OURS
    assert reopened.Film == film.CUSTOM
    copy.recompute()
    assert reopened.SolvedFor == solved
    App.closeDocument(copy.Name)


def test_choosing_a_film_of_the_library_forgets_the_card(balloon):
    material.take(balloon, material.card_named(OURS))
    balloon.Film = "pe"
    assert not balloon.Material
    assert film.read(balloon).name == "pe"


def test_unknown_card_is_refused():
    with pytest.raises(InputError, match="no material card"):
        material.card_named("Unobtainium")


def test_broken_card_is_refused(balloon):
    card = material.Card("Broken", "User", {"YoungsModulus": "3 bananas"})
    with pytest.raises(InputError, match="bananas"):
        material.take(balloon, card)


@pytest.mark.parametrize(
    "text",
    [
        "; a comment\n[Mechanical]\nYoungsModulus = 2 GPa\nDensity = 910 kg/m^3\nSourceURL = http://x/?a=b\n",
        "---\nModels:\n  L:\n    YoungsModulus: \"2 GPa\"\n    Density: '910 kg/m^3'\n",
    ],
    ids=["0.20", "1.0"],
)
def test_both_kinds_of_card_file_are_read(text):
    values = material.read_card(text)
    assert values["YoungsModulus"] == "2 GPa"
    assert values["Density"] == "910 kg/m^3"


@pytest.fixture
def own_film():
    """A film file in the user's folder."""
    folder = film.own_folder()
    folder.mkdir(parents=True, exist_ok=True)
    data = json.loads((Path(material.ROOT) / "resources/films/pe.json").read_text(encoding="utf-8"))
    data |= {"name": "my-foil", "title": "My foil", "thickness_m": 33e-6}
    path = folder / "my-foil.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    yield path
    path.unlink(missing_ok=True)


def test_own_film_can_be_chosen(doc, own_film):
    balloon = create.make(doc).balloon
    balloon.Film = "my-foil"
    assert balloon.Thickness.getValueAs("mm").Value == pytest.approx(0.033)
    assert film.read(balloon).title == "My foil"


def test_own_film_is_offered_to_older_objects(balloon, own_film):
    balloon.Film = "pe"
    assert "my-foil" not in balloon.getEnumerationsOfProperty("Film")
    film.offer(balloon)
    assert balloon.Film == "pe"
    balloon.Film = "my-foil"
    assert balloon.Thickness.getValueAs("mm").Value == pytest.approx(0.033)


def test_document_keeps_an_own_film_that_is_gone(doc, own_film, tmp_path):
    """Another machine lacks the file: the numbers are in the document."""
    balloon = create.make(doc).balloon
    balloon.Film = "my-foil"
    own_film.unlink()
    path = tmp_path / "own.FCStd"
    doc.saveAs(str(path))
    copy = App.openDocument(str(shutil.copy(path, tmp_path / "elsewhere.FCStd")))
    there = copy.getObject(balloon.Name)
    assert there.Film == "my-foil"
    assert film.read(there).thickness == pytest.approx(33e-6)
    film.offer(there)
    assert there.Film == "my-foil"
    assert film.read(there).thickness == pytest.approx(33e-6)
    App.closeDocument(copy.Name)


def test_broken_own_film_is_left_out(own_film):
    own_film.write_text("{", encoding="utf-8")
    assert "my-foil" not in film.known_films()


def test_a_card_tells_its_sealing_side(balloon):
    """What a valve has to weld to: from our cards and the library; a card without it leaves it open."""
    material.take(balloon, material.card_named("Aluminised nylon-PE foil (party balloon), 30 um"))
    assert (balloon.SealingSide, film.read(balloon).sealing_side) == ("PE", "PE")
    material.take(balloon, material.card_named("PET-Generic"))
    assert film.read(balloon).sealing_side is None
    balloon.Film = "bopp-foil"
    assert (balloon.SealingSide, film.read(balloon).sealing_side) == ("PP", "PP")
