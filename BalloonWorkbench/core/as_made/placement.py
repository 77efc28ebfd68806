# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an outline is shifted and turned, and sized where asked, to lie over another one.

First at many angles, then point to line (Chen and Medioni, Image Vision Comput. 10, 1992, 145-155), with
weights that what sticks out at a few places does not move the whole (Huber 1964).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops, nearest_places
from BalloonWorkbench.core.geometry.normals import left_normals
from BalloonWorkbench.core.geometry.polyline import arc_lengths, centroid, extent
from BalloonWorkbench.core.geometry.sampling import evenly, simplify
from BalloonWorkbench.core.geometry.vectors import norm, perpendicular, rotation
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Bools, Floats

_ANGLES = 72
#: So many of them that are better than those beside them are tried to the end; a star has as many as tips.
_TRIED = 6
_ROUGH, _TRIAL, _FINE = 120, 300, 800  # points along an outline, when it is laid down, tried, and placed
_STEPS = 40  # of a fit; moves of these parts of the size end a trial, and the last one
_ROUGHLY, _STILL = 1e-4, 1e-6
#: How far a goal may be off when it is simplified, in parts of its size.
_TOLERANCE = 1e-5
#: Differences beyond so many times the median count less, but never those below a micrometre.
_OUTLYING, _LEAST = 3.0, 1e-6
#: The mirror image must lie so much nearer to be taken.
NEARER = 0.5


@dataclass(frozen=True)
class IntakeZone:
    """A place of an outline around which nothing is compared: within reach [m] of it an intake sticks out."""

    place: Floats
    reach: float

    def near(self, places: Floats) -> Bools:
        """Which of places (k, 2) it is that lie there."""
        return np.asarray(norm(places - self.place) < self.reach)


@dataclass(frozen=True)
class Placement:
    """points @ matrix.T + shift lie over the goal; mean: how far they are from it then [m]."""

    matrix: Floats
    shift: Floats
    mean: float

    @property
    def mirrored(self) -> bool:
        """The back is seen."""
        return float(np.linalg.det(self.matrix)) < 0.0

    @property
    def size(self) -> float:
        """By how much it was made larger."""
        return float(np.sqrt(abs(np.linalg.det(self.matrix))))

    @property
    def turn(self) -> float:
        """Counter-clockwise, after it was mirrored left to right [rad]."""
        x, y = self.matrix[:, 1] / self.size  # where up goes
        return float(np.arctan2(-x, y))

    def __call__(self, points: Floats) -> Floats:
        """Points (n, 2) where they lie over the goal."""
        return np.asarray(points @ self.matrix.T + self.shift)

    def then(self, other: Placement) -> Placement:
        """This one, and another one after it."""
        return Placement(other.matrix @ self.matrix, other.matrix @ self.shift + other.shift, other.mean)

    def outline(self, seen: Outline) -> Outline:
        """An outline there, oriented as an outline is."""
        if not self.mirrored:
            return Outline(self(seen.outer), tuple(self(hole) for hole in seen.holes))
        return Outline(self(seen.outer)[::-1], tuple(self(hole)[::-1] for hole in seen.holes))


def place(
    seen: Outline, goal: Outline, necks: tuple[IntakeZone, ...] = (), *, sized: bool = False
) -> Placement:
    """How an outline with its holes lies nearest to another one; sized: also made larger.

    The smallest turn of those that are equally good; mirrored only where that is far better.
    """
    fit = _Fit(seen, goal, necks, sized)
    best: list[Placement] = []
    for mirror in (np.eye(2), np.diag([-1.0, 1.0])):
        starts = fit.starts(mirror)
        means = np.array([start.mean for start in starts])
        lowest = np.flatnonzero((means <= np.roll(means, 1)) & (means <= np.roll(means, -1)))
        begun = sorted((starts[number] for number in lowest), key=lambda start: start.mean)
        ends = [fit.fitted(start, _TRIAL, _ROUGHLY) for start in begun[:_TRIED]]
        best.append(min(ends, key=lambda end: end.mean * (1.0 + 1e-3 * abs(end.turn))))
    upright, mirrored = best
    return fit.fitted(mirrored if mirrored.mean < NEARER * upright.mean else upright, _FINE)


def settle(
    seen: Outline, goal: Outline, necks: tuple[IntakeZone, ...] = (), *, sized: bool = False
) -> Placement:
    """The same for an outline that nearly lies where it should."""
    start = Placement(np.eye(2), np.zeros(2), np.inf)
    return _Fit(seen, goal, necks, sized).fitted(start, _FINE)


class _Fit:
    """One outline to be laid on another."""

    def __init__(self, seen: Outline, goal: Outline, necks: tuple[IntakeZone, ...], sized: bool) -> None:
        self._seen, self._necks, self._sized = seen, necks, sized
        self._size = extent(goal.outer)
        self._goal = [simplify(loop, _TOLERANCE * self._size) for loop in goal.loops]
        self._centre = centroid([goal.outer])
        self._factor = float(np.sqrt(Outline(goal.outer).area / Outline(seen.outer).area)) if sized else 1.0

    def _points(self, count: int) -> tuple[Floats, Floats]:
        """Points (k, 2) along all loops of the seen outline, and the normals there."""
        spacing = float(arc_lengths(self._seen.outer)[-1]) / count
        loops = [evenly(loop, spacing) for loop in self._seen.loops]
        return np.concatenate(loops), np.concatenate([left_normals(loop) for loop in loops])

    def starts(self, mirror: Floats) -> list[Placement]:
        """The outline laid on the goal by its centre, turned to all sides."""
        points, _ = self._points(_ROUGH)
        middle = centroid([self._seen.outer])
        starts = []
        for angle in np.arange(_ANGLES) * (2.0 * np.pi / _ANGLES):
            matrix: Floats = self._factor * (rotation(float(angle)).T @ mirror)
            shift = self._centre - matrix @ middle
            away = nearest_on_loops(self._goal, points @ matrix.T + shift).distance
            turned = min(angle, 2.0 * np.pi - angle)
            mean = float(np.median(away) + away.mean()) * (1.0 + 1e-3 * turned)
            starts.append(Placement(matrix, shift, mean))
        return starts

    def fitted(self, start: Placement, count: int, still: float = _STILL) -> Placement:
        """The placement to which a start leads, with so many points along the outline."""
        points, across = self._points(count)
        matrix, shift = start.matrix, start.shift
        for _ in range(_STEPS):
            checkpoint()
            here = points @ matrix.T + shift
            turn, moved, about = self._step(here, across @ matrix.T / np.sqrt(abs(np.linalg.det(matrix))))
            matrix, shift = turn @ matrix, turn @ (shift - about) + about + moved
            if np.abs(moved).max() + np.abs(turn - np.eye(2)).max() * self._size < still * self._size:
                break
        here = points @ matrix.T + shift
        nearest = nearest_places(self._goal, here)
        away = norm(nearest - here)[~in_necks(nearest, self._necks)]
        return Placement(matrix, shift, float(away.mean()) if len(away) else np.inf)

    def _step(self, here: Floats, normals: Floats) -> tuple[Floats, Floats, Floats]:
        """The matrix by which points turn next, about which place, and how far they move."""
        goals = nearest_places(self._goal, here)
        missing = np.einsum("ij,ij->i", goals - here, normals)
        centre = here.mean(axis=0)
        away = here - centre
        columns = [normals, np.einsum("ij,ij->i", perpendicular(away), normals)]
        if self._sized:
            columns.append(np.einsum("ij,ij->i", away, normals))
        weights = weights_of(missing, goals, self._necks)
        rows = np.column_stack(columns) * weights[:, None]
        moves = np.linalg.lstsq(rows, missing * weights, rcond=1e-6)[0]
        size = 1.0 + (float(moves[3]) if self._sized else 0.0)
        return rotation(float(moves[2])).T * size, moves[:2], centre


def in_necks(places: Floats, necks: tuple[IntakeZone, ...]) -> Bools:
    """Which of places (k, 2) of the goal are at a neck."""
    return np.any([np.zeros(len(places), dtype=bool), *(neck.near(places) for neck in necks)], axis=0)


def weights_of(missing: Floats, goals: Floats, necks: tuple[IntakeZone, ...]) -> Floats:
    """By what rows of a fit are multiplied: 1, less for what lies far off, 0 at necks."""
    kept = ~in_necks(goals, necks)
    usual = _OUTLYING * float(np.median(np.abs(missing[kept]))) if kept.any() else 0.0
    size = np.maximum(np.abs(missing), 1e-300)
    return np.where(kept, np.sqrt(np.minimum(1.0, max(usual, _LEAST) / size)), 0.0)
