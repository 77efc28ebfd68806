# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of the film nested panels use, beside the best that spyrrow finds on the same terms.

The library is optional: without it only rows are measured, and the page keeps what it had.
"""

from __future__ import annotations

import importlib.util
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from BalloonWorkbench.core.bag_pattern.make import bag_patterns
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.making.bag_numbers import bag_pieces
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.layout import GrainRule, Piece, Stock, outline_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, to_mm

PICTURES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures"
_SEAL = 0.006  # m
_SPACING = 0.003  # m
#: The other search: seconds for each of some seeds, with a thread for each processor.
_SECONDS, _SEEDS = 30, (1, 2)


@dataclass(frozen=True)
class Nested:
    """A set of pieces on a roll: how many, its width [m]; used film of rows, of ours, of the best found."""

    name: str
    count: int
    width: float
    rows: float
    ours: float
    best: float
    seconds: float

    @property
    def behind(self) -> float:
        """How far ours is behind the best."""
        return self.best - self.ours


_TITLE = "Film that a layout uses"
_TEXT = """\
## {title}

Panels of example pictures 250 mm wide, front and mirrored back, and of balls of 400 mm, on a roll with 3 mm
between them: film in pieces relative to the film that is taken. Ours is what `--nest` gives, which searches
with the package spyrrow on one thread until it ends by itself; the column before is what it gives without
that package. The other is spyrrow alone, on the same outlines, width, spacing and angles, {seeds} times
{seconds} s on all threads; the best of all counts. Ours is at most {behind:.1f} points behind it. Run of
{date}.

{table}"""
_HEAD = "| pieces | how many | roll | without spyrrow | ours | best found | processor time of ours |"


def replaced(text: str, found: list[Nested]) -> str:
    """The page of speed with its part about layouts, the last one; as it is where nothing was measured."""
    if not found:
        return text
    parts = [part for part in text.rstrip("\n").split("\n\n## ") if not part.startswith(_TITLE)]
    part = _TEXT.format(
        title=_TITLE,
        seeds=len(_SEEDS),
        seconds=_SECONDS,
        behind=100.0 * max(one.behind for one in found),
        date=date.today().isoformat(),
        table="\n".join([_HEAD, 7 * "|---" + "|", *map(_row, found)]),
    )
    return "\n\n## ".join([*parts, part.removeprefix("## ")]) + "\n"


def _row(one: Nested) -> str:
    rows, ours, best = (f"{100.0 * share:.1f} %" for share in (one.rows, one.ours, one.best))
    width = f"{to_mm(one.width):.0f} mm"
    return f"| {one.name} | {one.count} | {width} | {rows} | **{ours}** | {best} | {one.seconds:.0f} s |"


def measure() -> list[Nested]:
    """All sets, one after the other; empty without the library."""
    if importlib.util.find_spec(nesting.PACKAGE) is None:
        sys.stdout.write("nesting: the package spyrrow is not installed, so nothing is compared\n")
        return []
    found = []
    for name, pieces, stock in _sets():
        found.append(_compared(name, pieces, stock))
        sys.stdout.write(f"nesting {found[-1]}\n")
        sys.stdout.flush()
    return found


def _compared(name: str, pieces: list[Piece], stock: Stock) -> Nested:
    with mock.patch.object(nesting, "PACKAGE", "no_such_package"):
        (row,), _ = nesting.nest(pieces, stock)
    began = time.process_time()
    (ours,), _ = nesting.nest(pieces, stock)
    seconds = time.process_time() - began
    area = ours.utilisation * ours.length * stock.width
    best = area / (stock.width * min(_searched(pieces, stock, seed) for seed in _SEEDS))
    count = sum(piece.count + piece.backs for piece in pieces)
    return Nested(
        name, count, stock.width, row.utilisation, ours.utilisation, max(best, ours.utilisation), seconds
    )


def _searched(pieces: list[Piece], stock: Stock, seed: int) -> float:
    """The length of film [m] that the library's own search needs: the outlines themselves, all its time."""
    import spyrrow

    items: list[Any] = []
    for number, piece in enumerate(pieces):
        for mirrored, count in ((False, piece.count), (True, piece.backs)):
            if count:
                points = _points(piece, mirrored)
                angles = piece.angles(mirrored, stock.grain)
                items.append(spyrrow.Item(f"{number} {mirrored}", points, count, angles))
    room = stock.width - 2.0 * stock.spacing
    instance = spyrrow.StripPackingInstance("", to_mm(room), items)
    config = spyrrow.StripPackingConfig(
        early_termination=False,
        total_computation_time=_SECONDS,
        num_workers=None,
        seed=seed,
        min_items_separation=to_mm(stock.spacing),
    )
    return from_mm(instance.solve(config).width) + 2.0 * stock.spacing


def _points(piece: Piece, mirrored: bool) -> list[tuple[float, float]]:
    ring = outline_of(piece.panel(mirrored)).simplify(from_mm(0.02)).exterior
    return [(x, y) for x, y in to_mm(np.asarray(ring.coords)[:-1]).tolist()]


def _sets() -> Iterator[tuple[str, list[Piece], Stock]]:
    """Pictures in several copies, pictures mixed, letters, gored bodies; along the grain and at any angle."""
    for name, width, copies, grain in (
        ("fish", 0.6, 4, GrainRule.ALONG),
        ("heart", 0.6, 4, GrainRule.ANY),
        ("star", 0.7, 5, GrainRule.ANY),
        ("trex", 0.5, 2, GrainRule.ALONG),
        ("butterfly", 0.8, 6, GrainRule.ALONG),
    ):
        yield f"{name} x {copies}", _picture(name, copies), Stock(width, None, _SPACING, grain)
    mixed = [piece for name in ("bear", "rocket", "cake") for piece in _picture(name, 2)]
    yield "bear, rocket, cake x 2", mixed, Stock(0.8, None, _SPACING)
    for count, grain in ((6, GrainRule.ALONG), (12, GrainRule.ANY)):
        pieces = bag_pieces(_gored(count), 1, 0.0)
        yield f"ball of {count} gores, {grain.value}", pieces, Stock(0.6, None, _SPACING, grain)
    pieces = [*bag_pieces(_gored(8), 1, 0.0), *_picture("star", 2)]
    yield "ball of 8 gores, star x 2", pieces, Stock(0.6, None, _SPACING)
    yield "line-dog x 3", _picture("line-dog", 3), Stock(0.6, None, _SPACING)


def _picture(name: str, copies: int) -> list[Piece]:
    drawing, _ = read_drawing(PICTURES / f"{name}.png", width=0.25)
    pieces = []
    for part in drawing.parts:
        for options in (PatternOptions(), PatternOptions(intake=False)):
            try:
                pieces.append(Piece(make_pattern(part, _SEAL, options), copies, copies))
                break
            except BalloonError:
                continue
    return pieces


def _gored(count: int) -> Any:
    turn: Floats = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 24)
    half = 0.2 * np.column_stack([np.cos(turn), np.sin(turn)])
    half[[0, -1], 0] = 0.0
    return bag_patterns(gored_bag(Profile(half), count), film("bopp-foil"), PatternOptions(intake=False))
