# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which settings a card tries, as people write them: one value, or several with commas between them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.own.entries import ENTRIES, MachineEntry, entry_number
from BalloonWorkbench.core.machines.tool import file_key
from BalloonWorkbench.core.options.making import TOOLS, ToolOptions
from BalloonWorkbench.core.options.option import Kind, options_of
from BalloonWorkbench.core.units import from_mm, parse_temperature

_OPTIONS = {option.name: option for option in options_of(ToolOptions)}
#: The settings, each with what it is in a machine's file.
SETTINGS: dict[str, MachineEntry] = {
    name: next(entry for entry in ENTRIES if entry.key == file_key(name))
    for name, option in _OPTIONS.items()
    if option.kind is not Kind.CHOICE
}


def read_tried(written: Mapping[str, Any]) -> dict[str, list[Any]]:
    """Values for `make_card` from texts such as "200, 300" or "140C", numbers, or lists of them, by the names
    of ToolOptions; a number is in the unit of its setting in a machine's file. What is empty is left out.

    Raises InputError for another name, and for what is no value.
    """
    tried: dict[str, list[Any]] = {}
    for name, values in written.items():
        if name not in _OPTIONS:
            raise InputError(f'A tool has no "{name}": choose one of {", ".join(_OPTIONS)}.')
        several = values.split(",") if isinstance(values, str) else values
        parts = several if isinstance(several, (list, tuple)) else [several]
        texts = [str(part).strip() for part in parts if str(part).strip()]
        if texts:
            tried[name] = [_value(name, text) for text in texts]
    return tried


def _value(name: str, text: str) -> Any:
    if name not in SETTINGS:
        if text not in TOOLS:
            raise InputError(f'the tool "{text}" is none of {", ".join(TOOLS)}.')
        return text
    number = entry_number(SETTINGS[name], text)
    if _OPTIONS[name].kind is Kind.HEIGHT:
        return from_mm(number)
    return parse_temperature(f"{number}C") if _OPTIONS[name].kind is Kind.TEMPERATURE else number
