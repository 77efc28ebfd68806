# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adding properties to document objects: the same call makes a new object and completes an old one."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable
from contextlib import contextmanager
from typing import Any, NamedTuple

from BalloonWorkbench.core.options.option import Kind, Option, options_of

READ_ONLY, OUTPUT = 1, 8


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text for translation; FreeCAD translates the tooltips of properties itself."""
    return text


class Property(NamedTuple):
    """One property: its value for a new object, and whether it is a result.

    entries  of an enumeration; option: of the engine, which it holds
    label    of its field in a panel; page: of which panel; needs: the property without which it has no effect
    preference  its label on the page of preferences
    """

    type: str  # without the leading "App::Property"
    name: str
    group: str
    tooltip: str
    value: Any = None
    result: bool = False  # read-only; changing it does not touch the object
    hidden: bool = False
    label: str = ""
    page: str = ""
    needs: str = ""
    preference: str = ""
    entries: Callable[[], Iterable[str]] | None = None
    option: Option | None = None


def result(kind: str, name: str, tooltip: str, *, hidden: bool = False, group: str = "Result") -> Property:
    """A property that the object itself writes."""
    return Property(kind, name, group, tooltip, result=True, hidden=hidden)


#: The property of each kind of option, and its unit in SI: FreeCAD counts in mm, kg, s and degrees.
_property_types = {
    Kind.LENGTH: ("Length", 1e-3),
    Kind.HEIGHT: ("Distance", 1e-3),
    Kind.ANGLE: ("Angle", math.pi / 180.0),
    Kind.PRESSURE: ("Pressure", 1e3),
    Kind.VOLUME: ("Volume", 1e-3**3),
    Kind.MASS: ("Float", 1e-3),
    Kind.TEMPERATURE: ("Float", 1.0),
    Kind.NUMBER: ("Float", 1.0),
    Kind.COUNT: ("Integer", None),
    Kind.FLAG: ("Bool", None),
    Kind.CHOICE: ("Enumeration", None),
    Kind.TEXT: ("String", None),
    Kind.FILE: ("FileIncluded", None),
}
_ICE = 273.15  # K, where degrees Celsius begin


def properties_of(declaring: type) -> tuple[Property, ...]:
    """The properties for the options that a dataclass declares; see core/options."""
    return tuple(_property(option) for option in options_of(declaring) if option.property_name)


def _property(option: Option) -> Property:
    chosen, kind = option.kind is Kind.CHOICE, _property_types[option.kind][0]
    first = option.default if option.begins is None else option.begins
    value = None if chosen or first in (None, "") else shown_value(option, first)
    if option.kind is Kind.NUMBER and option.most < 1.0:
        kind, value = "FloatConstraint", (value, option.least, option.most, option.step)
    return Property(
        kind,
        option.property_name,
        option.group,
        option.text,
        value,
        label=option.label,
        page=option.page,
        needs=option.needs,
        preference=option.preference,
        entries=(lambda: list(option.titles.values())) if chosen else None,
        option=option,
    )


def shown_value(option: Option, value):
    """A value of the engine as its property has it; what the engine finds is 0, or with what it begins
    where it cannot be 0."""
    unit = _property_types[option.kind][1]
    if value is None and option.kind is Kind.NUMBER and option.least > 0.0:
        value = option.begins
    if option.kind is Kind.CHOICE:
        return option.title(value)
    if option.kind is Kind.TEXT:
        return value or ""
    if option.kind is Kind.TEMPERATURE:
        return value - _ICE
    if option.kind is Kind.COUNT:
        return value or 0
    return value if unit is None else (value or 0.0) / (unit * option.scale)


def engine_value(option: Option, value):
    """What a property has, as a value of the engine; 0 where the engine may find it is None."""
    unit = _property_types[option.kind][1]
    if option.kind is Kind.CHOICE:
        return option.value(value)
    if option.kind is Kind.TEXT and option.default is None:
        return value.strip() or None
    if unit is None:
        return value
    number = float(getattr(value, "Value", value))
    if option.kind is Kind.TEMPERATURE:
        return number + _ICE
    return None if option.default is None and not number else number * unit * option.scale


def options_from(obj, declaring: type, **own):
    """The options of a document object; own: those that more than their property decides."""
    read = {
        option.name: engine_value(option, getattr(obj, option.property_name))
        for option in options_of(declaring)
        if option.property_name and option.name not in own
    }
    return declaring(**{**read, **own})


def write_options(obj, options, declaring: type, *names: str) -> None:
    """Give a document object the options that a dataclass declares, or those that are named."""
    for option in options_of(declaring):
        if option.property_name and (option.name in names or not names):
            setattr(obj, option.property_name, shown_value(option, getattr(options, option.name)))


def with_switches(properties: tuple[Property, ...], switches: dict[str, Property]) -> tuple[Property, ...]:
    """The properties, each after the one that says in a document whether it is given."""
    return tuple(item for own in properties for item in (switches.get(own.name), own) if item is not None)


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


def put_file(obj, item: Property, path: str) -> None:
    """Give a property of a file its file, of which a copy travels in the document; an empty path takes it
    away, which FreeCAD itself does not do. OSError where there is none."""
    if path:
        setattr(obj, item.name, (path, os.path.basename(path)))
    elif getattr(obj, item.name):
        obj.removeProperty(item.name)
        add_missing(obj, (item,))
        obj.touch()


def is_complete(obj, properties: tuple[Property, ...]) -> bool:
    """The object has all of them: it is neither being made nor restored."""
    return all(item.name in obj.PropertiesList for item in properties)


def offer_choices(obj, properties: tuple[Property, ...]) -> None:
    """Give enumerations their entries; an older object keeps its choice."""
    for item in properties:
        if item.entries is None:
            continue
        entries, present = list(item.entries()), obj.getEnumerationsOfProperty(item.name) or []
        if present != entries:
            chosen = getattr(obj, item.name) if present else entries[0]
            setattr(obj, item.name, entries)
            setattr(obj, item.name, chosen)


def follow_needs(obj, properties: tuple[Property, ...]) -> None:
    """Offer only what has an effect."""
    needy = {item.name: item.needs for item in properties if item.needs}
    show_in_editor(obj, **{name: "edit" if getattr(obj, need) else "hide" for name, need in needy.items()})


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
    output = _Results(obj)
    yield output
    for name, value in output._values.items():
        setattr(obj, name, value)
