# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Panel object: one panel, or another piece, of a pattern of many, to name, hide and measure alone."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.properties.property_table import Property, result, results

PROPERTIES = (
    Property("Link", "Pattern", "Panel", "The pattern that it is a piece of"),
    Property("Integer", "Number", "Panel", "Which piece of the pattern it is, from 1", 1),
    result("String", "PanelName", "What it is called on the pattern"),
    result("Length", "SeamLength", "Length of its welds"),
    result("Length", "PatternWidth", "Width of the piece of film"),
    result("Length", "PatternHeight", "Height of the piece of film"),
    result("Area", "CutArea", "Area of the piece of film"),
    result("StringList", "Roles", "What to do along each wire of the shape"),
    result("String", "NamedAs", "Label that the workbench has given it", hidden=True),
    result("String", "Status", "Up to date, or what is wrong"),
)


class PanelProxy(DocumentProxy):
    """Behaviour of the Panel object (Part::FeaturePython): its shape is its part of the pattern's."""

    properties = PROPERTIES

    def compute(self, obj):
        has_result = bool(obj.Roles)
        if status.waits_for(obj, obj.Pattern, has_result, "Its pattern is gone: delete it."):
            return
        if not 1 <= obj.Number <= len(obj.Pattern.PanelNames):
            count = len(obj.Pattern.PanelNames)
            status.set_problem(obj, has_result, f"{obj.Pattern.Label} has {count} pieces now: delete it.")
            return
        with status.reported(obj, has_result):
            with results(obj) as output:
                _show(output)
            if obj.Placement != obj.Pattern.Placement:
                obj.Placement = obj.Pattern.Placement
            status.set_status(obj, status.READY)

    def cut_pattern(self, obj):
        """What is cut for this piece alone, the core's Pattern."""
        return obj.Pattern.Proxy.piece(obj.Pattern, obj.Number)


def _show(obj) -> None:
    """Take the piece out of the shape of its pattern, with its measures."""
    import Part

    pattern = obj.Pattern
    own = [number == obj.Number for number in pattern.PanelNumbers]
    shape = pattern.Shape.copy()
    shape.Placement = type(shape.Placement)()
    parts, roles, at = [], [], 0
    for part in shape.SubShapes:
        count = len(part.Wires)
        if own[at]:
            parts.append(part)
            roles += pattern.Roles[at : at + count]
        at += count
    obj.Shape = Part.Compound(parts)
    obj.Roles = roles
    obj.PanelName = pattern.PanelNames[obj.Number - 1]
    faces = [part for part in parts if part.ShapeType == "Face"]
    box = Part.Compound(faces or parts).BoundBox
    obj.PatternWidth, obj.PatternHeight = box.XLength, box.YLength
    obj.CutArea = sum(face.Area for face in faces)
    welds = (
        wire for wire, role in zip((wire for part in parts for wire in part.Wires), roles) if role == "SEAL"
    )
    obj.SeamLength = sum(wire.Length for wire in welds)
