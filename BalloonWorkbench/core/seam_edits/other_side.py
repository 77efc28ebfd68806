# SPDX-License-Identifier: LGPL-2.1-or-later
"""The other side of a division whose panels are mirror images: where an edit is repeated."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.seam_edits.edit import CUT, MERGE, MOVE, SeamEdit
from BalloonWorkbench.core.seam_edits.operations import seam_near
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats

#: So much of each panel's area must have its image in one panel.
_ALIKE = 0.95
#: A place so near to the plane lies on it, of the diagonal.
_ON = 1e-3
_SAMPLES = 2000  # triangles whose images are looked at

Plane = tuple[Floats, Floats]
#: Edits that are made at places of one side.
REPEATED = (MERGE, CUT, MOVE)


def mirror_plane(division: Division, planes: Sequence[Plane]) -> Plane | None:
    """A point (3,) and the normal (3,) of the plane behind which the panels are mirror images; None without.

    planes  those of symmetry of the body; of several that which parts left from right: it is upright, and
            the body is narrow across it
    """
    target = division.target
    size = np.ptp(target.points, axis=0)
    step = max(1, len(target.triangles) // _SAMPLES)
    middles = target.points[target.triangles[::step]].mean(axis=1)
    panels, areas = division.panels[::step], target.areas[::step]
    surface = NearestSurface(target.points, target.triangles)
    for middle, normal in sorted(planes, key=lambda plane: _order(plane, size)):
        images = middles - 2.0 * ((middles - middle) @ normal)[:, None] * normal
        behind = division.panels[surface.query(images).triangles]
        count = len(division.names)
        pairs = np.bincount(panels * count + behind, areas, count * count)
        total = np.maximum(np.bincount(panels, areas, count), 1e-300)
        shares = pairs.reshape(count, count) / total[:, None]
        partner = shares.argmax(axis=1)
        if shares.max(axis=1).min() > _ALIKE and (partner[partner] == np.arange(count)).all():
            return middle, normal
    return None


def _order(plane: Plane, size: Floats) -> tuple[bool, float]:
    """Upright planes first, and those across which the body is narrow; size (3,) of its box."""
    normal = np.abs(plane[1])
    return bool(normal[2] > 0.5), float(normal @ size)


def image_of(division: Division, edit: SeamEdit, plane: Plane) -> SeamEdit | None:
    """The edit on the other side; None where it is its own image, lies on both sides, or is of no side."""
    if edit.kind not in REPEATED or not len(edit.points):
        return None
    middle, normal = plane
    heights = (edit.points - middle) @ normal
    near = _ON * division.target.diagonal
    if np.abs(heights).max() <= near or heights.min() < -near < near < heights.max():
        return None
    image = edit.image(middle, normal)
    if edit.kind == CUT:
        return image
    try:
        own, other = (seam_near(division, each.points[0])[0] for each in (edit, image))
    except InputError:
        return None
    return None if set(own.vertices.tolist()) == set(other.vertices.tolist()) else image
