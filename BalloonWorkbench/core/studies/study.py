# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study: its rows, worked out as they are asked for, and what is kept of each balloon."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.axes import Axis, Between
from BalloonWorkbench.core.studies.columns import INPUT, SEPARATOR
from BalloonWorkbench.core.studies.job import BALLOON, KEPT, MOST_ROWS, REPORT

LATIN, RANDOM = "latin-hypercube", "random"

#: A row: values as they were written, by column; cells beyond the last column under None.
Row = Mapping[Any, Any]


@dataclass(frozen=True)
class Study:
    """Rows of values, by column, and

    columns  in the order of the table
    rows     each a mapping from column to value, as it was written; may be worked out when it is asked for
    keep     of each balloon: one of KEPT (job.py)
    folder   from which files are looked for
    task     what works out a row: see Job
    own      columns that are no options: the task reads them; shared: what else it gets with each row
    hashed   inputs are named after a hash of what counts in them: their other bytes do not matter
    """

    columns: tuple[str, ...]
    rows: Sequence[Row]
    keep: str = REPORT
    folder: Path = field(default_factory=Path)
    task: str = BALLOON
    own: tuple[str, ...] = ()
    shared: Mapping[str, Any] = field(default_factory=dict)
    hashed: bool = False

    def __post_init__(self) -> None:
        if INPUT not in self.columns:
            raise InputError("The study has no inputs: give it a column 'input' with the names of drawings.")
        if self.keep not in KEPT:
            raise InputError(f"'{self.keep}' cannot be kept: write {', '.join(KEPT[:-1])} or {KEPT[-1]}.")
        if not len(self.rows):
            raise InputError("The study has no rows.")


def check_count(rows: int, most: int = MOST_ROWS) -> None:
    """Raise InputError for more rows than anybody means."""
    if rows > most:
        raise InputError(
            f"The study has {rows} rows, more than {most}: take fewer values, or give --most {rows} if"
            " that is meant."
        )


@dataclass(frozen=True)
class Grid(Sequence[Row]):
    """Each value of each column with each of all others; the last column runs fastest."""

    fixed: Row
    axes: Mapping[str, Sequence[Any]]

    def __len__(self) -> int:
        return math.prod(len(axis) for axis in self.axes.values())

    def __getitem__(self, number: Any) -> Any:
        if isinstance(number, slice):
            return [self[each] for each in range(*number.indices(len(self)))]
        left = range(len(self))[number]
        values = {}
        for name, axis in reversed(list(self.axes.items())):
            left, place = divmod(left, len(axis))
            values[name] = axis[place]
        return {**self.fixed, **dict(reversed(values.items()))}


@dataclass(frozen=True)
class SampledRows(Sequence[Row]):
    """A row for each point of the unit cube: points (n, d), one dimension a column."""

    fixed: Row
    axes: Mapping[str, Axis]
    points: np.ndarray[Any, np.dtype[np.float64]]

    def __len__(self) -> int:
        return len(self.points)

    def __getitem__(self, number: Any) -> Any:
        if isinstance(number, slice):
            return [self[each] for each in range(*number.indices(len(self)))]
        shares = self.points[number].tolist()
        pairs = zip(self.axes.items(), shares, strict=True)
        return {**self.fixed, **{name: _at(axis, share) for (name, axis), share in pairs}}

    def __iter__(self) -> Iterator[Row]:
        return (self[number] for number in range(len(self)))


def _at(axis: Axis, share: float) -> Any:
    return axis.at(share) if isinstance(axis, Between) else axis[math.floor(share * len(axis))]


def points_of(kind: str, rows: int, dimensions: int, seed: int) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Points (rows, dimensions) of the unit cube; the same for the same seed.

    kind: LATIN, where each of so many equal parts of a column is taken once (scipy.stats.qmc), or RANDOM.
    Raises InputError, MissingPackageError.
    """
    if kind == RANDOM:
        return np.random.default_rng(seed).random((rows, dimensions))
    if kind != LATIN:
        raise InputError(f"'{kind}' is no way to take samples: write {LATIN} or {RANDOM}.")
    try:
        from scipy.stats import qmc
    except ImportError:
        raise packages.without_scipy(
            f"Samples of a {LATIN} need scipy: install it with pip install scipy, or take {RANDOM} ones."
        ) from None
    return np.asarray(qmc.LatinHypercube(dimensions, seed=seed).random(rows))


def written(value: Any) -> str:
    """A value of a row as a table has it."""
    if value is None:
        return ""
    if isinstance(value, (list, tuple)):
        return SEPARATOR.join(map(str, value))
    return str(value)
