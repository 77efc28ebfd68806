# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a comparison: both outlines over each other, what is too much and too little in colours."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.as_made.comparison import Comparison
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.polyline import bounds, ring
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pictures.canvas import PreviewCanvas
from BalloonWorkbench.core.pictures.cards import (
    HEIGHT,
    INK,
    WIDTH,
    CardFrame,
    PreviewCard,
    cards_png,
    scale_bar,
)
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, to_mm

_EXPECTED, _SEEN, _MORE, _LESS, _FARTHEST = "#39424f", "#d81e3f", "#e8590c", "#1971c2", "#6a3fc4"
_MARGIN = 26
#: Radius of the ring round the place that is farthest off [pixels].
_MARK = 26.0


def comparison_png(comparison: Comparison) -> bytes:
    """A PNG of 1800 x 1000 pixels; the same bytes for the same comparison. MissingPackageError."""

    def draw(canvas: PreviewCanvas) -> None:
        title = "As made over what was expected"
        card = PreviewCard(canvas, _MARGIN, _MARGIN, WIDTH - 2 * _MARGIN, HEIGHT - 2 * _MARGIN, title)
        _draw(card, comparison)

    return cards_png(draw)


def _draw(card: PreviewCard, comparison: Comparison) -> None:
    expected, seen = comparison.expected.outline, comparison.seen
    points = to_mm(np.concatenate([expected.outer, seen.outer]))
    frame = CardFrame(*bounds(points), card.inside(420, 90, 60, 80))
    shape, made = _area(expected), _area(seen)
    for area, colour in ((made.difference(shape), _MORE), (shape.difference(made), _LESS)):
        for part in parts(area):
            card.area([frame(to_mm(_loop(each))) for each in (part.exterior, *part.interiors)], colour, 0.55)
    for outline, colour, width in ((expected, _EXPECTED, 1.0), (seen, _SEEN, 1.0)):
        card.lines([frame(to_mm(ring(loop))) for loop in outline.loops], colour, width)
    for stretch in comparison.stretches[:1]:
        angles = np.linspace(0.0, 2.0 * np.pi, 60)
        circle = _MARK * direction(angles)
        card.lines([circle + frame(to_mm(stretch.place[None]))], _FARTHEST, 2.0)
    apart = comparison.residual
    lines = [
        (_EXPECTED, "expected"),
        (_SEEN, "as made"),
        (_MORE, "as made is larger"),
        (_LESS, "as made is smaller"),
    ]
    if comparison.stretches:
        lines.append((_FARTHEST, "farthest off"))
    for number, (colour, text) in enumerate(lines):
        height = card.height - 110 - 34 * number
        card.lines([np.array([(28, height), (64, height)])], colour, 4.0)
        card.text(76, height, text, 12, INK)
    scale_bar(card, frame.scale)
    card.caption(
        f"{length_text(apart.mean, 2)} off in the mean, {length_text(apart.p95, 2)} for 95 %,"
        f" {length_text(apart.max, 2)} at most"
    )


def _area(outline: Outline) -> Any:
    area = shapely().Polygon(outline.outer, outline.holes)
    return area if area.is_valid else area.buffer(0.0)


def _loop(line: Any) -> Floats:
    return np.asarray(line.coords, dtype=np.float64)[:-1]
