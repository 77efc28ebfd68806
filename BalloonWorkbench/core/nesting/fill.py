# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying out pieces inside film of any shape: a remnant, with holes, where no strip can be packed.

Film is seen as cells. Where a piece may lie, in each way, all places at once are found as a correlation of
the cells that are taken with those of the piece, by Fourier transforms; it goes as far to the left as it can,
the largest piece first. Cells only propose: each place is then moved until it touches, and looked at exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.nesting.layout import Piece, Place, Stock, Unit, outline_of
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.placement import turned
from BalloonWorkbench.core.types import Bools, Floats, Progress
from BalloonWorkbench.core.units import from_mm

#: So many cells at most, and how large they are at least [m].
_CELLS, _LEAST = 100_000, from_mm(0.5)
#: Half the diagonal of a cell.
_HALF = 0.7072
#: Steps in which a piece is moved on until it touches, in cells.
_STEPS = (1.0, 0.5, 0.25, 0.125, 0.0625)


@dataclass(frozen=True)
class _TurnedPiece:
    """A piece turned by an angle [rad]: its outline, the cells that it may touch (n, m), and the lower left
    corner (2,) of these [m]."""

    angle: float
    outline: Any
    cells: Bools
    low: Floats


class _Room:
    """What is free of some film."""

    def __init__(self, stock: Stock) -> None:
        package = shapely()
        self.area = stock.film.buffer(-stock.spacing, join_style="mitre")
        low, high = np.zeros(2), np.array([stock.length or 0.0, stock.width])
        self.step = max(float(np.sqrt(np.prod(high - low) / _CELLS)), _LEAST)
        self._counts = np.ceil((high - low) / self.step).astype(int)
        self._x, self._y = ((np.arange(count) + 0.5) * self.step for count in self._counts)
        inner = self.area.buffer(-_HALF * self.step)
        package.prepare(inner)
        x, y = np.meshgrid(self._x, self._y, indexing="ij")
        self._taken = ~package.contains_xy(inner, x, y)

    def way(self, panel: Any, degrees: float) -> _TurnedPiece:
        """A piece turned by so much."""
        package, angle = shapely(), float(np.radians(degrees))
        outline = outline_of(turned(panel, angle, np.zeros(2)))
        grown = outline.buffer(_HALF * self.step)
        left, below, right, above = grown.bounds
        x = np.arange(left + 0.5 * self.step, right + self.step, self.step)
        y = np.arange(below + 0.5 * self.step, above + self.step, self.step)
        package.prepare(grown)
        cells = package.contains_xy(grown, *np.meshgrid(x, y, indexing="ij"))
        return _TurnedPiece(angle, outline, cells, np.array([left, below]))

    def place(self, ways: Sequence[_TurnedPiece]) -> tuple[_TurnedPiece, Floats] | None:
        """The way, and the shift (2,), that lies farthest to the left, and of these lowest; None without."""
        taken = np.fft.rfft2(self._taken.astype(np.float32))
        candidates: list[tuple[float, float, int, Floats]] = []
        for number, way in enumerate(ways):
            last = self._counts - np.array(way.cells.shape)
            if (last < 0).any():
                continue
            other = np.fft.rfft2(way.cells.astype(np.float32), s=self._taken.shape)
            met = np.fft.irfft2(taken * np.conj(other), s=self._taken.shape)
            free = np.argwhere(met[: last[0] + 1, : last[1] + 1] < 0.5)
            if len(free):
                at = self.step * free[0] - way.low  # by x, then by y
                end = float(np.round(at[0] + way.outline.bounds[2], 9))
                candidates.append((end, float(at[1]), number, at))
        for _, _, number, at in sorted(candidates, key=lambda each: each[:3]):
            if self._fits(ways[number], at):
                return ways[number], self._moved_on(ways[number], at)
        return None

    def take(self, way: _TurnedPiece, shift: Floats, spacing: float) -> None:
        """A piece lies there."""
        package = shapely()
        laid = package.transform(way.outline, lambda points: points + shift)
        self.area = self.area.difference(laid.buffer(spacing))
        grown = laid.buffer(spacing + _HALF * self.step)
        left, below, right, above = grown.bounds
        x = np.flatnonzero((self._x >= left) & (self._x <= right))
        y = np.flatnonzero((self._y >= below) & (self._y <= above))
        package.prepare(grown)
        inside = package.contains_xy(grown, *np.meshgrid(self._x[x], self._y[y], indexing="ij"))
        self._taken[np.ix_(x, y)] |= inside

    def _fits(self, way: _TurnedPiece, shift: Floats) -> bool:
        package = shapely()
        return bool(self.area.contains(package.transform(way.outline, lambda points: points + shift)))

    def _moved_on(self, way: _TurnedPiece, shift: Floats) -> Floats:
        """The same place moved to the left and down until the piece touches."""
        for step in (each * self.step for each in _STEPS):
            for ahead in (np.array([-step, 0.0]), np.array([0.0, -step])):
                while self._fits(way, shift + ahead):
                    shift = shift + ahead
        return shift


def in_shape(
    pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit], progress: Progress
) -> tuple[list[Place], list[Unit]]:
    """Places of the pieces that find room on film of any shape, and those that do not.

    When progress says stop, the others find none.
    """
    room, places, left = _Room(stock), list[Place](), list[Unit]()
    areas = {unit: float(outline_of(pieces[unit[0]].panel(unit[1])).area) for unit in set(units)}
    order = sorted(units, key=lambda unit: (-areas[unit], unit))
    ways = {
        unit: [room.way(pieces[unit[0]].panel(unit[1]), degrees) for degrees in _angles(pieces, unit, stock)]
        for unit in sorted(areas)
    }
    full: set[Unit] = set()
    stopped = False
    for number, unit in enumerate(order):
        stopped = stopped or not progress(number / len(order), "laying out")
        lies = None if unit in full or stopped else room.place(ways[unit])
        if lies is None:
            full.add(unit)
            left.append(unit)
            continue
        way, shift = lies
        room.take(way, shift, stock.spacing)
        places.append(Place(*unit, way.angle, shift))
    return places, left


def _angles(pieces: Sequence[Piece], unit: Unit, stock: Stock) -> list[float]:
    return pieces[unit[0]].angles(unit[1], stock.grain)
