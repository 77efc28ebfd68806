# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of expressions: FreeCAD takes an area for a length without a word, with its number in millimetres."""

from __future__ import annotations

from BalloonWorkbench.core.errors import InputError

# of the property itself nothing can be asked: it has taken the unit of its expression over
_UNITS = {
    "Length": "a length",
    "Distance": "a length",
    "Angle": "an angle",
    "Pressure": "a pressure",
    "Volume": "a volume",
    **dict.fromkeys(("Float", "FloatConstraint", "Integer"), "a number without a unit"),
}


def check(obj, properties) -> None:
    """Raise InputError where an expression of an object has another unit than its property."""
    following = {path.lstrip("."): text for path, text in obj.ExpressionEngine}
    for item in properties:
        if item.name not in following or item.type not in _UNITS:
            continue
        text = following[item.name]
        actual = _named(obj.evalExpression(text))
        if actual and actual != _UNITS[item.type]:
            raise InputError(
                f"{item.name} of {obj.Label} is {_UNITS[item.type]}, but its expression '{text}' gives"
                f" {actual}: change the expression."
            )


def _named(value) -> str:
    """The unit of a value in words, such as a length; empty for a plain number, which is in FreeCAD's own."""
    unit = getattr(value, "Unit", None)
    if unit is None or not any(unit.Signature):
        return ""
    kind = unit.Type.lower()  # empty for units that have no name
    return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}" if kind else "another unit"
