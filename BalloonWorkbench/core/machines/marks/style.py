# SPDX-License-Identifier: LGPL-2.1-or-later
"""The registration marks that a machine looks for, as its file describes them under `marks`.

What makers state, and where, is in the machines' own files and in docs/machines.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.layers import one_of
from BalloonWorkbench.core.units import from_mm, number_text, size_text, to_mm

#: Three crosses in circles, for the eye. A square and two corners. Four corners. Four discs. Rows of squares
#: at both sides. Four dots and one more beside the lower right one. None: the machine's program has its own.
STYLES = (BY_EYE, SILHOUETTE, CORNERS, DISCS, SQUARES, DOTS, NONE) = (
    "crosses", "silhouette", "corners", "discs", "squares", "dots", "none",
)  # fmt: skip

#: Keys of a style, with the least and the most that they may be [mm].
_LENGTHS = {
    "size_mm": (0.5, 50.0),
    "line_mm": (0.1, 5.0),
    "square_mm": (0.5, 50.0),
    "clear_mm": (0.0, 100.0),
    "inset_mm": (0.0, 500.0),
    "step_mm": (10.0, 10000.0),
    "bar_mm": (0.5, 20.0),
}
_SIDES = ("page_mm", "most_mm")
_LEAST_SIDE, _MOST_SIDE = 10.0, 1e5  # mm
#: What each style has to say; what it may say besides.
_NEEDED = {
    BY_EYE: ("size_mm", "line_mm"),
    SILHOUETTE: ("size_mm", "line_mm", "square_mm"),
    CORNERS: ("size_mm", "line_mm"),
    DISCS: ("size_mm",),
    SQUARES: ("size_mm",),
    DOTS: ("size_mm",),
    NONE: (),
}
_ALWAYS = ("clear_mm", "inset_mm")
_MORE = {SQUARES: ("step_mm", "bar_mm"), CORNERS: ("outward",)}


@dataclass(frozen=True)
class Marks:
    """Registration marks of one style; lengths [m].

    size     of a cross, arm of a corner, diameter of a disc, side of a square
    line     width of the lines of crosses and corners; square: side of Silhouette's square
    clear    white film between marks and print; inset: from the edge of the paper to the marks
    step     greatest distance between squares along a side, None for those at the ends alone
    bar      height of the bar between the lower squares, 0 for none
    outward  the arms of corners point away from the print
    page     width and height of the paper; None for as much as is needed
    most     width and height that the marks, or without any the print, may take; None where there is no limit
    owner    title of the machine, and its name
    """

    style: str
    size: float = 0.0
    line: float = 0.0
    square: float = 0.0
    clear: float = 0.0
    inset: float = 0.0
    step: float | None = None
    bar: float = 0.0
    outward: bool = False
    page: tuple[float, float] | None = None
    most: tuple[float, float] | None = None
    owner: tuple[str, str] = field(default=("", ""), compare=False)

    @property
    def are_seen(self) -> bool:
        """Whether somebody finds them by eye and tells the machine: any machine takes them."""
        return self.style == BY_EYE

    @property
    def are_found(self) -> bool:
        """Whether the machine looks for them itself."""
        return self.style not in (BY_EYE, NONE)


#: Those of a machine whose file says nothing.
CROSSES = Marks(BY_EYE, size=from_mm(10.0), line=from_mm(0.25), clear=from_mm(3.0), inset=from_mm(2.0))


def read_marks(data: Mapping[str, Any]) -> Marks:
    """Those of a machine's file, checked; three crosses where it has none. InputError that names the key."""
    owner = str(data["title"]), str(data["name"])
    if "marks" not in data:
        return replace(CROSSES, owner=owner)
    described = data["marks"]
    if not isinstance(described, Mapping):
        raise InputError(f'marks is {described!r}: give {{"style": ...}}, or leave it out for crosses.')
    style = one_of(described.get("style"), STYLES, "the style of marks")
    needed = (*_NEEDED[style], *_ALWAYS)
    known = ("style", *needed, *_MORE.get(style, ()), *_SIDES)
    strange = sorted(set(described) - set(known))
    if strange:
        raise InputError(f'marks of style {style} have no "{strange[0]}": only {", ".join(known)}.')
    values = {key: value for key, value in described.items() if value is not None}
    missing = [key for key in needed if key not in values]
    if missing:
        raise InputError(f"marks of style {style} lack {missing[0]}: add it.")
    measured: dict[str, Any] = {
        key.removesuffix("_mm"): (_size if key in _SIDES else _length)(values[key], key)
        for key in (*_LENGTHS, *_SIDES)
        if key in values
    }
    outward = values.get("outward", False)
    if not isinstance(outward, bool):
        raise InputError(f"outward of marks is {outward!r}: write true or false.")
    return _checked(Marks(style, **measured, outward=outward, owner=owner))


def _checked(marks: Marks) -> Marks:
    """InputError for marks that are none, or that their page has no room for."""
    line, size, inset = (number_text(to_mm(length)) for length in (marks.line, marks.size, marks.inset))
    if marks.line > 0.5 * marks.size:
        raise InputError(
            f"line_mm of marks is {line}, and size_mm {size}: a line is at most half as wide as its mark."
        )
    if marks.square > marks.size and marks.style == SILHOUETTE:
        raise InputError(f"square_mm of marks is larger than size_mm, {size}: make it smaller.")
    if marks.page is not None and not 2.0 * (marks.inset + marks.size) < min(marks.page):
        raise InputError(
            f"marks of size_mm {size} and inset_mm {inset} do not fit on a page_mm of"
            f" {size_text(*marks.page)}: give a larger page or smaller marks."
        )
    return marks


def _length(value: object, key: str) -> float:
    return from_mm(_number(value, key, *_LENGTHS[key]))


def _size(value: object, key: str) -> tuple[float, float]:
    if not (isinstance(value, list) and len(value) == 2):
        raise InputError(f"{key} of marks is {value!r}: give [width, height], or leave it out.")
    width, height = (from_mm(_number(side, key, _LEAST_SIDE, _MOST_SIDE)) for side in value)
    return width, height


def _number(value: object, key: str, least: float, most: float) -> float:
    number = float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else float("nan")
    if not least <= number <= most:
        raise InputError(
            f"{key} of marks is {value!r}: give a number from {number_text(least)} to {number_text(most)}."
        )
    return number
