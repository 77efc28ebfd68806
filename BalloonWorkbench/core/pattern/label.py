# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text on the pattern as outlines: machines know no fonts."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pages.fonts import outlines, plain, unshown
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.shapes import closed_loop
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

#: Size at which letters are turned into polylines: fine steps at any height.
_FINE = 2000.0
_MOST = 60
#: Between letters and a mark [m].
_BESIDE = from_mm(0.5)


def with_label(pattern: Pattern, text: str, height: float) -> Pattern:
    """The pattern with a line of text where the film is widest, on the layer ENGRAVE.

    height  of capital letters [m]
    Raises InputError where the text is longer than the film has room or has letters that cannot be drawn,
    MissingPackageError without matplotlib.
    """
    text = plain(text)
    if not text:
        return pattern
    if not (1e-4 <= height <= 10.0 and len(text) <= _MOST):
        raise InputError(f"A label has up to {_MOST} letters, between 0.1 mm and 10 m high: change it.")
    package = shapely()
    largest = max(pattern.of(Role.CUT), key=lambda cut: float(package.Polygon(cut.points).area))
    film = package.Polygon(largest.points)
    for lines in pattern.contours:
        if lines.role is not Role.CUT:
            film = film.difference(_taken(lines, pattern.seal_width))
    room = package.maximum_inscribed_circle(parts(film)[0])
    (x, y), radius = room.coords[0], float(room.length)
    letters = _letters(text, height)
    low, high = bounds(np.concatenate(letters))
    if 0.5 * float(np.hypot(*(high - low))) > radius:
        raise InputError(
            f'The label "{text}" is {length_text(float(high[0] - low[0]))} long, and the film is only'
            f" {length_text(2.0 * radius)} wide: take a shorter text or lower letters."
        )
    return replace(pattern, contours=(*_at(letters, np.array([x, y])), *pattern.contours))


def _taken(lines: Contour, seal_width: float) -> Any:
    """What a hole, a weld or a mark takes of the film, as a polygon of shapely."""
    package = shapely()
    if lines.role is Role.CUT_INNER:
        return package.Polygon(lines.points)
    welded = lines.role in (Role.SEAL, Role.WELD)
    return package.LineString(lines.line).buffer(0.5 * seal_width if welded else _BESIDE)


def lettering(text: str, height: float, middle: Floats) -> tuple[Contour, ...]:
    """A text as outlines round a point (2,), whose capitals are so high [m]. Errors as for `with_label`."""
    return _at(_letters(text, height), middle)


def _at(letters: list[Floats], middle: Floats) -> tuple[Contour, ...]:
    low, high = bounds(np.concatenate(letters))
    shift = middle - 0.5 * (low + high)
    return tuple(Contour(Role.ENGRAVE, loop + shift, True) for loop in letters)


def _letters(text: str, height: float) -> list[Floats]:
    """Closed outlines (n, 2) m of a text whose capitals are so high."""
    scale = height / float(np.ptp(np.concatenate(outlines("H", _FINE)), axis=0)[1])
    names = ", ".join(unshown(text))
    if names:
        raise InputError(
            f"With the fonts of this computer {names} cannot be drawn, letter by letter from left to right:"
            " leave that out of the label, or install a font that has it and start again."
        )
    rings = [shapely().LinearRing(loop * scale) for loop in outlines(text, _FINE)]
    return [closed_loop(ring, bool(ring.is_ccw)) for ring in rings]
