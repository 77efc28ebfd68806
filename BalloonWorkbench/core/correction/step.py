# SPDX-License-Identifier: LGPL-2.1-or-later
"""One step of the pattern: what is missing at the seam, smoothed and turned into the pattern, and limited.

A curved arm curls up when it is inflated (Siefert et al. 2019, over-curvature of inflated curved tubes) and
carries its end round. What is missing at the end is seen in the drawing's directions; the pattern, which is
not curled, has to change in its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.correction.iterate import Iterate
from BalloonWorkbench.core.correction.mixing import UpdateRule
from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.visible_seam import visible_places
from BalloonWorkbench.core.geometry.normals import tangents
from BalloonWorkbench.core.geometry.polyline import arc_lengths
from BalloonWorkbench.core.geometry.vectors import cross, unit
from BalloonWorkbench.core.types import Floats

CLAMP = 0.05  # of the larger dimension, for one step
ROTATION = 16.0  # mesh sizes over which the film's rotation is averaged: of arms, not of folds
DRIFT = 2.0  # mesh sizes that seam vertices may slide along the drawing,
DRIFT_ROUND = 1.0 / 12.0  # but no more of the way round a small hole, which else closes
TIP = 2.0  # mesh sizes from a tip to where its sides are film and not mesh
OVERHANG = 0.0075  # of the larger dimension, that the silhouette may lie beside the seam


@dataclass(frozen=True)
class Scales:
    """Lengths that a step goes by [m]."""

    size: float  # larger dimension of the drawing
    edge: float  # of the mesh
    smoothing: float  # over which differences are averaged along the seam
    clearance: float  # between facing parts of the pattern


def next_seam_map(current: Iterate, rule: UpdateRule, scales: Scales) -> SeamMap:
    """The seam map of an iterate with its pattern moved by one step of the rule, welds inside included."""
    seam_map, most = current.seam_map, CLAMP * scales.size
    step = rule.step(current, np.concatenate(_corrections(current, scales)))
    # the whole step becomes smaller: parts cut off singly would bend the pattern where it should turn
    step = step * min(1.0, most / max(float(np.linalg.norm(step, axis=1).max()), 1e-300))
    panel, positions = current.panel, current.inflation.positions[:, :2]
    lines = [
        line.corrected(panel.rest_positions[weld], positions[weld], scales.edge, most)
        for line, weld in zip(seam_map.lines, panel.welds, strict=True)
    ]
    stops = np.cumsum([len(loop) for loop in seam_map.pattern])[:-1]
    fields = tuple(np.split(step, stops))
    return replace(seam_map, lines=tuple(lines)).moved(fields, TIP * scales.edge, scales.clearance)


def _corrections(current: Iterate, scales: Scales) -> tuple[Floats, ...]:
    """For each loop what is missing at its points (n, 2), smooth and in the directions of the pattern."""
    corrections = []
    for drawing, node, seam in zip(current.seam_map.drawing, current.nodes, current.panel.loops, strict=True):
        points = current.inflation.positions[seam, :2]
        around = float(arc_lengths(drawing)[-1])
        drift = np.full(len(points), min(DRIFT * scales.edge, DRIFT_ROUND * around))
        places = visible_places(points, current.silhouette, OVERHANG * scales.size)
        places[node.corner_nodes] = points[node.corner_nodes]
        missing = goals(drawing, places, node.lengths, node.corner_nodes, node.corners, drift) - places
        smooth = node.field(missing, drawing, scales.smoothing)
        rotation = seam_rotations(current.panel.rest_positions[seam], points)
        corrections.append(rotated_back(smooth, node.field(rotation, drawing, ROTATION * scales.edge)))
    return tuple(corrections)


def seam_rotations(flat: Floats, inflated: Floats) -> Floats:
    """Sines and cosines (k, 2) of the angles by which a closed seam, flat (k, 2) m, has turned: (k, 2) m."""
    before, after = tangents(flat), tangents(inflated)
    return unit(np.column_stack([cross(before, after), np.einsum("ij,ij->i", before, after)]))


def rotated_back(moves: Floats, rotation: Floats) -> Floats:
    """Moves (n, 2) rotated back by angles given as sines and cosines (n, 2) of any length."""
    sine, cosine = unit(rotation).T
    x, y = moves.T
    return np.column_stack([cosine * x + sine * y, cosine * y - sine * x])
