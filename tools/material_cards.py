# SPDX-License-Identifier: LGPL-2.1-or-later
"""material_cards.py   writes the films of resources/films as cards for FreeCAD's material system."""

from __future__ import annotations

import json
import uuid
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
FILMS = ROOT / "resources" / "films"
CARDS = ROOT / "resources" / "materials" / "cards"
MODEL = "1d3f5c9e-6a0b-5e52-9c35-6f1c4b0b7f21"  # of resources/materials/models/Film.yml

#: Property of the model, key of the film file, factor and unit.
_VALUES = (
    ("Density", None, 1.0, "kg/m^3"),
    ("PoissonRatio", "poisson_ratio", 1.0, ""),
    ("YoungsModulus", "young_modulus_Pa", 1e-6, "MPa"),
    ("YoungsModulusAcross", "young_modulus_across_Pa", 1e-6, "MPa"),
    ("YoungsModulusLeast", None, 1e-6, "MPa"),
    ("YoungsModulusMost", None, 1e-6, "MPa"),
    ("UltimateTensileStrength", "max_stress_Pa", 1e-6, "MPa"),
    ("Thickness", "thickness_m", 1e3, "mm"),
    ("ArealDensity", "areal_density_kg_m2", 1.0, "kg/m^2"),
    ("SealWidth", "seal_width_m", 1e3, "mm"),
    ("WeldRigidity", None, 1.0, ""),
)


def card_name(film: dict[str, Any]) -> str:
    """Name of a film's card; also that of its file, which FreeCAD shows."""
    title = film["title"]
    for sign, letters in (('"', ""), ("/", "-"), ("²", "2"), ("µ", "u")):  # a file name on any system
        title = title.replace(sign, letters)
    return " ".join(title.split())


def card(film: dict[str, Any]) -> str:
    """The card of a film file's content."""
    least, most = film["young_modulus_range_Pa"]
    known = {
        "Density": film["areal_density_kg_m2"] / film["thickness_m"],
        "YoungsModulusLeast": least,
        "YoungsModulusMost": most,
        "WeldRigidity": film["weld_rigidity"]["value"],
    }
    lines = [
        "---",
        "# SPDX-License-Identifier: LGPL-2.1-or-later",
        "# Written by tools/material_cards.py: change the film's file and run it again.",
        "General:",
        f'  UUID: "{uuid.uuid5(uuid.UUID(MODEL), film["name"])}"',
        '  Author: "Film Balloon workbench"',
        '  License: "LGPL-2.1-or-later"',
        f"  Name: {_text(card_name(film))}",
        f"  Description: {_text(film['note'])}",
        f"  ReferenceSource: {_text(' | '.join(film['sources']))}",
        "Models:",
        "  Film:",
        f"    UUID: '{MODEL}'",
    ]
    for name, key, factor, unit in _VALUES:
        value = known.get(name, film.get(key))
        if value is not None:
            lines.append(f'    {name}: "{f"{factor * value:.10g} {unit}".strip()}"')
    lines.append(f"    SealingSide: {_text(film['sealing_side'])}")
    lines += [f"    {name}: {_text(text)}" for name, text in _joining(film).items() if text]
    return "\n".join(lines) + "\n"


def _joining(film: dict[str, Any]) -> dict[str, str]:
    """How panels are joined, and whether a laser may cut them; empty where nobody knows."""
    return {
        "Joining": film["joining"],
        "OneSided": "yes" if film["one_side"] else "no",
        "Laser": {None: "", True: "may be cut", False: "never"}[film["laser"]],
    }


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)  # a JSON string is a YAML string


def cards() -> dict[str, str]:
    """Content of every card, by file name."""
    films = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(FILMS.glob("*.json"))]
    return {f"{card_name(film)}.FCMat": card(film) for film in films}


def main() -> None:
    """Write the cards, and drop those of films that are gone."""
    wanted = cards()
    for path in CARDS.glob("*.FCMat"):
        if path.name not in wanted:
            path.unlink()
    for name, content in wanted.items():
        (CARDS / name).write_text(content, encoding="utf-8")


if __name__ == "__main__":
    main()
