# SPDX-License-Identifier: LGPL-2.1-or-later
"""What came out of a test card: a machine file of the user's own with the settings of the best field."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import UNUSABLE, read_data, reason_of
from BalloonWorkbench.core.machines.machine import machine_of
from BalloonWorkbench.core.machines.own.keep import copied
from BalloonWorkbench.core.machines.tool import read_tool, value_text
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.options.option import Kind, options_of


def kept_machine(card: Path, field: str, name: str) -> dict[str, Any]:
    """What the file of a machine of that name has, with what a field of a card tried; see `files.card_files`.

    Raises InputError for a file that is no card, a field that it has not, and a name that is none.
    """
    content = _read(card)
    fields = content["fields"]
    tool = fields.get(field.strip().upper())
    if not isinstance(tool, dict):
        raise InputError(f"The card has no field {field}: choose one of {', '.join(fields)}.")
    made = copied(content["machine"], name)
    layers = made.get("layers", {})
    made |= {"tool": tool, "layers": {role: layers.get(role, {}) for role in content["layers"]}}
    try:
        machine_of(made)
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"The field {field} of this card makes no machine: {reason_of(error)}") from None
    return made


def fields_of(card: Path) -> dict[str, str]:
    """The fields of a card by name, each with what it tried, or why it cannot be kept.

    Raises InputError for a file that is no card.
    """
    fields = {}
    for name, data in _read(card)["fields"].items():
        try:
            tool = read_tool(data)
        except (*UNUSABLE, InputError) as error:
            fields[str(name)] = str(reason_of(error))
            continue
        options = (option.name for option in options_of(ToolOptions) if option.kind is not Kind.CHOICE)
        known = [value_text(tool, option) for option in options]
        fields[str(name)] = ", ".join(filter(None, known))
    return fields


def _read(path: Path) -> dict[str, Any]:
    try:
        content = read_data(path)
    except OSError as error:
        raise InputError(f"Cannot read '{path}' ({error.strerror}): name the file of a test card.") from None
    except UNUSABLE:
        content = None
    kinds = {"machine": dict, "layers": list, "fields": dict}
    if not isinstance(content, dict) or any(
        not isinstance(content.get(key), kind) for key, kind in kinds.items()
    ):
        raise InputError(f"'{path}' is no test card: name the test-card.json that was made with it.")
    return content
