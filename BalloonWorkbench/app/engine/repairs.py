# SPDX-License-Identifier: LGPL-2.1-or-later
"""The repairs that were taken.

A repair belongs to the Outline: it is kept there, in the property Repairs, and applied to whatever is read
from the drawing or the sketch, which themselves stay as they are. Taking an entry out takes the repair back.
"""

from __future__ import annotations

import json
from dataclasses import replace

from BalloonWorkbench.app.properties.property_table import Property
from BalloonWorkbench.app.shapes.pattern_shape import DIRECTION
from BalloonWorkbench.core.errors import OutlineError
from BalloonWorkbench.core.options.option import option_of
from BalloonWorkbench.core.options.pattern import LOW, PatternOptions

PROPERTIES = (
    Property(
        "StringList",
        "Repairs",
        "Drawing",
        "Repairs that were made in the drawing, one each; delete an entry to take it back",
    ),
    Property(
        "Float", "DrawnSize", "Drawing", "Larger dimension before repairs, in mm", result=True, hidden=True
    ),
)


def take(parts, repair) -> None:
    """Make a repair: a moved intake in the pattern, anything else in the outline; nothing is computed yet."""
    import math

    from BalloonWorkbench.core.advice.as_data import repair_data
    from BalloonWorkbench.core.advice.findings import RepairKind

    if repair.kind is RepairKind.MOVE_INTAKE:
        parts.pattern.IntakeAuto = False
        parts.pattern.IntakeBy = DIRECTION
        parts.pattern.IntakeAngle = math.degrees(repair.size)
        return
    if repair.kind is RepairKind.LOWER_INTAKE:
        parts.pattern.IntakeAuto = True
        parts.pattern.IntakeAutoPlace = option_of(PatternOptions, "intake_place").title(LOW)
        return
    entry = {**repair_data(repair), "of_mm": parts.outline.DrawnSize}
    parts.outline.Repairs = [*parts.outline.Repairs, json.dumps(entry)]


def repair_outline(obj, outline, scales: bool):
    """The outline as read, with the object's repairs; one that no longer fits is left out, with a note.

    scales  the drawing follows Width and Height, and its repairs with it; a sketch has its own size
    """
    from BalloonWorkbench.core.advice.as_data import repair_from
    from BalloonWorkbench.core.advice.repairs import repaired, scaled
    from BalloonWorkbench.core.units import to_mm

    obj.DrawnSize = size = to_mm(max(outline.size))
    for number, entry in enumerate(obj.Repairs, 1):
        try:
            data = json.loads(entry)
            repair = repair_from(data)
            factor = size / float(data["of_mm"]) if scales else 1.0
        except (ValueError, KeyError, TypeError):
            outline = _noted(outline, f"Repair {number} cannot be read: delete it from Repairs.")
            continue
        try:
            outline = repaired(outline, scaled(repair, factor))
        except OutlineError as error:
            outline = _noted(outline, str(error))
    return outline


def _noted(outline, note: str):
    return replace(outline, notes=(*outline.notes, note))
