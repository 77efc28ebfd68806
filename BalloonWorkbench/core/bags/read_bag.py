# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags written out as JSON, with seams between the points of panels seen from outside, counter-clockwise:

{"unit": "mm",
 "panels": [{"name": "top", "outer": [[x, y], ...], "holes": [[[x, y], ...]]}, ...],
 "seams": [{"a": ["top", 0, 1], "b": ["side", 3, 2]}, ...],
 "opening": {"panel": "side", "at": 2}}

A side of a seam is a panel and two of its points, counted from 0; a fourth entry is the number of a hole,
whose points run clockwise. Side a runs along its loop, b against it. A whole loop is written as two seams.
"ease" is how much longer one side of a seam may be, as a part of its length; a panel with "cut": false only
closes an open end.
"""

from __future__ import annotations

import json
from typing import Any

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.readers.json_values import is_count, is_number, line_of, unit_of, unpacked
from BalloonWorkbench.core.units import to_mm

_PANEL = 'Write {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.'
_SEAM = 'Write {"a": ["top", 0, 1], "b": ["side", 3, 2]}.'
_OPENING = 'Write {"panel": "side", "at": 2}.'


def read_bag(data: bytes, budget: Budget) -> Bag:
    """The bag in a JSON text, as it is written: `check_bag` says whether it can be made. InputError."""
    text = unpacked(data, budget, _PANEL)
    if not isinstance(text, dict) or not isinstance(text.get("panels"), list) or not text["panels"]:
        raise InputError(f"The JSON file has no list of 'panels'. {_PANEL}")
    factor, notes = unit_of(text)
    panels = tuple(_panel(each, k, factor, budget) for k, each in enumerate(text["panels"], start=1))
    numbers = {panel.name: number for number, panel in enumerate(panels)}
    if len(numbers) < len(panels):
        twice = next(panel.name for number, panel in enumerate(panels) if numbers[panel.name] != number)
        raise InputError(f"Two panels of the JSON file are called '{twice}'. Give each a name of its own.")
    seams = text.get("seams")
    if not isinstance(seams, list):
        raise InputError(f"The JSON file has no list of 'seams'. {_SEAM}")
    budget.spend_elements(len(seams))
    ease = text.get("ease", 0.0)
    if not is_number(ease) or not 0.0 <= ease < 1.0:
        raise InputError("The 'ease' of the JSON file is no part of a length. Give a number from 0 to 1.")
    return Bag(
        panels,
        tuple(_seam(seam, number, numbers) for number, seam in enumerate(seams, start=1)),
        _opening(text.get("opening"), numbers),
        float(ease),
        notes,
    )


def bag_json(bag: Bag) -> bytes:
    """The JSON text of a bag, in millimetres."""
    text: dict[str, Any] = {"unit": "mm", "panels": [_panel_data(panel) for panel in bag.panels]}
    text["seams"] = [{"a": _side_data(bag, seam.a), "b": _side_data(bag, seam.b)} for seam in bag.seams]
    if bag.opening is not None:
        text["opening"] = {"panel": bag.panels[bag.opening.panel].name, "at": bag.opening.at}
    if bag.ease:
        text["ease"] = bag.ease
    return (json.dumps(text) + "\n").encode()


def _panel(panel: Any, number: int, factor: float, budget: Budget) -> BagPanel:
    name = panel.get("name", str(number)) if isinstance(panel, dict) else None
    if not isinstance(name, str) or not name.strip() or "outer" not in panel:
        raise InputError(f"Panel {number} of the JSON file has no name or no 'outer' loop. {_PANEL}")
    holes, cut = panel.get("holes", []), panel.get("cut", True)
    if not isinstance(holes, list):
        raise InputError(f"The 'holes' of panel '{name}' are not a list of loops. {_PANEL}")
    if not isinstance(cut, bool):
        raise InputError(f"The 'cut' of panel '{name}' is neither true nor false. Write one of them.")
    budget.spend_elements(1 + len(holes))
    outer = line_of(panel["outer"], f"panel '{name}'", budget, _PANEL)
    loops = [
        line_of(hole, f"hole {k} of panel '{name}'", budget, _PANEL) for k, hole in enumerate(holes, start=1)
    ]
    return BagPanel(name, outer * factor, tuple(hole * factor for hole in loops), cut)


def _seam(seam: Any, number: int, numbers: dict[str, int]) -> BagSeam:
    if not isinstance(seam, dict) or not {"a", "b"} <= set(seam):
        raise InputError(f"Seam {number} of the JSON file has no two sides 'a' and 'b'. {_SEAM}")
    one, other = (_side(seam[key], key, number, numbers) for key in "ab")
    return BagSeam(one, other)


def _side(side: Any, key: str, number: int, numbers: dict[str, int]) -> Side:
    if (
        not isinstance(side, list)
        or len(side) not in (3, 4)
        or not isinstance(side[0], str)
        or not all(map(is_count, side[1:]))
    ):
        raise InputError(f"Side '{key}' of seam {number} is not the name of a panel and two points. {_SEAM}")
    if side[0] not in numbers:
        raise InputError(
            f"Side '{key}' of seam {number} is on a panel '{side[0]}' that is not there. {_SEAM}"
        )
    return Side(numbers[side[0]], *side[1:])


def _opening(opening: Any, numbers: dict[str, int]) -> Opening | None:
    if opening is None:
        return None
    if not isinstance(opening, dict) or not is_count(opening.get("at")):
        raise InputError(f"The 'opening' of the JSON file has no panel and point. {_OPENING}")
    panel = opening.get("panel")
    if not isinstance(panel, str) or panel not in numbers:
        raise InputError(f"The opening is on a panel '{panel}' that is not there. {_OPENING}")
    return Opening(numbers[panel], opening["at"])


def _panel_data(panel: BagPanel) -> dict[str, Any]:
    outer, *holes = (to_mm(loop).tolist() for loop in panel.loops)
    data: dict[str, Any] = {"name": panel.name, "outer": outer}
    if holes:
        data["holes"] = holes
    if not panel.cut:
        data["cut"] = False
    return data


def _side_data(bag: Bag, side: Side) -> list[str | int]:
    return [bag.panels[side.panel].name, side.start, side.end, *([side.loop] if side.loop else [])]
