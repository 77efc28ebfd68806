# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and arrows as single strokes: small, quick to draw, and without a font."""

from __future__ import annotations

from functools import cache

import numpy as np

from BalloonWorkbench.core.types import Floats

#: Width of a digit and from one to the next, in heights.
_WIDE, _NEXT = 0.5, 0.8
#: Strokes of the digits on a grid of three columns and five rows: columns a to c, rows 0 to 4 from below.
_STROKES = {
    "0": ("a0 c0 c4 a4 a0",),
    "1": ("a3 b4 b0",),
    "2": ("a4 c4 c2 a2 a0 c0",),
    "3": ("a4 c4 c0 a0", "b2 c2"),
    "4": ("a4 a1 c1", "b3 b0"),
    "5": ("c4 a4 a2 c2 c0 a0",),
    "6": ("c4 a4 a0 c0 c2", "c2 a2"),
    "7": ("a4 c4 a0",),
    "8": ("a0 c0 c4 a4 a0", "a2 c2"),
    "9": ("a0 c0 c4 a4 a2", "a2 c2"),
}
#: An arrow to the right, of length 1.
_ARROW = ("0 0 1 0", "0.6 0.25 1 0 0.6 -0.25")


def number_strokes(number: int) -> list[Floats]:
    """Lines (k, 2) of a number, its digits 1 high, from the origin to the right."""
    return [
        line + np.array([_NEXT * place, 0.0])
        for place, digit in enumerate(str(number))
        for line in _digit(digit)
    ]


def number_width(number: int) -> float:
    """Width of a number whose digits are 1 high."""
    return _NEXT * (len(str(number)) - 1) + _WIDE


def arrow_strokes() -> list[Floats]:
    """Lines (k, 2) of an arrow from the origin to the right, of length 1."""
    return [np.array(text.split(), dtype=np.float64).reshape(-1, 2) for text in _ARROW]


@cache
def _digit(digit: str) -> tuple[Floats, ...]:
    lines = []
    for stroke in _STROKES[digit]:
        places = [("abc".index(place[0]), int(place[1])) for place in stroke.split()]
        lines.append(np.array(places) * np.array([0.5 * _WIDE, 0.25]))
    return tuple(lines)
