# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as G-code for grbl, Marlin or LinuxCNC: what a controller is told, a line each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.tool import GRBL, MachineTool
from BalloonWorkbench.core.machines.toolpaths import Toolpaths
from BalloonWorkbench.core.machines.writers.moves import DIGITS, Instruction, laid, moves
from BalloonWorkbench.core.options.making import LASER
from BalloonWorkbench.core.units import from_mm, number_text, to_mm, to_mm_per_minute

_CONTROLLERS = {"grbl": "GRBL", "marlin": "Marlin", "linuxcnc": "LinuxCNC"}


def drawing_gcode(drawing: Toolpaths, machine: Machine) -> bytes:
    """The file's content; the same bytes for the same drawing. Comments follow semicolons, in plain ASCII.

    Raises ExportError for what nobody but the user knows and has not told.
    """
    steps = moves(drawing, machine)
    assert machine.tool is not None  # moves has seen it
    return gcode(_header(laid(drawing, machine), machine, machine.tool), steps)


def gcode(header: Iterable[str], steps: Iterable[Instruction]) -> bytes:
    """The content of a file: what has to be known before it is run, and what a controller is told."""
    lines = [*(f"; {line}" for line in header), *map(_line, steps)]
    return ("\n".join(lines) + "\n").encode("ascii", "replace")


def _header(drawing: Toolpaths, machine: Machine, tool: MachineTool) -> Iterator[str]:
    """What has to be known before the file is run."""
    yield f"Balloon pattern for {_CONTROLLERS[machine.version]}, tool: {tool.kind}"
    yield "Units: millimetres (G21), feeds in mm/min. Coordinates: absolute (G90), arcs' centres from starts."
    yield "X0 Y0: lower left corner of the film, with room for the tool; Z0: the tool touches the film."
    width, height = (number_text(size, 6) for size in (drawing.width, drawing.height))
    yield f"It moves within X0 to X{width} and Y0 to Y{height}."
    along = sum(path.curve.length for path in drawing.paths)
    metres, between = (number_text(from_mm(length)) for length in (along, drawing.travel))
    yield f"{metres} m along lines, {between} m between them"
    yield f"Feed {number_text(to_mm_per_minute(tool.feed or 0.0), 6)} mm/min"
    if tool.depth is not None:
        depth, lifted = (number_text(to_mm(length), 4) for length in (tool.depth, tool.lift))
        yield f"Depth {depth} mm, lifted {lifted} mm"
    if tool.turning_axis:
        yield f"{tool.turning_axis}0: the tool points along X; it turns counter-clockwise seen from above."
    if tool.kind == LASER:
        yield f"Power {number_text(100.0 * (tool.power or 0.0))} %"
    yield from laser_settings(machine)
    if tool.temperature is not None:
        yield f"Temperature {number_text(tool.temperature - 273.15, 4)} C"


def laser_settings(machine: Machine) -> Iterator[str]:
    """What a controller must be set to where it has a laser."""
    if machine.tool is None or machine.tool.kind != LASER:
        return
    full = number_text(machine.tool.full_power, 6)
    yield f"S{full} is full power"
    if machine.version == GRBL:
        yield f"Laser mode must be on ($32=1), and $30={full}."


def _line(step: Instruction) -> str:
    words = " ".join(
        [step.name, *(f"{letter}{_number(value)}" for letter, value in step.words.items())]
    ).strip()
    return f"{words} ; {step.note}".strip() if step.note else words


def _number(value: float) -> str:
    text = f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
