# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film valve on the assembly sheet: strips in their neck, and what is done to them in which order."""

from __future__ import annotations

from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly_sheet.pen import ACCENT, BAND, INK, SOFT, Pen
from BalloonWorkbench.core.geometry.vectors import direction, perpendicular
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.intake.valve import strips
from BalloonWorkbench.core.pattern.pattern import Contour, Intake, Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

_STRIP, _INKED = "#cfe8df", "#8fb8a8"
#: What is shown beside the strips [mm of film].
_BESIDE = 8.0
#: Lines of the legend below [mm].
_LINE = 4.2


def has_valve(pattern: Pattern) -> bool:
    """Whether an intake of the pattern has strips to be drawn."""
    return any(strips(intake, pattern.seal_width) for intake in pattern.intakes)


def draw_valve(pen: Pen, pattern: Pattern, box: tuple[float, float, float, float]) -> None:
    """The first valve in a box of the page: the neck's mouth at the left, the balloon at the right."""
    from matplotlib.patches import Rectangle

    left, bottom, right, top = box
    intake = next(each for each in pattern.intakes if strips(each, pattern.seal_width))
    pen.heading(left, top - 3.4, pen.say("Valve, on one panel"), right - left)
    pieces = strips(intake, pattern.seal_width)
    ends = np.concatenate([_beside_axis(line.points, intake) for piece in pieces for line in piece])
    low, high = ends.min(axis=0) - _BESIDE, ends.max(axis=0) + _BESIDE
    order = (
        pen.say("Ink, or a slip of baking paper"),
        pen.say("Strips welded together"),
        pen.say("Tacked to one panel"),
        pen.say("Welded across, last"),
    )
    legend = _LINE * len(order) + 2.0
    room = np.array([right - left, top - 7.0 - bottom - legend])
    scale = float(np.min(room / (high - low)))
    middle = np.array([0.5 * (left + right), bottom + legend + 0.5 * room[1]])
    window = Rectangle(
        middle - 0.5 * scale * (high - low), *(scale * (high - low)), transform=pen.axes.transData
    )

    def place(points: Floats) -> Floats:
        return np.asarray((_beside_axis(points, intake) - 0.5 * (low + high)) * scale + middle)

    for contour in sorted(pattern.contours, key=lambda each: each.role is not Role.CUT):
        _line(pen.axes, contour, place, window, BAND if contour.role is Role.CUT else None)
    for number, piece in enumerate(pieces):
        for contour in sorted(piece, key=lambda each: each.role is not Role.CUT):
            colour = _STRIP if contour.role is Role.CUT and number == 0 else None
            inked = contour.role is Role.PEN and contour.closed
            _line(pen.axes, contour, place, window, _INKED if inked else colour)
    _steps(pen, pieces, place, order, (left, bottom + legend - 2.0 - 0.7 * _LINE, right))


def _beside_axis(points: Floats, intake: Intake) -> Floats:
    """Points (n, 2) mm from the neck's root: inward to the right, across upward."""
    axis = direction(intake.angle)
    return np.asarray(-to_mm(points - intake.at) @ np.column_stack([axis, perpendicular(axis)]))


def _line(axes: Any, contour: Contour, place: Any, window: Any, filled: str | None) -> None:
    points = place(contour.line)
    if filled is not None:
        (area,) = axes.fill(*points.T, color=filled, lw=0.0)
        area.set_clip_path(window)
    style: dict[str, Any] = {"ls": (0, (4.0, 2.0))} if contour.role is Role.SEAL else {}
    thin = 0.25 if contour.role is Role.ENGRAVE else 0.8
    (drawn,) = axes.plot(*points.T, color=LAYERS[contour.role].rgb, lw=thin, **style)
    drawn.set_clip_path(window)


def _steps(
    pen: Pen,
    pieces: tuple[tuple[Contour, ...], ...],
    place: Any,
    order: tuple[str, ...],
    legend: tuple[float, float, float],
) -> None:
    """A letter at each place of the work, and below what it means: x and y of the first line, last x."""
    drawn = [line for piece in pieces for line in piece if line.role is Role.PEN]
    field = place(next(line.points for line in drawn if line.closed))
    across = place(next(line.points for line in drawn if not line.closed))
    welds = [place(line.points) for line in pieces[0] if line.role is Role.SEAL]
    tacks = [np.array([across[0, 0], weld[0, 1]]) for weld in welds]
    for tack in tacks:
        pen.axes.plot(*tack, marker="o", ms=3.0, color=INK, mew=0.0)
    places = (
        field.mean(axis=0),
        welds[0].mean(axis=0),
        max(tacks, key=lambda tack: float(tack[1])) + np.array([2.6, 0.0]),
        across[int(np.argmin(across[:, 1]))] - np.array([0.0, 1.0]),
    )
    look: dict[str, Any] = {"ha": "center", "va": "center", "color": "white", "bold": True}
    x, y, right = legend
    for letter, at, text in zip("ABCD", places, order, strict=True):
        for spot in (at, np.array([x + 1.5, y])):
            pen.axes.plot(*spot, marker="o", ms=7.5, color=ACCENT, mew=0.0)
            pen.text(float(spot[0]), float(spot[1]), letter, 6.0, **look)
        pen.text(x + 5.0, y, text, 7.0, right - x - 5.0, va="center", color=SOFT)
        y -= _LINE
