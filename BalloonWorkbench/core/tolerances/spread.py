# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a quantity strays: a distribution round its nominal value, as people declare it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from statistics import NormalDist
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import number_text, parse_length, parse_pressure

NORMAL, UNIFORM = "normal", "uniform"
EDGE, WHOLE = "edge", "whole"
#: Over which length along a seam errors stay alike, unless it is said [m].
ALONG = 0.05
#: The largest parts of a nominal value that leave it something: of four standard deviations, and of a bound.
_MOST = {NORMAL: 0.2, UNIFORM: 0.8}
_UNIT_NORMAL = NormalDist()


class ErrorSource(Enum):
    """What strays: its key, an example of its spread, what it is, and whether its deviation is a share.

    cut    the cutter's path, and with it the weld, which is guided by the edge
    weld   the sealing bar on the film
    """

    CUT = ("cut", "0.2mm", "cutting error")
    WELD = ("weld", "0.5mm", "welding error")
    THICKNESS = ("thickness", "10%", "thickness of the film")
    MODULUS = ("modulus", "10%", "Young's modulus of the film")
    STRENGTH = ("strength", "15%", "strength of film and weld")
    PRESSURE = ("pressure", "100Pa", "pressure at filling")
    TEMPERATURE = ("temperature", "5K", "temperature after filling")

    @property
    def key(self) -> str:
        """In the declaration of a study, and as a column of its table."""
        return self.value[0]

    @property
    def example(self) -> str:
        """A spread as it may be written."""
        return self.value[1]

    @property
    def title(self) -> str:
        """For people."""
        return self.value[2]

    @property
    def of_seam(self) -> bool:
        """Whether it moves the seam and may vary along it."""
        return self in (ErrorSource.CUT, ErrorSource.WELD)


@dataclass(frozen=True)
class Spread:
    """A distribution round 0, which is the nominal value.

    kind      NORMAL, with `size` as its standard deviation, or UNIFORM, from -size to size
    size      in SI units, or as a share of the nominal value where it is `relative`
    along     [m] over which an error of a seam stays alike; None for one that the whole contour has
    """

    kind: str
    size: float
    relative: bool = False
    along: float | None = None

    def at(self, share: float) -> float:
        """The deviation that a share of all cases stays below."""
        if self.kind == UNIFORM:
            return self.size * (2.0 * share - 1.0)
        return self.size * _UNIT_NORMAL.inv_cdf(share)

    def of_normal(self, values: Floats) -> Floats:
        """Deviations for values (n,) of a unit normal distribution."""
        if self.kind == NORMAL:
            return self.size * values
        try:
            from scipy.special import ndtr
        except ImportError as error:
            raise without_scipy("Uniform errors along a seam need scipy: pip install scipy.") from error
        return np.asarray(self.size * (2.0 * ndtr(values) - 1.0))


def read_spread(source: ErrorSource, data: Any) -> Spread:
    """The spread of a source from {"normal": "0.2mm", "per": "edge", "along": "50mm"}.

    Raises InputError, in one sentence, for what makes no sense.
    """
    like = f'such as {{"normal": "{source.example}"}}'
    if not isinstance(data, Mapping) or not all(isinstance(key, str) for key in data):
        raise InputError(f"The spread of {source.key} is {data!r}: write one {like}.")
    known = {NORMAL, UNIFORM, *(("per", "along") if source.of_seam else ())}
    if unknown := sorted(set(data) - known):
        raise InputError(
            f'The spread of {source.key} has "{unknown[0]}", which is none of {", ".join(sorted(known))}.'
        )
    kinds = [kind for kind in (NORMAL, UNIFORM) if kind in data]
    if len(kinds) != 1:
        raise InputError(f'Give {source.key} either "{NORMAL}" or "{UNIFORM}", {like}.')
    size, relative = _size(source, data[kinds[0]])
    if relative and size > _MOST[kinds[0]]:
        raise InputError(
            f"A spread of {number_text(100.0 * size)} % leaves nothing of the {source.title}: give"
            f" {kinds[0]} at most {number_text(100.0 * _MOST[kinds[0]])} %."
        )
    return Spread(kinds[0], size, relative, _along(source, data))


def _along(source: ErrorSource, data: Mapping[str, Any]) -> float | None:
    if not source.of_seam:
        return None
    per = data.get("per", EDGE)
    if per not in (EDGE, WHOLE):
        raise InputError(f'The error of {source.key} is per {per!r}: write "{EDGE}" or "{WHOLE}".')
    if per == WHOLE:
        if "along" in data:
            raise InputError(f'The error of {source.key} is of the whole contour: leave "along" out.')
        return None
    along = parse_length(data["along"]) if "along" in data else ALONG
    if not along > 0.0:
        raise InputError(f"Errors of {source.key} stay alike over a length above 0, such as 50mm.")
    return along


def _size(source: ErrorSource, text: Any) -> tuple[float, bool]:
    """The size of a spread, and whether it is a share."""
    value, relative = math.nan, False
    if isinstance(text, str):
        percent = re.fullmatch(r"\s*(\S+?)\s*%\s*", text)
        relative = percent is not None and source not in (
            ErrorSource.CUT,
            ErrorSource.WELD,
            ErrorSource.TEMPERATURE,
        )
        try:
            if percent and relative:
                value = 0.01 * float(percent[1])
            elif source in _PARSERS and not percent and re.search(r"[^\d.\s+-]", text):
                value = _PARSERS[source](text)
        except (ValueError, InputError):
            value = math.nan
    if not math.isfinite(value):
        raise InputError(
            f"The spread of {source.key} cannot be {text!r}: write it with its unit, such as"
            f' "{source.example}".'
        )
    if not value > 0.0:
        raise InputError(f"The spread of {source.key} is {text!r}: give one above 0, or leave it out.")
    return value, relative


def _kelvins(text: str) -> float:
    """A difference of temperatures [K]."""
    match = re.fullmatch(r"\s*([+-]?[\d.]+)\s*(?:°\s*)?([kcf])\s*", text, re.IGNORECASE)
    if match is None:
        raise InputError(f"'{text}' is no difference of temperatures: write 5K, 5C or 9F.")
    return float(match[1]) / (1.8 if match[2].lower() == "f" else 1.0)


_PARSERS: dict[ErrorSource, Callable[[str], float]] = {
    ErrorSource.CUT: parse_length,
    ErrorSource.WELD: parse_length,
    ErrorSource.THICKNESS: parse_length,
    ErrorSource.MODULUS: parse_pressure,
    ErrorSource.PRESSURE: parse_pressure,
    ErrorSource.TEMPERATURE: _kelvins,
}
