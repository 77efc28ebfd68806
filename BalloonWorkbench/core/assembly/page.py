# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet as a PDF of one page: pattern to scale, balloon, sizes, material, numbers, steps."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.assembly.steps import steps
from BalloonWorkbench.core.assembly.texts import broken, figures, material
from BalloonWorkbench.core.errors import ExportError, MissingPackageError
from BalloonWorkbench.core.export.layers import LAYERS
from BalloonWorkbench.core.export.render import balloon_picture
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.maker.numbers import Numbers
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

#: Pages by name, upright [mm].
PAGES = {"A4": (210.0, 297.0), "Letter": (215.9, 279.4)}
_INCH = 25.4
_MARGIN = 13.0
_INK, _SOFT, _RULE, _BAND = "#1f2937", "#64748b", "#d3d9e3", "#f2f4f8"
_ACCENT = "#c81e4a"
#: Scales of the drawing: 1 to so many.
_SCALES = (*np.arange(1.0, 8.0, 0.5), *range(8, 12), 12, 15, 20, 25, 30, 40, 50, 75, 100)
_BAR = 50.0
_NAMES = {
    Role.CUT: "cut",
    Role.CUT_INNER: "cut inside",
    Role.SEAL: "weld",
    Role.WELD: "weld inside",
    Role.MARK: "mark",
}
#: Height of a line of the lists [mm], dots of the balloon's picture per mm.
_LINE, _DOTS = 4.2, 6.0
_LETTERS = 44  # of a line of the lists
#: Width of a letter of the body text, in parts of its size; points to millimetres.
_LETTER, _POINT = 0.535, 25.4 / 72.0


@dataclass(frozen=True)
class Subject:
    """What the sheet is about: a name, what it is made of, how it inflates, its panel and its numbers."""

    title: str
    film: Film
    inflation: Inflation
    pattern: Pattern
    numbers: Numbers


def assembly_pdf(subject: Subject, paper: str = "A4") -> bytes:
    """The page; the same bytes for the same subject.

    ExportError for other paper than "A4" and "Letter", MissingPackageError without matplotlib.
    """
    size = PAGES.get("A4" if paper.upper() == "A4" else paper.capitalize())
    if size is None:
        raise ExportError(f'There is no paper "{paper}" for the assembly sheet: choose A4 or Letter.')
    try:
        from matplotlib import rc_context
        from matplotlib.backends.backend_pdf import FigureCanvasPdf
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingPackageError(
            "The assembly sheet needs matplotlib: install it with pip install matplotlib."
        ) from error
    with rc_context({"pdf.fonttype": 42, "pdf.compression": 6, "font.family": "DejaVu Sans"}):
        figure = Figure(figsize=(size[0] / _INCH, size[1] / _INCH))
        canvas = FigureCanvasPdf(figure)
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_xlim(0.0, size[0])
        axes.set_ylim(0.0, size[1])
        axes.axis("off")
        _fill(axes, subject, size)
        stream = io.BytesIO()
        # no date: the same bytes again
        told = {"Title": f"{subject.title}: assembly sheet", "CreationDate": None, "Creator": None}
        canvas.print_pdf(stream, metadata={**told, "Producer": None})
    return stream.getvalue()


def _fill(axes: Any, subject: Subject, size: tuple[float, float]) -> None:
    width, height = size
    right, top = width - _MARGIN, height - _MARGIN
    _head(axes, subject, right, top)
    work = steps(subject.pattern, subject.film, subject.numbers)
    columns = _wrapped(work, 0.5 * (right - _MARGIN - 6.0))
    foot = _MARGIN + 6.0
    steps_top = foot + 10.0 + max(_tall(column) for column in columns)
    _steps(axes, columns, steps_top, right)
    lists = (material(subject.film, subject.pattern, subject.numbers), figures(subject.numbers))
    lists_top = (
        steps_top
        + 12.0
        + _LINE * max(sum(len(broken(value, _LETTERS)) for _, value in rows) for rows in lists)
    )
    for title, rows, x in zip(("Material", "Numbers"), lists, (_MARGIN, _half(right))):
        _list(axes, title, rows, x, lists_top)
    split = _MARGIN + 0.6 * (right - _MARGIN)
    scale = _pattern(axes, subject.pattern, (_MARGIN, lists_top + 6.0, split - 4.0, top - 17.0))
    _balloon(axes, subject, (split + 4.0, lists_top + 6.0, right, top - 17.0), size)
    _foot(axes, scale, foot, right)


def _half(right: float) -> float:
    """Where the second of two columns begins [mm]."""
    return _MARGIN + 0.5 * (right - _MARGIN + 6.0)


def _text(axes: Any, x: float, y: float, text: str, size: float = 8.0, **look: Any) -> None:
    look = {"color": _INK, "va": "baseline", **look}
    axes.text(x, y, text, fontsize=size, parse_math=False, **look)


def _head(axes: Any, subject: Subject, right: float, top: float) -> None:
    low, high = subject.inflation.positions.min(axis=0), subject.inflation.positions.max(axis=0)
    across, up, _ = to_mm(high - low)
    thick = to_mm(2.0 * float(high[2]))
    _text(axes, _MARGIN, top - 6.5, subject.title, 20.0, fontweight="bold")
    litres = 1e3 * subject.numbers.volume
    told = f"Assembly sheet  ·  inflated {across:.0f} × {up:.0f} × {thick:.0f} mm, {litres:.3g} litres"
    _text(axes, _MARGIN, top - 12.0, told, 9.0, color=_SOFT)
    axes.plot([_MARGIN, right], [top - 14.6, top - 14.6], color=_ACCENT, lw=1.6, solid_capstyle="butt")


def _pattern(axes: Any, pattern: Pattern, box: tuple[float, float, float, float]) -> float:
    """The panel with its dimensions; returns the scale it is drawn in."""
    left, bottom, right, top = box
    _heading(axes, left, top - 3.4, "Pattern, cut two (one mirrored)")
    inside = (left + 10.0, bottom + 17.0, right, top - 7.0)
    low, high = (to_mm(corner) for corner in pattern.bounds)
    room = np.array([inside[2] - inside[0], inside[3] - inside[1]])
    need = float(np.max((high - low) / room))
    scale = next((scale for scale in _SCALES if scale >= need), need)
    middle = np.array([0.5 * (inside[0] + inside[2]), 0.5 * (inside[1] + inside[3])])

    def place(points: Floats) -> Floats:
        return np.asarray((points - 0.5 * (low + high)) / scale + middle)

    for contour in sorted(pattern.contours, key=lambda each: each.role is not Role.CUT):
        points = to_mm(contour.points)
        points = place(np.concatenate([points, points[:1]]) if contour.closed else points)
        if contour.role is Role.CUT:
            axes.fill(*points.T, color=_BAND, lw=0.0)
        elif contour.role is Role.CUT_INNER:
            axes.fill(*points.T, color="#ffffff", lw=0.0)
        dashed = contour.role in (Role.SEAL, Role.WELD)
        style = {"ls": (0, (4.0, 2.0))} if dashed else {}
        thin = 0.25 if contour.role is Role.ENGRAVE else 0.9
        axes.plot(*points.T, color=LAYERS[contour.role].rgb, lw=thin, solid_joinstyle="round", **style)
    (x0, y0), (x1, y1) = place(low), place(high)
    width, height = high - low
    _dimension(axes, (x0, y0 - 5.0), (x1, y0 - 5.0), f"{width:.1f} mm")
    _dimension(axes, (x0 - 5.0, y0), (x0 - 5.0, y1), f"{height:.1f} mm", 90.0)
    for x in (x0, x1):
        axes.plot([x, x], [y0 - 6.5, y0 - 1.0], color=_SOFT, lw=0.4)
    for y in (y0, y1):
        axes.plot([x0 - 6.5, x0 - 1.0], [y, y], color=_SOFT, lw=0.4)
    at = left + 10.0
    for role in pattern.roles:
        if role not in _NAMES:
            continue
        style = {"ls": (0, (3.0, 1.5))} if role in (Role.SEAL, Role.WELD) else {}
        axes.plot([at, at + 7.0], [bottom + 3.0, bottom + 3.0], color=LAYERS[role].rgb, lw=1.2, **style)
        _text(axes, at + 8.5, bottom + 3.0, _NAMES[role], 7.0, color=_SOFT, va="center")
        at += 14.0 + 1.4 * len(_NAMES[role])
    return float(scale)


def _dimension(
    axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, rotation: float = 0.0
) -> None:
    arrow = {"arrowstyle": "<|-|>,head_width=0.12,head_length=0.3", "color": _SOFT, "lw": 0.6}
    axes.annotate("", xy=end, xytext=start, arrowprops={**arrow, "shrinkA": 0.0, "shrinkB": 0.0})
    middle = 0.5 * (np.array(start) + np.array(end))
    box = {"fc": "white", "ec": "none", "pad": 1.2}
    axes.text(*middle, text, fontsize=8.0, color=_INK, ha="center", va="center", rotation=rotation, bbox=box)


def _balloon(
    axes: Any, subject: Subject, box: tuple[float, float, float, float], size: tuple[float, float]
) -> None:
    left, bottom, right, top = box
    _heading(axes, left, top - 3.4, "Inflated")
    wide, tall = right - left, top - 7.0 - bottom
    pixels = int(_DOTS * wide), int(_DOTS * tall)
    picture = balloon_picture(
        [subject.inflation], subject.pattern.seal_width, *pixels, subject.film.look.colour
    )
    axes.imshow(picture, extent=(left, right, bottom, top - 7.0), interpolation="nearest", aspect="auto")
    axes.set_xlim(0.0, size[0])
    axes.set_ylim(0.0, size[1])


def _list(axes: Any, title: str, rows: Sequence[tuple[str, str]], x: float, top: float) -> None:
    """Figures with their names, from an upper edge downward."""
    _heading(axes, x, top - 3.4, title)
    y = top - 6.0
    for name, value in rows:
        _text(axes, x, y - 3.0, name, color=_SOFT)
        for line in broken(value, _LETTERS):
            _text(axes, x + 23.0, y - 3.0, line)
            y -= _LINE


def _wrapped(work: Sequence[str], width: float) -> tuple[list[tuple[int, list[str]]], ...]:
    """The steps in two columns of equal height, each as its number and lines."""
    letters = int((width - 7.0) / (8.0 * _POINT * _LETTER))
    told = [(number, broken(text, letters)) for number, text in enumerate(work, 1)]
    half = min(range(len(told) + 1), key=lambda at: (abs(_tall(told[:at]) - _tall(told[at:])), -at))
    return told[:half], told[half:]


def _tall(column: Sequence[tuple[int, list[str]]]) -> float:
    return sum(2.2 + 3.7 * len(lines) for _, lines in column)


def _steps(axes: Any, columns: Sequence[list[tuple[int, list[str]]]], top: float, right: float) -> None:
    axes.plot([_MARGIN, right], [top + 4.5, top + 4.5], color=_RULE, lw=0.8)
    _heading(axes, _MARGIN, top - 1.6, "Steps")
    for number, column in enumerate(columns):
        x = _half(right) if number else _MARGIN
        y = top - 6.0
        for count, lines in column:
            axes.plot([x + 2.2], [y - 1.6], marker="o", ms=11.0, color=_ACCENT, mew=0.0)
            _text(
                axes,
                x + 2.2,
                y - 1.7,
                str(count),
                7.0,
                color="white",
                ha="center",
                va="center",
                fontweight="bold",
            )
            for line in lines:
                _text(axes, x + 7.0, y - 2.6, line)
                y -= 3.7
            y -= 2.2


def _foot(axes: Any, scale: float, y: float, right: float) -> None:
    """A bar to check the print, and the same length of the balloon."""
    axes.plot([_MARGIN, right], [y + 2.5, y + 2.5], color=_RULE, lw=0.8)
    base = y - 4.5
    for k in range(5):
        x = _MARGIN + k * _BAR / 5.0
        colour = _INK if k % 2 == 0 else "white"
        axes.fill(
            [x, x + 10.0, x + 10.0, x], [base, base, base + 1.6, base + 1.6], fc=colour, ec=_INK, lw=0.5
        )
    told = f"{_BAR:g} mm on paper = {_BAR * scale:g} mm of film"
    _text(axes, _MARGIN + _BAR + 3.0, base, told, 7.5)
    _text(axes, right, base, f"Pattern drawn 1 : {scale:.3g}", 7.5, color=_SOFT, ha="right")


def _heading(axes: Any, x: float, y: float, text: str) -> None:
    _text(axes, x, y, text, 9.0, fontweight="bold", color=_ACCENT)
