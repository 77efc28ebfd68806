# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a preview picture is drawn on: areas, lines and texts with smooth edges, by Pillow.

Pillow comes with matplotlib, whose font is used. A diagram of matplotlib's own takes many times as long, most
of it to load.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.geometry.polyline import line_lengths, point_on
from BalloonWorkbench.core.types import Floats

#: Pixels of a point of type.
_POINT = 100.0 / 72.0
#: Edges are smooth because masks are drawn so many times as large.
_FINER = 4


class PreviewCanvas:
    """A picture of pixels; y is up, as in a drawing."""

    def __init__(self, width: int, height: int, paper: str) -> None:
        image, self._draw, self._font = _pillow()
        self.width, self.height = width, height
        self._new = image.new
        self._of = image.fromarray
        self._image = image.new("RGB", (width, height), paper)

    def png(self) -> bytes:
        """The file; the same bytes for the same picture."""
        stream = io.BytesIO()
        self._image.save(stream, "PNG", compress_level=4)
        return stream.getvalue()

    def area(self, loops: Sequence[Floats], colour: str, opacity: float = 1.0) -> None:
        """A filled shape: a loop (n, 2), and holes in it."""

        def drawn(draw: Any, to_mask: Callable[[Floats], Any]) -> None:
            for number, loop in enumerate(loops):
                draw.polygon(to_mask(loop), fill=0 if number else 255)

        self._masked(np.concatenate(loops), 1.0, drawn, colour, opacity)

    def lines(
        self,
        lines: Sequence[Floats],
        colour: str,
        width: float,
        *,
        dash: tuple[float, float] | None = None,
        opacity: float = 1.0,
    ) -> None:
        """Lines (n, 2) with round ends, so many points wide; dash: drawn and left out, in widths."""
        if not lines:
            return
        if dash is not None:
            lines = [part for line in lines for part in _dashed(line, *(width * _POINT * np.array(dash)))]
        wide = width * _POINT * _FINER

        def drawn(draw: Any, to_mask: Callable[[Floats], Any]) -> None:
            for line in lines:
                points = to_mask(line)
                draw.line(points, fill=255, width=max(1, round(wide)), joint="curve")
                if wide > 2.0 * _FINER and dash is None:
                    for x, y in (points[0], points[-1]):
                        draw.ellipse((x - wide / 2, y - wide / 2, x + wide / 2, y + wide / 2), fill=255)

        self._masked(np.concatenate(lines), width * _POINT, drawn, colour, opacity)

    def box(self, low: tuple[float, float], high: tuple[float, float], fill: str, edge: str) -> None:
        """A box with round corners and an edge of a point."""
        for inner, colour in ((0.0, edge), (_POINT, fill)):
            corners = np.array([low, high]) + np.array([[inner], [-inner]])

            def drawn(draw: Any, to_mask: Callable[[Floats], Any], corners: Floats = corners) -> None:
                (left, bottom), (right, top) = to_mask(corners)
                draw.rounded_rectangle((left, top, right, bottom), 14 * _FINER, fill=255)

            self._masked(corners, 0.0, drawn, colour, 1.0)

    def text_width(self, text: str, size: float, bold: bool = False) -> float:
        """How wide a text of a size in points is [pixels]."""
        return float(self._font(size * _POINT, bold).getlength(text))

    def text(
        self,
        place: tuple[float, float],
        text: str,
        size: float,
        colour: str,
        *,
        bold: bool = False,
        centre: float = 0.0,
        upright: bool = False,
        paper: str | None = None,
    ) -> None:
        """A line of text at half its height.

        centre: the part of it that is before the place; upright: it runs upward; paper: behind it
        """
        font = self._font(size * _POINT, bold)
        ascent, descent = font.getmetrics()
        room = (int(np.ceil(font.getlength(text))) + 4, ascent + descent)
        mask = self._new("L", room, 0)
        self._draw(mask).text((2, 0), text, fill=255, font=font)
        x, y = place[0] - 2 - centre * (room[0] - 4), place[1]
        left, top = x, self.height - y - 0.5 * room[1]
        if upright:
            mask = mask.transpose(2)  # a quarter turn to the left
            left, top = place[0] - 0.5 * room[1], self.height - place[1] - 0.5 * room[0]
        box = round(left), round(top), round(left) + mask.size[0], round(top) + mask.size[1]
        if paper is not None:
            self._image.paste(paper, box)
        self._image.paste(colour, box, mask)

    def picture(self, pixels: Floats, left: int, bottom: int) -> None:
        """A picture (h, w, 3 or 4) of values from 0 to 1, with its lower left corner there."""
        shown = self._of(np.round(255.0 * pixels).astype(np.uint8))
        place = left, self.height - bottom - len(pixels)
        self._image.paste(shown.convert("RGB"), place, shown if pixels.shape[2] == 4 else None)

    def _masked(
        self,
        points: Floats,
        margin: float,
        draw: Callable[[Any, Callable[[Floats], Any]], None],
        colour: str,
        opacity: float,
    ) -> None:
        """What is drawn into a finer mask of the place of some points."""
        low = np.floor(points.min(axis=0) - margin - 1.0).astype(int).clip(0)
        high = np.minimum(np.ceil(points.max(axis=0) + margin + 1.0).astype(int), (self.width, self.height))
        wide, tall = (high - low).tolist()
        if wide <= 0 or tall <= 0:
            return
        mask = self._new("L", (_FINER * wide, _FINER * tall), 0)

        def to_mask(points: Floats) -> Any:
            return [tuple(at) for at in ((points - (low[0], high[1])) * (_FINER, -_FINER)).tolist()]

        draw(self._draw(mask), to_mask)
        mask = mask.reduce(_FINER)
        if opacity < 1.0:
            mask = mask.point(lambda value: opacity * value)
        top = self.height - int(high[1])
        self._image.paste(colour, (int(low[0]), top, int(low[0]) + wide, top + tall), mask)


def _dashed(line: Floats, drawn: float, left_out: float) -> list[Floats]:
    """The parts of a line (n, 2) that a dashed one has."""
    lengths = line_lengths(line)
    starts = np.arange(0.0, lengths[-1], drawn + left_out)
    ends = np.minimum(starts + drawn, lengths[-1])
    first, last = (point_on(line, lengths, at) for at in (starts, ends))
    inner = zip(np.searchsorted(lengths, starts, side="right"), np.searchsorted(lengths, ends))
    return [
        np.concatenate([begin[None], line[low:high], end[None]])
        for begin, end, (low, high) in zip(first, last, inner, strict=True)
    ]


@cache
def _pillow() -> tuple[Any, Any, Callable[[float, bool], Any]]:
    """Pillow's images, what draws on them, and fonts by their height in pixels."""
    try:
        import matplotlib
        from PIL import Image, ImageDraw, ImageFont  # type: ignore[import-untyped]
    except ImportError as error:
        raise MissingPackageError(
            "The preview picture needs matplotlib: install it with pip install matplotlib."
        ) from error
    folder = Path(matplotlib.get_data_path(), "fonts", "ttf")

    @cache
    def font(height: float, bold: bool) -> Any:
        name = folder / ("DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf")
        # without the shaping of letters that not every Pillow has
        plain = getattr(ImageFont, "Layout", ImageFont).BASIC
        with name.open("rb") as file:
            return ImageFont.truetype(io.BytesIO(file.read()), round(height), layout_engine=plain)

    return Image, ImageDraw.Draw, font
