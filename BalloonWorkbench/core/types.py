# SPDX-License-Identifier: LGPL-2.1-or-later
"""Array types and the callbacks shared by all rooms of the core."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Bools = NDArray[np.bool_]

#: Called as progress(fraction 0..1, what is being done); returning False asks to stop.
Progress = Callable[[float, str], bool]


def no_progress(fraction: float, text: str) -> bool:
    """Ignore progress and never ask to stop."""
    return True


def part_of(progress: Progress, first: float, last: float) -> Progress:
    """The progress of a part of some work, between two fractions."""
    return lambda fraction, text: progress(first + (last - first) * fraction, text)


def rising(progress: Progress) -> Progress:
    """The same progress without steps back: what is left of a simulation is only foretold."""
    most = 0.0

    def report(fraction: float, text: str) -> bool:
        nonlocal most
        most = max(most, fraction)
        return progress(most, text)

    return report


Made = TypeVar("Made")


class Attempt(Protocol):
    """Makes a part of the work that the rest can do without: None where that failed as nobody foresaw."""

    def __call__(self, what: str, make: Callable[[], Made], /) -> Made | None:
        """What make() gives; what: how it is called when people are told that it is missing."""


def insist(what: str, make: Callable[[], Made], /) -> Made | None:
    """Any failure is one of the whole work."""
    return make()


#: Gives a text in the language of the reader.
Say = Callable[[str], str]


def in_english(text: str) -> str:
    """The text as it is."""
    return text
