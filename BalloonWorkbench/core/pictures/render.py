# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shaded picture of balloons: metallic film under studio lights, drawn with NumPy alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.geometry.raster import NearestCover, covered, mixed, nearest_covers
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.pictures.two_panels import two_panel_surfaces
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Bools, Floats, Ints

_YAW, _PITCH = np.radians(-28.0), np.radians(14.0)
#: Distance of the eye in sizes of the balloon.
_EYE = 3.6
_OVERSAMPLING = 2
#: Of film that has no colour of its own, and how much darker a weld and the inner side of film are.
FILM_COLOUR = "#db1f38"
WELD_SHADE, INNER_SHADE = 0.9, 0.55
#: Positions (n, 3) m, triangles (m, 3), unit normals (n, 3) and colours (n, 3) of vertices.
Coloured = tuple[Floats, Ints, Floats, Floats]
#: Gives colours (k, 3) for what stands in the place of colours, between the vertices.
ColourAt = Callable[[Floats], Floats]


def balloon_picture(
    inflations: Sequence[Inflation], seal_width: float, width: int, height: int, colour: str = FILM_COLOUR
) -> Floats:
    """RGBA (height, width, 4), values 0..1: the balloons upright, with their welds, over a soft shadow.

    colour  of the film, written like #ff0000
    """
    return surface_picture(_surface(inflations, seal_width, rgb(colour)), width, height)


def surface_picture(
    surface: Coloured,
    width: int,
    height: int,
    painting: ColourAt | None = None,
    box: Floats | None = None,
) -> Floats:
    """RGBA (height, width, 4) of a surface over its soft shadow; y is up, z to the eye.

    painting  gives the colours of places between vertices, from what these have instead of colours
    box       (2, 3) m, lower and upper corner of what the picture has room for; None: of the surface
    """
    size = np.array([width, height]) * _OVERSAMPLING
    positions, triangles, normals, colours = surface
    within = positions if box is None else np.array([*product(*box.T)])
    middle = 0.5 * (within.min(axis=0) + within.max(axis=0))
    reach = float(np.linalg.norm(np.ptp(within, axis=0)))
    turn = _rotation()
    # The shadow falls on a floor below the lowest point of the upright balloon.
    floor = within[:, 1].min() - 0.04 * reach

    def eye(points: Floats) -> Floats:
        return (points - middle) @ turn.T / reach

    def fallen(points: Floats) -> Floats:
        return _projected(eye(np.stack([points[:, 0], np.full(len(points), floor), points[:, 2]], axis=1)))

    seen, flat_shadow = eye(positions), fallen(positions)
    flat = _projected(seen)
    low, high = bounds(np.concatenate([_projected(eye(within)), fallen(within)]))
    scale = 0.86 * float(np.min(size / (high - low)))
    shift = 0.5 * size - 0.5 * scale * (low + high)

    def to_pixels(points: Floats) -> Floats:
        pixels = points * scale + shift
        return np.stack([pixels[:, 0], size[1] - pixels[:, 1]], axis=1)

    shadow = np.zeros((height, width))
    for part in covered(to_pixels(flat_shadow) / _OVERSAMPLING, triangles, *_middles(width, height)):
        shadow[part.rows, part.columns] = 1.0
    shadow = 0.34 * _blurred(shadow, max(1, int(0.018 * scale / _OVERSAMPLING)))
    facing = triangles[_facing_viewer(to_pixels(flat), triangles)]
    drawn = nearest_covers(to_pixels(flat), seen[:, 2], facing, *_middles(*size.tolist()))
    attributes = np.concatenate([normals @ turn.T, colours, seen], axis=1)
    return _over(_means(drawn, facing, attributes, (height, width), painting), shadow)


def _middles(width: int, height: int) -> tuple[Floats, Floats]:
    """Where the pixels of a picture are."""
    return np.arange(width) + 0.5, np.arange(height) + 0.5


def _means(
    drawn: NearestCover,
    triangles: Ints,
    attributes: Floats,
    shape: tuple[int, int],
    painting: Callable[[Floats], Floats] | None = None,
) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Pixels (k,) of a picture (h, w) with something in them, how much of each, its attributes (k, n)."""
    pixel = (drawn.rows // _OVERSAMPLING) * shape[1] + drawn.columns // _OVERSAMPLING
    count = np.bincount(pixel, minlength=shape[0] * shape[1])
    hit = np.flatnonzero(count)
    corners = triangles[drawn.number]
    means = np.empty((len(hit), attributes.shape[1]))
    each = [mixed(drawn.shares, values, corners) for values in attributes.T]
    if painting is not None:
        each[3:6] = painting(np.column_stack(each[3:6])).T
    for number, values in enumerate(each):
        means[:, number] = np.bincount(pixel, values, minlength=len(count))[hit] / count[hit]
    return hit, count[hit] / _OVERSAMPLING**2, means


def _over(drawn: tuple[NDArray[np.intp], Floats, Floats], shadow: Floats) -> Floats:
    """RGBA (h, w, 4) of what is drawn over its shadow (h, w), which is black."""
    hit, share, means = drawn
    image = np.zeros((*shadow.shape, 4))
    image[..., 3] = shadow
    flat = image.reshape(-1, 4)
    below = flat[hit, 3] * (1.0 - share)
    flat[hit, 3] = share + below
    flat[hit, :3] = _lit(means) * (share / flat[hit, 3])[:, None]
    return np.clip(image, 0.0, 1.0)


def rgb(colour: str) -> Floats:
    """Red, green and blue (3,) from 0 to 1 of a colour written like #ff0000."""
    return np.array([int(colour[place : place + 2], 16) / 255.0 for place in (1, 3, 5)])


def _surface(inflations: Sequence[Inflation], seal_width: float, film: Floats) -> Coloured:
    """Positions, triangles, vertex normals and colours of both halves and of the weld around them."""
    parts = [part for inflation in inflations for part in two_panel_surfaces(inflation, seal_width)]
    return together(
        [
            (
                part.positions,
                part.triangles,
                part.normals,
                np.tile(WELD_SHADE * film if part.weld else film, (len(part.positions), 1)),
            )
            for part in parts
        ]
    )


def together(parts: Sequence[Coloured]) -> Coloured:
    """Several surfaces as one."""
    starts = np.cumsum([0, *(len(part[0]) for part in parts)])
    return (
        np.concatenate([part[0] for part in parts]),
        np.concatenate([part[1] + start for part, start in zip(parts, starts)]).astype(np.int32),
        np.concatenate([part[2] for part in parts]),
        np.concatenate([part[3] for part in parts]),
    )


def _rotation() -> Floats:
    cy, sy, cp, sp = np.cos(_YAW), np.sin(_YAW), np.cos(_PITCH), np.sin(_PITCH)
    about_y = np.array([[cy, 0.0, sy], [0.0, 1.0, 0.0], [-sy, 0.0, cy]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cp, -sp], [0.0, sp, cp]])
    return about_x @ about_y


def _projected(points: Floats) -> Floats:
    return points[:, :2] * (_EYE / (_EYE - points[:, 2]))[:, None]


def _facing_viewer(pixels: Floats, triangles: Ints) -> Bools:
    return signed_areas(pixels, triangles) < 0.0  # rows of a picture run downward


def _lit(drawn: Floats) -> Floats:
    """Colours (n, 3) of metallic film from normals, film colours and places as the eye sees them."""
    normal = unit(drawn[:, :3])
    film, place = drawn[:, 3:6], drawn[:, 6:9]
    view = unit(np.array([0.0, 0.0, _EYE]) - place)
    facing = np.clip((normal * view).sum(axis=1, keepdims=True), 0.0, 1.0)
    mirrored = 2.0 * (normal * view).sum(axis=1, keepdims=True) * normal - view
    key = unit(np.array([-0.45, 0.8, 0.65]))
    bounce = 0.5 - 0.5 * normal[:, 1:2]  # light from the floor
    diffuse = 0.34 + 0.66 * np.clip(normal @ key, 0.0, None)[:, None] + 0.22 * bounce
    edge = (1.0 - facing) ** 4
    tint = film + (1.0 - film) * edge
    colour = film * (0.6 * diffuse) + tint * (0.75 * _studio(mirrored))[:, None]
    glint = np.clip(mirrored @ key, 0.0, None)[:, None]
    colour += 0.55 * glint**60 + 0.12 * glint**12
    return np.clip(colour, 0.0, 1.0) ** (1.0 / 1.15)


def _studio(direction: Floats) -> Floats:
    """Brightness of the surroundings: dark floor, bright sky, a wide lamp above and a strip at the right."""
    x, y, z = direction.T
    sky = 0.22 + 0.42 * _step(y, -0.3, 0.9) + 0.16 * _step(-y, 0.3, 1.0)
    lamp = _step(y, 0.3, 0.65) * (1.0 - _step(y, 0.85, 1.0)) * (1.0 - _step(np.abs(x + 0.15), 0.4, 0.8))
    strip = _step(x, 0.5, 0.8) * (1.0 - _step(x, 0.85, 1.0)) * _step(z, -0.5, 0.2)
    return sky + 0.5 * lamp + 0.3 * strip


def _step(value: Floats, start: float, end: float) -> Floats:
    share = np.clip((value - start) / (end - start), 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def _blurred(image: Floats, radius: int) -> Floats:
    """Three box filters in each direction: nearly a Gaussian."""
    for axis in (0, 1):
        for _ in range(3):
            padding = [(radius + 1, radius) if k == axis else (0, 0) for k in range(2)]
            total = np.cumsum(np.pad(image, padding), axis=axis)
            length = image.shape[axis]
            image = (
                np.take(total, np.arange(length) + 2 * radius + 1, axis=axis)
                - np.take(total, np.arange(length), axis=axis)
            ) / (2 * radius + 1)
    return image
