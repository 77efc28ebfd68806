# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bringing objects of older files up to date, one schema at a time."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD as App

from BalloonWorkbench.app.properties.property_table import Property, add_missing

SCHEMA = 2

#: Arcs of a shape are that near to the pattern's points [mm].
_ON_CUT = 0.1

VERSION = Property(
    "Integer", "SchemaVersion", "Base", "Version of this object's properties", SCHEMA, hidden=True
)


def _part_marks(obj) -> None:
    """Schema 2: lines that were all MARK are notches, which begin on a cut, or only drawn."""
    if "MARK" not in getattr(obj, "Roles", ()):
        return
    wires = list(zip(obj.Shape.Wires, obj.Roles))
    cuts = [wire for wire, role in wires if role == "CUT"]

    def own(wire, role: str) -> str:
        if role != "MARK":
            return role
        begun = any(wire.Edges[0].firstVertex().distToShape(cut)[0] < _ON_CUT for cut in cuts)
        return "NOTCH" if begun else "PEN"

    obj.Roles = [own(wire, role) for wire, role in wires]


#: STEPS[i] takes an object from schema i + 1 to schema i + 2. A step may run twice on the same object.
STEPS: tuple[Callable[[object], None], ...] = (_part_marks,)


def bring_up_to_date(obj, properties: tuple[Property, ...]) -> bool:
    """Complete the object's properties and take it to the present schema; True when that is done.

    An object of a newer release is left as it is, with a warning: it may know more than we do.
    """
    if "SchemaVersion" in obj.PropertiesList and obj.SchemaVersion > SCHEMA:
        App.Console.PrintWarning(
            f"{obj.Label}: made by a newer Film Balloon workbench; update the workbench before changing it.\n"
        )
        return False
    add_missing(obj, (VERSION, *properties))
    for step in STEPS[obj.SchemaVersion - 1 :]:
        step(obj)
    if obj.SchemaVersion != SCHEMA:
        obj.SchemaVersion = SCHEMA
    return True
