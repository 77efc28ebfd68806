# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures as texts in the units that the user has chosen for FreeCAD, with digits that mean something."""

from __future__ import annotations

import math

import FreeCAD as App

from BalloonWorkbench.app.quantities import kilopascals
from BalloonWorkbench.core.units import to_mm

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
    return f"{length * factor:.{digits}g} {unit}"


def lengths_text(*lengths: float) -> list[str]:
    """Lengths in mm, with three digits."""
    return [length_text(length, 3) for length in lengths]


def size_text(width: float, height: float) -> str:
    """Two lengths in mm, in one unit."""
    factor, unit = user_unit("mm", max(width, height))
    return f"{width * factor:.4g} x {height * factor:.4g} {unit}"


def bed_size_text(bed: tuple[float, float] | None) -> str:
    """The bed of a machine [m]: its width alone for a roll, empty where there is no limit."""
    if bed is None:
        return ""
    width, height = map(to_mm, bed)
    return length_text(width) if math.isinf(height) else size_text(width, height)


def volume_text(volume: float) -> str:
    """A volume in mm3."""
    _, factor, unit = App.Units.Quantity(volume, App.Units.Volume).getUserPreferred()
    return f"{volume / factor:.3g} {unit}"


def pressure_text(pressure: float) -> str:
    """A pressure in Pa; FreeCAD itself writes thousands of Pa."""
    _, factor, unit = App.Units.Quantity(kilopascals(pressure), App.Units.Pressure).getUserPreferred()
    if unit == "Pa":
        factor, unit = 1.0, "kPa"
    return f"{kilopascals(pressure) / factor:.3g} {unit}"
