# SPDX-License-Identifier: LGPL-2.1-or-later
"""One picture of a balloon of many panels, and of its flat panels: both edges of a seam in one colour."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.seams import side_lines
from BalloonWorkbench.core.bags.seam_colours import seam_colour
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pictures.bag_picture import bag_picture, upright
from BalloonWorkbench.core.pictures.canvas import PreviewCanvas
from BalloonWorkbench.core.pictures.cards import (
    CARD,
    HEIGHT,
    WIDTH,
    CardFrame,
    PreviewCard,
    cards_png,
    dimension,
    scale_bar,
)
from BalloonWorkbench.core.pictures.render import FILM_COLOUR
from BalloonWorkbench.core.results.colour_map import colours
from BalloonWorkbench.core.results.off_target import off_target
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, percent_text, size_text, to_mm, volume_text

_MARGIN, _GAP, _FLAT = 26, 20, 1000
_FILM = "#fbeef0"
_NOTHING = 1e-12  # m; a scale needs an end
#: Lines that are drawn beside the seams' own.
_SHOWN = (Role.CUT, Role.CUT_INNER, Role.SEAL, Role.ENGRAVE, Role.NOTCH)

#: Gives the colour of a seam by its number, from 1.
SeamColour = Callable[[int], str]


def bag_preview_png(
    design: BagDesign, patterns: BagPatterns, seam_colour: SeamColour = seam_colour, colour: str = FILM_COLOUR
) -> bytes:
    """A PNG of 1800 x 1000 pixels; same bytes for same input. MissingPackageError without matplotlib."""

    def draw_cards(canvas: PreviewCanvas) -> None:
        left, tall = WIDTH - 2 * _MARGIN - _GAP - _FLAT, HEIGHT - 2 * _MARGIN
        distances = off_target(design)
        map_tall = 0 if distances is None else (tall - _GAP) // 2
        if distances is not None:
            title = f"Off the {'profile' if isinstance(design.source, Profile) else 'drawing'}"
            _map(PreviewCard(canvas, _MARGIN, _MARGIN, left, map_tall, title), design, distances)
        low = _MARGIN + (map_tall + _GAP if map_tall else 0)
        place = PreviewCard(canvas, _MARGIN, low, left, HEIGHT - _MARGIN - low, "Balloon")
        _balloon(place, design, seam_colour, colour)
        count = len(patterns.patterns)
        title = "1 panel" if count == 1 else f"{count} panels"
        place = PreviewCard(canvas, _MARGIN + left + _GAP, _MARGIN, _FLAT, tall, title)
        _panels(place, design, patterns, seam_colour)

    return cards_png(draw_cards)


def _balloon(card: PreviewCard, design: BagDesign, seam_colour: SeamColour, colour: str) -> None:
    seams = {number: seam_colour(number) for number in range(1, len(design.bag.seams) + 1)}
    card.picture(bag_picture(design, card.width - 28, card.height - 120, colour, seams=seams), 14, 56)
    size = size_text(*np.ptp(upright(design)[design.film], axis=0).tolist())
    card.caption(f"{size}, {volume_text(design.inflation.volume)}")


def _map(card: PreviewCard, design: BagDesign, distances: Floats) -> None:
    """The balloon by its distances (n,) m from what was wanted, with the scale and what they are in all."""
    away, error = np.abs(distances), design.residual
    top = max(_NOTHING, float(away.max()) if error is None else min(error.max, 2.0 * error.p95))
    shown = colours(np.clip(away / top, 0.0, 1.0)) / 255.0
    card.picture(bag_picture(design, card.width - 28, card.height - 160, shown, seams={}), 14, 96)
    scale = colours(np.linspace(0.0, 1.0, card.width - 240)) / 255.0
    card.picture(np.tile(scale, (14, 1, 1)), 120, 66)
    card.text(110, 73, "0", 11, centre=1.0)
    card.text(card.width - 110, 73, length_text(top, 2), 11)
    if error is not None:
        mean, most, largest = (
            f"{length_text(part, 2)} ({percent_text(part / design.size)})"
            for part in (error.mean, error.p95, error.max)
        )
        card.caption(f"mean {mean}, 95 % below {most}, at most {largest}")


def _panels(card: PreviewCard, design: BagDesign, patterns: BagPatterns, seam_colour: SeamColour) -> None:
    laid = (*patterns.patterns, *patterns.pieces)
    points = to_mm(np.concatenate([contour.points for pattern in laid for contour in pattern.contours]))
    low, high = bounds(points)
    frame = CardFrame(low, high, card.inside(74, 130, 40, 84))
    for pattern in laid:
        for contour in sorted(pattern.contours, key=lambda each: each.role is not Role.CUT):
            line = frame(to_mm(contour.line))
            if contour.role in (Role.CUT, Role.CUT_INNER):
                card.area([line], _FILM if contour.role is Role.CUT else CARD)
            if contour.role in _SHOWN:
                faint: dict[str, Any] = {"dash": (5, 2), "opacity": 0.5} if contour.role is Role.SEAL else {}
                card.lines([line], LAYERS[contour.role].rgb, 0.7, **faint)
    shifts = dict(zip(patterns.panels, patterns.shifts, strict=True))
    for mark, seam in zip(patterns.seams, design.bag.seams, strict=True):
        sides = zip(mark.panels, side_lines(design.bag, seam))
        seen = [side + shifts[panel] for panel, side in sides if panel in shifts and mark.made]
        card.lines([frame(to_mm(side)) for side in seen], seam_colour(mark.number), 2.6)
    start, end = frame(low), frame(high)
    across, up = (length_text(from_mm(float(size))) for size in high - low)
    dimension(card, (start[0], start[1] - 26), (end[0], start[1] - 26), across)
    dimension(card, (start[0] - 26, start[1]), (start[0] - 26, end[1]), up)
    scale_bar(card, frame.scale)
    count = sum(mark.made for mark in patterns.seams)
    turned = sum(mark.made and not mark.flat for mark in patterns.seams)
    text = f"{count} seams, {length_text(patterns.seam_length)} in all"
    card.caption(f"{text}; {turned} do not lie flat" if turned else text)
