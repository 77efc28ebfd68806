# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary loops of a division's panels, as the sides of seams that follow each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import perimeter
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Ints


@dataclass(frozen=True)
class SeamSide:
    """One side of a seam, in the direction of its panel's boundary: the film is to its left.

    seam      number of the seam
    second    it is the seam's second side, which runs against the seam
    vertices  (k,) opened vertices along it
    """

    seam: int
    second: bool
    vertices: Ints


def panel_loops(division: Division) -> list[list[list[SeamSide]]]:
    """For each panel its loops, each the sides of seams one after another; the longest loop first.

    A loop begins with the first of its seams. Raises InputError for a panel without a boundary.
    """
    sides: list[list[SeamSide]] = [[] for _ in division.names]
    for number, seam in enumerate(division.seams):
        one, other = seam.sides
        sides[seam.panels[0]].append(SeamSide(number, False, one))
        sides[seam.panels[1]].append(SeamSide(number, True, other[::-1]))
    every = []
    for name, own in zip(division.names, sides):
        if not own:
            raise InputError(
                f"Panel '{name}' is the whole surface and has no edge: divide the body into more panels."
            )
        loops = _linked(own)
        lengths = [_length(division, loop) for loop in loops]
        every.append([loops[k] for k in np.argsort(lengths, kind="stable")[::-1]])
    return every


def _linked(sides: list[SeamSide]) -> list[list[SeamSide]]:
    after = {int(side.vertices[0]): side for side in sides}
    loops = []
    for side in sides:
        if int(side.vertices[0]) not in after:
            continue
        loop, at = [], int(side.vertices[0])
        while at in after:
            loop.append(after.pop(at))
            at = int(loop[-1].vertices[-1])
        loops.append(loop)
    return loops


def _length(division: Division, loop: list[SeamSide]) -> float:
    points = division.target.points[division.opened.vertices[loop_vertices(loop)]]
    return perimeter(points)


def loop_vertices(loop: list[SeamSide]) -> Ints:
    """The opened vertices (k,) round a loop, each once."""
    return np.concatenate([side.vertices[:-1] for side in loop])
