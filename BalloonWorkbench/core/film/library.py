# SPDX-License-Identifier: LGPL-2.1-or-later
"""The films we know, read from resources/films, and films of the user's own."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data, reason_of
from BalloonWorkbench.core.film.film import ASSUMED, BY_USER, JOININGS, LOOKS, Film, Look
from BalloonWorkbench.core.film.start_values import NOT_STATED, StartValues, read_start_values
from BalloonWorkbench.core.options.film import DEFAULT_FILM  # noqa: F401 - it is the name of one of them
from BalloonWorkbench.core.units import number_text, pressure_text

FOLDER = RESOURCES / "films"

_TYPICAL_DENSITY = 1200.0  # kg/m3; polymer films lie between 900 and 1400


def films() -> dict[str, Film]:
    """All films of the library by name, in alphabetical order.

    Raises InputError when a data file is broken.
    """
    return dict(_library())


def film(name: str) -> Film:
    """The film of this name, capitals and spaces do not matter, or the one that a file (.json) describes.

    Raises InputError with the known names when there is none.
    """
    if name.lower().endswith(".json"):
        return read_film(Path(name))
    known = _library()
    named = known.get("-".join(name.lower().split()))
    if named is None:
        raise InputError(f'There is no film "{name}": choose one of {", ".join(known)}.')
    return named


def film_data(name: str) -> dict[str, Any]:
    """What the file of a film says, by its name or that of the file. Raises InputError as `film` does."""
    path = Path(name)
    if not name.lower().endswith(".json"):
        path = FOLDER / f"{film(name).name}.json"
    read_film(path)
    return dict(read_data(path))


def custom_film(young: float, poisson: float, thickness: float, areal_density: float | None = None) -> Film:
    """A film of the user's own: Young's modulus [Pa], Poisson's ratio, thickness [m], areal density [kg/m2].

    Without an areal density that of a typical polymer (1200 kg/m3) is assumed.
    Raises InputError when a value is outside what any film can have.
    """
    if areal_density is None:
        areal_density = _TYPICAL_DENSITY * _thickness(thickness)
    return Film(
        name="custom",
        young_modulus=_within(young, 1e5, 1e12, "Young's modulus", "Pa", "3000000000"),
        poisson_ratio=_poisson(poisson),
        thickness=_thickness(thickness),
        areal_density=_within(areal_density, 1e-4, 20.0, "areal density", "kg/m2", "0.035"),
        title="Film of your own",
    )


def with_grain(film: Film, young_across: float, angle: float = 0.0) -> Film:
    """The film with another Young's modulus [Pa] across its grain, which runs at an angle [rad] from x.

    Raises InputError for a modulus beyond what any film of this Poisson's ratio can have: its energy would
    not be positive (Jones, Mechanics of Composite Materials, 2.4).
    """
    across = _within(young_across, 1e5, 1e12, "Young's modulus across the grain", "Pa", "2000000000")
    if film.poisson_ratio**2 * across >= 0.99 * film.young_modulus:
        raise InputError(
            f"The Young's modulus across the grain {pressure_text(across)} is too large for one along it of "
            f"{pressure_text(film.young_modulus)}: turn the grain by 90 degrees and exchange the two."
        )
    if not math.isfinite(angle):
        raise InputError(
            f"The grain's angle {number_text(angle)} is no number: give degrees from the x axis."
        )
    # whole turns change nothing
    return replace(film, young_modulus_across=across, grain_angle=math.fmod(angle, math.tau))


def with_weld(film: Film, rigidity: float) -> Film:
    """The film with another rigidity of its welds, see Film; its own keeps its source.

    Raises InputError for one that no weld has.
    """
    if _weld_rigidity(rigidity) == film.weld_rigidity:
        return film
    return replace(film, weld_rigidity=rigidity, weld_rigidity_source=BY_USER)


@cache
def _library() -> dict[str, Film]:
    return {path.stem: read_film(path) for path in sorted(FOLDER.glob("*.json"))}


def read_film(path: Path) -> Film:
    """The film described by a data file, checked; its keys carry their units.

    Raises InputError that names the file when something is missing, mistyped or out of range.
    """
    try:
        described = _film_of(read_data(path))
    except KeyError as error:
        raise InputError(f"The film file {path.name} lacks {error}: add it.") from error
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"The film file {path.name} is of no use: {reason_of(error)}") from error
    if described.name != path.stem:
        raise InputError(
            f'The film file {path.name} calls itself "{described.name}": give both the same name.'
        )
    return described


def _film_of(data: dict[str, Any]) -> Film:
    own = custom_film(
        float(data["young_modulus_Pa"]),
        float(data["poisson_ratio"]),
        float(data["thickness_m"]),
        float(data["areal_density_kg_m2"]),
    )
    low, high = map(float, data["young_modulus_range_Pa"])
    _within(own.young_modulus, low, high, "Young's modulus", "Pa, its own range", number_text(low))
    return replace(
        own,
        name=str(data["name"]),
        seal_width=_within(float(data["seal_width_m"]), 0.0, 0.1, "seal width", "m", "0.005"),
        max_stress=_within(float(data["max_stress_Pa"]), 1e4, 1e11, "strength", "Pa", "100000000"),
        title=str(data["title"]),
        look=_look(**data["look"]),
        **_weld(data.get("weld_rigidity", {"value": 1.0, "source": ASSUMED})),
        sealing_side=_sealing_side(data.get("sealing_side")),
        grain=_truth(data, "grain", False),
        joining=_joining(data.get("joining", "")),
        one_side=_truth(data, "one_side", False),
        some_grades=_truth(data, "some_grades", False),
        laser=_truth(data, "laser", None),
        start_values=_start_values(data),
        note=str(data["note"]),
        sources=tuple(str(source) for source in data["sources"]),
    )


def _sealing_side(value: object) -> str | None:
    if value is not None and not (isinstance(value, str) and re.fullmatch(r"[\w/-]{1,20}", value)):
        raise InputError(f'the sealing side {value!r} is no polymer: give one such as "PE", or "none".')
    return value


def _look(kind: str, colour: str, opacity: float) -> Look:
    if kind not in LOOKS:
        raise InputError(f'There is no look "{kind}": choose one of {", ".join(LOOKS)}.')
    if not re.fullmatch("#[0-9a-f]{6}", colour):
        raise InputError(f'"{colour}" is no colour: give one such as "#cc294d".')
    return Look(kind, colour, _within(opacity, 0.05, 1.0, "opacity", "", "1"))


def _weld(data: dict[str, Any]) -> dict[str, Any]:
    value, source = data["value"], data["source"]
    if not (isinstance(source, str) and source.strip()):
        raise InputError('the weld rigidity lacks its source: write where it is from, or "assumed".')
    return {"weld_rigidity": _weld_rigidity(float(value)), "weld_rigidity_source": source}


def _weld_rigidity(value: float) -> float:
    return _within(value, 1e-6, 10.0, "weld rigidity", "times that of flat film", "1")


def _joining(way: object) -> str:
    if way not in JOININGS:
        raise InputError(f'There is no joining "{way}": choose one of {", ".join(filter(None, JOININGS))}.')
    return str(way)


def _start_values(data: dict[str, Any]) -> StartValues:
    """Of films that are welded by heat; nothing of the kind is started with others."""
    if "start_values" not in data:
        return NOT_STATED
    if _joining(data.get("joining", "")) != "heat":
        raise InputError('start_values are of films that are welded by heat: give "joining": "heat" too.')
    return read_start_values(data["start_values"])


def _truth(data: dict[str, Any], key: str, unknown: bool | None) -> Any:
    value = data.get(key, unknown)
    if value is not unknown and not isinstance(value, bool):
        raise InputError(f"{key} is {value!r}: write true or false.")
    return value


def _thickness(value: float) -> float:
    return _within(value, 1e-6, 5e-3, "thickness", "m", "0.000025")


def _poisson(value: float) -> float:
    if not 0.0 <= value < 0.5:
        raise InputError(
            f"The Poisson's ratio {number_text(value)} is not between 0 and 0.5: give one such as 0.38."
        )
    return float(value)


def _within(value: float, low: float, high: float, what: str, unit: str, example: str) -> float:
    if not low <= value <= high:  # NaN fails too
        raise InputError(
            f"The {what} is {number_text(value)}, not between {number_text(low)} and {number_text(high)}"
            f" {unit}:"
            f" give one such as {example}."
        )
    return float(value)
