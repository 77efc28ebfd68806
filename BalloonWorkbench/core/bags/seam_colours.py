# SPDX-License-Identifier: LGPL-2.1-or-later
"""One colour for each seam: on both its edges, in all pictures, on the assembly sheet and in the window.

The twelve of a round differ by 16 steps of CIELAB or more, also to eyes without red, green or blue cones
(as simulated by Machado, Oliveira and Fernandes 2009), and stand out from white paper. The number beside
them tells the rest.
"""

from __future__ import annotations

_ROUND = (
    *("#0072b2", "#e07306", "#662d19", "#8c1ff9", "#dba670", "#24248f"),
    *("#2eb8b8", "#fb51fb", "#e00673", "#666619", "#7c0340", "#ae0484"),
)
#: From round to round each colour goes so far towards black, then towards white, then farther.
_FADE = 0.09


def seam_rgb(number: int) -> tuple[float, float, float]:
    """Red, green and blue from 0 to 1 of a seam, by its number from 1."""
    turn, place = divmod(number - 1, len(_ROUND))
    red, green, blue = (int(_ROUND[place][k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    goal = 0.0 if turn % 2 else 1.0
    share = min(_FADE * ((turn + 1) // 2), 0.5)
    return (red + share * (goal - red), green + share * (goal - green), blue + share * (goal - blue))


def seam_colour(number: int) -> str:
    """The same as a text, such as #ff0000."""
    return "#" + "".join(f"{round(255 * part):02x}" for part in seam_rgb(number))
