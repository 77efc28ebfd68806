# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cards of a preview picture: a sheet of 1800 x 1000 pixels, and what stands on it."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text

WIDTH, HEIGHT, DPI = 1800, 1000, 100
PAPER, CARD, EDGE = "#eef0f4", "#ffffff", "#d5d9e1"
INK, SOFT = "#232a36", "#6b7484"


def cards_png(draw: Callable[[Any], None]) -> bytes:
    """The PNG of what is drawn on a figure of matplotlib; the same bytes for the same.

    MissingPackageError without matplotlib.
    """
    try:
        from matplotlib import style
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingPackageError(
            "The preview picture needs matplotlib: install it with pip install matplotlib."
        ) from error
    with style.context("default"):  # not as the user's other diagrams
        figure = Figure(figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI, facecolor=PAPER)
        canvas = FigureCanvasAgg(figure)
        draw(figure)
        stream = io.BytesIO()
        canvas.print_png(stream, metadata={"Software": None})
    return stream.getvalue()


def card(figure: Any, x: int, y: int, width: int, height: int, title: str) -> Any:
    """Axes that fill a card with the title on it; one unit is one pixel."""
    from matplotlib.patches import FancyBboxPatch

    axes = figure.add_axes((x / WIDTH, y / HEIGHT, width / WIDTH, height / HEIGHT))
    axes.set_xlim(0, width)
    axes.set_ylim(0, height)
    axes.axis("off")
    card = FancyBboxPatch(
        (7, 7), width - 14, height - 14, boxstyle="round,pad=6,rounding_size=14", fc=CARD, ec=EDGE, lw=1.0
    )
    axes.add_patch(card)
    axes.text(24, height - 36, title, color=INK, fontsize=14, fontweight="bold", va="center")
    return axes


def caption(axes: Any, text: str, color: str = SOFT) -> None:
    """A line at the foot of a card, smaller where the card is too narrow for it."""
    line = axes.text(24, 30, text, color=color, fontsize=11, va="center")
    width = line.get_window_extent(axes.figure.canvas.get_renderer()).width
    line.set_fontsize(11.0 * min(1.0, (axes.get_xlim()[1] - 48.0) / max(width, 1.0)))


class CardFrame:
    """Millimetres to pixels: a box of the drawing fitted into a box of the card."""

    def __init__(self, low: Floats, high: Floats, box: tuple[float, float, float, float]) -> None:
        left, bottom, right, top = box
        self.scale = float(min((right - left) / (high[0] - low[0]), (top - bottom) / (high[1] - low[1])))
        self.shift = np.array([0.5 * (left + right), 0.5 * (bottom + top)]) - 0.5 * self.scale * (low + high)

    def __call__(self, points: Floats) -> Floats:
        """Points (n, 2) mm in pixels of the card."""
        return points * self.scale + self.shift


def box_inside(
    axes: Any, left: float, bottom: float, right: float, top: float
) -> tuple[float, float, float, float]:
    """Left, lower, right and upper end of a card without its margins [pixels]."""
    return left, bottom, axes.get_xlim()[1] - right, axes.get_ylim()[1] - top


def dimension(
    axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, rotation: float = 0.0
) -> None:
    """An arrow with two heads and its length."""
    axes.annotate(
        "",
        xy=end,
        xytext=start,
        arrowprops={"arrowstyle": "<|-|>", "color": SOFT, "lw": 0.8, "shrinkA": 0, "shrinkB": 0},
    )
    middle = 0.5 * (np.array(start) + np.array(end))
    axes.text(
        *middle, text, color=INK, fontsize=11, ha="center", va="center", rotation=rotation,
        bbox={"fc": CARD, "ec": "none", "pad": 2.0},
    )  # fmt: skip


def scale_bar(axes: Any, scale: float) -> None:
    """100 mm where that fits, else the nearest power of ten."""
    length = 100.0
    while length * scale > 240.0:
        length /= 10.0
    while length * scale < 24.0:
        length *= 10.0
    right, y = axes.get_xlim()[1] - 30, 62
    left = right - length * scale
    axes.plot([left, left, left, right, right, right], [y - 6, y + 6, y, y, y - 6, y + 6], color=INK, lw=1.4)
    axes.text(
        0.5 * (left + right),
        y + 16,
        length_text(from_mm(length)),
        color=INK,
        fontsize=10,
        ha="center",
        va="center",
    )
