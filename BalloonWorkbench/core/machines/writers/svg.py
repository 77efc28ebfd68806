# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as SVG at its real size, with real arcs and a layer for each role.

A role has a second layer where one layer after the other would cut film that is free already.
"""

from __future__ import annotations

from itertools import groupby

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.machines.machine import UNITS, Machine
from BalloonWorkbench.core.machines.toolpaths import Toolpaths, in_unit
from BalloonWorkbench.core.units import MILLIMETRE

#: Laser drivers take strokes up to a thousandth of an inch as lines to cut [mm].
_HAIRLINE = 0.025
_DASH = 4.0
_DIGITS = 5


def drawing_svg(drawing: Toolpaths, machine: Machine) -> bytes:
    """The file's content; the same bytes for the same drawing."""
    scale = MILLIMETRE / UNITS[machine.unit]
    scaled = in_unit(drawing, UNITS[machine.unit])
    width, height = _number(scaled.width), _number(scaled.height)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
        f' version="1.1" width="{width}{machine.unit}" height="{height}{machine.unit}"'
        f' viewBox="0 0 {width} {height}">',
    ]
    for (turn, role), paths in groupby(scaled.by_layer, lambda path: (path.turn, path.role)):
        line = machine.layers[role]
        own = f"{line.name}-{turn + 1}" if turn else line.name
        dash = f' stroke-dasharray="{_number(_DASH * scale)}"' if line.line == "DASHED" else ""
        lines.append(
            f'  <g id="{own}" inkscape:groupmode="layer" inkscape:label="{own}"'
            f' fill="none" stroke="{line.rgb}" stroke-width="{_number(_HAIRLINE * scale)}"{dash}>'
        )
        lines += [f'    <path d="{_course(path.curve, scaled.height)}"/>' for path in paths]
        lines.append("  </g>")
    lines.append("</svg>")
    return ("\n".join(lines) + "\n").encode("utf-8")


def _course(curve: Curve, height: float) -> str:
    """The path's commands. SVG's y runs downward, so a turn to the left has the sweep flag 0."""
    x, y = curve.joints[0]
    words = [f"M {_number(x)} {_number(height - y)}"]
    command = ""
    segments = curve.segments
    if curve.closed and segments[-1].bulge == 0.0:
        segments = segments[:-1]  # Z draws it
    for segment, radius in zip(segments, curve.radii):
        end = f"{_number(segment.end[0])} {_number(height - segment.end[1])}"
        if segment.bulge == 0.0:
            words.append(end if command == "L" else f"L {end}")
            command = "L"
        else:
            command = "A"
            size, large = _number(float(radius)), int(abs(segment.bulge) > 1.0)
            words.append(f"A {size} {size} 0 {large} {int(segment.bulge < 0.0)} {end}")
    return " ".join([*words, "Z"] if curve.closed else words)


def _number(value: float) -> str:
    text = f"{value:.{_DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
