# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern that the correction of a side band sets out from: the drawing, drawn in or out all round."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bag_design.band_iterate import smoothed
from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.normals import corners, turns
from BalloonWorkbench.core.geometry.polyline import arc_lengths, edge_vectors, gaps, point_at
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.mesh.thickness import thickness
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

#: Of the width of an arm, by which its face grows on either side for no band at all; a disc grows as one of
#: WIDEST times the mean width would.
GROWTH, WIDEST = 0.25 * np.pi - 0.5, 1.2
_MITRE = 0.3  # of a corner's square: a sharper one is moved less
_FARTHEST = 8.0  # that a corner is moved, in moves of its sides
#: Of the stretch beside a corner that a move would fold: over so much of it the sides are drawn together.
_SPARE = 2.0


def first_pattern(drawn: SeamMap, target: Outline, band: float, clearance: float) -> SeamMap:
    """The drawing, drawn in or out all round so that arms become as wide as drawn.

    Face and band are half of the way round an arm, so the face is pi / 2 times the width less the band. Film
    is taut round a hole, whose seam is as long as the hole is wide where the band has bulged in.
    """
    inward = [0.5 * band - GROWTH * wide for wide in _widths(drawn, target)]
    for number, wide in enumerate(_widths(drawn, target)[1:], 1):
        inward[number] = 0.5 * wide * (1.0 - np.cos(np.minimum(band / wide, 0.5 * np.pi)))
    loops = zip(inward, drawn.pattern, strict=True)
    return drawn.moved(tuple(drawn_out(loop, -by) for by, loop in loops), 0.0, clearance)


def _widths(drawn: SeamMap, target: Outline) -> list[Floats]:
    """How wide the drawing is at the points of each loop (n,) m; where nothing faces them, as beside."""
    mean = 2.0 * target.area / target.perimeter
    walls = thickness(target, 4.0 * mean, 0.1 * mean)
    sure = np.isfinite(walls.across)
    if not sure.any():
        return [np.full(len(loop), mean) for loop in drawn.drawing]
    tree, across = kd_tree(walls.points[sure]), np.minimum(walls.across[sure], WIDEST * mean)
    smooth = (smoothed(loop, across[tree.query(loop)[1]][:, None], 0.5 * mean) for loop in drawn.drawing)
    return [wide[:, 0] for wide in smooth]


def _mitred(loop: Floats) -> Floats:
    """Moves (n, 2) by which each edge of a closed loop goes by 1 to its left, corners less where sharp."""
    ahead = unit(edge_vectors(loop))
    before, after = perpendicular(np.roll(ahead, 1, axis=0)), perpendicular(ahead)
    along = np.einsum("ij,ij->i", before, after)[:, None]
    return np.asarray((before + after) / np.maximum(1.0 + along, _MITRE))


def drawn_out(loop: Floats, by: Floats) -> Floats:
    """Moves (n, 2) m of the points of a closed loop (n, 2) m to its right by (n,) m, which do not fold it.

    Each side goes along its normals. Beside a corner into which it goes, its points would pass those of the
    other side: there all go linearly from the move of the corner, which is where both moved sides meet.
    """
    field = -by[:, None] * _mitred(loop)
    reach = float(np.abs(by).mean())
    sharp = corners(loop, reach=reach)
    sharp = sharp[by[sharp] * turns(loop, reach)[sharp] < 0.0]
    if not len(sharp):
        return field
    along = arc_lengths(loop)
    here, around = along[:-1], float(along[-1])
    half = 0.5 * np.abs(turns(loop, reach)[sharp])
    ahead = point_at(loop, along, here[sharp] + reach) - point_at(loop, along, here[sharp] - reach)
    far = np.minimum(1.0 / np.cos(half), _FARTHEST)
    field[sharp] = -(by[sharp] * far)[:, None] * unit(perpendicular(ahead))
    zones = _SPARE * np.abs(by[sharp]) * np.minimum(np.tan(half), _FARTHEST)
    sure = (gaps(here[:, None], here[sharp], around) > zones).all(axis=1)
    sure[sharp] = True
    return np.column_stack([np.interp(here, here[sure], column, period=around) for column in field[sure].T])
