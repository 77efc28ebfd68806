# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as what a controller is told one after the other: G-code as data, for files and other programs.

Nothing happens below the lift height but along a line: the tool is lifted, or its beam is off, before each
way to the next line, and at the end it is made safe.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.tool import GRBL, LINUXCNC, MARLIN, MachineTool, lacking
from BalloonWorkbench.core.machines.toolpaths import Path, Toolpaths
from BalloonWorkbench.core.machines.writers.corners import slowed
from BalloonWorkbench.core.machines.writers.turning import angles_along
from BalloonWorkbench.core.options.making import LASER, SPINDLE
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, to_mm, to_mm_per_minute

#: Digits of coordinates [mm]; what is nearer together is one place for a controller.
DIGITS = 4
#: Arcs that rise less are lines; so are, within this, those too large for a controller's numbers [mm].
_RISE = 0.001
_LARGEST = 2000.0
#: The feed of every way down [mm/min]: no axis is slower.
_DOWN = 300.0
#: How fast an axis turns the tool where it stands [degrees/min].
_TURN = 3600.0
_MS = 1000.0


@dataclass(frozen=True)
class Instruction:
    """What a controller is told: a name such as G1, and its words; a note alone has no name.

    words  coordinates and centres [mm], A, B and C [degrees], F [mm/min], all others as the controller wants
           them
    """

    name: str = ""
    words: Mapping[str, float] = field(default_factory=dict)
    note: str = ""


def moves(drawing: Toolpaths, machine: Machine) -> list[Instruction]:
    """All of it, of a machine that holds a tool, see `laid`.

    Raises ExportError for what nobody but the user knows and has not told.
    """
    return moves_of([(laid(drawing, machine), machine)])


def moves_of(parts: Sequence[tuple[Toolpaths, Machine]]) -> list[Instruction]:
    """The same of several drawings, one after the other, each as it lies with settings of its own."""
    writers = [_writer(machine) for _, machine in parts]
    steps = [*writers[0].beginning(), *writers[0].ready()]
    for number, ((drawing, _), writer) in enumerate(zip(parts, writers, strict=True)):
        if number and list(writer.ready()) != list(writers[number - 1].ready()):
            steps += writer.ready()
        steps += [step for path in drawing.paths for step in writer.line(path)]
    return [*steps, *writers[-1].end()]


def laid(drawing: Toolpaths, machine: Machine) -> Toolpaths:
    """The drawing as it lies on the bed: upright, or turned to the left where it fits only so."""
    if machine.bed is None:
        return drawing
    size, bed = from_mm(np.array([drawing.width, drawing.height])), np.array(machine.bed)
    if (size <= bed).all() or not (size[::-1] <= bed).all():
        return drawing
    right = np.array([drawing.height, 0.0])
    paths = [replace(path, curve=_turned(path.curve, right)) for path in drawing.paths]
    return Toolpaths(tuple(paths), drawing.height, drawing.width)


def _turned(curve: Curve, shift: Floats) -> Curve:
    return Curve(perpendicular(curve.joints) + shift, curve.bulges, curve.closed)


def _writer(machine: Machine) -> _Writer:
    tool = machine.tool
    if tool is None:
        raise ExportError(f"{machine.title} reads no G-code: choose a machine that does.")
    missing = lacking(tool, machine.version)
    if missing:
        raise ExportError(missing)
    return _Writer(machine, tool)


class _Writer:
    """Says what a tool does, in the words of its controller."""

    def __init__(self, machine: Machine, tool: MachineTool) -> None:
        self._machine, self._tool = machine, tool
        self._controller = machine.version
        self._feed = round(to_mm_per_minute(tool.feed or 0.0), 3)
        self._laser = tool.kind == LASER
        self._turns = tool.kind in (LASER, SPINDLE)
        self._down = None if tool.depth is None else round(-to_mm(tool.depth), DIGITS) + 0.0
        self._up = round(to_mm(tool.lift), DIGITS)

    def beginning(self) -> Iterator[Instruction]:
        """Units and modes, the tool off and up."""
        yield Instruction("G21", note="millimetres")
        yield Instruction("G90", note="absolute coordinates")
        if self._controller != MARLIN:
            for name in ("G17", "G94", "G91.1", "G40", "G49", "G54"):
                yield Instruction(name)
        if self._controller == LINUXCNC:
            yield Instruction("G64", {"P": 0.005}, "how far corners are rounded")
        if self._turns:
            yield Instruction("M5", note="off")
        if not self._laser:
            yield Instruction("G0", {"Z": self._up}, "tool up")
        elif self._down is not None:
            yield Instruction("G0", {"Z": self._down}, "focus")

    def ready(self) -> Iterator[Instruction]:
        """The tool turning or hot, before it goes down."""
        tool = self._tool
        if tool.kind == SPINDLE and tool.spindle_speed is not None:
            yield Instruction("M3", {"S": round(60.0 * tool.spindle_speed, 3)})
            yield from self._dwell()
        if tool.is_hot and self._controller == MARLIN and tool.temperature is not None:
            celsius = round(tool.temperature - 273.15, 1)
            yield Instruction("M104", {"S": celsius}, "heat the tool")
            yield Instruction("M109", {"S": celsius}, "wait until it is hot")
        elif tool.is_hot:
            yield Instruction("M0", note="go on when the tool is hot")

    def line(self, path: Path) -> Iterator[Instruction]:
        """One line: there, down, along it, up."""
        curve, slow = path.curve, np.zeros(len(path.curve), dtype=bool)
        if self._tool.corner_feed < 1.0:
            curve, slow = slowed(curve)
        at = np.round(curve.joints[0], DIGITS) + 0.0
        yield Instruction(note=path.role.value)
        yield Instruction("G0", {"X": float(at[0]), "Y": float(at[1])})
        axis = self._tool.turning_axis
        starts, ends, lifted = angles_along(curve)
        if axis:
            yield Instruction("G0", {axis: _angle(starts[0])})
        yield from self._on()
        feed = 0.0
        for segment, is_slow in enumerate(slow):
            own_feed = round(self._feed * self._tool.corner_feed, 3) if is_slow else self._feed
            steps = list(_along(at, curve, segment))
            if axis and segment and steps and starts[segment] != ends[segment - 1]:
                yield from self._turned(starts[segment], bool(lifted[segment]))
                feed = 0.0
            for number, step in enumerate(steps, 1):
                words = dict(step.words)
                if axis and starts[segment] != ends[segment]:
                    turned = number / len(steps) * (ends[segment] - starts[segment])
                    words[axis] = _angle(starts[segment] + turned)
                if own_feed != feed:
                    feed = words["F"] = own_feed
                at = np.array([words["X"], words["Y"]])
                yield replace(step, words=words)
        yield from self._away()

    def _turned(self, angle: float, lifted: bool) -> Iterator[Instruction]:
        """The tool turned where it is."""
        turn = {self._tool.turning_axis: _angle(angle)}
        if lifted:
            yield from self._away()
            yield Instruction("G0", turn)
            yield from self._on()
        else:
            yield Instruction("G1", {**turn, "F": _TURN})

    def end(self) -> Iterator[Instruction]:
        """The tool up, off and back at the corner."""
        yield Instruction(note="end")
        if self._tool.is_hot and self._controller == MARLIN:
            yield Instruction("M104", {"S": 0.0}, "heater off")
        if not self._laser:
            yield Instruction("G0", {"Z": self._up})
        if self._turns:
            yield Instruction("M5")
        yield Instruction("G0", {"X": 0.0, "Y": 0.0})
        if self._tool.turning_axis:
            yield Instruction("G0", {self._tool.turning_axis: 0.0})
        if self._controller != MARLIN:
            yield Instruction("M2")

    def _on(self) -> Iterator[Instruction]:
        if self._laser:
            number = round((self._tool.power or 0.0) * self._tool.full_power, 3)
            # M4 of grbl's laser mode makes the beam weaker where the machine slows down
            yield Instruction("M4" if self._controller == GRBL else "M3", {"S": number})
        elif self._down is not None:
            yield Instruction("G1", {"Z": self._down, "F": _DOWN})
        if self._tool.kind != SPINDLE:
            yield from self._dwell()

    def _away(self) -> Iterator[Instruction]:
        yield Instruction("M5") if self._laser else Instruction("G0", {"Z": self._up})

    def _dwell(self) -> Iterator[Instruction]:
        if self._tool.dwell > 0.0:
            seconds = self._tool.dwell * (_MS if self._controller == MARLIN else 1.0)
            yield Instruction("G4", {"P": round(seconds, 3)})


def _angle(degrees: float) -> float:
    return float(np.round(degrees, DIGITS) + 0.0)


def _along(at: Floats, curve: Curve, segment: int) -> Iterator[Instruction]:
    """A segment of a curve, from the place (2,) that the controller is at; nothing where that is its end."""
    end, bulge = curve.ends[segment], float(curve.bulges[segment])
    radius = float(curve.radii[segment])
    rise = 0.5 * abs(bulge) * float(np.hypot(*(end - curve.starts[segment])))
    goal = np.round(end, DIGITS) + 0.0
    if rise < _RISE or radius > _LARGEST or np.array_equal(goal, at):
        piece = Curve(np.array([curve.starts[segment], end]), np.array([bulge]), False)
        for point in np.round(piece.flattened(_RISE)[1:], DIGITS) + 0.0:
            if not np.array_equal(point, at):
                yield Instruction("G1", {"X": float(point[0]), "Y": float(point[1])})
            at = point
        return
    heading = float(curve.headings[0][segment])
    centre = curve.starts[segment] + np.copysign(radius, bulge) * perpendicular(direction(heading))
    i, j = np.round(centre - at, DIGITS) + 0.0
    words = {"X": float(goal[0]), "Y": float(goal[1]), "I": float(i), "J": float(j)}
    yield Instruction("G3" if bulge > 0.0 else "G2", words)
