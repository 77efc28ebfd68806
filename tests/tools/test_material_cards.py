# SPDX-License-Identifier: LGPL-2.1-or-later
"""The material cards agree with the film files that they are made from."""

import importlib.util
import json
from pathlib import Path
from typing import Any

import pytest

yaml = pytest.importorskip("yaml")
ROOT = Path(__file__).resolve().parents[2]
FILMS = [json.loads(path.read_text(encoding="utf-8")) for path in (ROOT / "resources/films").glob("*.json")]
CARDS = {
    path.stem: yaml.safe_load(path.read_text(encoding="utf-8"))
    for path in (ROOT / "resources/materials/cards").glob("*.FCMat")
}
MODEL = yaml.safe_load((ROOT / "resources/materials/models/Film.yml").read_text(encoding="utf-8"))["Model"]

#: SI value of each unit that the cards use.
UNITS = {"MPa": 1e6, "mm": 1e-3, "kg/m^2": 1.0, "kg/m^3": 1.0, "": 1.0}


#: What is told in words.
WORDS = ("Joining", "OneSided", "Laser")


def in_si(text: str) -> float:
    number, _, unit = text.partition(" ")
    return float(number) * UNITS[unit]


def card_of(film: dict[str, Any]) -> dict[str, Any]:
    found = [card for card in CARDS.values() if card["General"]["Description"] == film["note"]]
    assert len(found) == 1, f"run tools/material_cards.py: {film['name']}"
    return found[0]


@pytest.mark.parametrize("film", FILMS, ids=lambda film: film["name"])
def test_card_has_the_numbers_of_the_film(film: dict[str, Any]) -> None:
    known = card_of(film)["Models"]["Film"]
    told = {name: text for name, text in known.items() if name not in (*WORDS, "SealingSide", "UUID")}
    assert known["SealingSide"] == film["sealing_side"]
    low, high = film["young_modulus_range_Pa"]
    expected = {
        "Thickness": film["thickness_m"],
        "YoungsModulus": film["young_modulus_Pa"],
        "YoungsModulusLeast": low,
        "YoungsModulusMost": high,
        "PoissonRatio": film["poisson_ratio"],
        "ArealDensity": film["areal_density_kg_m2"],
        "Density": film["areal_density_kg_m2"] / film["thickness_m"],
        "SealWidth": film["seal_width_m"],
        "WeldRigidity": film["weld_rigidity"]["value"],
        "UltimateTensileStrength": film["max_stress_Pa"],
    }
    assert {name: in_si(text) for name, text in told.items()} == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("film", FILMS, ids=lambda film: film["name"])
def test_card_says_how_the_film_is_joined(film: dict[str, Any]) -> None:
    told = card_of(film)["Models"]["Film"]
    assert told["Joining"] == film["joining"]
    assert told["OneSided"] == ("yes" if film["one_side"] else "no")
    assert told.get("Laser") == {None: None, True: "may be cut", False: "never"}[film["laser"]]


def test_there_is_a_card_for_each_film_and_no_other() -> None:
    assert len(CARDS) == len(FILMS)
    assert len({card["General"]["UUID"] for card in CARDS.values()}) == len(FILMS)


def test_cards_are_as_the_tool_writes_them() -> None:
    spec = importlib.util.spec_from_file_location("material_cards", ROOT / "tools/material_cards.py")
    assert spec is not None
    assert spec.loader is not None
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    folder = ROOT / "resources/materials/cards"
    written = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.FCMat")}
    assert tool.cards() == written


@pytest.mark.parametrize("name", CARDS)
def test_card_and_its_file_have_the_same_plain_name(name: str) -> None:
    """FreeCAD shows the file's name; archives and Windows take plain letters only."""
    assert CARDS[name]["General"]["Name"] == name
    assert name.isascii()


def test_model_has_what_the_cards_give() -> None:
    """Beside what it takes over from FreeCAD's linear elastic material."""
    inherited = {"UUID", "Density", "PoissonRatio", "YoungsModulus", "UltimateTensileStrength"}
    given = set().union(*(card["Models"]["Film"] for card in CARDS.values())) - inherited
    assert given <= set(MODEL)
    assert all(card["Models"]["Film"]["UUID"] == MODEL["UUID"] for card in CARDS.values())
    assert MODEL["Inherits"][0]["UUID"] == "7b561d1d-fb9b-44f6-9da9-56a4f74d7536"
