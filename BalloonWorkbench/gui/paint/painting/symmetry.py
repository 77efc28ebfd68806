# SPDX-License-Identifier: LGPL-2.1-or-later
"""Symmetry of what is painted: mirrored about an axis, turned about a centre, or both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from BalloonWorkbench.gui.paint.painting.layers import SIDE
from BalloonWorkbench.gui.qt import QtCore, QtGui

MOST_FOLDS = 12
UPRIGHT = 90.0  # degrees


@dataclass(frozen=True)
class Symmetry:
    """Where each stroke is painted again.

    fold    so many times around the centre
    mirror  on the other side of the axis too
    x, y    the centre, which lies on the axis, px with y down
    angle   of the axis, degrees counter-clockwise from the right
    """

    fold: int = 1
    mirror: bool = False
    x: float = SIDE / 2
    y: float = SIDE / 2
    angle: float = UPRIGHT

    @property
    def is_none(self) -> bool:
        """All is painted once."""
        return self.fold == 1 and not self.mirror

    @cached_property
    def transforms(self) -> tuple:
        """From a place on the paper to all that are painted, the place itself first."""
        turns = [2.0 * np.pi * number / self.fold for number in range(self.fold)]
        turned = [self._about((np.cos(turn), np.sin(turn)), (-np.sin(turn), np.cos(turn))) for turn in turns]
        if not self.mirror:
            return tuple(turned)
        double = np.radians(-2.0 * self.angle)  # y is down
        mirrored = self._about((np.cos(double), np.sin(double)), (np.sin(double), -np.cos(double)))
        return tuple(each for turn in turned for each in (turn, mirrored * turn))

    def lines(self) -> list[tuple[float, float]]:
        """Directions (x, y), y down, from the centre to where a sector or a mirrored half begins."""
        step = 180.0 / self.fold if self.mirror else 360.0 / self.fold
        count = 2 * self.fold if self.mirror else self.fold
        turns = [np.radians(-self.angle + step * number) for number in range(count)]
        return [] if self.is_none else [(float(np.cos(turn)), float(np.sin(turn))) for turn in turns]

    def data(self) -> list:
        """For the file."""
        return [self.fold, self.mirror, *(round(value, 2) for value in (self.x, self.y, self.angle))]

    def _about(self, across, down):
        """The transform about the centre that gives the unit vectors these places."""
        (a, b), (c, d) = ((round(float(value), 12) for value in vector) for vector in (across, down))
        x, y = self.x, self.y
        return QtGui.QTransform(a, b, c, d, x - a * x - c * y, y - b * x - d * y)


#: No symmetry.
ONCE = Symmetry()


def symmetry_from(data: dict) -> Symmetry:
    """That of a step in a file; the first ones knew a mirror in the middle of the paper alone."""
    if "symmetry" not in data:
        return Symmetry(mirror=bool(data.get("mirror", False)))
    fold, mirror, x, y, angle = data["symmetry"]
    fold = min(max(int(fold), 1), MOST_FOLDS)
    return Symmetry(fold, bool(mirror), float(x), float(y), float(angle))


def mapped(transform, points) -> np.ndarray:
    """Points (n, 2) through a transform."""
    places = [transform.map(QtCore.QPointF(float(x), float(y))) for x, y in points]
    return np.array([(place.x(), place.y()) for place in places])
