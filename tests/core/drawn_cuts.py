# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns for the tests of what is cut: pictures, letters, holes with tips, all options; and layouts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, TURN, oriented, polar, star
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.layout import GrainRule, Piece, Stock
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.intake.kinds import intake_kinds
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.types import Floats

PICTURES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures"
#: All of DejaVu Sans with a counter.
LETTERS = "ABDOPQRabdegopq0468&@%#$"
SEAL = 0.006


def lens(length: float, width: float, count: int = 60) -> Floats:
    """Two arcs with a tip at both ends."""
    radius = (0.25 * length**2 + 0.25 * width**2) / width
    turn = np.linspace(-1.0, 1.0, count) * np.arcsin(0.5 * length / radius)
    side = np.stack([radius * np.sin(turn), radius * np.cos(turn) - (radius - 0.5 * width)], axis=1)
    return np.concatenate([side[:-1], -side[:-1]])


def drop(length: float, width: float) -> Floats:
    turn = TURN[::4]
    return np.stack([0.5 * length * np.cos(turn), width * np.sin(turn) * np.sin(0.5 * turn) ** 1.5], axis=1)


#: Holes with tips, of a disc of 220 mm.
HOLES = {
    "lens": lens(0.09, 0.025),
    "slender lens": lens(0.12, 0.022),
    "blunt lens": lens(0.09, 0.04, 200),
    "drop": drop(0.1, 0.03),
    "wedge": np.array([[-0.05, -0.012], [0.05, 0.0], [-0.05, 0.012]]),
    "slit": np.array([[-0.05, -0.01], [0.05, -0.01], [0.05, 0.01], [-0.05, 0.01]]),
    "star": star(5, 0.05, 0.02).outer,
    "spiky": star(8, 0.055, 0.02).outer,
    "heart": 0.35 * NAMED["heart"].outer,
}


def turned(loop: Floats, angle: float) -> Floats:
    return loop @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])


def holed(name: str, scale: float = 1.0, angle: float = 0.0) -> Outline:
    return Outline(polar(0.11 * scale), (oriented(turned(HOLES[name], angle) * scale, False),))


@cache
def letter(sign: str, height: float = 0.25) -> Outline:
    """A letter of the font that labels are written in."""
    glyph = TextPath((0.0, 0.0), sign, size=2000.0, prop=FontProperties(family="DejaVu Sans"))
    areas = [shapely.Polygon(loop) for loop in glyph.to_polygons(closed_only=True)]
    body = max(areas, key=lambda area: area.area)
    scale = height / (body.bounds[3] - body.bounds[1])

    def loop(area: shapely.Polygon, outer: bool) -> Floats:
        return oriented(shapely.get_coordinates(area)[:-1] * scale, outer)

    counters = (area for area in areas if area is not body and body.contains(area))
    return Outline(loop(body, True), tuple(loop(area, False) for area in counters))


@cache
def pictured(name: str) -> tuple[Outline, ...]:
    drawing, _ = read_drawing(PICTURES / f"{name}.png", width=0.3)
    return drawing.parts


NAMES = sorted(path.stem for path in PICTURES.glob("*.png"))


def wishes(random: np.random.Generator) -> PatternOptions:
    """Any of the options."""
    relief = float(random.choice([0.0, 0.0, 0.002]))
    return PatternOptions(
        allowance=float(random.choice([0.002, 0.003, 0.005])),
        intake=bool(random.random() < 0.8),
        intake_kind=str(random.choice([kind.name for kind in intake_kinds().values()])),
        corner_radius=relief,
        notches=int(random.choice([0, 4, 7, 24])),
        tie_tab=bool(random.random() < 0.5),
        label=str(random.choice(["", "B8", "R&D"])),
        label_height=0.004,
        mirror=bool(random.random() < 0.5),
        copies=int(random.choice([1, 1, 1, 2, 10])),
    )


def made(parts: tuple[Outline, ...], wanted: PatternOptions) -> Pattern | None:
    """The sheet of all parts; without what has no room on them, None where even that is not enough."""
    for wish in (wanted, replace(wanted, label="", notches=0, tie_tab=False), PatternOptions(intake=False)):
        try:
            return on_one_sheet([sheet_of(make_pattern(part, SEAL, wish), wish) for part in parts])
        except BalloonError:
            continue
    return None


def sheets(count: int, most_copies: int = 10) -> Iterator[tuple[str, Pattern]]:
    """So many patterns with a name, in an order that soon has some of each kind."""
    return islice(_sheets(most_copies), count)


def _sheets(most_copies: int) -> Iterator[tuple[str, Pattern]]:
    for seed in range(10**6):
        random = np.random.default_rng(seed)
        names = list(HOLES)
        drawn = (
            (f"hole {names[seed % len(names)]}", (holed(names[seed % len(names)], *_any(random, seed)),)),
            (f"letter {LETTERS[seed % len(LETTERS)]}", (letter(LETTERS[seed % len(LETTERS)]),)),
            (f"picture {NAMES[seed % len(NAMES)]}", pictured(NAMES[seed % len(NAMES)])),
        )
        for name, parts in drawn:
            wanted = wishes(random)
            wanted = replace(wanted, copies=min(wanted.copies, most_copies))
            sheet = made(parts, wanted)
            if sheet is not None:
                yield f"{name}, {wanted}", sheet


def _any(random: np.random.Generator, seed: int) -> tuple[float, float]:
    """Scale and angle of a hole; as it is drawn at first."""
    first = seed < len(HOLES)
    return (1.0, 0.0) if first else (float(random.uniform(0.6, 2.0)), float(random.uniform(0.0, 7.0)))


@cache
def laid_out(balloons: int = 1) -> Pattern:
    """Rings, in their holes discs with a hole, and hearts; in rows, as without the nesting library."""
    ring = made(
        (Outline(polar(0.14), (oriented(polar(0.09), False),)),), PatternOptions(intake=False, notches=6)
    )
    small = made(
        (Outline(polar(0.05), (oriented(polar(0.02), False),)),), PatternOptions(intake=False, notches=3)
    )
    heart = made((NAMED["heart"].map(lambda loop: 0.3 * loop),), PatternOptions(label="I"))
    assert ring and small and heart
    pieces = [Piece(ring, balloons, balloons), Piece(small, balloons, balloons), Piece(heart, balloons)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nesting, "PACKAGE", "no_such_package")
        (layout,), _ = nesting.nest(pieces, Stock(0.7, grain=GrainRule.ANY))
    return layout.pattern(pieces)
