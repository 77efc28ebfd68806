# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values without their last digits: on the grid that files and other units lead back to.

Numbers that went through a file or another unit differ in their last digits. Left in, they would let the same
balloon come out a little different in FreeCAD and on the command line, or after a value was changed and
changed back. So what comes in is rounded, and the seam that a document keeps in mm.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import TypeVar, cast

import numpy as np

from BalloonWorkbench.core.outline.outline import Outline

_DECIMALS = 9  # of lengths in m
_DIGITS = 9

Value = TypeVar("Value")


def rounded_outline(outline: Outline) -> Outline:
    """The outline on a grid of a nanometre."""
    return outline.map(lambda loop: np.round(loop, _DECIMALS) + 0.0)  # + 0.0: no negative zeros


def rounded(value: Value) -> Value:
    """A number, or a dataclass with all its numbers, to nine significant digits."""
    if isinstance(value, float):
        return cast(Value, float(f"{value:.{_DIGITS}g}"))
    if is_dataclass(value) and not isinstance(value, type):
        return cast(
            Value, replace(value, **{item.name: rounded(getattr(value, item.name)) for item in fields(value)})
        )
    return value
