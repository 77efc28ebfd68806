# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam as it is made: the nominal one, moved by what cutter and sealing bar are off.

Both films lie flat on each other when they are sealed, and one bar seals them: wherever it runs, both panels
have the same seam. The bar is guided by the cut edge, so an error of the cutter moves weld and edge, one of
the bar the weld alone. Films that are cut one by one have two edges, and the bar follows the mean of both:
the error of a single cut is the worst that can be made of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_weights
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.tolerances.error_field import field, offset
from BalloonWorkbench.core.tolerances.samples import Sample, Tolerances
from BalloonWorkbench.core.tolerances.spread import ErrorSource
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class MadeSeam:
    """A flat panel as it is made.

    kept    on the nominal mesh, with moved vertices; else it was meshed anew
    grown   film of one panel beside the nominal, by the cut [m2]
    errors  by source: mean error along the whole seam [m], positive where there is more film
    """

    panel: Panel
    kept: bool
    grown: float
    errors: dict[ErrorSource, float]


def made_seam(nominal: Panel, spots: int, sample: Sample, tolerances: Tolerances) -> MadeSeam:
    """The panel of a sample; spots: how many of its last loops are sealed but not cut.

    Lines that are welded inside stay where they are. Raises InputError for errors too fine for the seam, and
    MeshError where they leave no panel.
    """
    loops = [nominal.rest_positions[loop] for loop in nominal.loops]
    strays = [source for source in ErrorSource if source in sample.deviations or source in sample.fields]
    errors = {source: _errors(loops, sample, tolerances, source) for source in strays if source.of_seam}
    if not errors:
        return MadeSeam(nominal, True, 0.0, {})
    weights = [point_weights(loop) for loop in loops]

    def sum_along(each: Sequence[Floats]) -> float:
        return sum(float(weight @ error) for weight, error in zip(weights, each))

    around = sum(float(weight.sum()) for weight in weights)
    means = {source: sum_along(each) / around for source, each in errors.items()}
    cut = errors.get(ErrorSource.CUT, [])
    grown = sum_along(cut[: len(loops) - spots])
    moved = [offset(loop, np.sum(together, axis=0)) for loop, *together in zip(loops, *errors.values())]
    welds = [nominal.rest_positions[weld] for weld in nominal.welds]
    panel = move_rim(nominal, moved, welds)
    if panel is not None:
        return MadeSeam(panel, True, grown, means)
    return MadeSeam(_meshed(nominal, moved, welds, spots), False, grown, means)


def _errors(loops: list[Floats], sample: Sample, tolerances: Tolerances, source: ErrorSource) -> list[Floats]:
    """How far each loop's points (n,) are off, away from the film [m]."""
    if source in sample.deviations:
        return [np.full(len(loop), sample.deviations[source]) for loop in loops]
    spread, which = tolerances.spreads[source], list(ErrorSource).index(source)
    assert spread.along is not None
    errors = []
    for number, loop in enumerate(loops):
        lengths = arc_lengths(loop)
        seed = (tolerances.seed, sample.fields[source], which, number)
        errors.append(spread.of_normal(field(lengths[:-1], float(lengths[-1]), spread.along, seed)))
    return errors


def _meshed(nominal: Panel, loops: list[Floats], welds: list[Floats], spots: int) -> Panel:
    last = len(loops) - spots
    outline = Outline(loops[0], tuple(loops[1:last]), (), tuple(welds), tuple(loops[last:]))
    try:
        return triangulate(outline, size_for(outline, len(nominal.rest_positions)))
    except MeshError as error:
        raise MeshError("Errors as large as these leave no panel: give smaller ones.", error.place) from error
