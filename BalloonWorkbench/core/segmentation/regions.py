# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of triangles that grow from seeds over the surface until they meet."""

from __future__ import annotations

import heapq
from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.segmentation.proxies import (
    Faces,
    Moments,
    Proxies,
    costs,
    distances,
    fit_proxies,
    moments,
)
from BalloonWorkbench.core.targets.half_edges import Indices, connected_parts
from BalloonWorkbench.core.types import Bools, Floats, Ints

#: Passes from the first seeds, and after a region has moved.
_PASSES, _AFTERWARDS = 12, 4
#: What counts as one distance between seeds: this turn of the normal [rad], and this part of the size.
_TURN, _LENGTH = 3.0, 0.5
#: Cosine of the angle between triangles that makes a sharp edge.
_SHARP = np.cos(np.radians(30.0))
#: Area of a region that is too small, and of one that is large enough to be made two, of the mean one; and
#: what area is worth where film follows all regions.
SMALL, LARGE, _BY_AREA = 0.15, 0.6, 1e-6
#: Decimals of what is compared: the last bits differ from machine to machine, and must not decide.
_DECIMALS = 8


def rounded(values: Floats) -> Floats:
    """Values to be compared, without their last bits."""
    return np.asarray(np.round(values, _DECIMALS), dtype=np.float64)


class Regions(NamedTuple):
    """Regions of a surface: labels (m,) from 0, and about how far film over each stays away from it (p,)."""

    labels: Ints
    distances: Floats

    @property
    def total(self) -> float:
        """Of all regions, rounded."""
        return float(rounded(self.distances).sum())


def between_creases(faces: Faces, beside: Indices) -> Ints:
    """The parts (m,) of a surface between its sharp edges, from 0; beside (m, 3) as in near_developable."""
    own, other = np.repeat(np.arange(len(beside)), 3), beside.ravel()
    flat = (other >= 0) & (np.einsum("ij,ij->i", faces.normals[own], faces.normals[other]) > _SHARP)
    return connected_parts(len(beside), own[flat], other[flat])


def near_developable(faces: Faces, beside: Indices, count: int) -> Regions:
    """So many regions that are nearly developable (Lloyd's iteration, the best of its passes).

    beside  (m, 3) the triangles beside each one, -1 for none; the surface hangs together
    """
    seeds = _first_seeds(faces, count)
    normals = faces.normals[seeds]
    proxies = Proxies(_across(normals), np.zeros(count), normals, np.zeros(count))
    best, seeds, proxies = _settled(faces, beside, seeds, proxies, _PASSES)
    for _ in range(count):
        moved = _moved(faces, beside, best)
        if moved is None:
            break
        after = _settled(faces, beside, *moved, _AFTERWARDS)[0]
        if after.total >= best.total:
            break
        best = after
    labels = without_small(faces, beside, best.labels)
    sums = moments(faces, labels, count)
    return Regions(labels, distances(sums, fit_proxies(sums)))


def without_small(faces: Faces, beside: Indices, labels: Ints) -> Ints:
    """Regions (m,), as many as before, none of them very small: such a one joins one beside it, and a large
    one is made two."""
    count = int(labels.max()) + 1
    for _ in range(2 * count):
        small = int(np.argmin(np.bincount(labels, faces.areas, count)))
        if moments(faces, labels, count).areas[small] * count > SMALL:
            break
        labels = without(faces, beside, labels, small)
    return labels


def without(faces: Faces, beside: Indices, labels: Ints, small: int) -> Ints:
    """Regions (m,), as many as before: this one joins one beside it, and its number is that of a half of
    the worst of the large ones that can be parted well."""
    count = int(labels.max()) + 1
    sums = moments(faces, labels, count)
    own = distances(sums, fit_proxies(sums))
    pairs = neighbours(labels, beside)
    one, other = _least_loss(sums, own, pairs[(pairs == small).any(axis=1)])
    labels = np.where(labels == small, one if other == small else other, labels)
    sums = moments(faces, labels, count)
    own = distances(sums, fit_proxies(sums))
    worst = np.where(sums.areas * count > LARGE, worth_parting(sums, own), -1.0)
    best, most = labels, -1.0
    order = np.argsort(-rounded(worst), kind="stable")
    for region in order[worst[order] >= 0.0].tolist():
        halves = in_halves(faces, beside, labels == region)
        left = float(np.bincount(halves[halves >= 0], faces.areas[halves >= 0], 2).min()) * count
        if left > most:
            best, most = np.where(halves == 1, small, labels), left
        if most > SMALL:
            break
    return best


def worth_parting(sums: Moments, own: Floats) -> Floats:
    """How bad (p,) a region is; own (p,): distances. Of regions that film follows the largest."""
    return np.asarray(own + _BY_AREA * sums.areas**1.5)


def _least_loss(sums: Moments, own: Floats, pairs: Ints) -> tuple[int, int]:
    """Of pairs (k, 2) of regions the one that loses least when it becomes one region; own (p,): distances."""
    both = sums.of(pairs)
    loss = distances(both, fit_proxies(both)) - own[pairs].sum(axis=1)
    one, other = pairs[np.argmin(rounded(loss))].tolist()
    return one, other


def _first_seeds(faces: Faces, count: int) -> Indices:
    """Triangles (count,) far from each other, in place and in direction."""
    places = np.column_stack([faces.normals / _TURN, faces.centres / _LENGTH])
    nearest = ((places - faces.areas @ places) ** 2).sum(axis=1)
    seeds = [int(np.argmax(rounded(nearest)))]
    nearest[:] = np.inf
    while len(seeds) < count:
        nearest = np.minimum(nearest, ((places - places[seeds[-1]]) ** 2).sum(axis=1))
        seeds.append(int(np.argmax(rounded(nearest))))
    return np.array(seeds, dtype=np.intp)


def _across(normals: Floats) -> Floats:
    """A direction (p, 3) square to each normal."""
    other = np.eye(3)[np.argmin(rounded(np.abs(normals)), axis=1)]
    return unit(np.cross(normals, other))


def _settled(
    faces: Faces, beside: Indices, seeds: Indices, proxies: Proxies, passes: int
) -> tuple[Regions, Indices, Proxies]:
    """The best regions of some passes from these seeds and proxies."""
    count, best = len(seeds), None
    weights = np.ones(count)
    for _ in range(passes):
        checkpoint()
        labels = grown(costs(faces, proxies) * weights, seeds, beside)
        regions = moments(faces, labels, count)
        proxies = fit_proxies(regions)
        made = Regions(labels, distances(regions, proxies))
        if best is None or made.total < best.total:
            best = made
        # an angle costs more on a wide region
        weights = np.sqrt(regions.areas * count)
        seeds = _middles(faces, proxies, labels)
    assert best is not None
    return best, seeds, proxies


def grown(cost: Floats, seeds: Indices, beside: Indices) -> Ints:
    """The region (m,) of each triangle: each time the cheapest triangle beside a region joins it.

    cost    (m, p) of each triangle in each region
    seeds   (p,) a triangle of each region
    beside  (m, 3) the triangles beside each one, -1 for none
    """
    price, around = rounded(cost).T.tolist(), beside.tolist()
    label = [-1] * len(cost)
    waiting = [(-1.0, int(seed), region) for region, seed in enumerate(seeds)]
    while waiting:
        _, triangle, region = heapq.heappop(waiting)
        if label[triangle] >= 0:
            continue
        label[triangle] = region
        for other in around[triangle]:
            if other >= 0 and label[other] < 0:
                heapq.heappush(waiting, (price[region][other], other, region))
    return np.array(label, dtype=np.int32)


def _middles(faces: Faces, proxies: Proxies, labels: Ints) -> Indices:
    """Of each region the triangle (p,) that is most like all of it."""
    own = rounded(costs(faces, proxies)[np.arange(len(labels)), labels])
    order = np.lexsort((own, labels))
    return order[np.searchsorted(labels[order], np.arange(len(proxies.axes)))]


def _moved(faces: Faces, beside: Indices, regions: Regions) -> tuple[Indices, Proxies] | None:
    """Seeds and proxies after the two regions are made one that lose least, and the worst one is made two."""
    count, labels = len(regions.distances), regions.labels
    pairs = neighbours(labels, beside)
    worst = int(np.argmax(rounded(regions.distances)))
    pairs = pairs[(pairs != worst).all(axis=1)]
    if not len(pairs) or np.count_nonzero(labels == worst) < 2:
        return None
    sums = moments(faces, labels, count)
    one, other = _least_loss(sums, regions.distances, pairs)
    halves = in_halves(faces, beside, labels == worst)
    labels = np.where(labels == other, one, labels)
    labels[halves == 1] = other
    proxies = fit_proxies(moments(faces, labels, count))
    return _middles(faces, proxies, labels), proxies


def in_halves(faces: Faces, beside: Indices, own: Bools) -> Ints:
    """Half 0 or 1 (m,) of each triangle of a region that hangs together, own (m,); -1 for the others."""
    places = np.column_stack([faces.normals, faces.centres / _LENGTH])
    there = np.flatnonzero(own)
    far = there[np.argmax(rounded(((places[there] - places[there].mean(axis=0)) ** 2).sum(axis=1)))]
    near = there[np.argmax(rounded(((places[there] - places[far]) ** 2).sum(axis=1)))]
    cost = np.stack([((places - places[seed]) ** 2).sum(axis=1) for seed in (near, far)], axis=1)
    return grown(cost, np.array([near, far]), np.where(own[beside] & own[:, None], beside, -1))


def neighbours(labels: Ints, beside: Indices) -> Ints:
    """Pairs (k, 2) of regions that share a border, the lower number first."""
    there = beside >= 0
    pairs = np.stack([np.repeat(labels, 3)[there.ravel()], labels[beside[there]]], axis=1)
    pairs = np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1)
    return np.unique(pairs, axis=0)
