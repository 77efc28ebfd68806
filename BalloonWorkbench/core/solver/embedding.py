# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first shape in space for any closed surface whose edges have known lengths.

Distances along the surface between a number of its vertices, the landmarks, are laid out in as many
dimensions as they need (classical scaling, Torgerson 1952) and pressed into three, while near landmarks keep
their distances best (majorisation of the stress, de Leeuw 1977). The other vertices are means of landmarks
near them. Averaging neighbours makes that even. It makes a body round, too, but closes thin tubes, and so it
goes on while the body holds more at the same length of its edges. What comes out is a little stretched, so
that nothing is slack at first.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.types import Floats, Ints

LANDMARKS = 100
DIMENSIONS = 8  # at first: a ring needs more than three for its own length before its section counts
PASSES = 60  # while the further dimensions are pressed, and as many afterwards
PRESSED = 0.9  # of the further dimensions, in each pass
NEIGHBOURS = 3  # landmarks that weigh most in the place of a vertex
FEWEST_AVERAGES, MOST_AVERAGES = 5, 160  # in a round, each of twice as many
FULLER = 1.005  # what a round has to bring
STRETCH = 1.1  # of the edges


def embedding(rest_corners: Floats, triangles: Ints) -> Floats:
    """Places (n, 3) of the vertices of a closed surface in one piece, outside out.

    rest_corners (m, 3, 2) of the flat triangles; triangles (m, 3) of n vertices, all in use
    """
    count = int(triangles.max()) + 1
    some = np.random.default_rng(0).permutation(count)[:LANDMARKS].astype(np.int32)
    ahead = np.roll(triangles, -1, axis=1).ravel()  # each edge of a closed surface once in each direction
    lengths = np.linalg.norm(np.roll(rest_corners, -1, axis=1) - rest_corners, axis=2).ravel()
    away = _distances(triangles.ravel(), ahead, lengths, count, some)
    reach = np.partition(away, NEIGHBOURS, axis=1)[:, NEIGHBOURS, None]
    share = np.exp(-((away / reach) ** 2))
    places = share / share.sum(axis=1, keepdims=True) @ _laid_out(away[some])
    if facet_volume(places, triangles) < 0.0:
        places = places * (1.0, 1.0, -1.0)
    return STRETCH * _evened(_scaled(places, triangles, ahead, lengths), triangles, ahead, lengths)


def _scaled(places: Floats, triangles: Ints, ahead: Ints, lengths: Floats) -> Floats:
    """Places whose edges have these lengths (e,) in the mean."""
    own = np.linalg.norm(places[ahead] - places[triangles.ravel()], axis=1)
    return np.asarray(places * ((lengths @ lengths) / (own @ lengths)))


def _evened(places: Floats, triangles: Ints, ahead: Ints, lengths: Floats) -> Floats:
    here, count = triangles.ravel(), len(places)
    share = 0.5 / np.bincount(here, minlength=count)
    averages = FEWEST_AVERAGES
    while averages <= MOST_AVERAGES:
        even = places
        for _ in range(averages):
            sums = [np.bincount(here, even[ahead, axis], count) for axis in range(3)]
            even = 0.5 * even + share[:, None] * np.column_stack(sums)
        even = _scaled(even, triangles, ahead, lengths)
        if facet_volume(even, triangles) < FULLER * facet_volume(places, triangles):
            break
        places, averages = even, 2 * averages
    return places


def _distances(here: Ints, ahead: Ints, lengths: Floats, count: int, origins: Ints) -> Floats:
    """Lengths (n, k) of the shortest ways along edges from all vertices to some.

    By SciPy (Dijkstra 1959), which some FreeCADs lack, or slowly and to the same bits (Bellman 1958).
    """
    order = np.argsort(here, kind="stable")
    ahead, lengths = ahead[order], lengths[order, None]
    first = np.searchsorted(here[order], np.arange(count))
    try:
        from scipy.sparse import csgraph, csr_matrix
    except ImportError:
        return _relaxed(ahead, lengths, first, origins)
    ways = csr_matrix((lengths.ravel(), ahead, np.append(first, len(ahead))), shape=(count, count))
    return np.ascontiguousarray(csgraph.dijkstra(ways.T.tocsr(), indices=origins).T)


def _relaxed(ahead: Ints, lengths: Floats, first: Ints, origins: Ints) -> Floats:
    away = np.full((len(first), len(origins)), np.inf)
    away[origins, np.arange(len(origins))] = 0.0
    while True:
        nearer = np.minimum(away, np.minimum.reduceat(away[ahead] + lengths, first, axis=0))
        if np.array_equal(nearer, away):
            return away
        away = nearer


def _laid_out(away: Floats) -> Floats:
    """Places (k, 3) at these distances (k, k) from each other, near ones above all."""
    count = len(away)
    centring = np.eye(count) - 1.0 / count
    values, vectors = np.linalg.eigh(-0.5 * centring @ away**2 @ centring)
    places = (vectors * np.sqrt(np.maximum(values, 0.0)))[:, ::-1][:, :DIMENSIONS]
    weights = np.zeros_like(away)
    np.divide(1.0, away**2, out=weights, where=away > 0.0)
    inverse = np.linalg.pinv(np.diag(weights.sum(axis=1)) - weights, hermitian=True)
    for number in range(2 * PASSES):
        places = places - places.mean(axis=0)
        if number < PASSES:
            axes = np.linalg.eigh(places.T @ places)[1][:, ::-1]
            places = places @ axes
            places[:, 3:] *= PRESSED
        elif number == PASSES:
            places = places[:, :3]
        squares = np.sum(places**2, axis=1)
        apart = np.sqrt(np.maximum(squares[:, None] + squares - 2.0 * places @ places.T, 0.0))
        pull = np.zeros_like(away)
        np.divide(weights * away, apart, out=pull, where=apart > 0.0)
        places = inverse @ (pull.sum(axis=1)[:, None] * places - pull @ places)
    return np.asarray(places)
