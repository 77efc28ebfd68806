# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures as texts in the units that the user has chosen for FreeCAD, with digits that mean something."""

from __future__ import annotations

import math

import FreeCAD as App

from BalloonWorkbench.app.properties.quantities import kilopascals
from BalloonWorkbench.core.units import number_text, to_mm

#: Stands where a measure is not known yet.
NOTHING = "\N{EN DASH}"


def user_unit(unit: str, largest: float) -> tuple[float, str]:
    """The unit in which the user reads lengths, and how many of it there are in a mm; others as they are."""
    if unit != "mm":
        return 1.0, unit
    _, factor, preferred = App.Units.Quantity(largest, App.Units.Length).getUserPreferred()
    return 1.0 / factor, preferred


def length_text(length: float, digits: int = 4) -> str:
    """A length in mm."""
    factor, unit = user_unit("mm", length)
    return f"{number_text(length * factor, digits)} {unit}"


def lengths_text(*lengths: float) -> list[str]:
    """Lengths in mm that are compared, with three digits in one unit."""
    factor, unit = user_unit("mm", max(map(abs, lengths)))
    return [f"{number_text(length * factor)} {unit}" for length in lengths]


def size_text(*lengths: float) -> str:
    """Lengths in mm of one thing, in one unit."""
    factor, unit = user_unit("mm", max(lengths))
    return f"{' x '.join(number_text(length * factor, 4) for length in lengths)} {unit}"


def bed_size_text(bed: tuple[float, float] | None) -> str:
    """The bed of a machine [m]: its width alone for a roll, empty where there is no limit."""
    if bed is None:
        return ""
    width, height = map(to_mm, bed)
    return length_text(width) if math.isinf(height) else size_text(width, height)


def volume_text(volume: float) -> str:
    """A volume in mm3."""
    _, factor, unit = App.Units.Quantity(volume, App.Units.Volume).getUserPreferred()
    return f"{number_text(volume / factor)} {unit.replace('^3', '³')}"


def pressure_text(pressure: float) -> str:
    """A pressure in Pa; FreeCAD itself writes thousands of Pa."""
    _, factor, unit = App.Units.Quantity(kilopascals(pressure), App.Units.Pressure).getUserPreferred()
    if unit == "Pa":
        factor, unit = 1.0, "kPa"
    return f"{number_text(kilopascals(pressure) / factor)} {unit}"
