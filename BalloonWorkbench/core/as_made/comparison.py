# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a shape that was photographed or scanned is from the one that was worked out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.as_made.photograph import SeenShape
from BalloonWorkbench.core.as_made.placement import NEARER, IntakeZone, Placement, in_necks, place, settle
from BalloonWorkbench.core.design.compare import Misfit, far_stretches, misfit
from BalloonWorkbench.core.design.design import Design, FarStretch, Residual
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.areas import loop_of, parts
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.pattern.shapes import offset, polygon
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import size_text

#: A shape that many times as large, or so far off in parts of its size, is another thing.
_LARGER, _UNLIKE = 1.6, 0.08
#: Around an intake nothing is compared: of its width on either side.
_BESIDE_NECK = 0.75
#: What sticks out there by more than this part of its reach is taken off, with a hair that parts lines [m].
_STUB, _HAIR = 0.5, 1e-6
#: A hole of the photograph is one of the balloon where it has about its area; else it is a glare.
_HOLE = 0.4


@dataclass(frozen=True)
class Expected:
    """What a photograph should show [m]; around necks nothing is compared."""

    outline: Outline
    necks: tuple[IntakeZone, ...] = ()


@dataclass(frozen=True)
class Comparison:
    """A shape laid over the one that was expected, which stays in its place; all lengths [m].

    seen       as it lies there
    placement  how it came there; placement.size is 1 unless the size was to be fitted
    residual   two-way distances, without those at necks
    stretches  where they are far apart, the farthest first
    size       width and height of the seen one, expected_size of the other, without an intake's zone
    offset     by how much it is larger all round
    """

    expected: Expected
    seen: Outline
    placement: Placement
    residual: Residual
    stretches: tuple[FarStretch, ...]
    size: tuple[float, float]
    expected_size: tuple[float, float]
    offset: float
    remarks: tuple[str, ...]


def compare(shape: SeenShape, candidates: Sequence[Expected]) -> Comparison:
    """The shape of a photograph beside that of the candidates which it fits best.

    Raises InputError where it is another size, or another shape altogether.
    """
    sized = shape.scale is None
    seen = shape.outline
    alike = [each for each in candidates if sized or _alike(seen, each.outline)]
    if not alike:
        width, height = seen.size
        raise InputError(
            f"The shape in the photograph measures {size_text(width, height)},"
            f" {size_text(*candidates[0].outline.size)} were expected: check the scale, or whether it is the"
            " right photograph."
        )
    shapes = [_with_holes(seen, each.outline) for each in alike]
    laid = []
    for own, each in zip(shapes, alike, strict=True):
        placement = place(own, each.outline, each.necks, sized=sized)
        placed = placement.outline(own)
        if each.necks:
            placed = _without_necks(placed, each)
            settled = settle(placed, each.outline, each.necks, sized=sized)
            placement, placed = placement.then(settled), settled.outline(placed)
        laid.append(compared(placed, each, placement, shape.remarks))
    best = min(laid, key=lambda each: _unlike(each) / (NEARER if each.placement.mirrored else 1.0))
    if _unlike(best) > _UNLIKE:
        raise InputError(
            "No shape in the photograph is like the one that was expected: take it straight from the front,"
            " on a plain background without anything else in it."
        )
    return best


def _unlike(comparison: Comparison) -> float:
    """The mean difference in parts of the size."""
    return comparison.residual.mean / max(comparison.expected.outline.size)


def compared(
    seen: Outline, expected: Expected, placement: Placement, notes: Sequence[str] = ()
) -> Comparison:
    """The comparison with an outline in its place; notes on how it was seen."""
    apart = _without(misfit(expected.outline, seen), expected)
    remarks = list(notes)
    if placement.mirrored:
        remarks.append("The photograph shows the back: it was mirrored.")
    if len(seen.holes) < len(expected.outline.holes):
        remarks.append("Not all holes are seen in the photograph: those that are not count as wrong.")
    if expected.necks:
        remarks.append("The intake was left out of the comparison.")
    return Comparison(
        expected,
        seen,
        placement,
        apart.residual,
        far_stretches(expected.outline, apart),
        _size_without(seen, expected),
        _size_without(expected.outline, expected),
        2.0 * (seen.area - expected.outline.area) / (seen.perimeter + expected.outline.perimeter),
        tuple(remarks),
    )


def _without_necks(seen: Outline, expected: Expected) -> Outline:
    """An outline in its place without what sticks out far at an intake, on a foot no wider than its zone."""
    package = shapely()
    whole, goal = package.Polygon(seen.outer), package.Polygon(expected.outline.outer)
    for neck in expected.necks:
        root, near = package.Point(neck.place), goal.buffer(_STUB * neck.reach)
        for out in parts(whole.difference(near)):
            foot = out.boundary.intersection(near.buffer(_HAIR))
            if out.distance(root) < neck.reach and foot.length < 2.0 * neck.reach:
                whole = parts(whole.difference(out.buffer(_HAIR)))[0]
    return Outline(loop_of(whole.exterior), seen.holes)


def _size_without(seen: Outline, expected: Expected) -> tuple[float, float]:
    """Width and height of an outline without what is in an intake's zone."""
    zones = in_necks(nearest_places([expected.outline.outer], seen.outer), expected.necks)
    width, height = np.ptp(seen.outer if zones.all() else seen.outer[~zones], axis=0)
    return float(width), float(height)


def _alike(seen: Outline, expected: Outline) -> bool:
    ratio = max(seen.size) / max(expected.size)
    return 1.0 / _LARGER < ratio < _LARGER


def _with_holes(seen: Outline, expected: Outline) -> Outline:
    """The seen outline with those of its holes that are no glare: as large in it as one that is expected."""
    whole = Outline(seen.outer).area
    least = min(
        (-Outline(hole).area / Outline(expected.outer).area for hole in expected.holes), default=np.inf
    )
    holes = sorted((hole for hole in seen.holes if -Outline(hole).area > _HOLE * least * whole), key=_area)
    return Outline(seen.outer, tuple(holes[: len(expected.holes)]))


def _area(hole: Floats) -> float:
    return Outline(hole).area


def _without(apart: Misfit, expected: Expected) -> Misfit:
    """The differences without those at necks."""
    places = np.empty((len(apart.loop), 2))
    for number, loop in enumerate(expected.outline.loops):
        lengths, mine = arc_lengths(loop), apart.loop == number
        places[mine] = point_at(loop, lengths, apart.share[mine] * lengths[-1])
    kept = ~in_necks(places, expected.necks)
    if not kept.any():
        return apart
    return Misfit(apart.distances[kept], apart.loop[kept], apart.share[kept])


def with_rim(outline: Outline, rim: float) -> Outline:
    """An outline with the weld round it, rim [m] wide, which lies flat beside the film that is blown up."""
    if rim == 0.0:
        return Outline(outline.outer, outline.holes)
    grown = parts(offset(polygon(outline.outer), rim))[0]
    holes = [part for hole in outline.holes for part in parts(offset(polygon(hole), -rim))]
    return Outline(loop_of(grown.exterior), tuple(loop_of(hole.exterior)[::-1] for hole in holes))


def expected_of(design: Design, pattern: Pattern, rim: float) -> Expected:
    """What a photograph of an inflated balloon should show; rim [m]: the weld and the film beside it."""
    outline = with_rim(design.silhouette, rim)
    necks = []
    intakes = ([] if pattern.intake is None else [pattern.intake]) + list(pattern.more_intakes)
    for intake in intakes:
        rest = design.inflation.panel.rest_positions
        seam = np.concatenate(design.inflation.panel.loops)
        root = seam[int(np.argmin(np.linalg.norm(rest[seam] - intake.at, axis=1)))]
        foot = nearest_places([outline.outer], design.inflation.positions[root, :2][None])[0]
        necks.append(IntakeZone(foot, _BESIDE_NECK * intake.width + 2.0 * rim))
    return Expected(outline, tuple(necks))
