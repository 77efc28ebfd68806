# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large a pixel of a photograph is: from two marked points, or a length in pixels."""

from __future__ import annotations

import math
from dataclasses import dataclass

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.units import length_text, number_text, parse_length

#: In the place of a scale: the size is what fits best.
FIT = "fit"
#: How well a marked point is met [px].
_MARKED = 1.0
_USAGE = (
    "write x1,y1,x2,y2,LENGTH for two marked points, PIXELS,LENGTH for a length in pixels, both such as"
    f" 812,200mm, or {FIT} where the size is not known"
)


@dataclass(frozen=True)
class PhotoScale:
    """Metres per pixel, and by which part of it that may be wrong."""

    pixel: float
    uncertainty: float


def parse_photo_scale(text: str) -> PhotoScale | None:
    """The scale that users write, in pixels of the picture as it is stored, y downward; None for FIT.

    Raises InputError for what is none, and for points that are one.
    """
    if text.strip().lower() == FIT:
        return None
    *numbers, length = text.split(",")
    try:
        values = [float(number) for number in numbers]
    except ValueError:
        values = []
    if len(values) not in (1, 4) or not all(map(math.isfinite, values)):
        raise InputError(f"The scale '{text}' cannot be used: {_USAGE}.")
    metres = parse_length(length)
    pixels = abs(values[0]) if len(values) == 1 else math.dist(values[:2], values[2:])
    if pixels < _MARKED or not 0.0 < metres < math.inf:
        raise InputError(
            f"The scale of {length_text(metres)} over {number_text(pixels)} pixels has no length: mark two"
            " points that are far apart, and give the distance between them."
        )
    return PhotoScale(metres / pixels, math.sqrt(2.0) * _MARKED / pixels)
