# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random bags whose balloons are targets: the panels that inflate to them are known."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from divided import NO_CUTS, divided
from solids import ball

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.division import side_line
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import length, line_lengths, point_on, signed_area
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.target_design.seam_unknowns import SeamUnknowns, spans_of
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats

_VERTICES = 1500
_MOVED = 0.01  # of the size, by how much corners and bulges are moved at random


class KnownAnswer(NamedTuple):
    """A bag, and the shape of its balloon divided along its seams."""

    bag: Bag
    division: Division


class Apart(NamedTuple):
    """By how much two bags differ at most: lengths of seams, areas of panels, and outlines of panels that lie
    over each other, all in parts of what they are, outlines of the body's diagonal."""

    lengths: float
    areas: float
    outlines: float


def random_bag(seed: int, film: Film, pressure: float) -> KnownAnswer:
    """4 to 10 panels of an ellipsoid, whose seams are moved at random, and their balloon."""
    random = np.random.default_rng(seed)
    scale = random.uniform(0.7, 1.4, 3)
    count = int(random.integers(4, 11))
    middles = _spread(random, count)

    def nearest(at: Floats) -> np.ndarray:
        return np.argmax((at / scale) @ middles.T, axis=1)

    division = divided(ball((scale[0], scale[1], scale[2]), 20), nearest)
    return answer(division, film, pressure, random)


def answer(
    division: Division, film: Film, pressure: float, random: np.random.Generator | None = None
) -> KnownAnswer:
    """The panels of a division laid flat, moved at random, and their balloon."""
    body = bag_of(division, flatten(division))
    bag, size = body.bag, division.target.diagonal
    if random is not None:
        unknowns = SeamUnknowns.of(bag, spans_of(bag, size, 3.0))
        moves = unknowns.basis.T @ random.normal(size=len(unknowns.basis))
        bag = unknowns.moved(bag, _MOVED * size * moves / np.sqrt(len(moves)))
    meshed = mesh_bag(bag, default_size(bag, _VERTICES))
    balloon = inflate(meshed.assembly, film, pressure, start=body.on_target(meshed))
    assert balloon.report.converged
    surface = balloon.assembly.surface
    used, corners = np.unique(surface.first[surface.triangles], return_inverse=True)
    counts = [len(panel.triangles) for panel in meshed.assembly.panels]
    panels = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
    target = Target(balloon.positions[used], corners.reshape(-1, 3).astype(np.int32), "balloon")
    return KnownAnswer(bag, Division(target, panels, division.names, NO_CUTS))


def apart(one: Bag, other: Bag, diagonal: float) -> Apart:
    """Two bags of the same panels; seams may have other numbers."""
    before, after = _sides(one), _sides(other)
    assert before.keys() == after.keys()
    lengths = [abs(length(after[key]) / length(before[key]) - 1.0) for key in before]
    areas = [abs(signed_area(b.outer) / signed_area(a.outer) - 1.0) for a, b in zip(one.panels, other.panels)]
    outlines = []
    for panel in range(len(one.panels)):
        own = [key for key in before if key[0] == panel]
        a, b = (np.concatenate([_even(sides[key]) for key in own]) for sides in (before, after))
        turn, shift = alignment(a, b, np.ones(len(a)))
        outlines.append(np.linalg.norm(a @ turn.T + shift - b, axis=1).max() / diagonal)
    return Apart(max(lengths), max(areas), float(max(outlines)))


def _sides(bag: Bag) -> dict[tuple[int, int], Floats]:
    """Points along each side, by its panel and the one beside it, as the loop of the panel runs."""
    sides = {}
    for seam in bag.seams:
        assert (seam.a.panel, seam.b.panel) not in sides
        sides[seam.a.panel, seam.b.panel] = side_line(bag, seam.a, against=False)
        sides[seam.b.panel, seam.a.panel] = side_line(bag, seam.b, against=True)[::-1]
    return sides


def _even(line: Floats) -> Floats:
    lengths = line_lengths(line)
    return point_on(line, lengths, np.linspace(0.0, lengths[-1], 30))


def _spread(random: np.random.Generator, count: int) -> Floats:
    """Directions (count, 3) far from each other: the best of some draws."""
    draws = random.normal(size=(200, count, 3))
    draws /= np.linalg.norm(draws, axis=2, keepdims=True)
    near = np.einsum("dik,djk->dij", draws, draws) - 3.0 * np.eye(count)
    return np.asarray(draws[np.argmin(near.max(axis=(1, 2)))])
