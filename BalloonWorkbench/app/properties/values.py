# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of a balloon by the names that the Python API has for them: mesh_size for MeshSize."""

from __future__ import annotations

import json
import os
from typing import Any

from BalloonWorkbench.app import bag, balloon, gored_body, outline, pattern, target
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target
from BalloonWorkbench.app.properties import quantities
from BalloonWorkbench.app.properties.property_table import Property, put_file
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.option import snake

#: They decide about others, so they come first.
_FIRST = ("film", "load", "size_goal", "drawing", "source", "ready")
_READ = {"Length": quantities.length, "Pressure": quantities.pressure, "Volume": quantities.volume}
#: Results that are written with the values: the one that goes with a film's numbers.
_ASSIGNED_RESULTS = ("Material",)


def places(source=None) -> dict[str, tuple[str, Property]]:
    """For each name, the object that has the value (a field of Parts) and its property.

    source  what the balloon is made from, a document object; None: an outline
    seal_width is that of the pattern, which overrules the film's: film_seal_width.
    """
    own = (
        target
        if is_target(source)
        else gored_body
        if is_gored_body(source)
        else bag
        if is_bag(source)
        else outline
    )
    cut = {item.name for item in pattern.PROPERTIES if not item.result}
    properties = {}
    for part, module in (("outline", own), ("balloon", balloon), ("pattern", pattern)):
        for item in module.PROPERTIES:
            if item.type != "Link" and (not item.result or item.name in _ASSIGNED_RESULTS):
                twice = part == "balloon" and item.name in cut
                properties[("film_" if twice else "") + snake(item.name)] = (part, item)
    return properties


def check(names, source=None) -> None:
    """Raise InputError for a name that no value has; source as for `places`."""
    known = places(source)
    for name in names:
        if name not in known:
            raise InputError(f'A balloon has no "{name}": it has {", ".join(sorted(known))}.')


def assign(parts, values: dict[str, Any]) -> None:
    """Set values by name; nothing is computed.

    Numbers are in FreeCAD's units; quantities, and text such as "300 mm", bring their own.
    Raises InputError for unknown names and for what a value cannot be.
    """
    check(values, parts.outline)
    known = places(parts.outline)
    for name in sorted(values, key=lambda name: (name not in _FIRST, name)):
        part, item = known[name]
        _set(getattr(parts, part), name, item, values[name])


def assign_to(obj, properties: tuple[Property, ...], values: dict[str, Any]) -> None:
    """As `assign`, for one object and its properties."""
    known = {snake(item.name): item for item in properties if not item.result}
    for name, value in values.items():
        if name not in known:
            raise InputError(f'{obj.Label} has no "{name}": it has {", ".join(sorted(known))}.')
        _set(obj, name, known[name], value)


def texts_of(obj, properties: tuple[Property, ...]) -> dict[str, str]:
    """The values of one object that are not the usual ones, as Python text by name; no files or links."""
    return {
        snake(item.name): text(getattr(obj, item.name), item)
        for item in properties
        if not item.result and "Link" not in item.type and item.type != "FileIncluded"
        if _plain(getattr(obj, item.name)) != _default(obj, item)
    }


def _plain(value):
    return getattr(value, "Value", value)


def _default(obj, item: Property):
    if item.type == "Enumeration":
        return obj.getEnumerationsOfProperty(item.name)[0]
    return item.value or type(_plain(getattr(obj, item.name)))()


def _set(obj, name: str, item: Property, value) -> None:
    read = _READ.get(item.type) if isinstance(value, str) else None
    try:
        if item.type == "FileIncluded":
            put_file(obj, item, os.fspath(value) if value else "")
        else:
            setattr(obj, item.name, read(value) if read else value)
    except (ValueError, TypeError, OSError, RuntimeError) as error:
        raise InputError(f'{name} cannot be "{value}": {_said(error)}') from error


def _said(error: Exception) -> str:
    """Its sentence: FreeCAD's own errors keep theirs among what they know of it."""
    known = error.args[0] if error.args else ""
    return str(known.get("sErrMsg", known) if isinstance(known, dict) else error)


def texts(parts) -> dict[str, str]:
    """The present values as Python text, by name; those that follow from others are left out."""
    return {
        name: text(getattr(getattr(parts, part), item.name), item)
        for name, (part, item) in places(parts.outline).items()
        if not _follows(parts, item.name, part)
    }


def text(value, item: Property) -> str:
    """A value as Python text that `assign` takes."""
    unit, factor = _UNITS.get(item.type, ("", 1.0))
    if unit:
        return f'"{value.Value * factor:.10g} {unit}"'
    if item.type == "Angle":
        return f"{value.Value:.10g}"
    if item.type == "LinkGlobal":
        return _object(value) if value else "None"
    if item.type == "LinkListGlobal":
        return f"[{', '.join(map(_object, value))}]"
    if item.type in ("LinkSubGlobal", "LinkSub"):
        return _link(value)
    if item.type == "LinkSubListGlobal":
        return f"[{', '.join(map(_link, value))}]"
    if isinstance(value, float):
        return f"{value:.10g}"
    return repr(value) if isinstance(value, (bool, int)) else json.dumps(value, ensure_ascii=False)


_UNITS = {"Length": ("mm", 1.0), "Distance": ("mm", 1.0), "Pressure": ("kPa", 1.0), "Volume": ("l", 1e-6)}


def _object(value) -> str:
    return f'App.ActiveDocument.getObject("{value.Name}")'


def _link(value) -> str:
    if not value:
        return "None"
    source, elements = value
    return f"({_object(source)}, {json.dumps(list(elements))})"


def _follows(parts, name: str, part: str) -> bool:
    """The value is set by another one or has no effect now: the property editor does not offer it."""
    return name == "Part" or (
        name not in _ASSIGNED_RESULTS and bool(getattr(parts, part).getEditorMode(name))
    )
