# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a test card: G-code, a plan to draw or print, and what each field tries."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from BalloonWorkbench.core.machines.machine import ANY, machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.tool import LINUXCNC, tool_data
from BalloonWorkbench.core.machines.toolpaths import Toolpaths, draw, reach
from BalloonWorkbench.core.machines.writers.gcode import gcode, laser_settings
from BalloonWorkbench.core.machines.writers.moves import moves_of
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.test_cards.card import CardField, SettingsCard
from BalloonWorkbench.core.units import number_text, to_mm

#: The file from which a field is kept.
CARD_FILE = "test-card.json"


def card_files(card: SettingsCard, file_data: dict[str, Any]) -> dict[str, bytes]:
    """Contents by file name; file_data is what the machine's own file has, see `keep.machine_data`.

    Raises MissingPackageError without matplotlib, whose fonts the plan takes.
    """
    version = card.fields[0].machine.version
    fields = {field.name: tool_data(field.machine.tool) for field in card.fields if field.machine.tool}
    layers = {field.name: [role.value for role in field.machine.layers] for field in card.fields}
    content = {"machine": file_data, "layers": layers[card.fields[0].name], "fields": fields}
    return {
        f"test-card.{'ngc' if version == LINUXCNC else 'gcode'}": _gcode(card),
        "test-card.svg": machine_file(card.plan, machine(ANY["svg"])),
        CARD_FILE: (json.dumps(content, indent=1, ensure_ascii=False) + "\n").encode(),
    }


def _gcode(card: SettingsCard) -> bytes:
    return gcode(_header(card), moves_of([(_in_place(field), field.machine) for field in card.fields]))


def _in_place(field: CardField) -> Toolpaths:
    """What the tool does in a field, in coordinates of the card; the kerf is looked for, not made up for."""
    held = replace(field.machine, kerf=0.0, bed=None)
    pattern = Pattern((field.line,), None, 0.0, 0.0)
    drawn, corner = draw(pattern, held), to_mm(reach(pattern, held)[0])
    return replace(drawn, paths=tuple(replace(path, curve=path.curve.moved(corner)) for path in drawn.paths))


def _header(card: SettingsCard) -> Iterator[str]:
    width, height = (number_text(to_mm(side), 6) for side in card.size)
    yield f"Test card of {len(card.fields)} fields for {card.fields[0].machine.title}"
    yield "Units: millimetres (G21), feeds in mm/min. Coordinates: absolute (G90), arcs' centres from starts."
    yield "X0 Y0: lower left corner of the film; Z0: the tool touches the film."
    yield f"It moves within X0 to X{width} and Y0 to Y{height}."
    yield from laser_settings(card.fields[0].machine)
    yield "Columns from the left: " + ", ".join(card.columns)
    yield "Rows from below: " + ", ".join(card.rows)
