# SPDX-License-Identifier: LGPL-2.1-or-later
"""Good meshes damaged in the ways of real files, several at once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from mesh_writers import WRITERS
from solids import ball, capsule, egg, pear, rounded_box, torus

from BalloonWorkbench.core.targets.half_edges import half_edges
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.refine import split_edges
from BalloonWorkbench.core.types import Floats, Ints

Mesh = tuple[Floats, Ints]
Random = np.random.Generator
BODIES = (ball, capsule, egg, pear, torus, rounded_box)


def without_some(mesh: Mesh, random: Random) -> Mesh:
    points, triangles = mesh
    return points, triangles[random.random(len(triangles)) > random.choice([1e-3, 0.01, 0.3])]


def without_a_patch(mesh: Mesh, random: Random) -> Mesh:
    points, triangles = mesh
    centres = points[triangles].mean(axis=1)
    away = np.linalg.norm(centres - centres[random.integers(len(centres))], axis=1)
    return points, triangles[away > random.uniform(0.05, 0.9) * away.max()]


def turned(mesh: Mesh, random: Random) -> Mesh:
    points, triangles = mesh
    some = random.random(len(triangles)) < random.choice([0.01, 0.5, 1.0])
    return points, np.where(some[:, None], triangles[:, ::-1], triangles)


def crossing(mesh: Mesh, random: Random) -> Mesh:
    """One body through the other, welded nowhere."""
    points, triangles = mesh
    shifted = points + random.uniform(-0.4, 0.4, 3) * np.ptp(points, axis=0)
    return np.concatenate([points, shifted]), np.concatenate([triangles, triangles + len(points)])


def crumpled(mesh: Mesh, random: Random) -> Mesh:
    """So rough that it crosses itself."""
    points, triangles = mesh
    return points + random.normal(size=points.shape) * random.choice([1e-3, 0.05]) * np.ptp(points), triangles


def flat(mesh: Mesh, random: Random) -> Mesh:
    return mesh[0] * (1.0, random.choice([0.0, 1e-9, 1e-3, 0.02]), 1.0), mesh[1]


def unknown(mesh: Mesh, random: Random) -> Mesh:
    points = mesh[0].copy()
    points[random.integers(0, len(points), 3), random.integers(3)] = random.choice([np.nan, np.inf, 1e300])
    return points, mesh[1]


def pinched(mesh: Mesh, random: Random) -> Mesh:
    """Points far from each other made one."""
    points, triangles = mesh
    one, other = random.integers(0, len(points), 2)
    return points, np.where(triangles == one, other, triangles)


def without_area(mesh: Mesh, random: Random) -> Mesh:
    """Triangles drawn out to a line, with their points on the edges of others."""
    points, triangles = mesh[0].copy(), mesh[1]
    for triangle in triangles[random.integers(0, len(triangles), 5)]:
        points[triangle[2]] = 0.5 * (points[triangle[0]] + points[triangle[1]])
    return points, triangles


def loose(mesh: Mesh, random: Random) -> Mesh:
    """Each triangle with points of its own, rounded."""
    points = mesh[0][mesh[1]].reshape(-1, 3).astype(np.float32)
    return points.astype(np.float64), np.arange(len(points), dtype=np.int32).reshape(-1, 3)


def with_a_fin(mesh: Mesh, random: Random) -> Mesh:
    """A sheet that stands on an edge of the surface."""
    points, triangles = mesh
    start, end, _ = triangles[random.integers(len(triangles))]
    tip = 1.3 * points[start]
    return np.concatenate([points, [tip]]), np.concatenate([triangles, [[start, end, len(points)]]])


def twice_over(mesh: Mesh, random: Random) -> Mesh:
    """A shell inside another one, the inner one seen from inside or not."""
    points, triangles = mesh
    inner = triangles[:, ::-1] if random.random() < 0.5 else triangles
    smaller = points.mean(axis=0) + random.choice([0.5, 0.999, 1.0]) * (points - points.mean(axis=0))
    return np.concatenate([points, smaller]), np.concatenate([triangles, inner + len(points)])


def at_rest_on_edges(mesh: Mesh, random: Random) -> Mesh:
    """Triangles whose neighbours have a point on their edge that they do not know of (T-junctions)."""
    points, triangles = mesh
    some = random.random(len(triangles)) < random.choice([2e-3, 0.3])
    a, b, c = triangles[some].T
    middle = len(points) + np.arange(len(a))
    parts = np.concatenate([np.column_stack([a, middle, c]), np.column_stack([middle, b, c])])
    middles = 0.5 * (points[a] + points[b])
    return np.concatenate([points, middles]), np.concatenate([triangles[~some], parts])


def far_away(mesh: Mesh, random: Random) -> Mesh:
    return mesh[0] + random.choice([1e3, 1e6, 1e9]), mesh[1]


def bottle_without_inside(mesh: Mesh, random: Random) -> Mesh:
    """Klein's bottle in the place of the body."""
    count = 24
    u, v = (grid.ravel() for grid in np.meshgrid(np.arange(count), np.arange(count), indexing="ij"))
    a, b = 2.0 * np.pi * u / count, 2.0 * np.pi * v / count
    out = 3.0 + np.cos(a / 2) * np.sin(b) - np.sin(a / 2) * np.sin(2 * b)
    up = np.sin(a / 2) * np.sin(b) + np.cos(a / 2) * np.sin(2 * b)
    points = 30.0 * np.column_stack([out * np.cos(a), out * np.sin(a), up])

    def number(i: Ints, j: Ints) -> Ints:
        return i % count * count + np.where(i < count, j, -j) % count

    here, right, above, both = number(u, v), number(u + 1, v), number(u, v + 1), number(u + 1, v + 1)
    return points, np.concatenate(
        [np.column_stack([here, right, both]), np.column_stack([here, both, above])]
    )


def single(mesh: Mesh, random: Random) -> Mesh:
    """One triangle, or none."""
    return mesh[0], mesh[1][: random.integers(2)]


def in_another_unit(mesh: Mesh, random: Random) -> Mesh:
    return mesh[0] * random.choice([1e-6, 1e-3, 25.4, 1e3, 1e9]), mesh[1]


DAMAGES: tuple[Callable[[Mesh, Random], Mesh], ...] = (
    *(without_some, without_a_patch, turned, crossing, crumpled, flat, unknown, pinched, without_area, loose),
    *(with_a_fin, in_another_unit, twice_over, at_rest_on_edges, far_away, bottle_without_inside, single),
)


def damaged_bytes(data: bytes, random: Random) -> bytes:
    """A file cut off, with other bytes, with a wrong count, with text in it, or as it is."""
    kind = random.integers(8)
    content = bytearray(data)
    if kind == 0:
        return bytes(content[: random.integers(len(content))])
    if kind == 1:
        for at in random.integers(0, len(content), 20):
            content[at] = random.integers(256)
    elif kind == 2:
        content[80:84] = int(random.integers(2**32)).to_bytes(4, "little")
    elif kind == 3:
        at = int(random.integers(len(content)))
        content[at:at] = "no mesh, \u00fc\u4e00 nan inf 1e999\n".encode() * 3
    return bytes(content)


def broken_file(number: int, folder: Path, triangles: int = 0) -> Path:
    """A file of some format of a damaged mesh, about so many triangles more than it has otherwise."""
    name, raw = broken_mesh(number)
    random = np.random.default_rng(1000 + number)
    points, corners = np.clip(raw.points, -3e38, 3e38), raw.triangles
    while 0 < len(corners) < triangles // 2:
        marked = np.ones(3 * len(corners), dtype=bool)
        ends = points[half_edges(corners)]
        points, corners, _ = split_edges(points, corners, marked, ends.mean(axis=1))
    suffix, write = list(WRITERS.values())[number % len(WRITERS)]
    path = folder / f"{number} {name}.{suffix}"
    with np.errstate(all="ignore"):
        path.write_bytes(damaged_bytes(write(points, corners), random))
    return path


def broken_mesh(number: int) -> tuple[str, RawMesh]:
    """A damaged mesh in millimetres and what was done to it; the first ones have each damage alone."""
    random = np.random.default_rng(number)
    body = BODIES[number % len(BODIES)]
    target = body()
    mesh = (100.0 * target.points, target.triangles)
    if number < len(DAMAGES):
        chosen = [number]
    else:
        chosen = random.choice(len(DAMAGES), random.integers(1, 4), replace=False).tolist()
    for damage in chosen:
        mesh = DAMAGES[damage](mesh, random)
    name = ", ".join([body.__name__, *(DAMAGES[damage].__name__ for damage in chosen)])
    return name, RawMesh(mesh[0], mesh[1].astype(np.int32))
