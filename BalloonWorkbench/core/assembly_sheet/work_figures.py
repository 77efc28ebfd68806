# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small figures of the work on a balloon: what is sealed now is thick, what is sealed already thin."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, BAND, INK, SOFT
from BalloonWorkbench.core.geometry.polyline import bounds, line_lengths, point_on, ring
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular, rotation
from BalloonWorkbench.core.pages.pdf import draw_line, picture
from BalloonWorkbench.core.pattern.intake.kinds import RIM, intake_kind
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats

Box = tuple[float, float, float, float]

_THIN, _THICK, _EDGE = 0.5, 2.4, 0.5  # points
_WATER, _TUBE, _BORE = "#5b9bd5", "#64748b", "#e2e8f0"
_DOWN = np.array([0.0, -1.0])
#: Of the height of a figure's box, what is below a balloon: for a hose with water, for what else hangs.
_HOSE, _BELOW = 0.34, 0.2
#: Of a figure's box: room round the balloon, width of a hose's bend, width and height of a weight.
_ROOM, _BEND, _WEIGHT = 0.07, 0.2, (0.12, 0.1)
#: Where the water stands in both legs of a hose, of the height of the lower one.
_LOW, _HIGH = 0.25, 0.8
#: How far a tube reaches past the root of a neck and out of it, in widths of the neck, which count as so
#: many mm at least.
_IN, _OUT, _LEAST = 1.6, 1.8, 3.0
#: Where along the outline bubbles are shown.
_BUBBLES = (0.2, 0.42, 0.63)


@dataclass(frozen=True)
class FigureStage:
    """A balloon in a box of the page, all in mm of the page.

    outline  (n, 2) of its film, seals and welds as lines; pixels: its picture instead, which is shown in a
             part of the box
    mouth, root, outward, width  of its neck; None where it has none
    """

    axes: Any
    box: Box
    outline: Floats
    seals: tuple[Floats, ...] = ()
    welds: tuple[Floats, ...] = ()
    pixels: Floats | None = None
    shown: Box = (0.0, 0.0, 0.0, 0.0)
    mouth: Floats | None = None
    root: Floats | None = None
    outward: Floats | None = None
    width: float = 0.0

    def draw(self, seals: float = _THIN, welds: float = _THIN) -> None:
        """The balloon, its seals and welds so thick; 0 leaves them out."""
        if self.pixels is not None:
            picture(self.axes, self.pixels, self.shown)
            return
        (area,) = self.axes.fill(*self.outline.T, color=BAND, lw=0.0)
        area.set_clip_on(False)
        draw_line(self.axes, self.outline, True, ec=SOFT, lw=_EDGE)
        for lines, thick in ((self.seals, seals), (self.welds, welds)):
            for line in lines if thick else ():
                colour = ACCENT if thick == _THICK else INK
                closed = bool(np.allclose(line[0], line[-1]))
                draw_line(self.axes, line, closed, ec=colour, lw=thick, capstyle="butt")
        if self.width and self.mouth is self.root and self.root is not None:  # a nozzle
            self.axes.plot(*self.root, marker="o", ms=6.0, mfc="white", mec=INK, mew=0.8)


def pattern_stage(axes: Any, box: Box, hanging: bool, pattern: Pattern) -> FigureStage:
    """The panel of two equal ones, as large as the box allows; hanging: its neck is turned down."""
    intake = pattern.intake
    neck = intake is not None and intake_kind(intake.kind).place == RIM
    turn = rotation(-0.5 * np.pi - intake.angle) if intake is not None and neck and hanging else np.eye(2)
    cut = max(pattern.of(Role.CUT), key=lambda each: float(np.prod(np.ptp(each.points, axis=0))))
    own = cut.points @ turn
    low, high = bounds(own)
    left, bottom, right, top = box
    room = (1.0 - 2.0 * _ROOM) * np.array([right - left, top - bottom])
    scale = float(np.min(room / (high - low)))
    middle = 0.5 * np.array([left + right, bottom + top])

    def place(points: Floats) -> Floats:
        return np.asarray((points @ turn - 0.5 * (low + high)) * scale + middle)

    lines = {role: tuple(place(each.line) for each in pattern.of(role)) for role in (Role.SEAL, Role.WELD)}
    stage = FigureStage(axes, box, place(cut.points), lines[Role.SEAL], lines[Role.WELD])
    if intake is None:
        return stage
    root, wide = place(intake.at), intake.width * scale
    if not neck:
        return replace(stage, mouth=root, root=root, outward=_DOWN, width=wide)
    outward = direction(intake.angle)
    mouth = place(intake.at + intake.length * outward)
    return replace(stage, mouth=mouth, root=root, outward=outward @ turn, width=wide)


def picture_stage(axes: Any, box: Box, _hanging: bool, pixels: Floats) -> FigureStage:
    """A balloon of which there is a picture (h, w, 4): its neck hangs from its lowest place."""
    height, width = pixels.shape[:2]
    dot = min((box[2] - box[0]) / width, (box[3] - box[1]) / height)
    left, top = 0.5 * (box[0] + box[2] - dot * width), box[3]
    right, bottom = left + dot * width, top - dot * height
    rows, columns = np.nonzero(pixels[:, :, 3] > 0.95)

    def place(row: float, column: float) -> Floats:
        return np.array([left + dot * (column + 0.5), top - dot * (row + 0.5)])

    lowest = rows.max()
    root = place(lowest, float(np.median(columns[rows == lowest])))
    ends = [(row, columns[rows == row]) for row in range(rows.min(), lowest + 1)]
    rim = [place(row, own.min()) for row, own in ends if len(own)]
    rim += [place(row, own.max()) for row, own in reversed(ends) if len(own)]
    wide = 0.06 * (right - left)
    return FigureStage(
        axes,
        (left, bottom, right, top),
        np.array(rim),
        pixels=pixels,
        mouth=root + 1.4 * wide * _DOWN,
        root=root,
        outward=_DOWN,
        width=wide,
    )


def stage_box(name: str, box: Box) -> Box:
    """Where in the box of a figure the balloon is: what hangs from it has its room below."""
    left, bottom, right, top = box
    below = _HOSE if name == "leak" else _BELOW if name in HANGING else 0.0
    return left, bottom + below * (top - bottom), right, top


def draw_figure(name: str, stage: FigureStage, box: Box) -> None:
    """One of the figures that the data name, in its box."""
    _FIGURES[name](replace(stage, box=box, shown=stage.box))


def _outline(stage: FigureStage) -> None:
    stage.draw(seals=_THICK, welds=0.0)


def _inside(stage: FigureStage) -> None:
    stage.draw(welds=_THICK)


def _across(stage: FigureStage) -> None:
    stage.draw()
    _neck_of(stage)
    draw_line(stage.axes, _over_the_neck(stage, 0.5), False, ec=ACCENT, lw=_THICK, capstyle="butt")


def _tube(stage: FigureStage) -> None:
    stage.draw()
    end = _draw_tube(stage)
    _arrow(stage, end, -_out(stage))


def _deflate(stage: FigureStage) -> None:
    stage.draw()
    _arrow(stage, _draw_tube(stage), _out(stage))


def _opened(stage: FigureStage) -> None:
    stage.draw()
    _neck_of(stage)
    line = _over_the_neck(stage, 0.15, 1.5)
    draw_line(stage.axes, line, False, ec=ACCENT, lw=1.2, ls=(0, (3.0, 1.5)), capstyle="butt")
    if stage.mouth is not None:
        _arrow(stage, stage.mouth, _out(stage))


def _leak(stage: FigureStage) -> None:
    """Bubbles on the seam, one of them marked, and a tube to a hose in which water stands higher."""
    stage.draw()
    rim = ring(stage.outline)
    ends = line_lengths(rim)
    for number, place in enumerate(point_on(rim, ends, ends[-1] * np.array(_BUBBLES))):
        for shift, size in (((0.0, 0.0), 3.6), ((1.2, 0.9), 2.4), ((-1.0, 1.1), 2.0)):
            stage.axes.plot(*(place + shift), marker="o", ms=size, mfc="white", mec=_WATER, mew=0.6)
        if number == 0:
            stage.axes.plot(*place, marker="o", ms=11.0, mfc="none", mec=ACCENT, mew=1.0)
    left, bottom, right, _ = stage.box
    x, y = _draw_tube(stage).tolist()
    bend, floor = _BEND * (right - left), bottom + 1.0
    tall = y - floor
    hose = np.array([[x, y], [x, floor], [x + bend, floor], [x + bend, y]])
    draw_line(stage.axes, hose, False, ec=_TUBE, lw=3.6, capstyle="butt")
    draw_line(stage.axes, hose, False, ec=_BORE, lw=2.0, capstyle="butt")
    water = np.array(
        [[x, floor + _LOW * tall], [x, floor], [x + bend, floor], [x + bend, floor + _HIGH * tall]]
    )
    draw_line(stage.axes, water, False, ec=_WATER, lw=2.2, capstyle="butt")


def _ribbon(stage: FigureStage) -> None:
    """From the neck in waves to a weight on the ground."""
    end, wide, tall = _draw_ribbon(stage)
    block = end + np.array([[-0.5, 0.0], [0.5, 0.0], [0.8, -1.0], [-0.8, -1.0]]) * [wide, tall]
    (weight,) = stage.axes.fill(*block.T, color=SOFT, lw=0.0)
    weight.set_clip_on(False)


def _hang(stage: FigureStage) -> None:
    """The same with a loop at its end."""
    end, _, _ = _draw_ribbon(stage)
    stage.axes.plot(*(end - [0.0, 1.4]), marker="o", ms=8.0, mfc="none", mec=ACCENT, mew=0.9)


def _draw_ribbon(stage: FigureStage) -> tuple[Floats, float, float]:
    """From the neck in waves; returns its end (2,), and how wide and high a weight there is."""
    stage.draw()
    _neck_of(stage)
    left, bottom, right, top = stage.box
    start = stage.outline[int(np.argmin(stage.outline[:, 1]))] if stage.root is None else stage.root
    if stage.root is not None and stage.mouth is not None:
        start = 0.5 * (stage.root + stage.mouth)
        draw_line(stage.axes, _over_the_neck(stage, 0.5), False, ec=ACCENT, lw=1.6)
    wide, tall = _WEIGHT[0] * (right - left), _WEIGHT[1] * (top - bottom)
    end = np.array([right - wide, bottom + tall])
    share = np.linspace(0.0, 1.0, 60)[:, None]
    waves = 0.9 * np.sin(6.0 * np.pi * share) * np.sin(np.pi * share) * [1.0, 0.0]
    hanging = (1.0 - share) * start + share * end + waves - [0.0, 3.0] * (share * (1.0 - share))
    draw_line(stage.axes, hanging, False, ec=ACCENT, lw=0.9)
    return end, wide, tall


def _out(stage: FigureStage) -> Floats:
    return _DOWN if stage.outward is None else stage.outward


def _neck_of(stage: FigureStage) -> None:
    """The neck of a balloon that is shown by its picture, which has none."""
    if stage.pixels is None or stage.root is None or stage.mouth is None:
        return
    across = 0.5 * stage.width * perpendicular(_out(stage))
    inner = stage.root - 0.3 * stage.width * _out(stage)
    corners = np.array([inner - across, stage.mouth - across, stage.mouth + across, inner + across])
    draw_line(stage.axes, corners, False, ec=SOFT, lw=1.0)


def _over_the_neck(stage: FigureStage, share: float, reach: float = 1.0) -> Floats:
    """A line across the neck (2, 2), at a share of its length from its root, so much wider than it."""
    if stage.root is None or stage.mouth is None:
        return np.empty((0, 2))
    middle = (1.0 - share) * stage.root + share * stage.mouth
    across = 0.5 * reach * max(stage.width, _LEAST) * perpendicular(_out(stage))
    return np.array([middle - across, middle + across])


def _draw_tube(stage: FigureStage) -> Floats:
    """A tube through the neck; returns its outer end (2,)."""
    _neck_of(stage)
    if stage.root is None or stage.mouth is None:
        return np.array([0.5 * (stage.box[0] + stage.box[2]), stage.box[1]])
    step = max(stage.width, _LEAST)
    inner, outer = stage.root - _IN * step * _out(stage), stage.mouth + _OUT * step * _out(stage)
    draw_line(stage.axes, np.array([inner, outer]), False, ec=_TUBE, lw=3.6, capstyle="butt")
    draw_line(stage.axes, np.array([inner, outer]), False, ec=_BORE, lw=2.0, capstyle="butt")
    return outer


def _arrow(stage: FigureStage, at: Floats, way: Floats) -> None:
    """How the gas goes, beside a place."""
    beside = at + 2.6 * perpendicular(way)
    look = {"arrowstyle": "-|>,head_width=0.16,head_length=0.4", "color": ACCENT, "lw": 1.2}
    arrow = {**look, "shrinkA": 0.0, "shrinkB": 0.0}
    stage.axes.annotate(
        "", xy=beside + 3.5 * way, xytext=beside - 3.5 * way, arrowprops=arrow, annotation_clip=False
    )


_FIGURES: dict[str, Callable[[FigureStage], None]] = {
    "outline": _outline,
    "inside": _inside,
    "across": _across,
    "neck": _across,
    "leak": _leak,
    "tube": _tube,
    "opened": _opened,
    "deflate": _deflate,
    "ribbon": _ribbon,
    "hang": _hang,
}
#: What the data may name, and of these what shows a balloon that hangs.
FIGURES = tuple(_FIGURES)
HANGING = ("leak", "tube", "neck", "opened", "deflate", "ribbon", "hang")
