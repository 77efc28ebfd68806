# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of seams written out as JSON:

{"unit": "mm",
 "seams": [{"do": "merge", "at": [[x, y, z]], "panels": ["3", "7"]},
           {"do": "cut", "at": [[x, y, z], [x, y, z]]},
           {"do": "move", "at": [[x, y, z], [x, y, z]]},
           {"do": "plane", "at": [[0, 0, 0]], "along": [1, 0, 0]},
           {"do": "symmetry"},
           {"do": "line", "at": [[x, y, z], ...], "along": [0, 0, 1], "side": "near"}]}

Places are in the body's own frame, whose origin is the middle of the box round it. "size" is that of the box
round the body that an edit was made on: on another one its places move along. "mirrored": false does not
repeat it on the other side of a symmetric body.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.user_file import read_whole
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.readers.json_values import is_number, unit_of, unpacked
from BalloonWorkbench.core.seam_edits.edit import (
    BOTH,
    CUT,
    LINE,
    MERGE,
    MOVE,
    NEAR,
    PLANE,
    SYMMETRY,
    SeamEdit,
    no_direction,
)
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, to_mm

_EXAMPLE = 'Write {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.'
_KINDS = (MERGE, CUT, MOVE, PLANE, SYMMETRY, LINE)
_MOST_BYTES = 8 << 20
_KEYS = ("do", "at", "along", "panels", "size", "side", "mirrored")


def read_seams(data: bytes, budget: Budget) -> tuple[SeamEdit, ...]:
    """The edits in a JSON text. InputError."""
    text = unpacked(data, budget, _EXAMPLE)
    if not isinstance(text, dict) or not isinstance(text.get("seams"), list):
        raise InputError(f"The JSON file has no list of 'seams'. {_EXAMPLE}")
    factor, _ = unit_of(text)
    budget.spend_elements(len(text["seams"]))
    return tuple(_edit(each, number, factor, budget) for number, each in enumerate(text["seams"], start=1))


def edits_in(path: str | None) -> tuple[SeamEdit, ...]:
    """The edits in a file; none without one. InputError."""
    return read_seams(read_whole(Path(path), _MOST_BYTES), Budget()) if path else ()


def edits_of(texts: Sequence[str]) -> tuple[SeamEdit, ...]:
    """The edits in texts of one each, as `edit_text` writes them, in millimetres. InputError."""
    budget = Budget()
    read = (unpacked(text.encode(), budget, _EXAMPLE) for text in texts)
    return tuple(_edit(each, number, from_mm(1.0), budget) for number, each in enumerate(read, start=1))


def edit_text(edit: SeamEdit) -> str:
    """The JSON text of one edit, in millimetres."""
    data: dict[str, Any] = {"do": edit.kind}
    if len(edit.points):
        data["at"] = _rounded(to_mm(edit.points))
    if edit.direction.any():
        data["along"] = np.round(edit.direction, 9).tolist()
    if edit.panels:
        data["panels"] = list(edit.panels)
    if any(edit.size):
        data["size"] = _rounded(to_mm(np.array(edit.size)))
    if edit.side != BOTH:
        data["side"] = edit.side
    if not edit.mirrored:
        data["mirrored"] = False
    return json.dumps(data)


def _rounded(values: Floats) -> Any:
    return (np.round(values, 6) + 0.0).tolist()


def _edit(data: Any, number: int, factor: float, budget: Budget) -> SeamEdit:
    if not isinstance(data, dict) or data.get("do") not in _KINDS:
        raise InputError(f"Seam {number} of the list does none of {', '.join(_KINDS)}. {_EXAMPLE}")
    unknown = [key for key in data if key not in _KEYS]
    if unknown:
        raise InputError(f"Seam {number} of the list has an unknown '{unknown[0]}'. Use {', '.join(_KEYS)}.")
    panels, side, mirrored = data.get("panels", []), data.get("side", BOTH), data.get("mirrored", True)
    if not isinstance(panels, list) or not all(isinstance(name, str) for name in panels):
        raise InputError(f"The 'panels' of seam {number} of the list are no names. {_EXAMPLE}")
    if side not in (BOTH, NEAR) or not isinstance(mirrored, bool):
        raise InputError(
            f"Seam {number} of the list: 'side' is '{BOTH}' or '{NEAR}', 'mirrored' is true or false."
        )
    at = data.get("at", [])
    if not isinstance(at, list):
        raise InputError(f"The 'at' of seam {number} of the list is no list of places. {_EXAMPLE}")
    budget.spend_points(len(at))
    points = np.array([_place(each, number) for each in at], dtype=np.float64).reshape(-1, 3) * factor
    along = np.array(_place(data["along"], number)) if "along" in data else no_direction()
    size = _place(data["size"], number) if "size" in data else [0.0, 0.0, 0.0]
    x, y, z = (float(each) * factor for each in size)
    return SeamEdit(str(data["do"]), points, along, tuple(panels), (x, y, z), side, mirrored)


def _place(place: Any, number: int) -> list[float]:
    if not (isinstance(place, list) and len(place) == 3 and all(map(is_number, place))):
        raise InputError(f"Seam {number} of the list has a place that is not [x, y, z]. {_EXAMPLE}")
    return place
