# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a drag in the view of flat pieces does: pull the view, move a piece, turn it by its handle."""

from __future__ import annotations

import math

import numpy as np

from BalloonWorkbench.core.arrangement.snapping import NEAR_TURN, Neighbours
from BalloonWorkbench.core.units import from_mm

_SNAP = 8.0  # px within which a piece touches another one


class PullDrag:
    """The background under the mouse goes with it."""

    def __init__(self, view, at):
        self._view, self._at = view, at.toPoint()

    def move(self, at, free: bool) -> None:
        """Go on to a point of the view; free: without snapping."""
        self._view.pull(at.toPoint() - self._at)
        self._at = at.toPoint()

    def end(self) -> None:
        """The button is up."""

    def cancel(self) -> None:
        """As it was before; a pull stays."""


class _PieceDrag:
    """A drag that takes a piece elsewhere; it is told of when it ends."""

    def __init__(self, view, number: int):
        self.view, self.number = view, number
        self.first = self.place = view.laid.places[number]
        self.neighbours = Neighbours(view.laid, number)

    def end(self) -> None:
        """The button is up: the piece lies there."""
        if self.place != self.first:
            self.view.lay(self.number, self.place)

    def cancel(self) -> None:
        """The piece lies where it was."""
        self.view.scene().lie(self.number, self.first)

    def show(self, place) -> None:
        """Let the piece be seen there."""
        self.place = place
        self.view.scene().lie(self.number, place)


class SlideDrag(_PieceDrag):
    """A piece goes with the mouse, and touches others that are near."""

    def __init__(self, view, number: int, at):
        super().__init__(view, number)
        self._start = view.place_at(at)

    def move(self, at, free: bool) -> None:
        """Go on to a point of the view; free: without snapping."""
        shift = self.view.place_at(at) - self._start
        if not free:
            shift = self.neighbours.touching(shift, from_mm(_SNAP / self.view.zoom))
        self.show(self.first.moved(shift))


class KeyDrag(_PieceDrag):
    """A piece is moved by keys until they are up."""

    def by(self, shift: np.ndarray) -> None:
        """Go on by a shift (2,) [m]."""
        self.show(self.place.moved(shift))

    def move(self, at, free: bool) -> None:
        """The mouse has no part in it."""


class TurnDrag(_PieceDrag):
    """A piece turns about its middle, and snaps to even angles, its grain and edges of others."""

    def __init__(self, view, number: int, at):
        super().__init__(view, number)
        self._start = self._angle(at)

    def move(self, at, free: bool) -> None:
        """Go on to a point of the view; free: without snapping."""
        place = self.first.turned(self._angle(at) - self._start)
        near = 0.0 if free else NEAR_TURN
        self.show(self.neighbours.turn(place, self.view.grains[self.number], near))

    def _angle(self, at) -> float:
        x, y = (self.view.place_at(at) - np.array(self.first.middle)).tolist()
        return math.atan2(y, x)
