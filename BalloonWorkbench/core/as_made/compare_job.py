# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way: a picture in, what it is compared with worked out, the files of the comparison out.

1. read the shape in the picture               photograph.py
2. work out the balloon, or read what was cut  core/job.py, readers/vector.py
3. lay the one over the other                  comparison.py
4. fit the film                                film_fit.py
5. files                                       comparison_picture.py, comparison_report.py
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from BalloonWorkbench.core.as_made.comparison import Comparison, Expected, compare, expected_of, with_rim
from BalloonWorkbench.core.as_made.comparison_picture import comparison_png
from BalloonWorkbench.core.as_made.comparison_report import comparison_bytes
from BalloonWorkbench.core.as_made.film_fit import FilmFit, fit_film
from BalloonWorkbench.core.as_made.photo_scale import FIT, PhotoScale
from BalloonWorkbench.core.as_made.photograph import SeenShape
from BalloonWorkbench.core.correction.fit import inflate_outline
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import loop_of, parts
from BalloonWorkbench.core.job import Balloon, Part, Settings
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.shapes import offset, polygon
from BalloonWorkbench.core.readers.vector import read_vector
from BalloonWorkbench.core.types import Progress, Say, in_english, no_progress

#: How much further inside the seam is tried, in parts of the balloon's size.
_STEP = 0.004


@dataclass(frozen=True)
class Compared:
    """A finished comparison; fit: None where it was not asked for."""

    comparison: Comparison
    fit: FilmFit | None


def rim_of(settings: Settings) -> float:
    """How far a balloon's weld and the film beside it reach beyond its seam [m]."""
    options = settings.pattern
    width = settings.film.seal_width if options.seal_width is None else options.seal_width
    return width + options.allowance


def compare_balloon(
    shape: SeenShape,
    balloon: Balloon,
    rim: float,
    *,
    fitted: bool = False,
    progress: Progress = no_progress,
) -> Compared:
    """An inflated balloon beside its simulation; rim [m]: what lies flat outside of the seam.

    fitted  also the film's stretch and the weld's shrinkage
    Raises InputError where the photograph shows another thing, or has no scale to fit them by.
    """
    if fitted and shape.scale is None:
        raise InputError(
            f"With --scale {FIT} the size tells nothing of the film: give the scale of the photograph to fit it."
        )
    candidates = [expected_of(part.design, part.pattern, rim) for part in balloon.parts]
    comparison = compare(shape, candidates)
    if not fitted or shape.scale is None:
        return Compared(comparison, None)
    chosen = next(k for k, each in enumerate(candidates) if each is comparison.expected)
    return Compared(
        comparison, _fit(comparison, balloon.parts[chosen], balloon.settings, rim, shape.scale, progress)
    )


def _fit(
    comparison: Comparison,
    part: Part,
    settings: Settings,
    rim: float,
    scale: PhotoScale,
    progress: Progress,
) -> FilmFit:
    """What the same pattern gives with its seam where it is, and further inside, on meshes alike."""
    seam, step = part.design.pattern, _STEP * max(part.design.pattern.size)
    rims = []
    for each in (seam, _narrower(seam, step)):
        blown = inflate_outline(
            each,
            settings.film,
            part.design.inflation.report.pressure,
            mesh_size=settings.mesh_size,
            backend=settings.backend,
            model=settings.model,
            progress=progress,
        )
        rims.append(with_rim(blown.silhouette, rim))
    return fit_film(comparison, rims[0], rims[1], step, scale)


def _narrower(seam: Outline, step: float) -> Outline:
    """A pattern with its seam further inside by a step [m]; InputError where nothing is left of a part."""
    areas = parts(offset(polygon(seam.outer), -step))
    if len(areas) != 1:
        raise InputError("The balloon has parts too thin to fit the film with: use a wider shape.")
    loops = [loop_of(areas[0].exterior)]
    for hole in (*seam.holes, *seam.spots):
        loops.append(loop_of(parts(offset(polygon(hole), step))[0].exterior)[::-1])
    return seam.with_loops(loops, seam.welds)


def compare_cut(shape: SeenShape, outlines: Sequence[Outline]) -> Compared:
    """A flat panel beside what was to be cut: the outer line of the outline that it is most like."""
    return Compared(compare(shape, [Expected(Outline(outline.outer)) for outline in outlines]), None)


def cut_outlines(path: str | Path) -> tuple[Outline, ...]:
    """What was cut, of an SVG or DXF that has it as it is written, such as pattern.dxf.

    Raises InputError and MissingPackageError as read_vector does.
    """
    return read_vector(path).parts


def compared_files(compared: Compared, say: Say = in_english) -> dict[str, bytes]:
    """Contents of the files of a comparison, by name. MissingPackageError without what draws the picture."""
    return {
        "compare.png": comparison_png(compared.comparison, say),
        "compare.json": comparison_bytes(compared.comparison, compared.fit),
    }
