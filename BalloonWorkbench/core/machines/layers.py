# SPDX-License-Identifier: LGPL-2.1-or-later
"""How each role looks where a machine does not say otherwise: in files, in pictures and in the 3D view; and
how a laser burns a layer, which only the user's own file of a machine says.
"""

from __future__ import annotations

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

#: LightBurn knows so many layers; the last two, T1 and T2, are tool layers.
PROJECT_LAYERS, TOOL_LAYER = 32, 30

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
