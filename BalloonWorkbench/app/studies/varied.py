# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a column of a study varies in a document: a property of the balloon, of a VarSet, or a named cell."""

from __future__ import annotations

import math
import re
from difflib import get_close_matches
from typing import Any, NamedTuple

import FreeCAD as App

from BalloonWorkbench.app.document.kinds import leader
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.columns import NO, YES
from BalloonWorkbench.core.units import number_text

SHEET, VARIABLES = "Spreadsheet::Sheet", "App::VarSet"
#: Properties with a unit, and FreeCAD's own one, in which `Varied.read` gives values.
UNITS = {
    "Length": "mm",
    "Distance": "mm",
    "Angle": "deg",
    "Pressure": "kPa",
    "Volume": "mm^3",
    "Area": "mm^2",
}
#: A plain number for one of these is millimetres or degrees, as everywhere in FreeCAD.
_PLAIN = ("Length", "Distance", "Angle")
_KINDS = frozenset({*UNITS, "Float", "FloatConstraint", "Integer", "Bool", "Enumeration", "String"})


class Varied(NamedTuple):
    """A property of an object by their names, or a cell with an alias; heading: as it stands in the table."""

    heading: str
    obj: Any
    name: str

    @property
    def key(self) -> str:
        """The same for the same property, whatever the heading."""
        return f"{self.obj.Name}.{self.name}"

    @property
    def kind(self) -> str:
        """The type of the property without App::Property; "" for a cell."""
        if self.obj.TypeId == SHEET:
            return ""
        return self.obj.getTypeIdOfProperty(self.name)[len("App::Property") :]

    def present(self):
        """Its value in the document, of what JSON can hold."""
        if self.obj.TypeId == SHEET:
            return str(self.obj.getContents(self.obj.getCellFromAlias(self.name)))
        value = getattr(self.obj, self.name)
        return getattr(value, "Value", value)

    def shown(self) -> str:
        """Its value as it is written into a table, with its unit."""
        if self.obj.TypeId == SHEET:
            return self.present().lstrip("=")
        value = getattr(self.obj, self.name)
        return str(getattr(value, "UserString", value))

    def read(self, cell):
        """What a cell of the table says, of what JSON can hold, in FreeCAD's own units. Raises InputError."""
        if self.obj.TypeId == SHEET:
            return _content(cell)
        if isinstance(cell, str):
            cell = " ".join(cell.split())  # FreeCAD's own errors have several lines
        if self.kind in UNITS:
            return self._quantity(cell)
        text = str(cell).strip()
        if self.kind == "Bool":
            return _flag(self.heading, text)
        if self.kind == "Enumeration":
            return self._entry(text)
        if self.kind == "String":
            return text
        return self._number(cell)

    def write(self, value) -> None:
        """Give the document a value that `read` has given. Raises InputError for one that it does not take.

        FreeCAD silently makes 0 of a negative length, and the end of a range of what lies beyond it.
        """
        if self.obj.TypeId == SHEET:
            self.obj.set(self.obj.getCellFromAlias(self.name), value)
            return
        setattr(self.obj, self.name, value)
        if isinstance(value, (int, float)) and not math.isclose(self.present(), value, rel_tol=1e-6):
            raise InputError(
                f"{self.name} of {self.obj.Label} cannot be {number_text(value)}: take another value."
            )

    def _quantity(self, cell) -> float:
        unit = getattr(self.obj, self.name).Unit
        quantity = _parsed(cell)
        if quantity is None:
            raise InputError(f"'{cell}' is no value for {self.heading}: write a number and its unit.")
        if not any(quantity.Unit.Signature):
            if self.kind not in _PLAIN:
                raise InputError(f"{self.heading} needs a unit: write {self.shown()} instead of {cell}.")
            return float(quantity.Value)
        if quantity.Unit != unit:
            raise InputError(f"'{cell}' has another unit than {self.heading}: write it like {self.shown()}.")
        return float(quantity.Value)

    def _number(self, cell):
        quantity = _parsed(cell)
        if quantity is None or any(quantity.Unit.Signature):
            raise InputError(f"'{cell}' is no value for {self.heading}: write a number without a unit.")
        number = float(quantity.Value)
        if self.kind != "Integer":
            return number
        if not number.is_integer():
            raise InputError(f"'{cell}' is no whole number: write one for {self.heading}.")
        return int(number)

    def _entry(self, text: str) -> str:
        entries = {
            _plain(entry): entry for entry in self.obj.getEnumerationsOfProperty(self.name) if entry.strip()
        }
        match = entries.get(_plain(text))
        if match is None:
            raise InputError(f"'{text}' is no {self.heading}: write {', '.join(entries.values())}.")
        return match


def varied(heading: str, parts, table) -> Varied:
    """What a heading means: `Property`, an option of the command line, an alias, or `Object.Property`.

    parts: of the balloon; table: the study's own, whose cells are none. Raises InputError.
    """
    owner, _, name = heading.rpartition(".")
    known: dict[str, Varied] = {}
    for obj in _objects(parts, table):
        if owner and _plain(owner) not in (_plain(obj.Name), _plain(obj.Label)):
            continue
        for own, wording in _names(obj):
            known.setdefault(_plain(wording), Varied(heading, obj, own))
    match = known.get(_plain(name))
    if match is None:
        near = [known[each].name for each in get_close_matches(_plain(name), known, 3, 0.5)]
        advice = f"the nearest are {', '.join(near)}" if near else "name a property of the balloon"
        raise InputError(f"The balloon has nothing that is called '{heading}': {advice}.")
    if match.obj.TypeId != SHEET and match.kind not in _KINDS:
        raise InputError(f"{heading} cannot be varied: choose a number, a word or a choice.")
    follows = dict(match.obj.ExpressionEngine).get(match.name)
    if follows:
        raise InputError(
            f"{match.name} of {match.obj.Label} follows the expression '{follows}': vary what that is made"
            " of."
        )
    return match


def of_key(document, key: str) -> Varied:
    """The property that a `Varied.key` names in a copy of the document."""
    owner, _, name = key.partition(".")
    return Varied(key, document.getObject(owner), name)


def write_all(document, values: dict[str, Any]) -> None:
    """Give a document the values of a row, by `Varied.key`; a choice may decide others, so it comes first."""
    pairs = [(of_key(document, key), value) for key, value in values.items()]
    for each, value in sorted(pairs, key=lambda pair: pair[0].kind != "Enumeration"):
        each.write(value)


def own_variables(variable_set) -> list[str]:
    """The properties of a VarSet that its user has made and a study can vary."""
    return [
        name
        for name in variable_set.PropertiesList
        if name not in ("ExpressionEngine", "Label", "Label2", "Visibility", "ExposedLength")
        and variable_set.getTypeIdOfProperty(name)[len("App::Property") :] in _KINDS
    ]


def _objects(parts, table) -> list:
    outline = leader(parts.outline)
    others = [obj for obj in outline.Document.Objects if obj.TypeId in (SHEET, VARIABLES) and obj != table]
    return [outline, parts.balloon, parts.pattern, *others]


def _names(obj):
    """Properties of an object that are no results, and what they are called."""
    if obj.TypeId == SHEET:
        aliases = re.findall(r'alias="([^"]+)"', obj.cells.Content)
        return [(alias, alias) for alias in aliases]
    if obj.TypeId == VARIABLES:
        return [(name, name) for name in own_variables(obj)]
    own = [item for item in obj.Proxy.properties if not item.result and not item.hidden]
    named = [(item.name, item.name) for item in own]
    return named + [(item.name, item.option.flag_name) for item in own if item.option is not None]


def _plain(text: str) -> str:
    """Without spaces, dashes and capitals; letters of any script stay."""
    return re.sub(r"[\W_]", "", text.casefold())


def _parsed(cell):
    """A cell as a quantity; None for what is none."""
    if isinstance(cell, bool):
        return None
    if isinstance(cell, (int, float)):
        return App.Units.Quantity(float(cell))
    if hasattr(cell, "Unit"):
        return cell
    try:
        return App.Units.Quantity(str(cell).strip())
    except (ValueError, RuntimeError, OSError, SyntaxError, ArithmeticError):
        return None


def _flag(heading: str, text: str) -> bool:
    if text.lower() not in (*YES, *NO):
        raise InputError(f"'{text}' is neither yes nor no: write one of them for {heading}.")
    return text.lower() in YES


def _content(cell) -> str:
    """A value as the content of a cell."""
    return f"={cell}" if hasattr(cell, "Unit") else str(cell)
