# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adding properties to document objects: the same call makes a new object and completes an old one."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, NamedTuple

READ_ONLY, OUTPUT = 1, 8


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text for translation; FreeCAD translates the tooltips of properties itself."""
    return text


class Property(NamedTuple):
    """One property: its value for a new object, and whether it is a result."""

    type: str  # without the leading "App::Property"
    name: str
    group: str
    tooltip: str
    value: Any = None
    result: bool = False  # read-only; changing it does not touch the object
    hidden: bool = False


def add_missing(obj, properties: tuple[Property, ...]) -> None:
    """Add those properties that the object does not have yet."""
    present = set(obj.PropertiesList)
    for item in properties:
        if item.name in present:
            continue
        attributes = READ_ONLY | OUTPUT if item.result else 0
        obj.addProperty(
            "App::Property" + item.type, item.name, item.group, item.tooltip, attributes, False, item.hidden
        )
        if item.value is not None:
            setattr(obj, item.name, item.value)


def offer_choices(obj, choices: dict[str, list[str]]) -> None:
    """Give enumerations their entries; an older object keeps its choice."""
    for name, entries in choices.items():
        present = obj.getEnumerationsOfProperty(name) or []
        if present != entries:
            chosen = getattr(obj, name) if present else entries[0]
            setattr(obj, name, entries)
            setattr(obj, name, chosen)


def show_in_editor(obj, **modes: str) -> None:
    """Set how properties appear in the editor: "edit", "show" (read-only) or "hide"."""
    for name, mode in modes.items():
        obj.setEditorMode(name, {"edit": 0, "show": 1, "hide": 2}[mode])


class _Results:
    """Stands for an object while its results are worked out: keeps what is written, else reads as it does."""

    def __init__(self, obj):
        vars(self).update(_obj=obj, _values={})

    def __setattr__(self, name, value):
        self._values[name] = value

    def __getattr__(self, name):
        return self._values[name] if name in self._values else getattr(self._obj, name)


@contextmanager
def results(obj):
    """Results of an object that are written together at the end: an error on the way leaves it as it was."""
    found = _Results(obj)
    yield found
    for name, value in found._values.items():
        setattr(obj, name, value)
