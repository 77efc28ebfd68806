# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that are images of each other, as of a symmetric body, kept so while they change."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.flattening.bag_of import FlatBody
from BalloonWorkbench.core.flattening.seam_points import all_points, at_points, panel_points, with_equal_seams
from BalloonWorkbench.core.geometry.nearest import kd_tree
from BalloonWorkbench.core.geometry.vectors import alignment, unit
from BalloonWorkbench.core.targets.symmetry_planes import Mirrored
from BalloonWorkbench.core.types import Floats, Ints

#: Points of panels that are images lie so near to each other's, in parts of the diagonal.
_NEAR = 2e-3
#: Symmetries of a body that are looked for at most.
_MOST = 128
#: Passes until images are alike to the last digits.
_PASSES = 3
_FLIP = np.array([-1.0, 1.0])


class Image(NamedTuple):
    """Points of a panel that are images of those of another one, or of its own in another order.

    numbers  (k,) of the points among all of a bag, in the order of the other panel's
    turned   whether it is a mirror image
    """

    numbers: Ints
    turned: bool


@dataclass(frozen=True)
class MirroredPanels:
    """Which point of a bag is the image of which.

    orbits  of each panel that is no image of one before it its images, itself the first: all the symmetries
    first   (panels,) of which panel each one is an image, or itself
    """

    orbits: tuple[tuple[Image, ...], ...] = ()
    first: tuple[int, ...] = ()

    @classmethod
    def of(cls, body: FlatBody) -> MirroredPanels:
        """Those of the planes that halve the body and its division, and what follows from them together."""
        symmetries = _closed(_mirrored(body))
        if not symmetries:
            return cls()
        own = panel_points(body.bag)
        panel_of = np.repeat(np.arange(len(own)), [len(each) for each in own])
        first = np.full(len(own), -1)
        orbits = []
        for panel, numbers in enumerate(own):
            if first[panel] >= 0:
                continue
            images = [Image(numbers, turned=False)]
            images += [Image(image[numbers], turned) for image, turned in symmetries]
            for image in images:
                first[panel_of[image.numbers[0]]] = panel
            orbits.append(tuple(images))
        return cls(tuple(orbits), tuple(first.tolist()))

    @property
    def share(self) -> float:
        """How many panels are no images, in parts of all."""
        return len(self.orbits) / len(self.first) if self.first else 1.0

    def first_of(self, panel: int) -> int:
        """Of which panel this one is an image, or itself."""
        return self.first[panel] if self.first else panel

    def alike(self, bag: Bag) -> Bag:
        """The bag with each panel and its images replaced by what is between them, where they lie."""
        if not self.orbits:
            return with_equal_seams(bag)
        for _ in range(_PASSES):
            points = all_points(bag)
            for images in self.orbits:
                own = images[0].numbers
                laid = [_onto(points[image.numbers], image.turned, points[own]) for image in images]
                mean = np.mean(laid, axis=0)
                for image in images:
                    if not np.isin(image.numbers[0], own):
                        points[image.numbers] = _onto(mean, image.turned, points[image.numbers])
                points[own] = mean
            bag = with_equal_seams(at_points(bag, points))
        return bag

    def fields(self, points: Floats, moves: Floats, orbit: int) -> Floats:
        """Moves (p, 2, k) of the panel of an orbit, at points (p, 2), in the mean of its images."""
        images = self.orbits[orbit]
        own = images[0].numbers
        result = np.zeros_like(moves)
        for image in images:
            flip = _FLIP if image.turned else 1.0
            matrix, _ = alignment(points[own] * flip, points[image.numbers], np.ones(len(own)))
            result[image.numbers] += np.einsum(
                "pdk,ed->pek", moves[own] * np.reshape(flip, (1, -1, 1)), matrix
            )
        onto_itself = sum(bool(np.isin(image.numbers[0], own)) for image in images)
        return result / onto_itself


NOT_MIRRORED = MirroredPanels()


def _onto(points: Floats, turned: bool, goals: Floats) -> Floats:
    points = points * _FLIP if turned else points
    matrix, shift = alignment(points, goals, np.ones(len(points)))
    return np.asarray(points @ matrix.T + shift)


def _mirrored(body: FlatBody) -> list[tuple[Ints, bool]]:
    """For planes that halve the body and its division the image (p,) of each point of the bag."""
    target, rims = body.division.target, _Rims(body)
    bodies = Mirrored(target.points, target.triangles)
    middles = np.array([each.mean(axis=0) for each in body.places])
    # one that brings the first panel to another is square to what lies between them
    between = middles[1:] - middles[0]
    others = unit(between[np.linalg.norm(between, axis=1) > rims.near])
    images: dict[bytes, tuple[Ints, bool]] = {}
    for normal in (*bodies.axes, *others):
        image = rims.image(bodies.middle, normal)
        if image is not None and image.tobytes() not in images and bodies.halved(normal):
            images[image.tobytes()] = image, True
    return list(images.values())


def _closed(generators: list[tuple[Ints, bool]]) -> list[tuple[Ints, bool]]:
    """All that follow from some symmetries, one after the other, without that which moves nothing."""
    known = {image.tobytes(): (image, turned) for image, turned in generators}
    waiting = list(known.values())
    while waiting and len(known) < _MOST:
        image, turned = waiting.pop()
        for other, other_turned in generators:
            both = image[other]
            if both.tobytes() not in known:
                known[both.tobytes()] = both, turned != other_turned
                waiting.append(known[both.tobytes()])
    if waiting:  # not all are known: those of one plane go together in any case
        known = {image.tobytes(): (image, turned) for image, turned in generators[:1]}
    return [each for each in known.values() if not _still(each[0])]


def _still(image: Ints) -> bool:
    return bool((image == np.arange(len(image))).all())


class _Rims:
    """The places of a bag's points on the target, whose images are looked for."""

    def __init__(self, body: FlatBody) -> None:
        self.near = _NEAR * body.division.target.diagonal
        self.points = np.concatenate(body.places)
        self.counts = [len(each) for each in body.places]
        self.starts = np.append(0, np.cumsum(self.counts)).astype(np.int32)
        self.trees = [kd_tree(each) for each in body.places]

    def image(self, middle: Floats, normal: Floats) -> Ints | None:
        """The number (p,) of the image of each point behind a plane; None if some panel has no image."""
        images = self.points - 2.0 * ((self.points - middle) @ normal)[:, None] * normal
        numbers = []
        for low, high in zip(self.starts[:-1], self.starts[1:]):
            number = self._panel(images[low:high])
            if number is None:
                return None
            numbers.append(number)
        return np.concatenate(numbers)

    def _panel(self, images: Floats) -> Ints | None:
        """The points of one panel that lie on images (k, 3), as many as it has."""
        for number, tree in enumerate(self.trees):
            if self.counts[number] != len(images):
                continue
            away, order = tree.query(images)
            if away.max() <= self.near and len(np.unique(order)) == len(order):
                return np.asarray(self.starts[number] + order, dtype=np.int32)
        return None
