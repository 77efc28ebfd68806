# SPDX-License-Identifier: LGPL-2.1-or-later
"""One colour for each seam, on both its edges and on the balloon, and a tint for each panel."""

from __future__ import annotations

import colorsys

from BalloonWorkbench.core.bags.seam_colours import seam_rgb

#: Each number is this far round the circle of hues from the one before: neighbours differ most.
_GOLDEN = 0.618033988749895
_TINT = 0.16  # saturation of a panel's colour
_LIGHT = (1.0, 0.8)  # in turns: neighbours also differ to eyes that see fewer hues

FREE = (0.45, 0.47, 0.50)  # an edge that is in no seam yet
WRONG = (0.84, 0.05, 0.10)  # a seam that cannot be sealed


def seam_colour(number: int) -> tuple[float, float, float]:
    """Red, green and blue from 0 to 1 of a seam, by its place in a list, from 0: as on the assembly sheet."""
    return seam_rgb(number + 1)


def panel_tint(number: int) -> tuple[float, float, float]:
    """Red, green and blue from 0 to 1 of a panel, by its number from 0."""
    return colorsys.hsv_to_rgb((0.1 + _GOLDEN * number) % 1.0, _TINT, _LIGHT[number % 2])
