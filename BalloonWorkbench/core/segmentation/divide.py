# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels for a target: as many as wanted, each nearly developable, with smooth borders."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.body import MOST_PANELS
from BalloonWorkbench.core.segmentation.creases import between_sharp_edges
from BalloonWorkbench.core.segmentation.discs import joined, pieces_apart
from BalloonWorkbench.core.segmentation.gores import in_gores, in_strips
from BalloonWorkbench.core.segmentation.proposal import Proposal, seen_faces
from BalloonWorkbench.core.segmentation.proxies import distances, fit_proxies, moments
from BalloonWorkbench.core.segmentation.regions import near_developable, neighbours, rounded
from BalloonWorkbench.core.segmentation.thin_parts import thin_notes
from BalloonWorkbench.core.targets.half_edges import euler_numbers, twins
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.refine import cut_where_zero, refined
from BalloonWorkbench.core.targets.simplify import simplified
from BalloonWorkbench.core.targets.symmetry_planes import axis_of, symmetry_planes
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import length_text

#: Triangles of the surface that is divided, and of each panel at least.
_TRIANGLES, _OF_PANEL = 4000, 120
#: Triangles for each that is wanted that are too many, and those that are left then; how long these may be,
#: and by which part of the diagonal the surface may change.
_TOO_MANY, _FEWER, _LONG, _CHANGED = 3.5, 1.5, 1.5, 6e-4
#: Panels that are mirror images of each other may be so much farther away, and those that are all equal.
_FOR_SYMMETRY, _FOR_EQUALITY = 1.15, 1.6
#: Halves that differ by less than this part of the diagonal are alike.
_ALIKE = 1e-3


@memoized(4)
def divide(target: Target, count: int) -> Division:
    """So many panels for a target, the same ones each time; 1 is a body without seams, which the user draws.

    The division's own target has the same surface, with triangles small enough for the borders; that of a
    body with a plane of symmetry is made of one half of it and its image. InputError for less than 1 and
    more than MOST_PANELS.
    """
    if not 1 <= count <= MOST_PANELS:
        raise InputError(f"A body is divided into 2 to {MOST_PANELS} panels: say how many.")
    points, triangles = _even_triangles(target, max(_TRIANGLES, _OF_PANEL * count))
    if count == 1:
        whole = np.zeros(len(triangles), dtype=np.int32)
        return joined(replace(target, points=points, triangles=triangles), whole, whole[:1])
    drafts = list(_drafts(points, triangles, count))
    best = drafts[int(np.argmin(rounded(np.array([distance for distance, _ in drafts]))))][1]
    points, triangles, pieces, owners = best.of_discs()
    notes = target.notes + thin_notes(target) + _made_alike(target, points, triangles)
    return joined(Target(points, triangles, target.source, notes), pieces, owners)


def _even_triangles(target: Target, count: int) -> tuple[Floats, Ints]:
    """The surface of a target in about so many triangles, none much longer than the others.

    The slivers of a body from CAD become very many when they are split: these are made fewer again, unless
    that changes the surface.
    """
    size = float(np.sqrt(4.0 * target.areas.sum() / count))
    points, triangles, _ = refined(target.points, target.triangles, size)
    if len(triangles) < _TOO_MANY * count:
        return points, triangles
    fewer = simplified(points, triangles, int(_FEWER * count))
    away = np.abs(NearestSurface(*fewer).query(target.points).distances).max()
    if away > _CHANGED * target.diagonal:
        return points, triangles
    points, triangles, _ = refined(*fewer, _LONG * size)
    return points, triangles


def _made_alike(target: Target, points: Floats, triangles: Ints) -> tuple[str, ...]:
    """A note where the surface that is divided is not quite that of the target, as its halves are alike."""
    away = np.abs(NearestSurface(points, triangles).query(target.points).distances).max()
    if away < _ALIKE * target.diagonal:
        return ()
    return (f"Both halves of the body are made alike: they differ by {length_text(away, 2)} at most.",)


def _drafts(points: Floats, triangles: Ints, count: int) -> Iterator[tuple[float, Proposal]]:
    """Proposals, each with how far film stays away from the surface; less for what is symmetric."""
    axis = axis_of(points, triangles)
    if axis is not None:
        ring = euler_numbers(twins(triangles), np.zeros(len(triangles), dtype=np.int32))[0] == 0
        draft = (in_strips if ring else in_gores)(points, triangles, axis, count)
        yield draft.distance / (_FOR_SYMMETRY if ring else _FOR_EQUALITY), draft
    parted = between_sharp_edges(points, triangles, count)
    if parted is not None:
        yield parted.distance, parted
    for plane in symmetry_planes(points, triangles):
        images = _in_images(points, triangles, plane, count)
        if images is not None:
            yield images.distance / _FOR_SYMMETRY, images
    draft = _grown(points, triangles, count).smoothed()
    yield draft.distance, draft


def _grown(points: Floats, triangles: Ints, count: int) -> Proposal:
    """Pieces that have grown over the surface."""
    faces, beside = seen_faces(points, triangles)
    labels = near_developable(faces, beside, count).labels
    return Proposal(points, triangles, labels, np.arange(count)).of_discs()


def _in_images(points: Floats, triangles: Ints, plane: tuple[Floats, Floats], count: int) -> Proposal | None:
    """Pieces of one half of a body and their images; None where the half does not hang together."""
    middle, normal = plane
    points, triangles, _ = cut_where_zero(points, triangles, (points - middle) @ normal)
    kept = triangles[(points[triangles].mean(axis=1) - middle) @ normal > 0.0]
    used, number = np.unique(kept, return_inverse=True)
    triangles = number.reshape(-1, 3).astype(np.int32)
    _, beside = seen_faces(points[used], triangles)
    if pieces_apart(np.zeros(len(triangles), dtype=np.int32), beside).max() > 0:
        return None
    half = _grown(points[used], triangles, -(-count // 2)).smoothed()
    draft = half.with_image(middle, normal)
    return _with_one_less(draft) if count % 2 else draft


def _with_one_less(draft: Proposal) -> Proposal:
    """A panel and its image beside it made one, where that costs least."""
    faces, beside = seen_faces(draft.points, draft.triangles)
    labels = draft.owners[draft.pieces]
    count = (int(draft.owners.max()) + 1) // 2
    pairs = neighbours(labels, beside)
    pairs = pairs[pairs[:, 1] == pairs[:, 0] + count]
    if not len(pairs):
        return draft
    sums = moments(faces, labels, 2 * count)
    both = sums.of(pairs)
    loss = distances(both, fit_proxies(both)) - distances(sums, fit_proxies(sums))[pairs].sum(axis=1)
    one, other = pairs[np.argmin(rounded(loss))]
    return draft._replace(owners=np.where(draft.owners == other, one, draft.owners))
