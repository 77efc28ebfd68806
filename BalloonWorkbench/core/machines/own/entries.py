# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users set of a machine's file in a form: each entry once, with its name and unit, and what has it.

Ranges are where the file is read: machine.LIMITS and tool.py.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.layers import LASER_KEYS
from BalloonWorkbench.core.machines.machine import LIMITS, UNITS
from BalloonWorkbench.core.machines.tool import (
    AXES,
    GRBL,
    LINUXCNC,
    MARLIN,
    TURNED,
    TURNING_AXIS,
    MachineTool,
    read_tool,
    tool_data,
)
from BalloonWorkbench.core.options.making import HOT_TIP, HOT_WHEEL, KNIFE, LASER, SPINDLE, TOOLS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import number_text, parse_length, parse_temperature, to_mm

#: What a machine reads, by format and version.
_FORMATS = {
    "dxf R2000": "DXF",
    "dxf R12": "DXF (R12)",
    "svg": "SVG",
    "pdf": "PDF",
    "hpgl": "HPGL",
    "lbrn2": "LightBurn",
    "gcode grbl": "G-code (GRBL)",
    "gcode marlin": "G-code (Marlin)",
    "gcode linuxcnc": "G-code (LinuxCNC)",
}
#: What controllers call full power.
_FULL_POWER = {GRBL: 1000.0, MARLIN: 255.0, LINUXCNC: 100.0}
#: Formats whose unit may be chosen, and those that never have arcs.
_WITH_UNIT, _WITHOUT_ARCS = ("dxf", "svg"), ("hpgl", "gcode")
_HOT, _ALL = (HOT_TIP, HOT_WHEEL), tuple(TOOLS)
_TOLERANCE = 0.005  # mm, of G-code
_DIGITS = 6


def _always(_data: Mapping[str, Any]) -> bool:
    return True


@dataclass(frozen=True, eq=False)
class MachineEntry:
    """One value of a machine's file.

    key        in the file, or in its tool; label and tip for people
    unit       of a number
    titles     what may be chosen, with titles for people
    of_tool    the tools that have it; of the machine itself without any
    has        whether a machine's file has it
    """

    key: str
    label: str
    tip: str = ""
    unit: str = ""
    titles: Mapping[str, str] = field(default_factory=dict)
    of_tool: tuple[str, ...] = ()
    has: Callable[[Mapping[str, Any]], bool] = _always

    def applies(self, data: Mapping[str, Any]) -> bool:
        """Whether the machine that a file describes has this value."""
        of_tool = not self.of_tool or data.get("tool", {}).get("kind") in self.of_tool
        return of_tool and self.has(data)


def _welds(data: Mapping[str, Any]) -> bool:
    return any(role in data["layers"] for role in (Role.SEAL.value, Role.WELD.value))


def _cuts(data: Mapping[str, Any]) -> bool:
    return Role.CUT.value in data["layers"]


def _swivels(data: Mapping[str, Any]) -> bool:
    tool = data.get("tool", {})
    kind = tool.get("kind", KNIFE)
    return not tool.get(TURNING_AXIS) and (kind == HOT_WHEEL or (kind == KNIFE and _cuts(data)))


FORMAT, BED, NOTE = "format", "bed_mm", "note"
ENTRIES = (
    MachineEntry(FORMAT, label="Reads", titles=_FORMATS,
        tip="The files that it, or its program, opens"),
    MachineEntry("unit", label="Unit", titles={unit: unit for unit in UNITS},
        tip="Unit of the numbers in its files", has=lambda data: data["format"] in _WITH_UNIT),
    MachineEntry(BED, label="Bed",
        tip="What it can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit"),
    MachineEntry("kind", label="Tool", of_tool=_ALL, tip="What it holds",
        titles={KNIFE: "Knife", LASER: "Laser", SPINDLE: "Spindle", HOT_TIP: "Hot tip",
                HOT_WHEEL: "Hot wheel"}),
    MachineEntry("feed_mm_min", label="Feed", unit="mm/min", of_tool=_ALL,
        tip="How fast it goes along a line; empty: not known yet"),
    MachineEntry("power_percent", label="Power", unit="%", of_tool=(LASER,),
        tip="Share of the laser's full power; empty: not known yet"),
    MachineEntry("spindle_rpm", label="Spindle", unit="1/min", of_tool=(SPINDLE,),
        tip="Turns a minute; empty: not known yet"),
    MachineEntry("temperature_C", label="Temperature", unit="°C", of_tool=_HOT,
        tip="Of the tip or wheel, 40 to 400 °C. Above 260 °C a layer of PTFE gives off poisonous fumes"),
    MachineEntry("depth_mm", label="Depth", unit="mm", of_tool=_ALL,
        tip="How far below the place where it touches the film it works: it presses so hard, or cuts so"
        " deep; of a laser its focus. Empty: not known yet"),
    MachineEntry("lift_mm", label="Lift", unit="mm", of_tool=_ALL,
        tip="Height between two lines; empty: 5 mm"),
    MachineEntry("dwell_s", label="Dwell", unit="s", of_tool=_ALL,
        tip="How long it waits before it moves along a line: film warms, a beam burns in, a spindle starts"),
    MachineEntry("corner_feed_percent", label="Feed in corners", unit="%", of_tool=_ALL,
        tip="Share of the feed near corners and in narrow bends"),
    MachineEntry("lead_in_mm", label="Lead-in", unit="mm", of_tool=_HOT,
        tip="How long a way from waste film to a weld may be; 0 for none"),
    MachineEntry(TURNING_AXIS, label="Turning axis", titles={"": "None", **{axis: axis for axis in AXES}},
        of_tool=TURNED, has=lambda data: data["version"] != GRBL,
        tip="The axis that turns the wheel or knife along the path, 0 along X, counter-clockwise from above;"
        " none for one that swivels or is round"),
    MachineEntry("full_power", label="S at full power", of_tool=(LASER,),
        tip="The number that the controller takes for full power: $30 of GRBL"),
    MachineEntry("kerf_mm", label="Kerf", unit="mm", has=_cuts,
        tip="Width of film that the beam or cutter takes away: cuts are moved outward by half of it"),
    MachineEntry("knife_offset_mm", label="Knife offset", unit="mm", has=_swivels,
        tip="How far a swivel knife or wheel lies behind its axis; 0 where the machine makes up for it"),
    MachineEntry("overcut_mm", label="Overcut", unit="mm", has=_cuts,
        tip="How far a closed cut runs past its start; empty: six times the knife's offset"),
    MachineEntry("overrun_mm", label="Weld overrun", unit="mm", has=_welds,
        tip="How far a closed weld runs past its start, so that the joint is tight"),
    MachineEntry("control_bar", label="Bar of 100 mm to measure",
        tip="Beside the pattern, to see whether the size was kept",
        has=lambda data: Role.REGISTRATION.value in data["layers"]),
    MachineEntry(NOTE, label="Note",
        tip="What you want to read when you choose this machine, such as film and separating layer"),
)  # fmt: skip
TITLE = MachineEntry("title", label="Name", tip="Letters, digits, spaces and - only")


def entry_value(entry: MachineEntry, data: Mapping[str, Any]) -> Any:
    """What a field shows: the choice, yes or no, or text; of a number in its unit, empty if unknown."""
    if entry.key == FORMAT:
        return f"{data['format']} {data['version']}".strip()
    value = (data.get("tool", {}) if entry.of_tool else data).get(entry.key)
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return number_text(value, _DIGITS)
    return "" if value is None else value


def with_entry(data: Mapping[str, Any], entry: MachineEntry, value: Any) -> dict[str, Any]:
    """A machine's file with another value: as `entry_value` gives it, of a bed as parse_bed gives it.

    Raises InputError for a text that is none, or is out of range.
    """
    if entry.key == FORMAT:
        return _in_format(data, *value.split())
    if entry.key == BED:
        return {**data, BED: bed_data(value)}
    if entry.key == "kind":
        return _with_tool(data, value)
    if not entry.titles and isinstance(value, str) and entry.key != NOTE:
        value = entry_number(entry, value) if value.strip() else None
    if not entry.of_tool:
        return _put(data, entry.key, value)
    tool = _put(data["tool"], entry.key, value)
    turned = read_tool(tool).turning_axis
    return {**data, "tool": tool, **({"knife_offset_mm": 0} if turned else {})}


def _put(data: Mapping[str, Any], key: str, value: Any) -> dict[str, Any]:
    """With the value; what is left empty is as in a file without it, and a length that must be there is 0."""
    if value is None and key in LIMITS and key != "overcut_mm":
        value = 0.0
    return {other: known for other, known in data.items() if other != key} | (
        {} if value is None else {key: value}
    )


def entry_number(entry: MachineEntry, text: str) -> float:
    """The number that is typed, in the entry's unit or with one of its own. Raises InputError for none."""
    plain = text.replace(",", ".").strip()
    has_unit = bool(plain) and plain[-1] not in "0123456789."
    if entry.unit == "mm":
        number = to_mm(parse_length(plain if has_unit else f"{plain}mm"))
    elif entry.unit == "°C":
        number = parse_temperature(plain if has_unit else f"{plain}C") - 273.15
    else:
        number = _plain_number(entry, plain.removesuffix(entry.unit).strip())
    number = round(number, _DIGITS)
    low, high = LIMITS.get(entry.key, (-math.inf, math.inf))
    if not low <= number <= high:
        raise InputError(
            f"{entry.label}: {number_text(number, _DIGITS)} mm is out of range, give"
            f" {number_text(low)} to {number_text(high)} mm."
        )
    return number


def _plain_number(entry: MachineEntry, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise InputError(f"{entry.label}: '{text}' is no number, write one such as 20.")
    return number


def bed_data(size: tuple[float, float] | None) -> list[float | None] | None:
    """A bed [m] as a machine's file has it."""
    if size is None:
        return None
    width, height = (round(to_mm(length), _DIGITS) for length in size)
    return [width, None if math.isinf(height) else height]


def _with_tool(data: Mapping[str, Any], kind: str) -> dict[str, Any]:
    """With another tool and its lines: of the old one its lift stays, and the number for full power."""
    if kind == data["tool"]["kind"]:
        return dict(data)
    old = read_tool(data["tool"])
    tool = MachineTool(kind, lift=old.lift, full_power=old.full_power)
    layers = {role.value: data["layers"].get(role.value, {}) for role in tool.roles}
    return {**data, "tool": tool_data(tool), "layers": layers}


def _in_format(data: Mapping[str, Any], kind: str, version: str = "") -> dict[str, Any]:
    """In another format: what the old one alone has goes, and so does the note, which is about it."""
    made = {**data, "format": kind, "version": version}
    if version == GRBL and "tool" in made:
        made["tool"] = {key: value for key, value in made["tool"].items() if key != TURNING_AXIS}
    if kind == data["format"]:
        return made
    made |= {NOTE: "", "arcs": made["arcs"] and kind not in _WITHOUT_ARCS}
    made.pop("tolerance_mm", None)
    if kind not in _WITH_UNIT:
        made["unit"] = "mm"
    held = made.pop("tool", None)
    if held is not None:
        made["process"] = read_tool(held).process
    made["layers"] = {
        role: {key: value for key, value in line.items() if key not in ("pen", "spot", *LASER_KEYS)}
        | ({"pen": number} if kind == "lbrn2" else {})
        for number, (role, line) in enumerate(made["layers"].items(), 1)
    }
    if kind == "gcode":
        process = made.pop("process", "")
        tool = MachineTool(
            HOT_TIP if process == "heat-sealing" else LASER if process == "laser" else KNIFE,
            full_power=_FULL_POWER[version],
        )
        made["layers"] = {role.value: made["layers"].get(role.value, {}) for role in tool.roles}
        made |= {"tool": tool_data(tool), "tolerance_mm": _TOLERANCE}
    return made
