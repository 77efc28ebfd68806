# SPDX-License-Identifier: LGPL-2.1-or-later
"""PDF by matplotlib: pages in real size, drawn on in millimetres from their lower left corner."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from BalloonWorkbench.core.packages import matplotlib_pdf
from BalloonWorkbench.core.pages.fonts import Fonts
from BalloonWorkbench.core.types import Floats

POINT = 25.4 / 72.0  # mm
_INCH = 25.4
#: Of a line in a spot colour [mm]: as thin as print shops ask for.
_SPOT_LINE = 0.1
#: Width and height [mm], and what draws on the axes of the page.
Page = tuple[tuple[float, float], Callable[[Any], object]]


def pdf(title: str, fonts: Fonts, pages: Iterable[Page], spots: Sequence[str] = ()) -> bytes:
    """The pages; the same bytes for the same pages. MissingPackageError without matplotlib.

    spots  names of the spot colours that `draw_spot` uses there
    """
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
        file = _file_with(backend, spots)(stream, metadata=metadata)
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


def _file_with(backend: Any, spots: Sequence[str]) -> Any:
    """The class of files in which spot colours are known, each a separation that shows as magenta."""
    if not spots:
        return backend.PdfFile
    name = backend.Name
    tint = {"FunctionType": 2, "Domain": [0, 1], "C0": [0, 0, 0, 0], "C1": [0, 1, 0, 0], "N": 1}
    colours = {spot: [name("Separation"), name(spot), name("DeviceCMYK"), tint] for spot in spots}
    overprint = {"Type": name("ExtGState"), "OP": True, "op": True, "OPM": 1}
    added = {"resourceObject": {"ColorSpace": colours}, "_extGStateObject": {"Overprint": overprint}}

    class SpotFile(backend.PdfFile):  # type: ignore[misc]
        """A file whose resources have the spot colours, and the state in which they print over all else."""

        def writeObject(self, reference: Any, contents: Any) -> None:  # noqa: N802
            for owner, more in added.items():
                if reference is getattr(self, owner, None):
                    contents = {**contents, **more}
            super().writeObject(reference, contents)

    return SpotFile


def draw_spot(axes: Any, points: Floats, closed: bool, spot: str) -> None:
    """A thin line through points (n, 2) mm in a spot colour, above all else and printed over it."""
    from matplotlib.artist import Artist

    steps = [f"{x:.4f} {y:.4f} {'l' if k else 'm'}" for k, (x, y) in enumerate((points / POINT).tolist())]
    width = f"{_SPOT_LINE / POINT:.4f}"
    commands = f"q /Overprint gs /{spot} CS 1 SCN {width} w 1 J 1 j {' '.join(steps)}{' h' * closed} S Q\n"

    class SpotLine(Artist):  # type: ignore[misc]
        """matplotlib has no spot colours: the line goes into the page as PDF has it."""

        def draw(self, renderer: Any) -> None:
            renderer.file.write(commands.encode("ascii"))

    line = SpotLine()
    line.set_zorder(10.0)
    axes.add_artist(line)


def draw_area(axes: Any, points: Floats) -> None:
    """A black area within points (n, 2) mm."""
    from matplotlib.patches import Polygon

    axes.add_artist(Polygon(points, closed=True, fc="#000000", ec="none", lw=0.0, clip_on=False))


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
    """Every pixel of a picture (h, w, 3 or 4) in a box of the page: left, bottom, right, top [mm].

    Just there: imshow would round the box to whole points.
    """
    left, bottom, right, top = box
    corners = np.array([(left, bottom), (right, bottom), (left, top)])
    placed_picture(axes, rgba(pixels), corners)


def rgba(pixels: Any) -> Any:
    """Pixels (h, w, 3 or 4) as `placed_picture` takes them; an array on several pages is stored once."""
    from matplotlib.cm import ScalarMappable

    return ScalarMappable().to_rgba(pixels, bytes=True)


def placed_picture(axes: Any, colours: Any, corners: Floats, window: Any = None) -> None:
    """A picture by the places (3, 2) mm of its lower left, lower right and upper left corner, cut off at a
    window (a patch)."""
    from matplotlib.artist import Artist
    from matplotlib.transforms import Affine2D

    low, across, up = (corner / POINT for corner in (corners[0], *(corners[1:] - corners[0])))
    place = Affine2D.from_values(*across, *-up, *(low + up))

    class PlacedPicture(Artist):  # type: ignore[misc]
        """Pixels with their place, which the renderer takes as it is."""

        def draw(self, renderer: Any) -> None:
            context = renderer.new_gc()
            if window is not None:
                context.set_clip_rectangle(window.get_window_extent(renderer))
            renderer.draw_image(context, 0.0, 0.0, colours, place)
            context.restore()

    axes.add_artist(PlacedPicture())
