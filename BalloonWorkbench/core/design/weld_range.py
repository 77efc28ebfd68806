# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design whose weld creases: its pattern inflated once more, with a weld that crumples freely.

A real weld lies between that and the elastic one of the design. Both are inflated on one coarser mesh, so
that what differs between them is the weld alone; on the design's own the crumpling takes ten times as long as
the elastic balloon. The crumpled one sets out from a balloon whose weld has nearly no rigidity, inflated from
the flat film: straight from there film catches, and a ring kinks on one mesh and does not on another.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.design.compare import far_stretches, laid_over, misfit
from BalloonWorkbench.core.design.design import Design, WeldRange
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.errors import MeshError, SolverError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.nearest import locate
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.simulation import CRUMPLED, ELASTIC
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.types import Floats, Progress, no_progress
from BalloonWorkbench.core.units import length_text, place_text

_COARSENING = 1.6  # of the mesh of the design
_OF_A_RING = 800  # vertices: on a coarser mesh few rings kink
#: A ring is nearly at rest before it kinks.
_AT_REST = NewtonSettings(tolerance=1e-6)
_WARNED = 0.03  # of the larger dimension; every rim scallops where its weld creases, that of a disc by 0.02
#: Of its rigidity, what a weld keeps that lets a ring kink; one of film sometimes catches before it does.
_YIELDING = 1e-3


def with_weld_range(design: Design, film: Film, progress: Progress = no_progress) -> Design:
    """The design with what comes out where its weld creases, and a warning where that is seen.

    As it is where the pattern was not corrected, or the weld of its model does not stay elastic. Raises
    Cancelled when progress returns False.
    """
    if not (design.passes and film.seal_width > 0.0 and _is_elastic(design.inflation)):
        return design
    try:
        weld_range = _weld_range(design, film, progress)
    except (MeshError, SolverError) as error:
        sentence = f"How far the outline moves if the weld creases could not be simulated. {error}"
        return replace(design, warnings=(*design.warnings, sentence))
    sentences = _sentences(weld_range, max(design.target.size))
    return replace(design, weld_range=weld_range, warnings=(*design.warnings, *sentences))


def _is_elastic(inflation: Inflation) -> bool:
    """Two equal panels at rest, simulated as film that crumples but for its weld."""
    solved = inflation.report
    model = solved.model
    as_usual = model.weld == ELASTIC and model.tension_field and not model.two_panels
    return as_usual and solved.backend != "newmark"


def _weld_range(design: Design, film: Film, progress: Progress) -> WeldRange:
    seam, solved = faired_seam(design.pattern), design.inflation.report
    panel = _meshed(seam, len(design.inflation.panel.rest_positions))

    def balloon(film: Film, weld: str, number: int, start: Inflation | None = None) -> Inflation:
        return inflate(
            panel,
            film,
            solved.pressure,
            start=start,
            backend=solved.backend,
            model=replace(solved.model, weld=weld),
            settings=_AT_REST if seam.holes else None,
            progress=lambda share, text: progress((number + share) / 3.0, f"if the weld creases: {text}"),
        )

    elastic = laid_over(balloon(film, ELASTIC, 0), _seam_places(design.inflation, panel))
    yielding = balloon(replace(film, weld_rigidity=_YIELDING * film.weld_rigidity), ELASTIC, 1)
    rim = elastic.positions[np.concatenate(panel.loops), :2]
    crumpled = laid_over(balloon(film, CRUMPLED, 2, yielding), rim)
    smooth, creased = (silhouette(trimmed(blown)) for blown in (elastic, crumpled))
    return WeldRange(
        misfit(design.target, creased).residual,
        far_stretches(smooth, misfit(smooth, creased)),
        crumpled.report.converged,
    )


def _meshed(seam: Outline, vertices: int) -> Panel:
    """The panel, coarser than with so many vertices but where it is too thin for that."""
    coarser = _OF_A_RING if seam.holes else round(vertices / _COARSENING**2)
    try:
        return triangulate(seam, size_for(seam, coarser))
    except MeshError:
        return triangulate(seam, size_for(seam, vertices))


def _seam_places(inflation: Inflation, panel: Panel) -> Floats:
    """Where the seam of another panel of the same pattern comes to lie, (k, 2) m, loop by loop."""
    places = []
    for mine, its in zip(panel.loops, inflation.panel.loops, strict=True):
        flat = inflation.panel.rest_positions[its]
        along = locate(flat, panel.rest_positions[mine])
        places.append(point_at(inflation.positions[its, :2], arc_lengths(flat), along))
    return np.concatenate(places)


def _sentences(weld_range: WeldRange, size: float) -> list[str]:
    sentences = []
    worst = next(iter(weld_range.creases), None)
    if worst is not None and worst.max > _WARNED * size:
        away, place = length_text(worst.max, 2), place_text(worst.place)
        sentences.append(f"If the weld creases, the outline may lie up to {away} away near {place}.")
    if not weld_range.converged:
        sentences.append(
            "The balloon whose weld creases did not come to rest; what is told of it is its last good state."
        )
    return sentences
