# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that can be laid flat: each in one piece, and cut open where it goes round the body."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.segmentation.proxies import Faces
from BalloonWorkbench.core.segmentation.regions import in_halves
from BalloonWorkbench.core.targets.half_edges import Indices, connected_parts, euler_numbers
from BalloonWorkbench.core.targets.target import Division, SeamLine, Target
from BalloonWorkbench.core.types import Floats, Ints

#: Length of the mean of the normals of a panel that lies flat enough to keep a hole.
_FLAT = 0.998


def in_one_piece(labels: Ints, beside: Indices, areas: Floats) -> Ints:
    """The regions (m,) of triangles, each in one piece.

    What lies apart from the largest piece of a region joins the region of most of the triangles beside it.
    """
    labels = labels.copy()
    while True:
        pieces = pieces_apart(labels, beside)
        sizes = np.bincount(pieces, areas)
        owner = np.zeros(len(sizes), dtype=np.int32)
        owner[pieces] = labels
        order = np.lexsort([-sizes, owner])
        apart = order[np.diff(owner[order], prepend=-1) == 0]
        if not len(apart):
            return labels
        piece = apart[np.argmin(sizes[apart])]
        around = beside[pieces == piece]
        around = around[around >= 0]
        labels[pieces == piece] = np.argmax(np.bincount(labels[around[pieces[around] != piece]]))


def pieces_apart(labels: Ints, beside: Indices) -> Ints:
    """For each triangle the number (m,) of the piece that hangs together in its region."""
    own = np.repeat(np.arange(len(labels)), 3)
    same = (beside.ravel() >= 0) & (labels[own] == labels[beside.ravel()])
    return connected_parts(len(labels), own[same], beside.ravel()[same])


def into_discs(faces: Faces, twin: Indices, labels: Ints) -> Ints:
    """Regions (m,) that are discs: those given, halved until they are; a flat one keeps its holes.

    labels  (m,) from 0, each region in one piece; those that are discs keep their numbers
    """
    labels, beside = labels.copy(), np.where(twin < 0, -1, twin // 3).reshape(-1, 3)
    while True:
        count = int(labels.max()) + 1
        sums = np.stack([np.bincount(labels, faces.areas * n, count) for n in faces.normals.T], axis=1)
        flat = np.linalg.norm(sums, axis=1) > _FLAT * np.bincount(labels, faces.areas, count)
        euler = euler_numbers(twin, labels)
        bad = np.flatnonzero((euler != 1) & ~(flat & (euler < 1)))
        if not len(bad):
            return labels
        for region in bad:
            own = labels == region
            labels[in_halves(faces, beside, own) == 1] = labels.max() + 1


def joined(target: Target, pieces: Ints, owners: Ints) -> Division:
    """The division into regions of pieces that are discs, cut open so that each of its panels is one, too.

    pieces  (m,) piece of each triangle
    owners  (k,) panel of each piece, from 0
    """
    names = tuple(str(k + 1) for k in range(int(owners.max()) + 1))
    fine = Division(target, pieces, tuple(map(str, range(len(owners)))), np.zeros((0, 2), dtype=np.int32))
    inner = [seam for seam in fine.seams if owners[seam.panels[0]] == owners[seam.panels[1]]]
    # pieces grow together along the longest seams; along the others the panel stays cut
    inner.sort(key=lambda seam: -_length(target, seam))
    group = np.arange(len(owners))
    cuts = [np.zeros((0, 2), dtype=np.int32)]
    for seam in inner:
        one, other = group[list(seam.panels)]
        if one == other:
            cuts.append(np.column_stack([seam.vertices[:-1], seam.vertices[1:]]))
        group[group == other] = one
    return Division(target, owners[pieces].astype(np.int32), names, np.concatenate(cuts).astype(np.int32))


def _length(target: Target, seam: SeamLine) -> float:
    return length(target.points[seam.vertices])
