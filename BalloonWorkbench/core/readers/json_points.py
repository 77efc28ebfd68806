# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines written out as JSON: {"unit": "mm", "outer": [[x, y], ...], "holes": [[[x, y], ...], ...]}.

Several shapes: {"unit": "mm", "parts": [{"outer": ..., "holes": ...}, ...]}. Beside "outer" there may be
"welds": lines [[x, y], ...], closed ones with their first point repeated, and spots [[x, y]].
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.drawing import Drawing, sealed
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.readers.json_values import line_of, unit_of, unpacked

_EXAMPLE = 'Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.'


def read_points(data: bytes, budget: Budget) -> Drawing:
    """The shapes in a JSON text, as they are written: neither cleaned nor checked. InputError."""
    text = unpacked(data, budget, _EXAMPLE)
    if not isinstance(text, dict):
        raise InputError(f"The JSON file has no 'outer' loop. {_EXAMPLE}")
    parts = text.get("parts", [text])
    if not isinstance(parts, list) or not parts:
        raise InputError(f"The 'parts' of the JSON file are not a list of shapes. {_EXAMPLE}")
    factor, notes = unit_of(text)
    outlines = [_outline(part, factor, budget) for part in parts]
    outlines.sort(key=lambda outline: -abs(signed_area(outline.outer)))
    return Drawing((replace(outlines[0], notes=notes), *outlines[1:]))


def _outline(part: Any, factor: float, budget: Budget) -> Outline:
    if not isinstance(part, dict) or "outer" not in part:
        raise InputError(f"The JSON file has no 'outer' loop. {_EXAMPLE}")
    holes, welds = part.get("holes", []), part.get("welds", [])
    for name, kind, lines in (("holes", "loops", holes), ("welds", "lines", welds)):
        if not isinstance(lines, list):
            raise InputError(f"The '{name}' of the JSON file are not a list of {kind}. {_EXAMPLE}")
    budget.spend_elements(1 + len(holes) + len(welds))
    plain = Outline(
        line_of(part["outer"], "'outer'", budget, _EXAMPLE) * factor,
        tuple(
            line_of(hole, f"hole {number}", budget, _EXAMPLE) * factor
            for number, hole in enumerate(holes, start=1)
        ),
    )
    lines = [
        line_of(weld, f"weld {number}", budget, _EXAMPLE, 1) * factor
        for number, weld in enumerate(welds, start=1)
    ]
    return sealed(plain, lines)
