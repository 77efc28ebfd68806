# SPDX-License-Identifier: LGPL-2.1-or-later
"""One colour for each seam, on both its edges and on the balloon, and a tint for each panel."""

from __future__ import annotations

import colorsys

#: Each number is this far round the circle of hues from the one before: neighbours differ most.
_GOLDEN = 0.618033988749895
_SEAM = ((0.95, 0.80), (0.85, 0.55), (1.00, 0.95))  # saturation and value, in turns
_TINT = 0.16  # saturation of a panel's colour

FREE = (0.45, 0.47, 0.50)  # an edge that is in no seam yet
WRONG = (0.84, 0.05, 0.10)  # a seam that cannot be sealed


def seam_colour(number: int) -> tuple[float, float, float]:
    """Red, green and blue from 0 to 1 of a seam, by its number from 0."""
    saturation, value = _SEAM[number % len(_SEAM)]
    return colorsys.hsv_to_rgb((0.58 + _GOLDEN * number) % 1.0, saturation, value)


def panel_tint(number: int) -> tuple[float, float, float]:
    """Red, green and blue from 0 to 1 of a panel, by its number from 0."""
    return colorsys.hsv_to_rgb((0.1 + _GOLDEN * number) % 1.0, _TINT, 1.0)
