# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis of a body of revolution, and the planes of symmetry of any body."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from BalloonWorkbench.core.targets.half_edges import area_vectors
from BalloonWorkbench.core.targets.nearest_surface import NearestSurface
from BalloonWorkbench.core.types import Floats, Ints

#: A body is symmetric if it is no farther from its image than these parts of its size: on average, and at
#: most. A mesh is coarse: both halves of one body have other corners.
_ON_AVERAGE, _AT_MOST = 1.5e-3, 2e-2
#: Turns that a body of revolution is tried with [rad]: no fractions of each other, nor of a full turn.
_TURNS = (0.37, 1.0, 2.2)
#: Triangles whose centres are looked at.
_SAMPLES = 1500
_FEW = 50  # of them, that tell most other bodies


def _axes(points: Floats, triangles: Ints) -> tuple[Floats, list[Floats]]:
    """The middle (3,) of a surface, and directions (3,) about which it may be symmetric: its main ones."""
    areas = np.linalg.norm(area_vectors(points, triangles), axis=1)
    corners = points[triangles]
    middle = areas @ corners.mean(axis=1) / areas.sum()
    offset = corners - middle
    # exact for linear triangles: a third of the middles of the sides
    halves = 0.5 * (offset + np.roll(offset, 1, axis=1))
    spread = np.einsum("m,mki,mkj->ij", areas, halves, halves) / (3.0 * areas.sum())
    return middle, [*np.eye(3)[::-1], *np.linalg.eigh(spread)[1].T]


class Mirrored:
    """A body that is compared with its images."""

    def __init__(self, points: Floats, triangles: Ints) -> None:
        self.middle, self.axes = _axes(points, triangles)
        self._nearest = NearestSurface(points, triangles)
        step = max(1, len(triangles) // _SAMPLES)
        self._places = np.concatenate([points[triangles[::step]].mean(axis=1), points[:: 2 * step]])
        self._size = float(np.linalg.norm(np.ptp(points, axis=0)))

    def are_on_it(self, image: Callable[[Floats], Floats]) -> bool:
        """Whether the image of the body lies on it."""
        some = self._places[:: max(1, len(self._places) // _FEW)][:_FEW]
        for places in (some, self._places):
            at = image(places - self.middle) + self.middle
            away = np.abs(self._nearest.query(at).distances) / self._size
            if away.max() > _AT_MOST or (len(at) > _FEW and away.mean() > _ON_AVERAGE):
                return False
        return True

    def halved(self, normal: Floats) -> bool:
        """Whether the plane with this normal (3,) through the middle halves the body into mirror images."""
        return self.are_on_it(partial(_mirrored, normal=normal))


def axis_of(points: Floats, triangles: Ints) -> tuple[Floats, Floats] | None:
    """A point (3,) and a direction (3,) of the axis of a body of revolution; None for any other body."""
    images = Mirrored(points, triangles)
    for axis in images.axes:
        if all(images.are_on_it(partial(_turned, axis=axis, angle=turn)) for turn in _TURNS):
            return images.middle, axis
    return None


def _turned(places: Floats, axis: Floats, angle: float) -> Floats:
    """Places (k, 3) turned about an axis (3,) through the origin (Rodrigues)."""
    along = (places @ axis)[:, None] * axis
    return np.asarray(
        along + np.cos(angle) * (places - along) + np.sin(angle) * np.cross(axis, places - along)
    )


def _mirrored(places: Floats, normal: Floats) -> Floats:
    """Places (k, 3) behind a plane through the origin."""
    return np.asarray(places - 2.0 * (places @ normal)[:, None] * normal)


def symmetry_planes(points: Floats, triangles: Ints) -> list[tuple[Floats, Floats]]:
    """A point (3,) and the normal (3,) of each plane that halves a body into mirror images.

    Only planes square to its main directions, or to the axes of its coordinates, are seen; of those that
    are not square to each other the first.
    """
    images = Mirrored(points, triangles)
    planes: list[tuple[Floats, Floats]] = []
    for axis in images.axes:
        if any(abs(axis @ known) > 0.01 for _, known in planes):
            continue
        if images.halved(axis):
            planes.append((images.middle, axis))
    return planes
