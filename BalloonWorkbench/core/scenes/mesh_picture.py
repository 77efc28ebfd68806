# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shaded picture of surfaces with what is printed on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.pictures.render import INNER_SHADE, Coloured, surface_picture, together
from BalloonWorkbench.core.scenes.surface_mesh import Finish, SurfaceMesh
from BalloonWorkbench.core.types import Floats


def meshes_picture(
    meshes: Sequence[SurfaceMesh], width: int, height: int, box: Floats | None = None
) -> Floats:
    """RGBA (height, width, 4), values 0 to 1: as core/pictures/render.py lights film; box: as there."""
    meshes = [*meshes, *(_inner(mesh) for mesh in meshes if mesh.finish.inside)]
    finishes = [*{id(mesh.finish): mesh.finish for mesh in meshes}.values()]
    number = {id(finish): float(k) for k, finish in enumerate(finishes)}
    parts: list[Coloured] = [
        (mesh.positions, mesh.triangles, mesh.normals, _at(mesh, number[id(mesh.finish)])) for mesh in meshes
    ]

    def colour_at(values: Floats) -> Floats:
        own = np.rint(values[:, 2]).astype(np.intp)
        colours = np.zeros((len(values), 3))
        for k, finish in enumerate(finishes):
            colours[own == k] = _colours(finish, values[own == k, :2])
        return colours

    return surface_picture(together(parts), width, height, colour_at, box)


def _inner(mesh: SurfaceMesh) -> SurfaceMesh:
    """The inner side of a surface, in the shade."""
    red, green, blue = (INNER_SHADE * part for part in mesh.finish.colour)
    finish = replace(mesh.finish, colour=(red, green, blue))
    return replace(mesh, triangles=mesh.triangles[:, ::-1], normals=-mesh.normals, finish=finish)


def _at(mesh: SurfaceMesh, number: float) -> Floats:
    return np.column_stack([mesh.places, np.full(len(mesh.places), number)])


def _colours(finish: Finish, places: Floats) -> Floats:
    """Colours (k, 3) of a finish at places (k, 2) of its picture."""
    colour = np.array(finish.colour)
    if finish.picture is None:
        return np.tile(colour, (len(places), 1))
    pixels = finish.picture.pixels
    height, width = pixels.shape[:2]
    columns = np.clip((places[:, 0] * width).astype(np.intp), 0, width - 1)
    rows = np.clip((places[:, 1] * height).astype(np.intp), 0, height - 1)
    return np.asarray(colour * pixels[rows, columns, :3] / 255.0)
