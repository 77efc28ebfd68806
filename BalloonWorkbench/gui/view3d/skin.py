# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of a balloon as nodes of the 3D view: each panel smooth, a sharp seam between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.core.results.result_files import results

_CREASE = 0.7  # rad between facets that are shaded as one surface, where normals are not known


@dataclass(frozen=True)
class Skin:
    """All panels in the object's coordinates.

    positions  (n, 3) mm
    triangles  (m, 3), counter-clockwise seen from outside
    normals    (n, 3), None where only FreeCAD's mesh is known
    lines      vertices along each seam, and along each weld
    panels     (m,) the panel of each triangle, None where only FreeCAD's mesh is known
    """

    positions: np.ndarray
    triangles: np.ndarray
    normals: np.ndarray | None = None
    lines: tuple[np.ndarray, ...] = ()
    panels: np.ndarray | None = None


def skin_of(obj) -> Skin | None:
    """The film of a balloon object as it is; None where there is none."""
    if film_result.is_known(obj):
        return skin_from(*film_result.stored(obj))
    points, facets = obj.Mesh.Topology
    return Skin(np.array([tuple(point) for point in points]), np.array(facets)) if points else None


def skin_from(inflation, film) -> Skin:
    """The film of a balloon of the core."""
    state, assembly = results(inflation, film), inflation.assembly
    panels = np.repeat(np.arange(len(assembly.panels)), [len(panel.triangles) for panel in assembly.panels])
    if assembly.mirror:
        panels = np.repeat([0, 1], len(inflation.panel.triangles))
    return Skin(
        state.positions,
        state.triangles,
        normals(state.positions, state.triangles),
        seam_lines(assembly),
        panels,
    )


def seam_lines(assembly) -> tuple[np.ndarray, ...]:
    """Vertices along each seam and each weld; of a rim that is closed the first one twice."""
    if assembly.mirror:
        (panel,) = assembly.panels
        return (*(np.append(loop, loop[:1]) for loop in panel.loops), *panel.welds)
    return tuple(
        seam.first.vertices + assembly.offsets[seam.first.panel] for seam in assembly.seams + assembly.welds
    )


def normals(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Unit normals (n, 3) of the vertices, weighted by area."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    areas = np.cross(b - a, c - a)
    corners = triangles.ravel()
    sums = np.stack([np.bincount(corners, np.repeat(part, 3), len(positions)) for part in areas.T], axis=1)
    return sums / np.maximum(np.linalg.norm(sums, axis=1, keepdims=True), 1e-12)


class SkinNodes:
    """The shape of a skin, which may move. What says how it looks goes before `film` and `seam`.

    shares  (m, 3) places along a texture at the corners of each triangle; None without
    """

    def __init__(self, skin: Skin, shares: np.ndarray | None = None):
        from pivy import coin

        self.skin = skin
        self.film, self.seam = coin.SoGroup(), coin.SoGroup()
        self._points, self._normals = coin.SoCoordinate3(), coin.SoNormal()
        hints = coin.SoShapeHints()
        hints.vertexOrdering.setValue(coin.SoShapeHints.COUNTERCLOCKWISE)  # both sides are lit
        hints.creaseAngle.setValue(_CREASE)
        before = [hints, self._points]
        if skin.normals is not None:
            binding = coin.SoNormalBinding()
            binding.value.setValue(coin.SoNormalBinding.PER_VERTEX_INDEXED)
            before += [binding, self._normals]
        faces = coin.SoIndexedFaceSet()
        _set_corners(faces.coordIndex, skin.triangles)
        if shares is not None:
            places, painted = coin.SoTextureCoordinate2(), coin.SoTextureCoordinateBinding()
            painted.value.setValue(coin.SoTextureCoordinateBinding.PER_VERTEX_INDEXED)
            places.point.setValues(0, shares.size, [(share, 0.5) for share in shares.ravel().tolist()])
            _set_corners(faces.textureCoordIndex, np.arange(shares.size).reshape(-1, 3))
            before += [places, painted]
        for child in (*before, faces):
            self.film.addChild(child)
        rim = coin.SoIndexedLineSet()
        numbers = [number for line in skin.lines for number in (*line.tolist(), -1)]
        rim.coordIndex.setValues(0, len(numbers), numbers)
        if skin.lines:
            for child in (self._points, rim):
                self.seam.addChild(child)
        self.move(skin.positions, skin.normals)

    def move(self, positions: np.ndarray, directions: np.ndarray | None) -> None:
        """Take the film to other places (n, 3) mm with other normals."""
        self._points.point.setValues(0, len(positions), positions.tolist())
        if directions is not None:
            self._normals.vector.setValues(0, len(directions), directions.tolist())


def _set_corners(field, triangles: np.ndarray) -> None:
    numbers = np.column_stack([triangles, np.full(len(triangles), -1)]).ravel().tolist()
    field.setValues(0, len(numbers), numbers)
