# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying out pieces one after another, each where it takes least film: fast, and without the nesting library.

Film is seen as bands along its length. Of the pieces that lie, each band knows how far they reach; of a piece
that comes, where it begins. Pushed along its bands until it touches, it fills the bays that others leave.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.vectors import rotation
from BalloonWorkbench.core.nesting.layout import Piece, Place, Stock, Unit, outline_of
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats

_BANDS = 250
#: Points along an outline for each band that it crosses.
_FINE = 8
#: So many pieces are laid in all trials of the first one's angle together.
_TRIALS = 300
_EXACT = 1e-9  # m


@dataclass(frozen=True)
class _Way:
    """A piece turned by an angle [rad], grown by half the spacing: its lower left corner (2,), its width and
    height [m], and in each band that it takes where it begins and ends from that corner."""

    angle: float
    low: Floats
    width: float
    height: float
    begins: Floats
    ends: Floats


@dataclass(frozen=True)
class _Laid:
    """Places on sheets, and the length of the last one that is used [m]."""

    sheets: list[list[Place]]
    length: float


def in_rows(pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit]) -> list[list[Place]]:
    """Places on one roll or on several sheets, the largest pieces first.

    The first piece is tried at all its angles, as many as there is time for.
    """
    ways = {unit: _ways(pieces, stock, unit) for unit in sorted(set(units))}
    order = sorted(units, key=lambda unit: (-max(way.width * way.height for way in ways[unit]), unit))
    first = sorted(ways[order[0]], key=lambda way: (round(way.width, 9), round(way.angle, 9)))
    trials = [_laid(stock, order, ways, way) for way in first[: max(1, _TRIALS // len(order))]]
    return min(trials, key=lambda laid: (len(laid.sheets), round(laid.length, 9))).sheets


def _laid(stock: Stock, order: Sequence[Unit], ways: dict[Unit, list[_Way]], first: _Way) -> _Laid:
    """All pieces one after another, the first one in a way that is given."""
    edge = 0.5 * stock.spacing
    most = np.inf if stock.length is None else stock.length - edge
    sheets: list[list[Place]] = [[]]
    reached, used = np.full(_BANDS, edge), edge
    for number, unit in enumerate(order):
        choices = ways[unit] if number else [first]
        begin, way, band = _best(reached, used, choices)
        if begin + way.width > most + _EXACT:
            sheets.append([])
            reached, used = np.full(_BANDS, edge), edge
            begin, way, band = _best(reached, used, choices)
        taken = slice(band, band + len(way.begins))
        reached[taken] = np.maximum(reached[taken], begin + way.ends)
        used = max(used, begin + way.width)
        corner = np.array([begin, edge + band * _step(stock)])
        sheets[-1].append(Place(*unit, way.angle, corner - way.low))
    return _Laid(sheets, used)


def _best(reached: Floats, used: float, ways: Sequence[_Way]) -> tuple[float, _Way, int]:
    """Where a piece begins [m], in which way and from which band on, so that least film is used and the piece
    lies farthest back."""
    candidates = []
    for number, way in enumerate(ways):
        windows = np.lib.stride_tricks.sliding_window_view(reached, len(way.begins))
        begins = np.round((windows - way.begins).max(axis=1), 9)
        band = int(np.argmin(begins))
        end = float(begins[band]) + way.width
        candidates.append((round(max(end, used), 9), round(end, 9), number, band, float(begins[band])))
    _, _, number, band, begin = min(candidates)
    return begin, ways[number], band


def _step(stock: Stock) -> float:
    """Width of a band [m]."""
    return (stock.width - stock.spacing) / _BANDS


def _ways(pieces: Sequence[Piece], stock: Stock, unit: Unit) -> list[_Way]:
    """All ways in which a piece fits on the film."""
    number, mirrored = unit
    grown = outline_of(pieces[number].panel(mirrored)).buffer(0.5 * stock.spacing, quad_segs=16)
    step = _step(stock)
    line = shapely().segmentize(grown.exterior, step / _FINE)
    outline = shapely().get_coordinates(line)
    ways = []
    for degrees in pieces[number].angles(mirrored, stock.grain):
        angle = float(np.radians(degrees))
        points = outline @ rotation(angle)
        low = points.min(axis=0)
        width, height = np.ptp(points, axis=0).tolist()
        fits = height <= stock.width - stock.spacing + _EXACT
        if stock.length is not None:
            fits &= width <= stock.length - stock.spacing + _EXACT
        if fits:
            ways.append(_Way(angle, low, width, height, *_bands(points - low, height, step)))
    return ways


def _bands(points: Floats, height: float, step: float) -> tuple[Floats, Floats]:
    """Where an outline (n, 2) begins and ends in each band; a chord counts in the bands of both ends."""
    count = min(max(1, int(np.ceil((height - _EXACT) / step))), _BANDS)
    band = np.clip((points[:, 1] / step).astype(int), 0, count - 1)
    begins, ends = np.full(count, np.inf), np.full(count, -np.inf)
    low = np.minimum(points[:-1, 0], points[1:, 0])
    high = np.maximum(points[:-1, 0], points[1:, 0])
    for which in (band[:-1], band[1:]):
        np.minimum.at(begins, which, low)
        np.maximum.at(ends, which, high)
    return begins, ends
