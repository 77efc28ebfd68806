# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edit of an outline, as it is kept: what is done, and where on the outline. As JSON text:

{"do": "move", "at": [[0.2, 0.4], [0.3, 0.5], [0.4, 0.4]], "to": [0.3, 0.6]}

Places are in parts of the canvas, from its lower left corner: of the whole picture, so that they stay where
they are when something else in it changes, and of the box round a drawing that is no picture.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.readers.json_values import is_number, unpacked
from BalloonWorkbench.core.types import Floats

#: A node goes elsewhere; one is added; one goes, and a curve runs from its neighbour to the next; one becomes
#: a corner; one becomes round; a hole is filled.
MOVE, ADD, REMOVE, SHARP, ROUND, FILL = "move", "add", "remove", "sharp", "round", "fill"
KINDS = (MOVE, ADD, REMOVE, SHARP, ROUND, FILL)
#: These have a single place.
_ALONE = (ADD, FILL)
_FARTHEST = 100.0
_EXAMPLE = 'Write {"do": "add", "at": [[0.3, 0.5]]}.'
_KEYS = ("do", "at", "to", "mirrored")


@dataclass(frozen=True)
class OutlineEdit:
    """One change of an outline.

    kind      one of KINDS
    places    (k, 2) parts of the canvas: the node; or of each node the one before it, itself, and the one
              after it, between which the outline changes
    to        (2,) where the first of the nodes that move goes, the others as far; else 0
    mirrored  it is repeated on the other side of a symmetric outline
    """

    kind: str
    places: Floats
    to: Floats
    mirrored: bool = False

    @property
    def node(self) -> Floats:
        """Where its first node is (2,)."""
        return self.places[0 if self.kind in _ALONE else 1]


def edit_text(edit: OutlineEdit) -> str:
    """The JSON text of an edit."""
    data: dict[str, Any] = {"do": edit.kind, "at": _rounded(edit.places)}
    if edit.kind == MOVE:
        data["to"] = _rounded(edit.to)
    if edit.mirrored:
        data["mirrored"] = True
    return json.dumps(data)


def edits_of(texts: Sequence[str]) -> tuple[OutlineEdit, ...]:
    """The edits in texts of one each. InputError."""
    budget = Budget()
    read = (unpacked(text.encode(), budget, _EXAMPLE) for text in texts)
    return tuple(_edit(each, number) for number, each in enumerate(read, start=1))


def _rounded(values: Floats) -> Any:
    return (np.round(values, 8) + 0.0).tolist()


def _edit(data: Any, number: int) -> OutlineEdit:
    if not isinstance(data, dict) or data.get("do") not in KINDS:
        raise InputError(f"Outline edit {number} does none of {', '.join(KINDS)}. {_EXAMPLE}")
    unknown = [key for key in data if key not in _KEYS]
    if unknown:
        raise InputError(f"Outline edit {number} has an unknown '{unknown[0]}'. Use {', '.join(_KEYS)}.")
    kind, at = str(data["do"]), data.get("at")
    if not isinstance(at, list) or not all(map(_is_place, at)) or not _is_count(kind, len(at)):
        raise InputError(f"Outline edit {number} has an 'at' that does not fit. {_EXAMPLE}")
    to = data.get("to", [0.0, 0.0])
    if not _is_place(to) or (kind == MOVE) != ("to" in data):
        raise InputError(
            f"Outline edit {number} has no place [x, y] as its 'to', or one too many. {_EXAMPLE}"
        )
    mirrored = data.get("mirrored", False)
    if not isinstance(mirrored, bool):
        raise InputError(f"Outline edit {number}: 'mirrored' is true or false.")
    return OutlineEdit(kind, np.array(at, dtype=np.float64), np.array(to, dtype=np.float64), mirrored)


def _is_count(kind: str, count: int) -> bool:
    return count == 1 if kind in _ALONE else count > 0 and count % 3 == 0


def _is_place(place: Any) -> bool:
    numbers = isinstance(place, list) and len(place) == 2 and all(map(is_number, place))
    return numbers and all(abs(each) <= _FARTHEST for each in place)
