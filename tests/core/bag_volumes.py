# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags whose volumes are known: closed forms of a film that cannot stretch, and values of two programs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.joined import joined_bag, polygon
from BalloonWorkbench.core.bodies.ready import ready_bag

A = 1.3110287771  # of the Mylar balloon


@dataclass(frozen=True)
class KnownVolume:
    """A bag, its k = E t / (p L) with L = 1 m, and its volume [m3]."""

    bag: Callable[[], Bag]
    k: float
    volume: float


def box(length: float, width: float, height: float) -> Bag:
    return ready_bag("box", length=length, width=width, height=height)


def octahedron() -> Bag:
    """Of edge 1."""
    around = list(pairwise([1, 2, 3, 4, 1]))
    return _of_triangles([(0, a, b) for a, b in around] + [(5, b, a) for a, b in around])


def icosahedron() -> Bag:
    """Of edge 1: 20 panels."""
    upper, lower = list(pairwise([1, 2, 3, 4, 5, 1])), list(pairwise([6, 7, 8, 9, 10, 6]))
    faces = [(0, a, b) for a, b in upper] + [(11, b, a) for a, b in lower]
    for (a, b), (c, d) in zip(upper, lower, strict=True):
        faces += [(b, a, c), (c, d, b)]
    return _of_triangles(faces)


def _of_triangles(faces: list[tuple[int, int, int]]) -> Bag:
    """Equal triangles of edge 1, by their corners seen from outside."""
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (0.5, np.sqrt(0.75))])
    panels = []
    for number, face in enumerate(faces, start=1):
        sides = ["-".join(map(str, sorted(pair))) for pair in pairwise([*face, face[0]])]
        panels.append((f"face {number}", polygon(corners, sides)))
    return joined_bag(panels, "0-1")


def drum(height: float) -> Bag:
    """Of radius 1."""
    return ready_bag("cylinder", radius=1.0, height=height)


def drum_volume(height: float) -> float:
    if height >= 2.0 * (A - 1.0):
        return np.pi * (height - 2.0 * (A - 1.0)) + 2.0 * np.pi / 3.0 * A
    return 2.0 * np.pi / 3.0 * A * ((1.0 + 0.5 * height) / A) ** 3


def cone(slant: float) -> Bag:
    """On a disc of radius 1."""
    return ready_bag("cone", radius=1.0, slant=slant)


def tetrahedron() -> Bag:
    return ready_bag("tetrahedron", edge=1.0)


#: Polyhedra of edge 1 from three nested meshes, confirmed by Surface Evolver; drums and cones in closed form.
KNOWN: dict[str, KnownVolume] = {
    "cube": KnownVolume(lambda: box(1.0, 1.0, 1.0), 1e3, 1.2629),
    "stiff cube": KnownVolume(lambda: box(1.0, 1.0, 1.0), 1e4, 1.2608),
    "long box": KnownVolume(lambda: box(1.0, 1.0, 2.0), 1e4, 2.532),
    "low box": KnownVolume(lambda: box(1.0, 1.0, 0.5), 1e4, 0.6466),
    "tetrahedron": KnownVolume(tetrahedron, 1e3, 0.17317),
    "stiff tetrahedron": KnownVolume(tetrahedron, 1e4, 0.17296),
    "octahedron": KnownVolume(octahedron, 1e3, 0.5406),
    "stiff octahedron": KnownVolume(octahedron, 1e4, 0.5398),
    "low drum": KnownVolume(lambda: drum(0.25), 1e3, drum_volume(0.25)),
    "drum": KnownVolume(lambda: drum(1.0), 1e3, drum_volume(1.0)),
    "high drum": KnownVolume(lambda: drum(2.0), 1e3, drum_volume(2.0)),
    "wide cone": KnownVolume(lambda: cone(2.0**0.5), 1e3, 1.733304),
    "cone": KnownVolume(lambda: cone(2.0), 1e3, 2.388874),
    "slender cone": KnownVolume(lambda: cone(3.0), 1e3, 3.468796),
}
