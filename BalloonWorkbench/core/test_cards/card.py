# SPDX-License-Identifier: LGPL-2.1-or-later
"""A test card: fields in columns and rows, each welded or cut with settings of its own.

A weld is peeled in strips of 25 mm, as ASTM F88 has them (15, 25 or 25.4 mm), with free film to hold on both
sides. Of a cut the piece falls out: so much smaller than its square is the kerf.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.machines.machine import Machine, bed_text, complete, holding
from BalloonWorkbench.core.machines.tool import value_text
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.pattern.label import lettering
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, size_text

#: Width and height of a field that is welded, and of one that is cut; side of the square that is cut out [m].
STRIP = from_mm(25.0), from_mm(50.0)
SQUARE = from_mm(20.0), from_mm(20.0)
CUT_OUT = from_mm(12.0)
#: Left of and below the fields there are texts [m], so high.
_LEFT, _BELOW, _BESIDE = from_mm(24.0), from_mm(10.0), from_mm(5.0)
_LETTERS = from_mm(3.0)
_MOST = 12
_ROWS = "ABCDEFGHIJKL"


@dataclass(frozen=True)
class CardField:
    """A field of a card.

    name     row and column, such as B3: rows from below, columns from the left
    corner   (2,) m, its lower left one
    machine  with the settings that are tried there
    """

    name: str
    corner: Floats
    machine: Machine

    @property
    def line(self) -> Contour:
        """What the tool does in it."""
        assert self.machine.tool is not None
        if self.machine.tool.is_hot:
            width, height = STRIP
            return Contour(
                Role.SEAL, self.corner + np.array([[0.0, 0.5], [1.0, 0.5]]) * [width, height], False
            )
        corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
        return Contour(Role.CUT, self.corner + 0.5 * (SQUARE[0] - CUT_OUT) + CUT_OUT * corners, True)


@dataclass(frozen=True)
class SettingsCard:
    """All fields in the order of the work, and what columns and rows try."""

    fields: tuple[CardField, ...]
    columns: tuple[str, ...]
    rows: tuple[str, ...]

    @property
    def field_size(self) -> tuple[float, float]:
        """Width and height of a field [m]."""
        return STRIP if self.fields[0].line.role is Role.SEAL else SQUARE

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the film that it takes [m]."""
        width, height = self.field_size
        return _LEFT + len(self.columns) * width + _BESIDE, _BELOW + len(self.rows) * height + _BESIDE

    @property
    def plan(self) -> Pattern:
        """Everything on it in its real size: lines to cut strips along, texts beside the fields."""
        width, height = self.field_size
        right, top = _LEFT + len(self.columns) * width, _BELOW + len(self.rows) * height
        upright = [[(x, _BELOW), (x, top)] for x in _LEFT + width * np.arange(len(self.columns) + 1)]
        level = [[(_LEFT, y), (right, y)] for y in _BELOW + height * np.arange(len(self.rows) + 1)]
        lines = [Contour(Role.PEN, np.array(line), False) for line in upright + level]
        texts = [
            (text, (_LEFT + (number + 0.5) * width, 0.5 * _BELOW)) for number, text in enumerate(self.columns)
        ]
        texts += [
            (text, (0.5 * _LEFT, _BELOW + (number + 0.5) * height)) for number, text in enumerate(self.rows)
        ]
        letters = [
            each for text, at in texts for each in _letters(text, min(0.9 * width, _LEFT), np.array(at))
        ]
        film = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]) * self.size
        around = Contour(Role.REGISTRATION, film, True)
        contours = (around, *letters, *lines, *(field.line for field in self.fields))
        return Pattern(contours, None, 0.0, 0.0)


def make_card(machine: Machine, tried: Mapping[str, Sequence[Any]]) -> SettingsCard:
    """The card on which a machine's tool tries settings.

    tried  values by the names of ToolOptions: of one or two of them several, of all others one

    Raises InputError for a machine without a tool, for more than two settings that vary, for values that
    the tool cannot have, for what is not known, and for a card that is larger than the bed.
    """
    if machine.tool is None:
        raise InputError(f"{machine.title} reads no G-code: choose a machine that does.")
    varied = [name for name, values in tried.items() if len(values) > 1]
    if not 1 <= len(varied) <= 2:
        raise InputError(
            "A test card tries one or two settings: give several values of them, such as 200,300,400."
        )
    if any(not 1 <= len(set(values)) == len(values) <= _MOST for values in tried.values()):
        raise InputError("A setting is tried with up to twelve values, each once.")
    fixed = ToolOptions(**{name: values[0] for name, values in tried.items() if len(values) == 1})
    across, upward = varied[0], varied[1] if len(varied) > 1 else None
    fields, rows = [], []
    for row, column in product(range(len(tried[upward]) if upward else 1), range(len(tried[across]))):
        wishes = replace(fixed, **{across: tried[across][column]})
        if upward:
            wishes = replace(wishes, **{upward: tried[upward][row]})
        held = complete(holding(machine, wishes))
        assert held.tool is not None
        width, height = STRIP if held.tool.is_hot else SQUARE
        corner = np.array([_LEFT + column * width, _BELOW + row * height])
        fields.append(CardField(f"{_ROWS[row]}{column + 1}", corner, held))
        if column == 0:
            rows.append(f"{_ROWS[row]}: {value_text(held.tool, upward)}" if upward else _ROWS[row])
    tools = [field.machine.tool for field in fields[: len(tried[across])]]
    columns = [f"{number}: {value_text(tool, across)}" for number, tool in enumerate(tools, 1) if tool]
    return _fitting(SettingsCard(tuple(fields), tuple(columns), tuple(rows)), machine)


def _letters(text: str, width: float, middle: Floats) -> tuple[Contour, ...]:
    """A text round a point (2,) m, no wider than there is space for it."""
    usual = extent(np.concatenate([letter.points for letter in lettering(text, _LETTERS, middle)]))
    return lettering(text, _LETTERS * min(1.0, 0.9 * width / usual), middle)


def _fitting(card: SettingsCard, machine: Machine) -> SettingsCard:
    if machine.bed is not None and any(side > room for side, room in zip(card.size, machine.bed)):
        raise InputError(
            f"The test card measures {size_text(*card.size)}, the bed of {machine.title}"
            f" is {bed_text(machine.bed)}: try fewer values, or say with --bed how large it is."
        )
    return card
