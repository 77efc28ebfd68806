# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bringing objects of older files up to date, one schema at a time."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD as App

from BalloonWorkbench.app.properties import Property, add_missing

SCHEMA = 1

VERSION = Property(
    "Integer", "SchemaVersion", "Base", "Version of this object's properties", SCHEMA, hidden=True
)

#: STEPS[i] takes an object from schema i + 1 to schema i + 2. A step may run twice on the same object.
STEPS: tuple[Callable[[object], None], ...] = ()


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
