# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a solid as panels: each one as it is, cut open where it goes round the body."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats, Ints

#: A face is curved both ways if its total curvature is more, on a ball that of a third of it [rad].
_CURVED = 4.0


def divide_at_faces(target: Target, faces: Ints, names: Sequence[str], cuts: Ints) -> Division:
    """A panel for each face of a solid.

    faces  (m,) number of the face of each triangle; a face without triangles is no panel
    names  of the faces
    cuts   (k, 2) points of edges along which a face that goes round the body is open
    """
    notes = list(target.notes)
    for face, turned in enumerate(total_curvatures(target, faces, len(names)).tolist()):
        if turned > _CURVED:
            notes.append(
                f"{names[face]} is curved both ways, so that its film folds. Give a number of panels, into"
                " which the body is divided."
            )
    target = replace(target, notes=tuple(notes))
    present, labels = np.unique(faces, return_inverse=True)
    return Division(target, labels.astype(np.int32), tuple(names[face] for face in present.tolist()), cuts)


def total_curvatures(target: Target, faces: Ints, count: int) -> Floats:
    """The total curvature (count,) of each face [rad]: what is missing to a full turn at its inner points.

    Without sign: that of a ball is 4 pi, of what can be laid flat 0 (Gauss and Bonnet). faces (m,) of the
    triangles.
    """
    corners = target.points[target.triangles]
    ahead = np.roll(corners, -1, axis=1) - corners
    back = np.roll(corners, 1, axis=1) - corners
    across = np.linalg.norm(np.cross(ahead, back), axis=2)
    angles = np.arctan2(across, np.einsum("mkd,mkd->mk", ahead, back))
    missing = 2.0 * np.pi - np.bincount(target.triangles.ravel(), angles.ravel(), len(target.points))
    lowest = np.full(len(target.points), count)
    highest = np.full(len(target.points), -1)
    np.minimum.at(lowest, target.triangles.ravel(), np.repeat(faces, 3))
    np.maximum.at(highest, target.triangles.ravel(), np.repeat(faces, 3))
    inner = lowest == highest
    return np.asarray(np.bincount(lowest[inner], np.abs(missing[inner]), count))
