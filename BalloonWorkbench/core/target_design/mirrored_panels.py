# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that are mirror images of each other, as of a symmetric body, kept so while they change."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.flattening.bag_of import FlatBody
from BalloonWorkbench.core.flattening.seam_points import all_points, at_points
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.targets.symmetry_planes import symmetry_planes
from BalloonWorkbench.core.types import Floats, Ints

#: Points of panels that are mirror images lie so near to each other's, in parts of the diagonal.
_NEAR = 2e-3
_FLIP = np.array([-1.0, 1.0])


@dataclass(frozen=True)
class MirroredPanels:
    """Which point of a bag is the mirror image of which.

    pairs  for each panel and its image, or itself, the numbers (k,) of its points among all of the bag, and
           those of their images
    """

    pairs: tuple[tuple[Ints, Ints], ...] = ()

    @classmethod
    def of(cls, body: FlatBody) -> MirroredPanels:
        """Those of the first plane that halves the body and its division; none where there is no such."""
        target = body.division.target
        points = np.concatenate(body.places)
        counts = [len(each) for each in body.places]
        owner, starts = (
            np.repeat(np.arange(len(counts)), counts),
            np.append(0, np.cumsum(counts)).astype(np.int32),
        )
        trees = [kd_tree(each) for each in body.places]
        for middle, normal in symmetry_planes(target.points, target.triangles):
            images = points - 2.0 * ((points - middle) @ normal)[:, None] * normal
            own = [images[owner == k] for k in range(len(counts))]
            mirrored = [_image(each, trees, counts, _NEAR * target.diagonal) for each in own]
            pairs = [
                (starts[k] + np.arange(counts[k], dtype=np.int32), starts[each[0]] + each[1])
                for k, each in enumerate(mirrored)
                if each is not None and each[0] >= k
            ]
            if all(each is not None for each in mirrored):
                return cls(tuple(pairs))
        return cls()

    def alike(self, bag: Bag) -> Bag:
        """The bag with each panel and its mirrored image replaced by what is between them, where they lie."""
        points = all_points(bag)
        for own, image in self.pairs:
            mirrored = points[image] * _FLIP
            matrix, shift = _laid_over(mirrored, points[own])
            mean = 0.5 * (points[own] + mirrored @ matrix.T + shift)
            if not np.array_equal(np.sort(own), np.sort(image)):
                matrix, shift = _laid_over(mean * _FLIP, points[image])
                points[image] = mean * _FLIP @ matrix.T + shift
            points[own] = mean
        return at_points(bag, points)


NOT_MIRRORED = MirroredPanels()


def _laid_over(points: Floats, goals: Floats) -> tuple[Floats, Floats]:
    return alignment(points, goals, np.ones(len(points)))


def _image(images: Floats, trees: list[Any], counts: list[int], near: float) -> tuple[int, Ints] | None:
    """The panel with so many points that lie on the images (k, 3) of a panel's, and their numbers (k,)."""
    for number, tree in enumerate(trees):
        if counts[number] != len(images):
            continue
        away, order = tree.query(images)
        if away.max() <= near and len(np.unique(order)) == len(order):
            return number, np.asarray(order, dtype=np.int32)
    return None
