# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films from FreeCAD's material cards: through its material system (1.0 and later), or from its card files.

Our films are cards of that system too. A chosen card gives its numbers to the balloon; its name is kept
beside them, so that the document needs neither the card nor the material system.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import FreeCAD as App

from BalloonWorkbench.app.host import has_material_system

ROOT = Path(__file__).resolve().parents[3]
RESOURCES = ROOT / "resources" / "materials"
FILM = "1d3f5c9e-6a0b-5e52-9c35-6f1c4b0b7f21"  # models of the material system
LINEAR_ELASTIC = "7b561d1d-fb9b-44f6-9da9-56a4f74d7536"
_PLACE = "User parameter:BaseApp/Preferences/Mod/Material/Resources/Modules/BalloonWorkbench"


class Card(NamedTuple):
    """A material: what people read, where it is from, and its values as FreeCAD writes quantities."""

    name: str
    library: str
    values: dict[str, str]


def register() -> None:
    """Tell FreeCAD's material system where our cards and their model are."""
    if not has_material_system():
        return
    group = App.ParamGet(_PLACE)
    group.SetString("ModuleDir", str(RESOURCES / "cards"))
    group.SetString("ModuleModelDir", str(RESOURCES / "models"))
    group.SetString("ModuleIcon", str(ROOT / "resources" / "icons" / "workbench.svg"))
    group.SetBool("ModuleReadOnly", True)


def cards() -> list[Card]:
    """Every card with a Young's modulus, ours first, then by library and name."""
    listed = _managed() if has_material_system() else _filed()
    usable = [card for card in listed if card.values.get("YoungsModulus")]
    return sorted(usable, key=lambda card: ("Thickness" not in card.values, card.library, card.name))


def card_named(name: str) -> Card:
    """The card of this name; InputError when there is none."""
    from BalloonWorkbench.core.errors import InputError

    for card in cards():
        if card.name == name:
            return card
    raise InputError(f'FreeCAD has no material card "{name}": choose one of its material editor.')


def card_with(uuid: str) -> Card | None:
    """The card of the material system with this identity; None when there is none."""
    import Materials

    material = Materials.MaterialManager().Materials.get(uuid)
    return None if material is None else Card(material.Name, material.LibraryName, dict(material.Properties))


def filters(films: str, others: str) -> list:
    """What FreeCAD's material tree may show, by these titles: our kind of card, or any elastic one."""
    import Materials

    made = []
    for title, models in ((films, [FILM]), (others, [LINEAR_ELASTIC])):
        each = Materials.MaterialFilter()
        each.Name, each.RequiredModels = title, models
        made.append(each)
    return made


def take(obj, card: Card) -> None:
    """Give a balloon the numbers of a card; what the card does not say stays. InputError for broken ones."""
    from BalloonWorkbench.app.properties import film

    obj.Film = film.CUSTOM
    numbers = _numbers(card)
    for name in ("YoungModulus", "PoissonRatio", "Thickness", "SealWidth", "WeldRigidity", "Strength"):
        if name in numbers:
            setattr(obj, name, numbers[name])
    obj.YoungModulusAcross = numbers.get("YoungModulusAcross", 0.0)
    if "ArealDensity" in numbers:
        obj.ArealDensity = numbers["ArealDensity"]
    elif "Density" in numbers:
        obj.ArealDensity = numbers["Density"] * obj.Thickness.getValueAs("m").Value
    obj.SealingSide = card.values.get("SealingSide", "").strip()
    laser = {"never": False, "may be cut": True}.get(card.values.get("Laser", ""))
    film.take_joining(obj, card.values.get("Joining", ""), card.values.get("OneSided") == "yes", laser)
    obj.Material = card.name


def _numbers(card: Card) -> dict[str, float]:
    """The values in the units of our properties."""
    from BalloonWorkbench.core.errors import InputError

    keys = {
        "YoungModulus": ("YoungsModulus", "kPa"),
        "YoungModulusAcross": ("YoungsModulusAcross", "kPa"),
        "Strength": ("UltimateTensileStrength", "kPa"),
        "PoissonRatio": ("PoissonRatio", ""),
        "Thickness": ("Thickness", "mm"),
        "SealWidth": ("SealWidth", "mm"),
        "WeldRigidity": ("WeldRigidity", ""),
        "ArealDensity": ("ArealDensity", "kg/m^2"),
        "Density": ("Density", "kg/m^3"),
    }
    numbers = {}
    for name, (key, unit) in keys.items():
        text = card.values.get(key, "").strip()
        if text:
            try:
                value = App.Units.Quantity(text)
                number = value.getValueAs(unit).Value if unit else value.Value
                numbers[name] = float(f"{number:.10g}")  # without what changing units has added
            except (ValueError, OSError, SyntaxError, ArithmeticError) as error:
                raise InputError(
                    f'The {key} "{text}" of the material card {card.name} cannot be read: correct the card.'
                ) from error
    return numbers


def _managed() -> Iterator[Card]:
    """The cards of the material system."""
    import Materials

    manager = Materials.MaterialManager()
    for material in manager.materialsWithModel(LINEAR_ELASTIC).values():
        yield Card(material.Name, material.LibraryName, dict(material.Properties))


def _filed() -> Iterator[Card]:
    """Ours, FreeCAD's own and the user's card files."""
    places = {
        "BalloonWorkbench": RESOURCES / "cards",
        "FreeCAD": Path(App.getResourceDir()) / "Mod" / "Material" / "StandardMaterial",
        "User": Path(App.getUserAppDataDir()) / "Material",
    }
    for library, folder in places.items():
        for path in sorted(folder.glob("*.FCMat")):
            yield Card(path.stem, library, read_card(path.read_text(encoding="utf-8", errors="replace")))


def read_card(text: str) -> dict[str, str]:
    """The values of a card file: "Key = value" lines as FreeCAD 0.20 writes them, or the YAML of later ones.

    Groups are left out, and text over several lines: only numbers are asked for.
    """
    values = {}
    for line in text.splitlines():
        mark = "=" if "=" in line.split(":")[0] else ":"
        key, separator, value = line.strip().partition(mark)
        value = value.strip().strip("\"'").strip()
        if separator and value and key.strip() and not key.startswith((";", "#", "[")):
            values.setdefault(key.strip(), value)
    return values
