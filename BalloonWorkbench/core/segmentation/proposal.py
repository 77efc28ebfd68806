# SPDX-License-Identifier: LGPL-2.1-or-later
"""A proposal for the panels of a surface, before it is known whether they can be laid flat."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.segmentation.borders import with_smooth_borders
from BalloonWorkbench.core.segmentation.discs import in_one_piece, into_discs
from BalloonWorkbench.core.segmentation.proxies import Faces, distances, fit_proxies, moments
from BalloonWorkbench.core.segmentation.regions import SMALL, without, without_small
from BalloonWorkbench.core.targets.half_edges import Indices, area_vectors, half_edges, twins
from BalloonWorkbench.core.types import Floats, Ints

#: How far borders are smoothed, in lengths of edges.
_REACHES = (2.0, 1.0, 0.5)
#: Area of a piece that is left at least.
_LEFT = 0.6
#: How often a panel is taken away that is lost between smooth borders.
_TRIES = 6


class Proposal(NamedTuple):
    """A surface of points (n, 3) and triangles (m, 3) in pieces, of which the panels consist.

    pieces  (m,) number of the piece of each triangle, from 0
    owners  (k,) number of the panel of each piece, from 0
    """

    points: Floats
    triangles: Ints
    pieces: Ints
    owners: Ints

    @property
    def distance(self) -> float:
        """How far film of these panels stays away from the surface on average, in parts of its size."""
        faces, _ = seen_faces(self.points, self.triangles)
        own = self.numbered()
        regions = moments(faces, own.pieces, len(own.owners))
        return float(distances(regions, fit_proxies(regions)).sum())

    def of_discs(self) -> Proposal:
        """With panels in one piece, of pieces that are discs, or flat."""
        faces, beside = seen_faces(self.points, self.triangles)
        whole = self.numbered()._connected(faces, beside).numbered()
        discs = into_discs(faces, twins(self.triangles), whole.pieces)
        owners = np.empty(int(discs.max()) + 1, dtype=np.int32)
        owners[discs] = whole.owners[whole.pieces]
        return whole._replace(pieces=discs, owners=owners)

    def _connected(self, faces: Faces, beside: Indices) -> Proposal:
        """With panels and pieces that hang together."""
        labels = self.owners[self.pieces]
        panels = in_one_piece(labels, beside, faces.areas)
        first = np.unique(self.owners, return_index=True)[1]
        pieces = np.where(panels == labels, self.pieces, first[panels]).astype(np.int32)
        inside = np.where((beside >= 0) & (panels[beside] == panels[:, None]), beside, -1)
        return self._replace(pieces=in_one_piece(pieces, inside, faces.areas))

    def smoothed(self) -> Proposal:
        """With smooth borders and no panel that is very small: one of which smooth borders leave little joins
        one beside it before, and another one is parted."""
        draft, count = self, int(self.owners.max()) + 1
        for _ in range(_TRIES):
            best = draft._with_smooth_borders()
            best = best._connected(*seen_faces(best.points, best.triangles))
            areas = np.bincount(best.owners, best._areas(), count)
            small = int(np.argmin(areas))
            if areas[small] * count > SMALL:
                return best
            draft = draft._without(small)
        return draft

    def _without(self, panel: int) -> Proposal:
        """As many panels, of which this one is another one."""
        faces, beside = seen_faces(self.points, self.triangles)
        labels = without(faces, beside, self.owners[self.pieces], panel)
        labels = without_small(faces, beside, labels)
        return self._replace(pieces=labels, owners=np.arange(int(labels.max()) + 1)).of_discs()

    def _with_smooth_borders(self) -> Proposal:
        """With borders as smooth as they can be without a piece that gets much smaller."""
        before = self._areas()
        best, most = self, 0.0
        for reach in _REACHES if len(self.owners) > 1 else ():
            split, pieces = with_smooth_borders(self.points, self.triangles, self.pieces, reach)
            made = Proposal(split.points, split.triangles, pieces, self.owners)
            left = float((made._areas() / before).min())
            if left > most:
                best, most = made, left
            if left > _LEFT:
                break
        return best

    def _areas(self) -> Floats:
        """Area of each piece, as a part of the whole."""
        areas = np.linalg.norm(area_vectors(self.points, self.triangles), axis=1)
        return np.asarray(np.bincount(self.pieces, areas / areas.sum(), len(self.owners)), dtype=np.float64)

    def numbered(self) -> Proposal:
        """The same without numbers of pieces and panels that are not there."""
        left, pieces = np.unique(self.pieces, return_inverse=True)
        owners = np.unique(self.owners[left], return_inverse=True)[1]
        return self._replace(pieces=pieces.astype(np.int32), owners=owners.astype(np.int32))

    def with_image(self, middle: Floats, normal: Floats) -> Proposal:
        """With its mirror image behind the plane on which its border lies.

        middle, normal  a point (3,) and the normal (3,) of the plane
        The image of piece or panel k of so many has number k + so many.
        """
        count = len(self.points)
        rim = np.unique(half_edges(self.triangles)[twins(self.triangles) < 0])
        points = self.points.copy()
        points[rim] -= ((points[rim] - middle) @ normal)[:, None] * normal
        image = points - 2.0 * ((points - middle) @ normal)[:, None] * normal
        inner = np.setdiff1d(np.arange(count), rim)
        number = np.arange(count)
        number[inner] = count + np.arange(len(inner))
        triangles = np.concatenate([self.triangles, number[self.triangles][:, ::-1]])
        pieces = np.concatenate([self.pieces, self.pieces + len(self.owners)])
        owners = np.concatenate([self.owners, self.owners + int(self.owners.max()) + 1])
        return Proposal(np.concatenate([points, image[inner]]), triangles.astype(np.int32), pieces, owners)


def seen_faces(points: Floats, triangles: Ints) -> tuple[Faces, Indices]:
    """Triangles as the regions see them, and those beside each one (m, 3), -1 for none."""
    normals, twin = area_vectors(points, triangles), twins(triangles)
    areas = np.linalg.norm(normals, axis=1)
    centres = points[triangles].mean(axis=1) / np.linalg.norm(np.ptp(points, axis=0))
    beside = np.where(twin < 0, -1, twin // 3).reshape(-1, 3)
    return Faces(unit(normals), areas / areas.sum(), centres), beside
