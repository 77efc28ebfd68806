# SPDX-License-Identifier: LGPL-2.1-or-later
"""One picture of the whole job: drawing, inflated silhouette, pattern and the balloon itself."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.geometry.polyline import bounds, ring
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.machines.machine import ANY, FOLDER, read_machine
from BalloonWorkbench.core.machines.toolpaths import Path, draw
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pictures.canvas import PreviewCanvas
from BalloonWorkbench.core.pictures.cards import (
    CARD,
    HEIGHT,
    SOFT,
    WIDTH,
    CardFrame,
    PreviewCard,
    cards_png,
    dimension,
    scale_bar,
)
from BalloonWorkbench.core.pictures.render import balloon_picture
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, percent_text, size_text, to_mm, volume_text

_DRAWING, _BALLOON, _UNREACHED, _CREASES = "#39424f", "#d81e3f", "#f2b705", "#6a3fc4"
_PARTLY = "#b3541e"  # the text about a balloon that does not reach its drawing
# Cards in pixels from the lower left: x, y, width, height.
_MARGIN, _GAP = 26, 20
_LEFT, _MIDDLE = 480, 540
_IN_A_ROW = 3
_NAMES = {
    Role.CUT: "cut",
    Role.CUT_INNER: "cut inside",
    Role.NOTCH: "notch",
    Role.FOLD: "fold",
    Role.PEN: "drawn",
    Role.ENGRAVE: "text",
    Role.PRINT: "print",
    Role.REGISTRATION: "registration",
}


def preview_png(designs: Sequence[Design], patterns: Sequence[Pattern], seam: str = "weld") -> bytes:
    """A PNG of 1800 x 1000 pixels of all balloons of a drawing; same bytes for same input.

    seam  what the film's seam is called
    MissingPackageError without matplotlib.
    """

    def draw_cards(canvas: PreviewCanvas) -> None:
        half = (HEIGHT - 2 * _MARGIN - _GAP) // 2
        tall = HEIGHT - 2 * _MARGIN
        second = _MARGIN + _LEFT + _GAP
        third = second + _MIDDLE + _GAP
        _drawing(PreviewCard(canvas, _MARGIN, _MARGIN + half + _GAP, _LEFT, half, "Drawing"), designs)
        _silhouette(PreviewCard(canvas, _MARGIN, _MARGIN, _LEFT, half, "Inflated over the drawing"), designs)
        _pattern(PreviewCard(canvas, second, _MARGIN, _MIDDLE, tall, "Pattern, cut two"), patterns, seam)
        title = "Balloon" if len(designs) == 1 else f"{len(designs)} balloons"
        _balloon(PreviewCard(canvas, third, _MARGIN, WIDTH - _MARGIN - third, tall, title), designs, patterns)

    return cards_png(draw_cards)


def _loops(outline: Outline, frame: CardFrame) -> list[Floats]:
    """An outline and its holes on a card."""
    return [frame(to_mm(loop)) for loop in outline.loops]


def _rings(outline: Outline, frame: CardFrame) -> list[Floats]:
    """The same as lines that end where they begin."""
    return [ring(loop) for loop in _loops(outline, frame)]


def _common_frame(card: PreviewCard, designs: Sequence[Design]) -> CardFrame:
    """The same scale for the drawing and for what is laid over it."""
    points = to_mm(
        np.concatenate([part.outer for design in designs for part in (design.target, design.silhouette)])
    )
    return CardFrame(*bounds(points), card.inside(34, 62, 34, 66))


def _drawing(card: PreviewCard, designs: Sequence[Design]) -> None:
    frame = _common_frame(card, designs)
    for design in designs:
        card.area(_loops(design.target, frame), _DRAWING)
        card.lines([frame(to_mm(weld)) for weld in design.target.welds], CARD, 1.4)
    width, height = np.ptp(np.concatenate([design.target.outer for design in designs]), axis=0)
    holes = sum(len(design.target.holes) for design in designs)
    shapes = "" if len(designs) == 1 else f", {len(designs)} shapes"
    inside = "" if not holes else ", 1 hole" if holes == 1 else f", {holes} holes"
    card.caption(f"{size_text(width, height)}{shapes}{inside}")


def _silhouette(card: PreviewCard, designs: Sequence[Design]) -> None:
    frame = _common_frame(card, designs)
    for design in designs:
        card.area(_loops(design.silhouette, frame), _BALLOON, 0.30)
        card.lines(_rings(design.silhouette, frame), _BALLOON, 1.6)
        card.lines(_rings(design.target, frame), _DRAWING, 1.2, dash=(4, 2.5))
    for design in designs:
        missed = [frame(to_mm(stretch.points)) for stretch in design.unreached]
        card.lines(missed, _DRAWING, 7.0)  # yellow alone does not stand out from white
        card.lines(missed, _UNREACHED, 5.0)
        creases = () if design.weld_range is None else design.weld_range.creases
        card.lines([frame(to_mm(stretch.points)) for stretch in creases], _CREASES, 3.0, dash=(1.0, 0.9))
    worst = max(designs, key=lambda design: design.residual.mean / max(design.target.size))
    off = worst.residual
    share = off.mean / max(*worst.target.size, 1e-12)
    which = "" if len(designs) == 1 else "worst: "
    marked = "; yellow: missed" if any(design.unreached for design in designs) else ""
    if any(design.weld_range is not None and design.weld_range.creases for design in designs):
        marked += "; violet: may crease"
    card.caption(
        f"{which}{length_text(off.mean, 2)} ({percent_text(share)}) off, {length_text(off.max, 2)} at"
        f" most{marked}",
        SOFT if all(design.reached for design in designs) else _PARTLY,
    )


def _pattern(card: PreviewCard, patterns: Sequence[Pattern], seam: str) -> None:
    names = {**_NAMES, Role.SEAL: seam, Role.WELD: f"{seam} inside"}
    pattern = on_one_sheet(patterns)
    sheet = draw(pattern, read_machine(FOLDER / f"{ANY['svg']}.json"))
    frame = CardFrame(np.zeros(2), np.array([sheet.width, sheet.height]), card.inside(74, 150, 40, 84))
    rings = {role: [_drawn(path, frame) for path in sheet.of(role)] for role in (Role.CUT, Role.CUT_INNER)}
    # A shape may lie in the hole of another: the larger ones first.
    for points, colour in sorted(
        [(points, "#fbeef0") for points in rings[Role.CUT]]
        + [(points, CARD) for points in rings[Role.CUT_INNER]],
        key=lambda item: -float(np.ptp(item[0], axis=0).prod()),
    ):
        card.area([points], colour)
    for role in dict.fromkeys(path.role for path in sheet.paths):
        lines, colour = [_drawn(path, frame) for path in sheet.of(role)], LAYERS[role].rgb
        if role in (Role.SEAL, Role.WELD):
            card.lines(lines, colour, 1.0, dash=(5, 2))
        else:  # small letters stay open
            card.lines(lines, colour, 0.4 if role is Role.ENGRAVE else 1.5)
    low, high = frame(np.zeros(2)), frame(np.array([sheet.width, sheet.height]))
    dimension(card, (low[0], low[1] - 26), (high[0], low[1] - 26), length_text(from_mm(sheet.width)))
    dimension(card, (low[0] - 26, low[1]), (low[0] - 26, high[1]), length_text(from_mm(sheet.height)))
    scale_bar(card, frame.scale)
    left, height = 24, 62
    for number, role in enumerate(reversed(pattern.roles)):
        if number and number % _IN_A_ROW == 0:  # beside the scale bar there is room for so many
            left, height = 24, height + 24
        card.lines([np.array([(left, height), (left + 24, height)])], LAYERS[role].rgb, 2.0)
        card.text(left + 32, height, names[role], 11)
        left += 60 + 8 * len(names[role])
    widths = [part.intake.width for part in patterns if part.intake is not None]
    neck = f"intake {length_text(max(widths), 3)} wide inside" if widths else "no intake"
    card.caption(
        f"{seam} {length_text(pattern.seal_width, 3)} wide, {length_text(pattern.seam_length)} long, {neck}"
    )


def _drawn(path: Path, frame: CardFrame) -> Floats:
    """Points (n, 2) of a path on the card, a closed one with its first point repeated."""
    return frame(ring(path.curve.joints, path.curve.closed))


def _balloon(card: PreviewCard, designs: Sequence[Design], patterns: Sequence[Pattern]) -> None:
    inflations = [design.inflation for design in designs]
    card.picture(
        balloon_picture(inflations, patterns[0].seal_width, card.width - 28, card.height - 120), 14, 56
    )
    positions = np.concatenate([inflation.positions for inflation in inflations])
    across, up, _ = np.ptp(positions, axis=0)
    size = size_text(across, up, 2.0 * float(positions[:, 2].max()))
    card.caption(f"{size}, {volume_text(sum(inflation.volume for inflation in inflations))}")
