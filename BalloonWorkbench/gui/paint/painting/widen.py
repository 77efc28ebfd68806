# SPDX-License-Identifier: LGPL-2.1-or-later
"""A step of a painting that widens a thin arm or neck: the paint on both sides of it moves apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.vectors import foot
from BalloonWorkbench.gui.paint.painting.layers import LAYERS
from BalloonWorkbench.gui.paint.painting.symmetry import ONCE, Symmetry, mapped, symmetry_from
from BalloonWorkbench.gui.qt import QtCore, QtGui

WIDEN = "widen"
_RIM = 0.35  # of the half width: lines along the rim move as they are, what lies between them is stretched
_ROOM = 1.5  # of the way they move, in which what lies beside is pushed together
_NEVER = 1e9


@dataclass
class Widen:
    """Widens what lies along a line, and a little beyond its ends, so that the roots become round.

    points       of the middle line (x, y) px
    was, widened  width before and after, px
    symmetry     how it is done again
    """

    points: list[tuple[float, float]]
    was: float
    widened: float
    symmetry: Symmetry = ONCE
    tool: str = WIDEN

    @property
    def layers(self) -> tuple[str, ...]:
        """What it changes: the decoration moves with the shape."""
        return LAYERS

    def paint(self, image, seen=None) -> None:
        """Move the paint of one layer; seen: what lies on the paper, of which it knows nothing."""
        line = np.array(self.points, dtype=float)
        done = [line]
        self._paint_along(image, line)
        for transform in self.symmetry.transforms[1:]:
            other = mapped(transform, line)
            if all(_distance(other, each) > 2.0 * self.widened for each in done):
                self._paint_along(image, other)
                done.append(other)

    def _paint_along(self, image, line) -> None:
        gain = 0.5 * (self.widened - self.was)
        reach = 0.5 * self.widened * (1.0 + _RIM) + _ROOM * gain
        low = np.maximum(np.floor(line.min(axis=0) - reach - self.widened), 0).astype(int)
        high = np.minimum(
            np.ceil(line.max(axis=0) + reach + self.widened), [image.width(), image.height()]
        ).astype(int)
        if (high <= low).any():
            return
        place = QtCore.QRect(*map(int, low), *map(int, high - low))
        pixels = _premultiplied(image.copy(place))
        y, x = np.mgrid[low[1] : high[1], low[0] : high[0]].astype(np.float32) + 0.5
        nearest_x, nearest_y, away, share = _along(line, x, y, self.widened)
        rim = 0.5 * _RIM * self.was
        taken = np.interp(
            away,
            [0.0, 0.5 * self.widened - rim, 0.5 * self.widened + rim, reach],
            [0.0, 0.5 * self.was - rim, 0.5 * self.was + rim, reach],
        )
        part = 1.0 + share * (taken / np.maximum(away, 1e-3) - 1.0)
        part[away >= reach] = 1.0
        moved = _sampled(
            pixels,
            nearest_x + part * (x - nearest_x) - low[0] - 0.5,
            nearest_y + part * (y - nearest_y) - low[1] - 0.5,
        )
        height, width = moved.shape[:2]
        layer = QtGui.QImage(
            moved.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888_Premultiplied
        )
        painter = QtGui.QPainter(image)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode_Source)
        painter.drawImage(place.topLeft(), layer)
        painter.end()

    def data(self) -> dict:
        """For the file."""
        return {
            "tool": WIDEN,
            "points": [[round(x, 2), round(y, 2)] for x, y in self.points],
            "was": round(self.was, 3),
            "wanted": round(self.widened, 3),
            "symmetry": self.symmetry.data(),
        }

    @classmethod
    def from_data(cls, data: dict) -> Widen:
        points = [(float(x), float(y)) for x, y in data["points"]]
        return cls(points, float(data["was"]), float(data["wanted"]), symmetry_from(data))


def _along(line, x, y, fade: float):
    """Nearest place on the line to each pixel, its distance, and how much of the move it gets, 1 to 0.

    The line goes on straight beyond its ends; over the length `fade` there the move dies away.
    """
    before = line[0] + fade * _direction(line[0] - line[1])
    behind = line[-1] + fade * _direction(line[-1] - line[-2])
    nodes = np.vstack([before, line, behind])
    shares = np.concatenate([[0.0], np.ones(len(line)), [0.0]])
    best = np.full(x.shape, _NEVER, np.float32)
    nearest_x, nearest_y, share = np.zeros_like(x), np.zeros_like(x), np.zeros_like(x)
    for k in range(len(nodes) - 1):
        (ax, ay), (dx, dy) = nodes[k], nodes[k + 1] - nodes[k]
        t, away = foot(x - ax, y - ay, dx, dy)
        nearer = away < best
        best = np.where(nearer, away, best)
        nearest_x, nearest_y = (
            np.where(nearer, ax + t * dx, nearest_x),
            np.where(nearer, ay + t * dy, nearest_y),
        )
        share = np.where(nearer, shares[k] + t * (shares[k + 1] - shares[k]), share)
    return nearest_x, nearest_y, best, share * share * (3.0 - 2.0 * share)


def _distance(line, other) -> float:
    """Between two lines (n, 2), which may cross."""
    crossed = first_crossing((), [line, other]) is not None
    near = min(nearest_on_line(a, b).distance.min() for a, b in ((line, other), (other, line)))
    return 0.0 if crossed else float(near)


def _direction(vector):
    return vector / max(float(np.linalg.norm(vector)), 1e-9)


def _premultiplied(image) -> np.ndarray:
    """Pixels (h, w, 4) uint8 with their colours times alpha: what may be averaged."""
    image = image.convertToFormat(QtGui.QImage.Format_RGBA8888_Premultiplied)
    lines = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.bytesPerLine())
    return lines[:, : 4 * image.width()].reshape(image.height(), image.width(), 4).copy()


def _sampled(pixels, x, y) -> np.ndarray:
    """The pixels (h, w, 4) at places between them, evenly mixed from the four around."""
    height, width = pixels.shape[:2]
    x, y = np.clip(x, 0, width - 1.001), np.clip(y, 0, height - 1.001)
    column, row = x.astype(int), y.astype(int)
    right, down = (x - column)[..., None], (y - row)[..., None]
    column1, row1 = np.minimum(column + 1, width - 1), np.minimum(row + 1, height - 1)
    above = pixels[row, column] * (1 - right) + pixels[row, column1] * right
    below = pixels[row1, column] * (1 - right) + pixels[row1, column1] * right
    return (above * (1 - down) + below * down + 0.5).astype(np.uint8)
