# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way: a picture and what it should show in, the files of the comparison out.

1. read the shape in the picture               photograph.py
2. take the balloon, or read what was cut       readers/vector.py
3. lay the one over the other                  comparison.py
4. fit the film                                film_fit.py
5. files                                       comparison_picture.py, comparison_report.py
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from BalloonWorkbench.core.as_made.comparison import Comparison, Expected, compare, expected_of, with_rim
from BalloonWorkbench.core.as_made.comparison_picture import comparison_png
from BalloonWorkbench.core.as_made.comparison_report import comparison_bytes
from BalloonWorkbench.core.as_made.film_fit import FilmFit, fit_film
from BalloonWorkbench.core.as_made.photo_scale import FIT
from BalloonWorkbench.core.as_made.photograph import SeenShape
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.areas import loop_of, parts
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pattern.shapes import offset, polygon
from BalloonWorkbench.core.readers.vector import read_outermost

#: How much further inside the seam is tried, in parts of the balloon's size.
_STEP = 0.004


@dataclass(frozen=True)
class Compared:
    """A finished comparison; fit: None where it was not asked for."""

    comparison: Comparison
    fit: FilmFit | None


def rim_of(film: Film, options: PatternOptions) -> float:
    """How far a balloon's weld and the film beside it reach beyond its seam [m]."""
    width = film.seal_width if options.seal_width is None else options.seal_width
    return width + options.allowance


def compare_balloon(
    shape: SeenShape,
    balloons: Sequence[tuple[Design, Pattern]],
    rim: float,
    inflate: Callable[[Outline, float], Design] | None = None,
) -> Compared:
    """An inflated balloon beside its simulation.

    rim      what lies flat outside of the seam [m]
    inflate  the balloon of a pattern at a pressure [Pa], with which the film is fitted; else it is not
    Raises InputError where the photograph shows another thing, or has no scale to fit the film by.
    """
    if inflate is not None and shape.scale is None:
        raise InputError(
            f"With --scale {FIT} the size tells nothing of the film: give the photograph's scale to fit it."
        )
    candidates = [expected_of(design, pattern, rim) for design, pattern in balloons]
    comparison = compare(shape, candidates)
    if inflate is None or shape.scale is None:
        return Compared(comparison, None)
    chosen = next(k for k, each in enumerate(candidates) if each is comparison.expected)
    design = balloons[chosen][0]
    step, pressure = _STEP * max(design.pattern.size), design.inflation.report.pressure
    usual, narrower = (
        with_rim(inflate(seam, pressure).silhouette, rim)
        for seam in (design.pattern, _narrower(design.pattern, step))  # on meshes alike
    )
    return Compared(comparison, fit_film(comparison, usual, narrower, step, shape.scale))


def _narrower(seam: Outline, step: float) -> Outline:
    """A pattern with its seam further inside by a step [m]; InputError where nothing is left of a part."""
    areas = parts(offset(polygon(seam.outer), -step))
    if len(areas) != 1:
        raise InputError("The balloon has parts too thin to fit the film with: use a wider shape.")
    loops = [loop_of(areas[0].exterior)]
    for hole in (*seam.holes, *seam.spots):
        loops.append(loop_of(parts(offset(polygon(hole), step))[0].exterior)[::-1])
    return seam.with_loops(loops, seam.welds)


def compare_cut(shape: SeenShape, path: str | Path) -> Compared:
    """A flat panel beside what was to be cut: the outer line that it is most like, of an SVG or DXF in real
    size such as pattern.dxf. Raises InputError and MissingPackageError as read_outermost does.
    """
    return Compared(compare(shape, [Expected(outline) for outline in read_outermost(path)]), None)


def compared_files(compared: Compared) -> dict[str, bytes]:
    """Contents of the files of a comparison, by name. MissingPackageError without what draws the picture."""
    return {
        "compare.png": comparison_png(compared.comparison),
        "compare.json": comparison_bytes(compared.comparison, compared.fit),
    }
