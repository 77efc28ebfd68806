# SPDX-License-Identifier: LGPL-2.1-or-later
"""PDF by matplotlib: pages in real size, drawn on in millimetres from their lower left corner."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable
from typing import Any

from BalloonWorkbench.core.packages import matplotlib_pdf
from BalloonWorkbench.core.pages.fonts import Fonts
from BalloonWorkbench.core.types import Floats

POINT = 25.4 / 72.0  # mm
_INCH = 25.4
#: Width and height [mm], and what draws on the axes of the page.
Page = tuple[tuple[float, float], Callable[[Any], object]]


def pdf(title: str, fonts: Fonts, pages: Iterable[Page]) -> bytes:
    """The pages; the same bytes for the same pages. MissingPackageError without matplotlib."""
    backend = matplotlib_pdf()
    from matplotlib import style
    from matplotlib.figure import Figure

    own = {
        "pdf.fonttype": fonts.kind,
        "pdf.compression": 6,
        "font.family": list(fonts.families),
        "path.simplify": False,
    }
    stream = io.BytesIO()
    with style.context(["default", own]):  # not as the user's other diagrams
        # no date: the same bytes again
        metadata = {"Title": title, "CreationDate": None, "Creator": None, "Producer": None}
        file = backend.PdfFile(stream, metadata=metadata)
        name = backend.Name
        unscaled = {"PrintScaling": name("None")}  # printers must not fit the page
        catalog = {"Type": name("Catalog"), "Pages": file.pagesObject, "ViewerPreferences": unscaled}
        file.writeObject(file.rootObject, catalog)
        for (width, height), draw in pages:
            inches = width / _INCH, height / _INCH
            figure = Figure(figsize=inches, dpi=72)
            axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, width), ylim=(0.0, height))
            axes.axis("off")
            draw(axes)
            file.newPage(*inches)
            vectors = backend.RendererPdf(file, 72, inches[1], inches[0])
            renderer = backend.MixedModeRenderer(figure, *inches, 72, vectors)
            figure.draw(renderer)
            renderer.finalize()
        file.finalize()
        file.close()
    return stream.getvalue()


def write(
    axes: Any,
    fonts: Fonts,
    at: tuple[float, float],
    text: str,
    size: float,
    room: float = 0.0,
    bold: bool = False,
    **look: Any,
) -> None:
    """A line at a size in points; smaller where it would be wider than the room [mm]."""
    wide = fonts.width(text, size, bold)
    weight = "bold" if bold else "normal"
    shrunk = size * room / wide if 0.0 < room < wide else size
    look = {"color": "#000000", "va": "baseline", **look}
    axes.text(*at, text, fontsize=shrunk, fontweight=weight, parse_math=False, **look)


def draw_line(axes: Any, points: Floats, closed: bool, **look: Any) -> Any:
    """A line through points (n, 2) mm, as what matplotlib calls a patch, which is not cut off at the page."""
    from matplotlib.patches import Polygon

    line = Polygon(points, closed=closed, fill=False, joinstyle="round", clip_on=False, **look)
    axes.add_artist(line)
    return line


def picture(axes: Any, pixels: Any, box: tuple[float, float, float, float]) -> None:
    """Every pixel of a picture in a box of the page: left, bottom, right, top [mm]."""
    left, bottom, right, top = box
    look = {"interpolation": "none", "aspect": "auto", "clip_on": False}
    limits = axes.get_xlim(), axes.get_ylim()
    axes.imshow(pixels, extent=(left, right, bottom, top), **look)
    axes.set(xlim=limits[0], ylim=limits[1])
