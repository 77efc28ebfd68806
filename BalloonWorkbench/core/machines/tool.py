# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool of a machine that reads G-code: what it does along which lines, and how fast, hot and deep.

Speed, power, temperature and height belong to a tool and a film. Nobody knows them but the user: what is
not given is asked for, never assumed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, NamedTuple

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.making import (
    HOT_TIP,
    HOT_WHEEL,
    KNIFE,
    LASER,
    SPINDLE,
    TOOLS,
    ToolOptions,
)
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import (
    from_mm,
    from_mm_per_minute,
    length_text,
    number_text,
    parse_temperature,
    seconds_text,
    speed_text,
    temperature_text,
    to_mm,
    to_mm_per_minute,
)

#: Controllers whose G-code we write.
GRBL, MARLIN, LINUXCNC = CONTROLLERS = "grbl", "marlin", "linuxcnc"
_HOT = (HOT_TIP, HOT_WHEEL)
#: Axes by which a controller turns a tool, what may be turned, and their key in a machine's file.
AXES, TURNED = ("A", "B", "C"), (KNIFE, HOT_WHEEL)
TURNING_AXIS = "turning_axis"
#: What a machine does to the film, see machine.PROCESSES.
_PROCESS = {LASER: "laser", HOT_TIP: "heat-sealing", HOT_WHEEL: "heat-sealing"}
_CUTS = tuple(role for role in Role if role.is_cut)
WELDS = (Role.SEAL, Role.WELD)


@dataclass(frozen=True)
class MachineTool:
    """What a machine holds; None is not known.

    kind           one of TOOLS
    feed           along a line [m/s], corner_feed the share of it near corners and in narrow bends
    power          share of a laser's full power, for which the controller is told the number full_power
    spindle_speed  [1/s]
    temperature    of a hot tip or wheel [K]
    depth          at work below where it touches the film [m]: 0 touches it; a laser's focus may be above
    lift           height between lines [m]
    dwell          before it moves along a line: a laser burns in, a hot tip warms the film, a spindle
                   starts [s]
    lead_in        how long a way from waste film to a weld may be, 0 for none [m]
    turning_axis   the axis that turns a knife or wheel along the path, one of AXES; "" for none
    """

    kind: str
    feed: float | None = None
    power: float | None = None
    spindle_speed: float | None = None
    temperature: float | None = None
    depth: float | None = None
    lift: float = from_mm(5.0)
    dwell: float = 0.0
    corner_feed: float = 1.0
    lead_in: float = from_mm(30.0)
    full_power: float = 1000.0
    turning_axis: str = ""

    @property
    def is_hot(self) -> bool:
        """Whether it welds, not cuts."""
        return self.kind in _HOT

    @property
    def roles(self) -> tuple[Role, ...]:
        """The lines that it goes along."""
        return WELDS if self.is_hot else _CUTS

    @property
    def process(self) -> str:
        """What it does to the film, one of machine.PROCESSES."""
        return _PROCESS.get(self.kind, "")


class _Value(NamedTuple):
    """A value of a tool: its key in a machine's file, its range, how numbers of that file are read, written
    and shown, what it is called, and how it is typed on the command line where it can be."""

    key: str
    least: float
    most: float
    read: Callable[[float], float]
    write: Callable[[float], float]
    show: Callable[[float], str]
    what: str
    flag: str = ""


def _percent_text(share: float) -> str:
    return f"{number_text(100.0 * share)} %"


_VALUES = {
    "feed": _Value("feed_mm_min", from_mm_per_minute(1.0), from_mm_per_minute(1e5), from_mm_per_minute,
        to_mm_per_minute,
        speed_text, "feed", "--feed 600 for 600 mm/min"),
    "power": _Value("power_percent", 0.001, 1.0, lambda percent: 0.01 * percent,
        lambda share: 100.0 * share, _percent_text, "power",
        "--power 40 for 40 %"),
    "spindle_speed": _Value("spindle_rpm", 0.1, 2000.0, lambda turns: turns / 60.0,
        lambda turns: 60.0 * turns,
        lambda turns: f"{number_text(60.0 * turns)} turns a minute", "speed of the spindle",
        "--spindle-speed 12000"),
    "temperature": _Value("temperature_C", parse_temperature("40C"), parse_temperature("400C"),
        lambda celsius: parse_temperature(f"{celsius}C"), lambda kelvin: kelvin - 273.15,
        temperature_text, "temperature",
        "--tip-temperature 180C"),
    "depth": _Value("depth_mm", from_mm(-50.0), from_mm(50.0), from_mm, to_mm, length_text,
        "depth", "--depth 0.2mm"),
    "lift": _Value("lift_mm", from_mm(0.5), from_mm(100.0), from_mm, to_mm, length_text, "lift of the tool"),
    "dwell": _Value("dwell_s", 0.0, 10.0, float, float, seconds_text, "dwell"),
    "corner_feed": _Value("corner_feed_percent", 0.1, 1.0, lambda percent: 0.01 * percent,
        lambda share: 100.0 * share, _percent_text, "feed in corners"),
    "lead_in": _Value("lead_in_mm", 0.0, from_mm(200.0), from_mm, to_mm, length_text, "lead-in"),
    "full_power": _Value("full_power", 1.0, 1e5, float, float, number_text, "number for full power"),
}  # fmt: skip

#: What fields of ToolOptions are called here, where that differs.
_OF_OPTIONS = {"tip_temperature": "temperature"}
_DIGITS = 6

_NEEDS = {
    LASER: ("feed", "power"),
    SPINDLE: ("feed", "spindle_speed", "depth"),
    KNIFE: ("feed", "depth"),
    HOT_TIP: ("feed", "temperature", "depth"),
    HOT_WHEEL: ("feed", "temperature", "depth"),
}
#: As whose values they are asked for.
_NAMES = {LASER: "laser", SPINDLE: "spindle", KNIFE: "knife", HOT_TIP: "hot tip", HOT_WHEEL: "hot wheel"}


def read_tool(data: Mapping[str, Any]) -> MachineTool:
    """The tool that a machine's file describes, checked; null is not known.

    Raises InputError that names the key.
    """
    known = {value.key: name for name, value in _VALUES.items()}
    strange = sorted(set(data) - {"kind", TURNING_AXIS, *known})
    if strange:
        keys = ", ".join([*known, TURNING_AXIS])
        raise InputError(f'nobody knows "{strange[0]}" of a tool: it may be one of {keys}.')
    if data.get("kind") not in TOOLS:
        raise InputError(f'the tool "{data.get("kind")}" is none of {", ".join(TOOLS)}.')
    values: dict[str, Any] = {TURNING_AXIS: _axis(data)}
    for key, number in data.items():
        if key in ("kind", TURNING_AXIS) or number is None:
            continue
        if isinstance(number, bool) or not isinstance(number, (int, float)):
            raise InputError(f"{key} is {number!r}: give a number.")
        values[known[key]] = _VALUES[known[key]].read(number)
    return _checked(MachineTool(str(data["kind"]), **values))


def _axis(data: Mapping[str, Any]) -> str:
    axis = data.get(TURNING_AXIS) or ""
    if axis not in ("", *AXES):
        raise InputError(f"{TURNING_AXIS} is {axis!r}: give {', '.join(AXES)}, or leave it out.")
    if axis and data["kind"] not in TURNED:
        raise InputError(f"No axis turns a {_NAMES[data['kind']]}: leave {TURNING_AXIS} out.")
    return str(axis)


def tool_data(tool: MachineTool) -> dict[str, Any]:
    """What a machine's file has of a tool; `read_tool` gives the same tool again."""
    values = {name: getattr(tool, name) for name in _VALUES}
    known = {name: value for name, value in values.items() if value is not None}
    axis = {TURNING_AXIS: tool.turning_axis} if tool.turning_axis else {}
    return {"kind": tool.kind, **axis} | {
        _VALUES[name].key: round(_VALUES[name].write(value), _DIGITS) for name, value in known.items()
    }


def file_key(option: str) -> str:
    """The key in a machine's file of what a field of ToolOptions sets."""
    return _VALUES[_OF_OPTIONS.get(option, option)].key if option != "tool" else "kind"


def value_text(tool: MachineTool, option: str) -> str:
    """The value of a tool that a field of ToolOptions sets, for people; empty where it is not known."""
    name = _OF_OPTIONS.get(option, option)
    value = getattr(tool, name)
    return "" if value is None else _VALUES[name].show(value)


def settings_text(tool: MachineTool, say: Say = in_english) -> str:
    """What only the user knows of a tool, as far as it is known, for people, in their language."""
    known = [name for name in _NEEDS[tool.kind] if getattr(tool, name) is not None]
    return ", ".join(f"{say(_VALUES[name].what)} {_VALUES[name].show(getattr(tool, name))}" for name in known)


def changed(tool: MachineTool, wishes: ToolOptions) -> MachineTool:
    """The tool with what the user wishes; of another kind nothing that the file says of its own stays.

    Raises InputError for what makes no sense.
    """
    if wishes.tool is not None and wishes.tool != tool.kind:
        tool = MachineTool(wishes.tool, lift=tool.lift, full_power=tool.full_power)
    typed = {"feed": wishes.feed, "power": wishes.power, "spindle_speed": wishes.spindle_speed}
    values: dict[str, Any] = {
        name: _VALUES[name].read(number) for name, number in typed.items() if number is not None
    }
    measured = {"temperature": wishes.tip_temperature, "depth": wishes.depth}
    values |= {name: value for name, value in measured.items() if value is not None}
    return _checked(replace(tool, **values))


def _checked(tool: MachineTool) -> MachineTool:
    for field in fields(tool):
        number, value = getattr(tool, field.name), _VALUES.get(field.name)
        if value is not None and number is not None and not value.least <= number <= value.most:
            raise InputError(
                f"The {value.what} of a {_NAMES[tool.kind]} must be from {value.show(value.least)} to"
                f" {value.show(value.most)}."
            )
    if tool.depth is not None and tool.kind != LASER and not tool.lift > -tool.depth:
        raise InputError(
            f"At work the {_NAMES[tool.kind]} is {length_text(-tool.depth)} above the film, and lifted"
            f" {length_text(tool.lift)} only: give it more depth, or a higher lift_mm."
        )
    return tool


def lacking(tool: MachineTool, controller: str) -> str:
    """A sentence about what has to be given before there can be a file; empty where nothing lacks.

    Only Marlin heats a tip itself; beside other controllers something else does.
    """
    missing = [_VALUES[name] for name in needed(tool.kind, controller) if getattr(tool, name) is None]
    if not missing:
        return ""
    return (
        f"Nobody but you knows the {_listed([value.what for value in missing])} of your {_NAMES[tool.kind]}"
        " for this film: fill in My machines in FreeCAD, or give"
        f" {_listed([value.flag for value in missing])}."
    )


def needed(kind: str, controller: str) -> list[str]:
    """The values that a kind of tool cannot do without."""
    return [name for name in _NEEDS[kind] if name != "temperature" or controller == MARLIN]


def _listed(words: list[str]) -> str:
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
