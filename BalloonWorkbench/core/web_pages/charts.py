# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts of a web page as SVG, of plain data: points, a histogram, tornado bars. Same bytes for same data."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.core.web_pages.page import Markup, element

_WIDTH, _HEIGHT = 480.0, 300.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 84.0, 26.0, 12.0, 46.0
_TICKS = 5
_ROW = 26.0
_NAME = 150.0  # room for the names of bars
_MOST_LETTERS = 22
_POINT = 3.5


@dataclass(frozen=True)
class Axis:
    """An axis: what it counts, its least and largest value, its ticks."""

    title: str
    least: float
    most: float
    ticks: tuple[float, ...]

    def share(self, value: float) -> float:
        """Where a value is between both ends."""
        return (value - self.least) / (self.most - self.least)


@dataclass(frozen=True)
class Bar:
    """What a result becomes when one value is at its lower and at its upper end."""

    name: str
    low: float
    high: float


def axis_of(title: str, values: Sequence[float]) -> Axis:
    """An axis that holds all values; its ticks are round numbers (1, 2 or 5 times a power of ten)."""
    least, most = min(values), max(values)
    if not most - least > 1e-12 * max(abs(least), abs(most)):
        reach = 0.5 * abs(most) or 1.0
        least, most = least - reach, most + reach
    rough = (most - least) / _TICKS
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= rough * (1.0 - 1e-9))
    first, last = math.floor(least / step + 1e-9), math.ceil(most / step - 1e-9)
    ticks = tuple(step * k for k in range(first, last + 1))
    return Axis(title, ticks[0], ticks[-1], ticks)


def scatter_chart(
    title: str, across: tuple[str, Sequence[float]], up: tuple[str, Sequence[float]], names: Sequence[str]
) -> Markup:
    """A point for each pair of finite values: (title, values) of both axes; names show under the mouse."""
    pairs = [
        (x, y, name)
        for x, y, name in zip(across[1], up[1], names, strict=True)
        if math.isfinite(x) and math.isfinite(y)
    ]
    if not pairs:
        return _empty(title)
    x_axis = axis_of(across[0], [x for x, _, _ in pairs])
    y_axis = axis_of(up[0], [y for _, y, _ in pairs])
    points = [
        element(
            "circle",
            element("title", f"{name}: {number_text(x, 4)}, {number_text(y, 4)}"),
            cx=_text(_x(x_axis, x)),
            cy=_text(_y(y_axis, y)),
            r=_text(_POINT),
            class_="mark",
            fill_opacity="0.7",
        )
        for x, y, name in pairs
    ]
    return _chart(title, [*_grid(x_axis, y_axis), *points])


def histogram_chart(title: str, counted: tuple[str, Sequence[float]], unit: str) -> Markup:
    """How many of the finite values lie in each of some even ranges; unit: what is counted."""
    values = [value for value in counted[1] if math.isfinite(value)]
    if not values:
        return _empty(title)
    x_axis = axis_of(counted[0], values)
    count = max(5, min(40, round(math.sqrt(len(values)))))
    step = (x_axis.most - x_axis.least) / count
    heights = [0] * count
    for value in values:
        heights[min(int((value - x_axis.least) / step), count - 1)] += 1
    y_axis = axis_of(unit, [0.0, float(max(heights))])
    bars = []
    for number, height in enumerate(heights):
        start, end = (_x(x_axis, x_axis.least + k * step) for k in (number, number + 1))
        low, high = _y(y_axis, 0.0), _y(y_axis, float(height))
        label = element("title", f"{number_text(x_axis.least + number * step, 4)}: {height}")
        bars.append(_bar(start + 0.5, high, end - start - 1.0, low - high, "mark", label))
    return _chart(title, [*_grid(x_axis, y_axis), *bars])


def tornado_chart(title: str, result: str, middle: float, bars: Sequence[Bar]) -> Markup:
    """The bars of what changes a result, the longest first, about its value where nothing is changed."""
    known = [bar for bar in bars if math.isfinite(bar.low) and math.isfinite(bar.high)]
    if not known:
        return _empty(title)
    known.sort(key=lambda bar: (-abs(bar.high - bar.low), bar.name))
    axis = axis_of(result, [middle, *(bar.low for bar in known), *(bar.high for bar in known)])
    height = _TOP + _ROW * len(known) + _BOTTOM

    def place(value: float) -> float:
        return _NAME + axis.share(value) * (_WIDTH - _NAME - _RIGHT)

    parts = _ticks_below(axis, place, height)
    for row, bar in enumerate(known):
        top = _TOP + _ROW * row + 4.0
        label = element("title", f"{bar.name}: {number_text(bar.low, 4)}, {number_text(bar.high, 4)}")
        for value, kind in ((bar.low, "other"), (bar.high, "mark")):
            start, end = sorted((place(middle), place(value)))
            parts.append(_bar(start, top, end - start, _ROW - 8.0, kind, label))
        short = bar.name if len(bar.name) <= _MOST_LETTERS else f"{bar.name[: _MOST_LETTERS - 1]}…"
        parts.append(_words(_NAME - 8.0, top + 13.0, short, "end"))
    line = _line(place(middle), _TOP, place(middle), height - _BOTTOM, "axis")
    return _chart(title, [*parts, line], height)


def _x(axis: Axis, value: float) -> float:
    return _LEFT + axis.share(value) * (_WIDTH - _LEFT - _RIGHT)


def _y(axis: Axis, value: float) -> float:
    return _HEIGHT - _BOTTOM - axis.share(value) * (_HEIGHT - _TOP - _BOTTOM)


def _grid(x_axis: Axis, y_axis: Axis) -> list[Markup]:
    parts = _ticks_below(x_axis, lambda value: _x(x_axis, value), _HEIGHT)
    for tick in y_axis.ticks:
        at = _y(y_axis, tick)
        parts += [
            _line(_LEFT, at, _WIDTH - _RIGHT, at, "grid"),
            _words(_LEFT - 6.0, at + 4.0, number_text(tick, 6), "end"),
        ]
    middle = 0.5 * (_TOP + _HEIGHT - _BOTTOM)
    turn = f"rotate(-90 14 {_text(middle)})"
    return [*parts, _words(14.0, middle, y_axis.title, "middle", turn)]


def _ticks_below(axis: Axis, place: Callable[[float], float], height: float) -> list[Markup]:
    parts = []
    for tick in axis.ticks:
        parts += [
            _line(place(tick), _TOP, place(tick), height - _BOTTOM, "grid"),
            _words(place(tick), height - _BOTTOM + 16.0, number_text(tick, 6), "middle"),
        ]
    middle = 0.5 * (place(axis.least) + place(axis.most))
    return [*parts, _words(middle, height - 8.0, axis.title, "middle")]


def _chart(title: str, parts: Sequence[Markup], height: float = _HEIGHT) -> Markup:
    box = f"0 0 {_text(_WIDTH)} {_text(height)}"
    drawing = element("svg", *parts, viewBox=box, class_="plot", role="img", aria_label=title)
    return element("figure", element("figcaption", title), drawing)


def _empty(title: str) -> Markup:
    return _chart(title, [], _TOP)


def _bar(x: float, y: float, width: float, height: float, kind: str, label: Markup) -> Markup:
    sizes = {"x": x, "y": y, "width": max(width, 0.0), "height": max(height, 0.0)}
    return element("rect", label, **{name: _text(value) for name, value in sizes.items()}, class_=kind)


def _line(x1: float, y1: float, x2: float, y2: float, kind: str) -> Markup:
    return element("line", x1=_text(x1), y1=_text(y1), x2=_text(x2), y2=_text(y2), class_=kind)


def _words(x: float, y: float, text: str, anchor: str, transform: str | None = None) -> Markup:
    return element("text", text, x=_text(x), y=_text(y), text_anchor=anchor, transform=transform)


def _text(value: float) -> str:
    return number_text(round(value, 2), 6)
