# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths as people say them: whole millimetres and centimetres, or inches where FreeCAD is set to them."""

from __future__ import annotations

from typing import NamedTuple

import FreeCAD as App

from BalloonWorkbench.core.units import from_mm, length_text, number_text

_IMPERIAL = {"in", '"', "ft", "'", "thou", "mil", "yd", "mi"}


class Large(NamedTuple):
    """The unit for the size of a balloon, and its length in mm."""

    name: str
    mm: float


def is_imperial() -> bool:
    """FreeCAD shows inches or feet."""
    return App.Units.Quantity(100.0, App.Units.Length).getUserPreferred()[2] in _IMPERIAL


def large() -> Large:
    """Centimetres or inches."""
    return Large("in", 25.4) if is_imperial() else Large("cm", 10.0)


def short(length: float) -> str:
    """A length in mm in a sentence."""
    return f"{number_text(length / 25.4, 2)} in" if is_imperial() else length_text(from_mm(length), 2)
