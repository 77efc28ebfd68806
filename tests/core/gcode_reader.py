# SPDX-License-Identifier: LGPL-2.1-or-later
"""G-code as a controller runs it: modal state, lines and arcs, units, what is on and how hot it is.

Written after the controllers' manuals, without ours: grbl 1.1 and LinuxCNC count dwells in seconds (P),
Marlin in milliseconds; a modal motion stays until another; arcs have I and J from their start and fail where
both radii differ by 0.005 mm; what a controller does not know is an error.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace

import numpy as np
import shapely

from BalloonWorkbench.core.machines.machine import Machine, holding, machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.units import parse_temperature

ROOM = 5.0  # mm round the pattern
LASER = ToolOptions("laser", feed=600.0, power=40.0)
KNIFE = ToolOptions("knife", feed=900.0, depth=1e-3)
SPINDLE = ToolOptions("spindle", feed=450.0, depth=5e-4, spindle_speed=12000.0)
HOT = ToolOptions("hot-tip", feed=300.0, tip_temperature=parse_temperature("180C"), depth=2e-4)
WHEEL = replace(HOT, tool="hot-wheel")

_WORD = re.compile(r"([A-Z])([+-]?(?:\d+\.?\d*|\.\d+))")
_SETTING = {
    "grbl": {"G17", "G90", "G94", "G91.1", "G40", "G49", "G54"},
    "linuxcnc": {"G17", "G90", "G94", "G91.1", "G40", "G49", "G54", "G43", "G64", "G80"},
    "marlin": {"G90"},
}
_SWITCHES = {
    "grbl": {"M0", "M2", "M3", "M4", "M5"},
    "linuxcnc": {"M0", "M2", "M3", "M5", "M6"},
    "marlin": {"M3", "M5", "M104", "M109"},
}
_UNITS = {"G20": 25.4, "G21": 1.0}
_CHORD = 5e-4


@dataclass
class Stroke:
    """A line along which the tool is at work: points mm with all of an arc's, feeds mm/min between them, and
    how an axis has turned the tool at each point, degrees."""

    points: list[np.ndarray]
    angles: list[float] = field(default_factory=list)
    feeds: list[float] = field(default_factory=list)
    power: float | None = None
    height: float | None = None
    dwell: float = 0.0

    @property
    def line(self) -> np.ndarray:
        return np.array(self.points)


@dataclass
class Run:
    """What a file does."""

    strokes: list[Stroke] = field(default_factory=list)
    places: list[tuple[float, float]] = field(default_factory=list)
    travel: list[tuple[float, float]] = field(default_factory=list)
    heights: list[float] = field(default_factory=list)
    heats: list[tuple[str, float, int]] = field(default_factory=list)
    codes: list[str] = field(default_factory=list)
    speeds: list[float] = field(default_factory=list)


class Controller:
    """Runs a file line by line; the tool is at work while its beam is on or it is below `touch`."""

    def __init__(self, kind: str, beam: bool) -> None:
        self.kind, self.beam = kind, beam
        self.at, self.z = np.zeros(2), None
        self.unit, self.absolute, self.motion = None, False, None
        self.feed, self.on, self.spindle = None, False, 0.0
        self.run, self.dwell = Run(), 0.0
        self.ended, self.stroke = False, None
        self.angle = 0.0

    def read(self, content: bytes) -> Run:
        for row in content.decode("ascii").splitlines():
            text = re.sub(r"\(.*?\)|;.*", "", row).strip().replace(" ", "")
            if text:
                assert not self.ended, "after the end"
                self._row(text)
        assert self.ended or self.kind == "marlin"
        return self.run

    @property
    def down(self) -> bool:
        return self.on if self.beam else self.z is not None and self.z <= 0.2

    def _row(self, text: str) -> None:
        words = _WORD.findall(text)
        assert "".join(letter + number for letter, number in words) == text, text
        codes = [f"{letter}{number.removeprefix('0') or '0'}" for letter, number in words if letter in "GM"]
        values = {letter: float(number) for letter, number in words if letter not in "GM"}
        assert len(values) + len(codes) == len(words), text
        for code in codes:
            self.run.codes.append(code)
            if code in ("G0", "G1", "G2", "G3"):
                self.motion = code
        for code in codes:
            self._setting(code, values)
        if "F" in values:
            assert values["F"] > 0.0, text
            self.feed = values["F"] * self.unit
        axes = set(values) & set("ABC")
        assert self.kind != "grbl" or not axes, text
        if set(values) & set("XYZIJ"):
            self._move(values)
        elif axes:
            self._turn(values)

    def _setting(self, code: str, values: dict[str, float]) -> None:
        if code in _UNITS:
            self.unit = _UNITS[code]
        elif code == "G4":
            self.dwell += values["P"] / (1000.0 if self.kind == "marlin" else 1.0)
        elif code in ("M104", "M109"):
            self.run.heats.append((code, values["S"], len(self.run.strokes)))
        elif code in ("M3", "M4"):
            self.on, self.spindle = True, values["S"]
            self.run.speeds.append(values["S"])
        elif code == "M5":
            self.on, self.stroke = False, None
        elif code == "M2":
            self.ended = True
        elif code not in ("G0", "G1", "G2", "G3", "M0", "M6"):
            assert code in _SETTING[self.kind], code
        if code == "G90":
            self.absolute = True
        if code.startswith("M"):
            assert code in _SWITCHES[self.kind], code

    def _turn(self, values: dict[str, float]) -> None:
        """The tool turns where it is: at work by small angles only."""
        (self.angle,), before = (values[axis] for axis in values if axis in "ABC"), self.angle
        assert self.motion == ("G1" if self.down else "G0")
        assert not self.down or abs(self.angle - before) <= 20.0, "it scuffs the film"

    def _move(self, values: dict[str, float]) -> None:
        assert self.absolute and self.unit, "units and coordinates are not stated"
        goal = np.array([values.get("X", self.at[0] / self.unit), values.get("Y", self.at[1] / self.unit)])
        goal = goal * self.unit
        if set(values) & set("XYIJ"):
            assert "Z" not in values or values["Z"] * self.unit == self.z, "down and along at once"
        elif "Z" in values:
            self.z = values["Z"] * self.unit
            self.run.heights.append(self.z)
            if not self.down:
                self.stroke = None
            return
        points = [goal]
        if self.motion in ("G2", "G3"):
            points = self._arc(goal, np.array([values["I"], values["J"]]) * self.unit)
        if self.motion == "G0":
            assert not self.down, "a way to the next line with the tool at work"
            self.run.travel.append((float(np.hypot(*(goal - self.at))), self.z))
            self.dwell = 0.0
        else:
            assert self.feed, "no feed"
            assert self.down, "a line without the tool"
            if self.stroke is None:
                self.stroke = Stroke(
                    [self.at], [self.angle], power=self.spindle, height=self.z, dwell=self.dwell
                )
                self.run.strokes.append(self.stroke)
            assert any(np.hypot(*(point - self.at)) > 0.0 for point in points), "no way"
            goal_angle = next((values[axis] for axis in values if axis in "ABC"), self.angle)
            shares = np.arange(1, len(points) + 1) / len(points)
            self.stroke.angles += (self.angle + shares * (goal_angle - self.angle)).tolist()
            self.angle = goal_angle
            self.stroke.points += points
            self.stroke.feeds += [self.feed] * len(points)
        self.run.places += [tuple(point) for point in points]
        self.at = goal

    def _arc(self, goal: np.ndarray, centre: np.ndarray) -> list[np.ndarray]:
        middle = self.at + centre
        first, last = self.at - middle, goal - middle
        radius = np.hypot(*first)
        assert abs(np.hypot(*last) - radius) < 0.005, "no arc"
        turn = np.arctan2(first[0] * last[1] - first[1] * last[0], first @ last)
        turn %= 2.0 * np.pi * (1.0 if self.motion == "G3" else -1.0)
        turn = turn or 2.0 * np.pi
        count = max(2, int(np.ceil(abs(turn) / np.sqrt(8.0 * _CHORD / radius))))
        angles = np.arctan2(first[1], first[0]) + turn * np.arange(1, count) / count
        return [middle + radius * np.array([np.cos(angle), np.sin(angle)]) for angle in angles] + [goal]


def held(controller: str, wishes: ToolOptions, **changes: object) -> Machine:
    return replace(holding(machine(f"gcode-{controller}"), wishes), **{"bed": None, **changes})


def run(pattern: Pattern, made_for: Machine) -> Run:
    return Controller(made_for.version, made_for.tool.kind == "laser").read(machine_file(pattern, made_for))


def lines_of(pattern: Pattern, *roles: Role) -> list[shapely.Geometry]:
    """Contours where a file has them [mm], straight from the pattern's points."""
    low = pattern.bounds[0]
    return [
        (shapely.LinearRing if each.closed else shapely.LineString)((each.points - low) * 1e3 + ROOM)
        for role in roles
        for each in pattern.of(role)
    ]


def film_of(pattern: Pattern) -> shapely.Geometry:
    cuts, holes = (map(shapely.Polygon, lines_of(pattern, role)) for role in (Role.CUT, Role.CUT_INNER))
    return shapely.union_all([*cuts]).difference(shapely.union_all([*holes]))
