# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as two panels and with a side band: both inflated roughly, and drawn as small pictures."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag
from BalloonWorkbench.core.design.draft import draft
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.sampling import simplify
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.gui.qt import QtCore, QtGui

_VERTICES = 500  # of the balloon with a band
_ROUGHNESS = 0.1  # of the mesh size, that the drawing is simplified by
_KEEPS_WIDTH = math.pi / 2.0 - 1.0  # band of an arm that is as wide inflated as flat, in parts of its width
_MARGIN = 3  # px
_TURN, _TILT = math.radians(-28.0), math.radians(24.0)  # how the pictures are looked at
_LIGHT = np.array([-0.35, 0.55, 0.76])


@dataclass(frozen=True)
class Sketched:
    """A balloon as roughly as a small picture needs it.

    positions  (n, 3) m; triangles (m, 3), counter-clockwise seen from outside
    """

    positions: np.ndarray
    triangles: np.ndarray

    @property
    def thickness(self) -> float:
        """How thick it is [m]."""
        return float(np.ptp(self.positions[:, 2]))


@dataclass(frozen=True)
class BandComparison:
    """What is asked for: a drawing as two panels, and with a side band [m]; pressure in Pa.

    corrected  two panels will be fitted to the drawing; else the drawing is their pattern
    """

    outline: Outline
    film: Film
    pressure: float
    band: float
    corrected: bool

    def solve(self, progress: Progress = no_progress) -> tuple[Sketched, Sketched]:
        """Both balloons; raises what `draft`, banded_bag, mesh_bag and inflate raise."""
        plain = draft(
            self.outline, self.film, self.pressure, progress=progress, corrected=self.corrected
        ).inflation
        return _mirrored(plain), _banded(self, progress)


def usual_band(outline: Outline) -> float:
    """Width of a band with which arms of the drawing's mean width keep theirs [m]."""
    return _KEEPS_WIDTH * 2.0 * outline.area / outline.perimeter


def _mirrored(inflation: Inflation) -> Sketched:
    faces, count = inflation.panel.triangles, len(inflation.positions)
    both = np.concatenate([inflation.positions, inflation.positions * MIRROR])
    return Sketched(both, np.concatenate([faces, faces[:, ::-1] + count]))


def _banded(asked: BandComparison, progress: Progress) -> Sketched:
    outline = asked.outline
    area = 2.0 * outline.area + asked.band * outline.perimeter
    edge = math.sqrt(area / (0.87 * _VERTICES))
    rough = outline.with_loops([simplify(loop, _ROUGHNESS * edge) for loop in outline.loops], ())
    joints = band_joints(rough.loops)
    bag, places = banded_bag(rough, asked.band, joints=joints), band_places(rough.loops, joints, asked.band)
    design = inflate_bag(bag, asked.film, asked.pressure, places=places, mesh_size=edge, progress=progress)
    return Sketched(design.inflation.positions, design.inflation.assembly.surface.triangles)


def picture_of(sketched: Sketched, width: int, height: int, colour: QtGui.QColor) -> QtGui.QPixmap:
    """The balloon seen from the front, a little from the right and from above."""
    pixmap = QtGui.QPixmap(width, height)
    pixmap.fill(QtCore.Qt.transparent)
    at = _seen(sketched.positions)
    low, size = at.min(axis=0), np.ptp(at, axis=0)
    scale = min((width - 2 * _MARGIN) / size[0], (height - 2 * _MARGIN) / size[1])
    places = (at[:, :2] - low[:2] - 0.5 * size[:2]) * (scale, -scale) + (0.5 * width, 0.5 * height)
    corners = at[sketched.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    light = np.clip(normals @ _LIGHT, 0.0, 1.0)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    for number in np.argsort(corners[:, :, 2].mean(axis=1)).tolist():
        if normals[number, 2] <= 0.0:
            continue
        shade = colour.darker(int(190 - 100 * light[number]))
        painter.setPen(QtGui.QPen(shade, 0.6))
        painter.setBrush(shade)
        corner = places[sketched.triangles[number]].tolist()
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in corner]))
    painter.end()
    return pixmap


def _seen(positions: np.ndarray) -> np.ndarray:
    """Positions (n, 3) to the right, upward and towards the eye."""
    across, up, ahead = (positions - positions.mean(axis=0)).T
    right = math.cos(_TURN) * across + math.sin(_TURN) * ahead
    ahead = -math.sin(_TURN) * across + math.cos(_TURN) * ahead
    raised = math.cos(_TILT) * up - math.sin(_TILT) * ahead
    return np.column_stack([right, raised, math.sin(_TILT) * up + math.cos(_TILT) * ahead])
