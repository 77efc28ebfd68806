# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Pattern object: the flat piece to cut and seal, made from the seam of a balloon."""

from __future__ import annotations

from functools import lru_cache
from types import SimpleNamespace

from BalloonWorkbench.app import migrate, status
from BalloonWorkbench.app.properties import Property, add_missing, show_in_editor
from BalloonWorkbench.app.stateless import Stateless

PROPERTIES = (
    Property("Link", "Balloon", "Pattern", "The balloon that is cut from this pattern"),
    Property("Length", "SealWidth", "Pattern", "Width of the weld; 0 takes the film's"),
    Property("Length", "Allowance", "Pattern", "Film left outside the weld", 2.0),
    Property("Bool", "Arcs", "Pattern", "Lines and arcs within 0.02 mm in place of many short lines", True),
    Property("Bool", "Intake", "Intake", "Add a neck through which the balloon is filled", True),
    Property("Length", "IntakeWidth", "Intake", "Inner width of the neck", 10.0),
    Property("Length", "IntakeLength", "Intake", "Length of the neck from the seam outward; 0 is automatic"),
    Property("Bool", "IntakeAuto", "Intake", "Point the neck from the centre to the farthest point", True),
    Property("Angle", "IntakeAngle", "Intake", "Direction of the neck, counter-clockwise from the x axis"),
    Property(
        "Integer", "Notches", "Marks", "Notches to lay both films on each other by, evenly along the cut", 0
    ),
    Property("Length", "NotchDepth", "Marks", "Length of a notch; at most the allowance", 1.5),
    Property("Bool", "TieTab", "Marks", "A tab with a hole to tie the balloon to, outside the weld", False),
    Property("Bool", "TieTabAuto", "Marks", "Put the tab opposite the intake", True),
    Property("Angle", "TieTabAngle", "Marks", "Direction of the tab from the middle of the pattern"),
    Property("String", "LabelText", "Marks", "A line of text where the film is widest, as outlines"),
    Property("Length", "LabelHeight", "Marks", "Height of its capital letters", 6.0),
    Property("Length", "SeamLength", "Result", "Length of the weld", result=True),
    Property("Length", "PatternWidth", "Result", "Width of the piece of film", result=True),
    Property("Length", "PatternHeight", "Result", "Height of the piece of film", result=True),
    Property("StringList", "Roles", "Result", "What to do along each wire of the shape", result=True),
    Property("StringList", "Warnings", "Result", "Remarks made while the pattern was drawn", result=True),
    Property("String", "Status", "Result", "Up to date, or what is wrong", result=True),
)


class PatternProxy(Stateless):
    """Behaviour of the Pattern object (Part::Part2DObjectPython)."""

    def __init__(self, obj):
        add_missing(obj, (migrate.VERSION, *PROPERTIES))
        obj.Proxy = self
        self.follow_intake(obj)

    def onDocumentRestored(self, obj):
        from BalloonWorkbench.app import hooks

        migrate.bring_up_to_date(obj, PROPERTIES)
        hooks.dress(obj)

    def onChanged(self, obj, name):
        if name in ("Intake", "IntakeAuto", "Notches", "TieTab", "TieTabAuto", "LabelText") and all(
            item.name in obj.PropertiesList for item in PROPERTIES
        ):
            self.follow_intake(obj)

    def follow_intake(self, obj):
        """Offer only what has an effect."""
        show_in_editor(
            obj,
            **dict.fromkeys(("IntakeWidth", "IntakeLength", "IntakeAuto"), "edit" if obj.Intake else "hide"),
            IntakeAngle="hide" if not obj.Intake else "show" if obj.IntakeAuto else "edit",
            NotchDepth="edit" if obj.Notches else "hide",
            LabelHeight="edit" if obj.LabelText else "hide",
            TieTabAuto="edit" if obj.TieTab else "hide",
            TieTabAngle="edit" if obj.TieTab and not obj.TieTabAuto else "hide",
        )

    def execute(self, obj):
        has_result = bool(obj.Roles)
        if status.waits_for(obj, obj.Balloon, has_result, "Choose the balloon that it belongs to."):
            return
        with status.reported(obj, has_result):
            show(obj, build(obj))
            status.set_status(obj, status.READY)
        obj.positionBySupport()


def is_pattern(obj) -> bool:
    """Whether a document object is a pattern."""
    return isinstance(getattr(obj, "Proxy", None), PatternProxy)


def values(obj) -> dict:
    """The object's own values, as `build_pattern` takes them."""
    from BalloonWorkbench.app.quantities import metres, radians

    return {
        "allowance": metres(obj.Allowance),
        "intake": obj.Intake,
        "intake_width": metres(obj.IntakeWidth),
        "intake_length": metres(obj.IntakeLength) or None,
        "intake_angle": None if obj.IntakeAuto else radians(obj.IntakeAngle),
    }


def usual_values() -> dict:
    """The values of a new pattern."""
    return values(SimpleNamespace(**{item.name: item.value or 0.0 for item in PROPERTIES}))


def build(obj):
    """The pattern in full precision, from the balloon's seam and the object's own values."""
    from BalloonWorkbench.app import shapes
    from BalloonWorkbench.app.quantities import metres, radians
    from BalloonWorkbench.core.pattern.build import build_pattern
    from BalloonWorkbench.core.pattern.extras import with_notches, with_tie_tab
    from BalloonWorkbench.core.pattern.label import with_label

    seal_width = metres(obj.SealWidth) or metres(obj.Balloon.SealWidth)
    pattern = build_pattern(shapes.stored(obj.Balloon, "Seam"), seal_width, **values(obj))
    if obj.TieTab:
        pattern = with_tie_tab(pattern, None if obj.TieTabAuto else radians(obj.TieTabAngle))
    pattern = with_label(pattern, obj.LabelText, metres(obj.LabelHeight))
    return with_notches(pattern, obj.Notches, metres(obj.NotchDepth))


@lru_cache(maxsize=64)
def _fitted(points: bytes, closed: bool):
    import numpy as np

    from BalloonWorkbench.core.pattern.arcs import fit_curve

    return fit_curve(np.frombuffer(points).reshape(-1, 2), closed)


def arcs(points, closed: bool):
    """The arcs of a contour; they take a while, and those of the last contours are remembered."""
    import numpy as np

    return _fitted((np.round(points, 9) + 0.0).tobytes(), closed)


def show(obj, pattern) -> None:
    """Write a pattern into the object: the sheet to cut out first, then welds and marks."""
    import math

    import Part

    from BalloonWorkbench.app import shapes
    from BalloonWorkbench.core.pattern.curves import polyline
    from BalloonWorkbench.core.pattern.pattern import Role
    from BalloonWorkbench.core.units import to_mm

    outer, inner = pattern.of(Role.CUT), pattern.of(Role.CUT_INNER)
    beside = (Role.SEAL, Role.WELD, Role.MARK, Role.ENGRAVE)
    lines = [contour for role in beside for contour in pattern.of(role)]
    fit = arcs if obj.Arcs else polyline
    wires = [shapes.curve_wire(fit(each.points, each.closed)) for each in (*outer, *inner, *lines)]
    cuts = len(outer) + len(inner)
    obj.Shape = Part.makeCompound([Part.Face(wires[:cuts]), *wires[cuts:]])
    obj.Roles = [contour.role.value for contour in (*outer, *inner, *lines)]
    obj.SeamLength = to_mm(pattern.seam_length)
    obj.PatternWidth, obj.PatternHeight = (to_mm(length) for length in pattern.size)
    obj.Warnings = list(pattern.warnings)
    if pattern.intake is not None and obj.IntakeAuto:
        obj.IntakeAngle = math.degrees(pattern.intake.angle)
