# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of a balloon of many panels; the same as those of two panels tell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.film.filling import Filling, gases
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.making.numbers import Floating, Numbers, floating_in, pieces_on_roll
from BalloonWorkbench.core.making.safety import safety
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.nesting.layout import Piece
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.pattern import Pattern


def bag_numbers(
    design: BagDesign, patterns: BagPatterns, film: Film, filling: Filling, *, exact: bool = True
) -> Numbers:
    """The numbers of one balloon of many panels; filling and exact as in `maker_numbers`."""
    data = making()
    valve = data.valve_film * sum(piece.film_area for piece in patterns.pieces[patterns.caps :])
    inner = inner_film(design)
    border = patterns.film_area - inner
    width = width_of(design)
    chosen = [filling, *(replace(filling, gas=gas, gas_temperature=None) for gas in gases().values())]
    seen: dict[str, Floating] = {}
    for each in chosen:
        if each.gas.name not in seen:
            halves = 0.5 * inner, 0.5 * border
            seen[each.gas.name] = floating_in(each, design.inflation, film, *halves, valve, width, data)
    return Numbers(
        patterns.film_area,
        pieces_on_roll(bag_pieces(patterns, 1, film.lies), data.roll_width),
        patterns.seam_length,
        film.areal_density * inner,
        film.areal_density * border,
        valve,
        design.inflation.volume,
        width,
        tuple(seen.values()),
        safety(design.inflation, film, exact=exact),
        data.currency,
        data.film_cost(film, patterns.film_area),
    )


def inner_film(design: BagDesign) -> float:
    """Film inside the seams, of all panels that are cut [m2]."""
    cut = [panel for panel in design.bag.panels if panel.cut]
    return float(sum(signed_area(loop) for panel in cut for loop in panel.loops))


def width_of(design: BagDesign) -> float:
    """Width of what was wanted [m]; of a bag as it is that of its balloon."""
    if isinstance(design.source, Profile):
        return 2.0 * float(design.source.points[:, 0].max())
    if isinstance(design.source, Outline):
        return float(design.source.size[0])
    return float(np.ptp(design.inflation.positions[design.film, 0]))


def bag_pieces(patterns: BagPatterns, balloons: int, grain: float | None) -> list[Piece]:
    """The pieces of so many balloons on their film; grain: its direction in the panels [rad], None without.

    All are cut as they are seen from outside, so that no side of the film is mixed up.
    """
    own = [Piece(pattern, balloons, 0, grain) for pattern in patterns.patterns]
    return [*own, *_pieces(patterns.pieces, balloons, grain)]


def _pieces(patterns: Sequence[Pattern], balloons: int, grain: float | None) -> list[Piece]:
    return [Piece(pattern, balloons, 0, None if grain is None else 0.0) for pattern in patterns]
