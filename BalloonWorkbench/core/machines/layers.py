# SPDX-License-Identifier: LGPL-2.1-or-later
"""How each role looks where a machine does not say otherwise: in files, in pictures and in the 3D view; and
how a laser burns a layer, which only the user's own file of a machine says.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import from_mm, number_text


@dataclass(frozen=True)
class Layer:
    """How a role is drawn: AutoCAD colour index and RGB. Cutters go by the name or by one of the colours."""

    aci: int
    rgb: str


LAYERS = {
    Role.CUT: Layer(1, "#ff0000"),
    Role.CUT_INNER: Layer(5, "#0000ff"),
    Role.SEAL: Layer(6, "#ff00ff"),
    Role.WELD: Layer(3, "#00a000"),
    Role.NOTCH: Layer(30, "#ff8000"),
    Role.FOLD: Layer(150, "#0080ff"),
    Role.PEN: Layer(34, "#804000"),
    Role.ENGRAVE: Layer(7, "#000000"),
    Role.PRINT: Layer(8, "#808080"),
    Role.REGISTRATION: Layer(4, "#00ffff"),
}

#: LightBurn knows so many layers; the last two, T1 and T2, are tool layers: they are only shown.
PROJECT_LAYERS, TOOL_LAYER = 32, 30
LINE_TYPES = ("CONTINUOUS", "DASHED")
_LAYER_NAME = re.compile(r"[A-Za-z0-9_$-]{1,31}")
_COLOUR = re.compile(r"#[0-9a-f]{6}")
_SPOT = re.compile(r"[A-Za-z0-9_-]{0,31}")

#: Keys of a layer, and from where to where their values go.
LASER_KEYS = {
    "speed_mm_s": (0.01, 1e5),
    "max_power_percent": (0.1, 100.0),
    "min_power_percent": (0.0, 100.0),
    "passes": (1, 1000),
}


@dataclass(frozen=True)
class LaserSettings:
    """How a layer is burnt: speed [m/s]; shares of the full power, the least in corners; how often.

    What is None is left to the laser's program.
    """

    speed: float
    max_power: float
    min_power: float | None = None
    passes: int | None = None


@dataclass(frozen=True)
class Line:
    """How a role is written: layer, AutoCAD colour index, RGB colour, line type, pen of a plotter.

    In a LightBurn project the pen is the number of the layer, and laser how it is burnt, where users say so.
    In a PDF a spot is the colour of its own by which a print shop's program knows a line.
    """

    name: str
    aci: int
    rgb: str
    line: str
    pen: int
    laser: LaserSettings | None = None
    spot: str = ""

    @property
    def is_burnt(self) -> bool:
        """Whether a LightBurn project burns it: the tool layers are only shown."""
        return self.pen < TOOL_LAYER


def laser_settings(line: Mapping[str, Any], name: str) -> LaserSettings | None:
    """Those of a layer in a machine's file, None where it has none. InputError for such as no laser has."""
    values = {
        key: number_in(line[key], f"{key} of {name}", *LASER_KEYS[key]) for key in LASER_KEYS if key in line
    }
    if not values:
        return None
    for key in ("speed_mm_s", "max_power_percent"):
        if key not in values:
            raise InputError(f"the layer {name} lacks {key}: give speed and power together, or neither.")
    power = values["max_power_percent"]
    least, passes = values.get("min_power_percent"), values.get("passes")
    if least is not None and least > power:
        raise InputError(f"min_power_percent of {name} is more than max_power_percent: exchange the two.")
    if passes is not None and passes != int(passes):
        raise InputError(f"passes of {name} is {number_text(passes)}: give a whole number.")
    return LaserSettings(
        from_mm(values["speed_mm_s"]),
        0.01 * power,
        None if least is None else 0.01 * least,
        None if passes is None else int(passes),
    )


def number_in(value: object, what: str, low: float, high: float) -> float:
    """A number of a machine's file; InputError for what is none, and for one outside its range."""
    number = float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else float("nan")
    if not low <= number <= high:
        raise InputError(
            f"{what} is {value!r}: give a number from {number_text(low)} to {number_text(high)}."
        )
    return number


def check_laser(layers: Sequence[tuple[str, int, LaserSettings | None]], project: bool) -> None:
    """InputError for layers, by name, number and how they are burnt, that LightBurn does not have, or that
    cannot be burnt as it is said; project: they are those of a LightBurn project.
    """
    if project and any(number >= PROJECT_LAYERS for _, number, _ in layers):
        raise InputError(f"a LightBurn project has layers up to {PROJECT_LAYERS - 1}: change the pen.")
    for name, number, laser in layers:
        if laser is not None and not (project and number < TOOL_LAYER):
            raise InputError(
                f"{name} has a speed and a power, which only layers below {TOOL_LAYER} of a LightBurn"
                " project have: remove them."
            )
        if project and any(other == number and burnt != laser for _, other, burnt in layers):
            raise InputError(
                f"layer {number} of the LightBurn project has two speeds or powers: give its roles one."
            )


def layers_of(data: Mapping[str, Mapping[str, Any]]) -> dict[Role, Line]:
    """The layers that a machine's file describes. InputError for what is none."""
    if not data:
        raise InputError("no layer is written: name at least CUT.")
    layers = {}
    for key, line in data.items():
        role = Role(one_of(key, tuple(role.value for role in Role), "layer"))
        name, rgb = str(line.get("name", role.value)), str(line.get("rgb", LAYERS[role].rgb)).lower()
        if not _LAYER_NAME.fullmatch(name):
            raise InputError(f'the layer name "{name}" may have 1 to 31 of A-Z, a-z, 0-9, _, - and $ only.')
        if not _COLOUR.fullmatch(rgb):
            raise InputError(f'the colour "{rgb}" is not written like #ff0000.')
        aci, pen = int(line.get("aci", LAYERS[role].aci)), int(line.get("pen", 1))
        if not (1 <= aci <= 255 and 1 <= pen <= 255):
            raise InputError(f"colour index {aci} and pen {pen} of {name} must be from 1 to 255.")
        dashes = one_of(line.get("line", LINE_TYPES[0]), LINE_TYPES, "line")
        spot = str(line.get("spot", ""))
        if not _SPOT.fullmatch(spot):
            raise InputError(f'the spot colour "{spot}" may have letters, digits, _ and - only.')
        layers[role] = Line(name, aci, rgb, dashes, pen, laser_settings(line, name), spot)
    return layers


def one_of(value: object, choices: tuple[str, ...], what: str) -> str:
    """The value, which is one of the choices. InputError for another one."""
    if value not in choices:
        raise InputError(
            f'{what} "{value}" is none of {", ".join(choice or "(empty)" for choice in choices)}.'
        )
    return str(value)
