# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of balloons as surfaces with a finish: y up, z toward the viewer, metres."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.artwork.carry import VisibleFilm
from BalloonWorkbench.core.artwork.picture import Picture
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.film.film import Look
from BalloonWorkbench.core.pictures.bag_picture import panel_surface, upright
from BalloonWorkbench.core.pictures.render import WELD_SHADE, rgb
from BalloonWorkbench.core.pictures.two_panels import two_panel_surfaces
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Ints

#: Longest side of a picture on film [pixels]: the largest that every device shows.
MOST_PIXELS = 1024
#: How much of a metal film is, and how rough, by what it looks like (core/film/film.py).
_METAL = {"foil": (0.6, 0.3), "clear": (0.0, 0.1), "paper": (0.0, 0.9), "matt": (0.0, 0.6)}


@dataclass(frozen=True, eq=False)
class Finish:
    """How film looks.

    colour   (r, g, b) from 0 to 1 as on screens (sRGB); with a picture what its colours are multiplied by
    opacity  from 0 to 1; metal, rough: shares of 1, as in glTF's metallic-roughness model
    inside   its inner side is seen as well
    """

    colour: tuple[float, float, float]
    opacity: float
    metal: float
    rough: float
    picture: Picture | None = None
    inside: bool = False


@dataclass(frozen=True, eq=False)
class SurfaceMesh:
    """A surface of one finish.

    positions  (n, 3) m; triangles (m, 3), counter-clockwise seen from outside; normals (n, 3) unit, outward
    places     (n, 2) in the finish's picture, from 0 at its upper left to 1; zeros without a picture
    """

    positions: Floats
    triangles: Ints
    normals: Floats
    places: Floats
    finish: Finish


@dataclass(frozen=True)
class Painted:
    """What is printed on two panels: on the front, and on the back as seen through it; None for bare film."""

    front: Picture | None = None
    behind: Picture | None = None


def finish_of(
    look: Look, picture: Picture | None = None, *, shade: float = 1.0, inside: bool = False
) -> Finish:
    """The finish of a film, or of a picture printed on it, by so much darker."""
    red, green, blue = (float(shade * part) for part in (rgb(look.colour) if picture is None else np.ones(3)))
    metal, rough = _METAL[look.kind]
    opacity = look.opacity if picture is None else 1.0
    return Finish((red, green, blue), opacity, metal, rough, picture, inside)


def small_picture(picture: Picture) -> Picture:
    """The picture in its place with at most MOST_PIXELS along a side, by means over blocks of pixels."""
    pixels = picture.pixels
    step = -(-max(pixels.shape[:2]) // MOST_PIXELS)
    if step == 1:
        return picture
    height, width = pixels.shape[0] // step, pixels.shape[1] // step
    rest = len(pixels) - step * height  # rows at the lower edge that do not make a whole block
    blocks = pixels[: height * step, : width * step].reshape(height, step, width, step, 4)
    means = np.rint(blocks.mean(axis=(1, 3))).astype(np.uint8)
    return Picture(means, picture.low + (0.0, rest) * picture.pixel, step * picture.pixel)


def two_panel_meshes(
    inflations: Sequence[Inflation], seal_width: float, look: Look, painted: Painted
) -> list[list[SurfaceMesh]]:
    """Of each balloon of two equal panels the film and its weld [m wide], closed.

    A picture is where it is seen along z, as it is printed (core/artwork/carry.py).
    """
    finishes = {
        (front, weld): finish_of(look, picture, shade=WELD_SHADE if weld else 1.0)
        for front, picture in ((True, painted.front), (False, painted.behind))
        for weld in (False, True)
    }
    if painted.front is painted.behind:  # one finish for both sides
        finishes |= {(False, weld): finishes[True, weld] for weld in (False, True)}
    return [
        [
            SurfaceMesh(
                part.positions,
                part.triangles,
                part.normals,
                _places(finishes[part.front, part.weld].picture, part.positions[:, :2]),
                finishes[part.front, part.weld],
            )
            for part in two_panel_surfaces(inflation, seal_width)
        ]
        for inflation in inflations
    ]


def bag_meshes(
    design: BagDesign, look: Look, printed: Sequence[tuple[VisibleFilm, Picture]] = ()
) -> list[SurfaceMesh]:
    """The panels of a balloon that are cut, upright: closed, but for an end that stays open.

    printed  for each of them where its film is in which picture
    """
    cut = [number for number, panel in enumerate(design.bag.panels) if panel.cut]
    inside = len(cut) < len(design.bag.panels)
    places = upright(design)
    bare = finish_of(look, inside=inside)
    finishes = {id(picture): finish_of(look, picture, inside=inside) for _, picture in printed}
    meshes = []
    for place, number in enumerate(cut):
        positions, triangles, normals = panel_surface(design, places, number)
        if not printed:
            meshes.append(SurfaceMesh(positions, triangles, normals, np.zeros((len(positions), 2)), bare))
            continue
        film, picture = printed[place]
        corners = _places(picture, film.seen)[film.triangles]
        if design.inflation.assembly.surface.turned[number]:
            corners = corners[:, ::-1]
        meshes.append(
            _with_corners(positions, triangles, normals, corners.reshape(-1, 2), finishes[id(picture)])
        )
    return meshes


def _places(picture: Picture | None, points: Floats) -> Floats:
    """Where points (n, 2) m lie in a picture, in parts of its sides from its upper left corner."""
    if picture is None:
        return np.zeros((len(points), 2))
    columns, rows = picture.columns_rows(points)
    height, width = picture.pixels.shape[:2]
    return np.column_stack([(columns + 0.5) / width, (rows + 0.5) / height])


def _with_corners(
    positions: Floats, triangles: Ints, normals: Floats, corners: Floats, finish: Finish
) -> SurfaceMesh:
    """A mesh whose triangles have places (3 m, 2) at their corners: with as few vertices as that needs."""
    corner_data = np.column_stack([triangles.ravel(), corners])
    own, numbers = np.unique(corner_data, axis=0, return_inverse=True)
    vertices = own[:, 0].astype(np.intp)
    return SurfaceMesh(
        positions[vertices],
        numbers.reshape(-1, 3).astype(np.int32),
        normals[vertices],
        own[:, 1:],
        finish,
    )
