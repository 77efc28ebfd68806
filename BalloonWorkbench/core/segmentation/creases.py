# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels between the sharp edges of a body, which stay seams; where there are more panels, cut straight."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.segmentation.proposal import Proposal, seen_faces
from BalloonWorkbench.core.segmentation.proxies import Faces, distances, fit_proxies, moments, spreads
from BalloonWorkbench.core.segmentation.regions import LARGE, SMALL, between_creases, rounded, worth_parting
from BalloonWorkbench.core.targets.half_edges import Indices
from BalloonWorkbench.core.targets.refine import cut_where_zero
from BalloonWorkbench.core.types import Floats, Ints

#: Area of a part that is no panel but a few slivers, which lie anyhow; of the mean one of a panel.
_SLIVER = 0.01


def between_sharp_edges(points: Floats, triangles: Ints, count: int) -> Proposal | None:
    """So many panels, each of one part between sharp edges; None where there are more such parts, or one, or
    where parts that are cut further are very small beside the others: no faces, but folds."""
    faces, beside = seen_faces(points, triangles)
    parts = _without_slivers(between_creases(faces, beside), faces, beside, _SLIVER / count)
    first = int(parts.max()) + 1
    small = np.bincount(parts, faces.areas).min() * count < SMALL
    if not 1 < first <= count or (small and first < count):
        return None
    draft = Proposal(points, triangles, parts, np.arange(first))
    while len(draft.owners) < count:
        draft = _with_one_more(draft)
    return draft


def _without_slivers(parts: Ints, faces: Faces, beside: Indices, least: float) -> Ints:
    """Parts (m,), of which those smaller than least join the one beside them that is longest beside them."""
    parts = parts.copy()
    for part in np.flatnonzero(np.bincount(parts, faces.areas) < least).tolist():
        around = parts[beside[parts == part]]
        parts[parts == part] = np.argmax(np.bincount(around[around != part]))
    return np.unique(parts, return_inverse=True)[1].astype(np.int32)


def _with_one_more(draft: Proposal) -> Proposal:
    """The worst panel cut in two, straight across in the way that leaves film nearest to it."""
    faces, _ = seen_faces(draft.points, draft.triangles)
    count = len(draft.owners)
    sums = moments(faces, draft.pieces, count)
    proxies = fit_proxies(sums)
    own = np.where(sums.areas * count > LARGE, worth_parting(sums, distances(sums, proxies)), 0.0)
    worst = int(np.argmax(rounded(own)))
    middle = sums.centres[worst] / sums.areas[worst]
    normals = [proxies.axes[worst], *np.linalg.eigh(spreads(sums)[worst])[1].T[:0:-1]]
    size = float(np.linalg.norm(np.ptp(draft.points, axis=0)))
    best, least = draft, np.inf
    for normal in normals:
        made = _cut(draft, worst, size * middle, normal)
        distance = _left(made, worst)
        if distance < least:
            best, least = made, distance
    return best


def _cut(draft: Proposal, panel: int, middle: Floats, normal: Floats) -> Proposal:
    """With a panel cut by a plane; what is beyond it gets a new number."""
    points, triangles, origin = cut_where_zero(
        draft.points, draft.triangles, (draft.points - middle) @ normal, draft.pieces == panel
    )
    beyond = (points[triangles].mean(axis=1) - middle) @ normal > 0.0
    pieces = draft.pieces[origin]
    count = len(draft.owners)
    pieces = np.where((pieces == panel) & beyond, count, pieces).astype(np.int32)
    return Proposal(points, triangles, pieces, np.arange(count + 1))


def _left(made: Proposal, panel: int) -> float:
    """How far film of the two halves of a panel stays away from it, uneven halves are worse."""
    faces, _ = seen_faces(made.points, made.triangles)
    sums = moments(faces, made.pieces, len(made.owners))
    own = worth_parting(sums, distances(sums, fit_proxies(sums)))
    return float(rounded(own[[panel, -1]]).sum())
