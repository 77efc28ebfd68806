# SPDX-License-Identifier: LGPL-2.1-or-later
"""With which settings the first welds of a film are tried, where a source states them.

They are start values: what welds best belongs to a tool and a roll of film, and comes from a test card.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import (
    from_mm_per_minute,
    number_text,
    parse_temperature,
    seconds_text,
    speed_text,
    temperature_text,
    to_mm_per_minute,
)

FILE = RESOURCES / "separating-layers.json"
#: The layer that chars, and the one that gives off poisonous fumes, when it gets too hot.
PAPER, PTFE = "baking paper", "PTFE"


@dataclass(frozen=True)
class StartRange:
    """From the least to the most that a source states, in SI units; equal where it states one value."""

    least: float
    most: float
    source: str

    def text(self, show: Callable[[float], str]) -> str:
        """Both ends for people, or the one value."""
        one, other = show(self.least), show(self.most)
        return one if one == other else f"{one}–{other}"


@dataclass(frozen=True)
class StartValues:
    """What sources state for the welds of a film; None is not known.

    bar_temperature   of a heated bar or an iron that presses [K], dwell how long it does [s]
    tip_temperature   of a hot tip that moves along the weld [K], tip_speed how fast [m/s]
    separating_layer  what lies between the hot tool and the film, "" where that is not known
    layer_source      who says so
    """

    bar_temperature: StartRange | None = None
    dwell: StartRange | None = None
    tip_temperature: StartRange | None = None
    tip_speed: StartRange | None = None
    separating_layer: str = ""
    layer_source: str = ""

    @property
    def is_known(self) -> bool:
        """Whether there is a temperature to begin with."""
        return self.bar_temperature is not None or self.tip_temperature is not None

    def sentence(self, say: Say = in_english) -> str:
        """All of it for people, in their language; empty where nothing is known."""
        bar, dwell, tip, speed = self.bar_temperature, self.dwell, self.tip_temperature, self.tip_speed
        still = [
            say(f"bar or iron {bar.text(temperature_text)}") if bar else "",
            say(f"pressed for {dwell.text(seconds_text)}") if dwell else "",
        ]
        moved = [
            say(f"hot tip at {tip.text(temperature_text)}") if tip else "",
            say(f"moved at {speed.text(speed_text)}") if speed else "",
        ]
        layer = self.separating_layer
        through = say(f"through a layer of {say(layer)}") if layer else ""
        return "; ".join(filter(None, [*(", ".join(filter(None, each)) for each in (still, moved)), through]))

    @property
    def sources(self) -> tuple[str, ...]:
        """Who states them, each once, in short: what stands before the colon."""
        ranges = (self.bar_temperature, self.dwell, self.tip_temperature, self.tip_speed)
        said = [each.source for each in ranges if each is not None]
        return tuple(dict.fromkeys(_short(each) for each in (*said, self.layer_source) if each))


NOT_STATED = StartValues()


def _short(source: str) -> str:
    return source.partition(": ")[0]


class _Key(NamedTuple):
    """A range in a film's file: how its numbers are read and shown, and what they may be."""

    name: str
    read: Callable[[float], float]
    write: Callable[[float], float]
    show: Callable[[float], str]
    least: float
    most: float


def _kelvin(celsius: float) -> float:
    return parse_temperature(f"{celsius}C")


def _celsius(kelvin: float) -> float:
    return round(kelvin - _kelvin(0.0), 6)


def _same(number: float) -> float:
    return number


_KEYS = {
    "bar_temperature_C": _Key("bar_temperature", _kelvin, _celsius, temperature_text, 40.0, 400.0),
    "dwell_s": _Key("dwell", _same, _same, seconds_text, 0.01, 600.0),
    "tip_temperature_C": _Key("tip_temperature", _kelvin, _celsius, temperature_text, 40.0, 400.0),
    "tip_speed_mm_min": _Key(
        "tip_speed", from_mm_per_minute, to_mm_per_minute, speed_text, 1.0, 100000.0
    ),
}  # fmt: skip
_LAYER = "separating_layer"


@cache
def separating_layers() -> dict[str, float]:
    """What may lie between a hot tool and film, and which temperature it bears [K].

    Raises InputError when the data file is broken.
    """
    try:
        return {str(each["name"]): _kelvin(float(each["bears_C"])) for each in read_data(FILE)["layers"]}
    except UNUSABLE as error:
        raise InputError(f"The file {FILE.name} is of no use: {error!r}. Install it anew.") from error


def read_start_values(data: Any) -> StartValues:
    """The start values that a film's file states, each with its source, checked.

    Raises InputError that names the key: for what nobody knows, what has no source, and temperatures that
    the separating layer does not bear.
    """
    if not isinstance(data, dict):
        raise InputError(f"start_values are {data!r}: give the values with their sources, or leave them out.")
    known = (*_KEYS, _LAYER)
    strange = sorted(set(data) - set(known))
    if strange:
        raise InputError(f'nobody knows the start value "{strange[0]}": it may be one of {", ".join(known)}.')
    values: dict[str, Any] = {
        _KEYS[key].name: _range(key, *_sourced(key, entry)) for key, entry in data.items() if key != _LAYER
    }
    if _LAYER in data:
        layer, source = _sourced(_LAYER, data[_LAYER])
        if layer not in tuple(separating_layers()):
            raise InputError(
                f'the separating layer "{layer}" is none of {", ".join(separating_layers())}: take one.'
            )
        values |= {"separating_layer": layer, "layer_source": source}
    read = StartValues(**values)
    _check_layer(read)
    return read


def _sourced(key: str, entry: Any) -> tuple[Any, str]:
    if not isinstance(entry, dict) or set(entry) != {"value", "source"}:
        raise InputError(f'{key} is {entry!r}: write it as {{"value": ..., "source": "who says so"}}.')
    source = entry["source"]
    if not isinstance(source, str) or not source.strip():
        raise InputError(f"{key} lacks its source: write who states it. What nobody states is left out.")
    return entry["value"], source


def _range(key: str, value: Any, source: str) -> StartRange:
    of = _KEYS[key]
    numbers = value if isinstance(value, list) else [value, value]
    if len(numbers) != 2 or not all(
        isinstance(number, (int, float)) and not isinstance(number, bool) for number in numbers
    ):
        raise InputError(f"{key} is {value!r}: give a number, or [least, most].")
    least, most = map(float, numbers)
    if not of.least <= least <= most <= of.most:
        raise InputError(
            f"{key} is {value!r}: give numbers from {number_text(of.least)} to {number_text(of.most)}, the"
            " smaller one first."
        )
    return StartRange(of.read(least), of.read(most), source)


def _check_layer(values: StartValues) -> None:
    """A temperature at which the separating layer burns or gives off fumes is nothing to begin with."""
    borne = separating_layers()
    layer = values.separating_layer or max(borne, key=lambda name: borne[name])
    for key, of in _KEYS.items():
        stated = getattr(values, of.name)
        if of.read is _kelvin and stated is not None and stated.most > borne[layer]:
            raise InputError(
                f"{key} goes up to {of.show(stated.most)}, and {layer} bears {of.show(borne[layer])}: give"
                " less."
            )


def start_values_data(values: StartValues) -> dict[str, Any]:
    """What a film's file has of them; `read_start_values` gives the same again."""
    data: dict[str, Any] = {}
    for key, of in _KEYS.items():
        stated = getattr(values, of.name)
        if stated is not None:
            ends = [of.write(stated.least), of.write(stated.most)]
            data[key] = {"value": ends, "source": stated.source}
    if values.separating_layer:
        data[_LAYER] = {"value": values.separating_layer, "source": values.layer_source}
    return data
