# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern as SVG at its real size, one layer per role."""

from __future__ import annotations

from BalloonWorkbench.core.export.sheet import DIGITS, LAYERS, Path, lay_out
from BalloonWorkbench.core.pattern.pattern import Pattern

#: Laser drivers take strokes up to a thousandth of an inch as lines to cut [mm].
_HAIRLINE = 0.025


def svg_bytes(pattern: Pattern) -> bytes:
    """The file's content; the same bytes for the same pattern."""
    sheet = lay_out(pattern)
    width, height = _number(sheet.width), _number(sheet.height)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
        f' version="1.1" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
    ]
    for role in pattern.roles:
        lines.append(
            f'  <g id="{role.value}" inkscape:groupmode="layer" inkscape:label="{role.value}"'
            f' fill="none" stroke="{LAYERS[role].rgb}" stroke-width="{_HAIRLINE}">'
        )
        lines += [f'    <path d="{_course(path, sheet.height)}"/>' for path in sheet.of(role)]
        lines.append("  </g>")
    lines.append("</svg>")
    return ("\n".join(lines) + "\n").encode("utf-8")


def _course(path: Path, height: float) -> str:
    """SVG's y runs downward."""
    points = " ".join(f"{_number(x)},{_number(height - y)}" for x, y in path.points.tolist())
    return f"M {points}{' Z' if path.closed else ''}"


def _number(value: float) -> str:
    text = f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
