# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first shape in space for any closed surface whose edges have known lengths.

Distances along the surface between a number of its vertices, the landmarks, are laid out in as many
dimensions as they need (classical scaling, Torgerson 1952) and pressed into three, while near landmarks keep
their distances best (majorisation of the stress, de Leeuw 1977). The other vertices are means of landmarks
near them. The shape is smooth, rounded, and right but for a few tens of percent.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import SolverError
from BalloonWorkbench.core.types import Floats, Ints

LANDMARKS = 150
DIMENSIONS = 8  # at first: a ring needs more than three for its own length before its section counts
PASSES = 150  # while the further dimensions are pressed, and as many afterwards
PRESSED = 0.95  # of the further dimensions, in each pass
NEIGHBOURS = 3  # landmarks that weigh most in the place of a vertex


def embedding(rest_corners: Floats, triangles: Ints) -> Floats:
    """Places (n, 3) of the vertices of a closed surface, outside out.

    rest_corners (m, 3, 2) of the flat triangles; triangles (m, 3) of n vertices, all in use. Raises
    SolverError where the surface is in several pieces.
    """
    count = int(triangles.max()) + 1
    some = np.random.default_rng(0).permutation(count)[:LANDMARKS].astype(np.int32)
    away = _distances(rest_corners, triangles, count, some)
    if not np.isfinite(away).all():
        raise SolverError("The panels are sealed to several bodies. Inflate each by itself.")
    reach = np.sort(away, axis=0)[min(NEIGHBOURS, len(some) - 1)]
    share = np.exp(-((away / reach) ** 2))
    places = (share / share.sum(axis=0)).T @ _laid_out(away[:, some])
    a, b, c = np.moveaxis(places[triangles], 1, 0)
    inside_out = np.einsum("ij,ij->", a, np.cross(b, c)) < 0.0
    return places * (1.0, 1.0, -1.0) if inside_out else places


def _distances(rest_corners: Floats, triangles: Ints, count: int, origins: Ints) -> Floats:
    """Lengths (k, n) of the shortest ways along edges from some vertices to all."""
    here = np.concatenate([triangles[:, [0, 1, 2]].ravel(), triangles[:, [1, 2, 0]].ravel()])
    there = np.concatenate([triangles[:, [1, 2, 0]].ravel(), triangles[:, [0, 1, 2]].ravel()])
    lengths = np.linalg.norm(np.roll(rest_corners, -1, axis=1) - rest_corners, axis=2).ravel()
    order = np.argsort(there, kind="stable")
    here, lengths = here[order], np.tile(lengths, 2)[order]
    first = np.searchsorted(there[order], np.arange(count))
    away = np.full((len(origins), count), np.inf)
    away[np.arange(len(origins)), origins] = 0.0
    while True:
        nearer = np.minimum(away, np.minimum.reduceat(away[:, here] + lengths, first, axis=1))
        if np.array_equal(nearer, away):
            return away
        away = nearer


def _laid_out(away: Floats) -> Floats:
    """Places (k, 3) at these distances (k, k) from each other, near ones above all."""
    count = len(away)
    away = 0.5 * (away + away.T)
    centring = np.eye(count) - 1.0 / count
    values, vectors = np.linalg.eigh(-0.5 * centring @ away**2 @ centring)
    places = (vectors * np.sqrt(np.maximum(values, 0.0)))[:, ::-1][:, :DIMENSIONS]
    weights = np.zeros_like(away)
    np.divide(1.0, away**2, out=weights, where=away > 0.0)
    laplacian = np.diag(weights.sum(axis=1)) - weights
    inverse = np.linalg.pinv(laplacian, hermitian=True)
    for number in range(2 * PASSES):
        if number < PASSES:
            axes = np.linalg.svd(places - places.mean(axis=0), full_matrices=False)
            places = axes[0] * axes[1]
            places[:, 3:] *= PRESSED
        apart = np.linalg.norm(places[:, None] - places[None], axis=2)
        pull = np.zeros_like(away)
        np.divide(weights * away, apart, out=pull, where=apart > 0.0)
        places = inverse @ ((np.diag(pull.sum(axis=1)) - pull) @ places[:, : 3 if number >= PASSES else None])
    return np.asarray(places)
