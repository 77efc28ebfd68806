# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as a LightBurn project: what is not burnt lies on LightBurn's tool layers, which it never sends.

No other format can say so: from DXF and SVG LightBurn takes the nearest colour of its cut layers. Speed and
power are those of the user's own file of the machine; where it has none, none are written. Kerf is made up
for in the lines, as for every machine: LightBurn's own offset, which is half of it, is 0, because it would
move a hole on a layer of its own the wrong way (docs.lightburnsoftware.com, Kerf Offset Testing).
"""

from __future__ import annotations

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.machines.layers import TOOL_LAYER, LaserSettings
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import Toolpaths
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import to_mm

#: How far a polyline may be off an arc [mm].
_CHORD = 0.005
_DIGITS = 4


def drawing_lightburn(drawing: Toolpaths, machine: Machine) -> bytes:
    """The project's content, mm with y upward; the same bytes for the same drawing."""
    from xml.sax.saxutils import quoteattr  # which brings all of urllib along

    numbers = _layer_numbers(drawing, machine)
    settings = {number: machine.layers[role].laser for (_, role), number in numbers.items()}
    names: dict[int, list[str]] = {}
    for (turn, role), number in numbers.items():
        name = machine.layers[role].name
        names.setdefault(number, []).append(f"{name}-{turn + 1}" if turn else name)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<LightBurnProject AppVersion="1.0.00" FormatVersion="1" MaterialHeight="0" MirrorX="False"'
        ' MirrorY="False">',
    ]
    for priority, (number, roles) in enumerate(names.items()):
        kind = "Tool" if number >= TOOL_LAYER else "Cut"
        lines += [
            f'    <CutSetting type="{kind}">',
            f'        <index Value="{number}"/>',
            f"        <name Value={quoteattr(' '.join(roles))}/>",
            f'        <priority Value="{priority}"/>',
            *_burnt(settings[number]),
            "    </CutSetting>",
        ]
    for path in drawing.by_layer:
        vertices, edges = _shape(path.curve)
        lines += [
            f'    <Shape Type="Path" CutIndex="{numbers[path.turn, path.role]}">',
            "        <XForm>1 0 0 1 0 0</XForm>",
            f"        <VertList>{vertices}</VertList>",
            f"        <PrimList>{edges}</PrimList>",
            "    </Shape>",
        ]
    lines.append("</LightBurnProject>")
    return ("\n".join(lines) + "\n").encode("utf-8")


def _burnt(laser: LaserSettings | None) -> list[str]:
    """What is known of how a layer is burnt, in LightBurn's mm/s and percent."""
    if laser is None:
        return []
    known = {
        "minPower": None if laser.min_power is None else 100.0 * laser.min_power,
        "maxPower": 100.0 * laser.max_power,
        "speed": to_mm(laser.speed),
        "kerf": 0.0,
        "numPasses": laser.passes,
    }
    return [f'        <{key} Value="{_number(value)}"/>' for key, value in known.items() if value is not None]


def _layer_numbers(drawing: Toolpaths, machine: Machine) -> dict[tuple[int, Role], int]:
    """The layer of each turn and role, in the order of the work: LightBurn burns one layer after the other.

    What waits for a later turn, as the hole of a panel with another panel in it, has the next free layer.
    """
    taken = {line.pen for line in machine.layers.values()}
    free = iter(number for number in range(TOOL_LAYER) if number not in taken)
    numbers: dict[tuple[int, Role], int] = {}
    for turn, role in dict.fromkeys((path.turn, path.role) for path in drawing.by_layer):
        own = machine.layers[role].pen
        number = own if turn == 0 or own >= TOOL_LAYER else next(free, None)
        if number is None:
            raise ExportError("LightBurn has too few layers for panels in holes of panels: lay out fewer.")
        numbers[turn, role] = number
    return numbers


def _shape(curve: Curve) -> tuple[str, str]:
    """Vertices without handles, and the edges between them."""
    points = curve.flattened(_CHORD).tolist()
    vertices = "".join(f"V{_number(x)} {_number(y)}c0x1c1x1" for x, y in points)
    if curve.closed:
        return vertices, "LineClosed"
    return vertices, "".join(f"L{k} {k + 1}" for k in range(len(points) - 1))


def _number(value: float) -> str:
    text = f"{value:.{_DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
