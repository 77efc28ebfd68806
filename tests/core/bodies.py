# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies of flat panels for tests: polyhedra, drums, gored spheres, a thick letter."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from solver_cases import grid

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.types import Floats, Ints


def panel_of(points: Floats, triangles: Ints) -> Panel:
    """A panel whose boundary loops are read from its triangles, the outer one first."""
    edges = {tuple(pair) for k in range(3) for pair in triangles[:, [k, (k + 1) % 3]].tolist()}
    following = {start: end for start, end in sorted(edges) if (end, start) not in edges}
    loops = []
    while following:
        at = min(following)
        loop = []
        while at in following:
            loop.append(at)
            at = following.pop(at)
        loops.append(np.array(loop, dtype=np.int32))
    loops.sort(key=lambda loop: -np.ptp(points[loop], axis=0).max())
    return Panel(points, triangles.astype(np.int32), tuple(loops))


def run(number: int, panel: Panel, start: Floats, end: Floats, loop: int = 0) -> Run:
    """Along a boundary loop counter-clockwise from one place to another; all round where they are one."""
    rim = panel.loops[loop]
    first, last = (int(np.argmin(np.hypot(*(panel.rest_positions[rim] - place).T))) for place in (start, end))
    count = (last - first) % len(rim) or len(rim)
    return Run(number, rim[(first + np.arange(count + 1)) % len(rim)])


def back(one: Run) -> Run:
    """The same run the other way round."""
    return Run(one.panel, one.vertices[::-1].copy())


def rectangle(columns: int, rows: int, length: float, width: float) -> Panel:
    """A grid of cells with alternating diagonals, from (0, 0)."""
    return panel_of(*grid(columns, rows, length, width))


def crossed(panel: Panel) -> Panel:
    """A grid whose cells are cut by both diagonals: pairs of triangles of the grid become four."""
    cells = panel.triangles.reshape(-1, 6)
    points, triangles = [panel.rest_positions], []
    for number, cell in enumerate(cells.tolist()):
        middle = len(panel.rest_positions) + number
        points.append(panel.rest_positions[list(set(cell))].mean(axis=0)[None])
        around = [(cell[k], cell[3 * (k // 3) + (k + 1) % 3]) for k in range(6)]
        triangles += [(a, b, middle) for a, b in around if (b, a) not in around]
    return panel_of(np.concatenate(points), np.array(triangles, dtype=np.int32))


def sealed(panels: list[Panel], faces: list[list[int]], corners: list[Floats]) -> Assembly:
    """A polyhedron: for each panel the numbers of its corners in space, and where they lie in it."""
    sides: dict[tuple[int, int], Run] = {}
    for number, (panel, face, places) in enumerate(zip(panels, faces, corners)):
        for k, name in enumerate(face):
            after = (k + 1) % len(face)
            sides[name, face[after]] = run(number, panel, places[k], places[after])
    seams = [Seam(side, back(sides[b, a])) for (a, b), side in sides.items() if a < b]
    return Assembly(tuple(panels), tuple(seams))


def box(a: float, b: float, c: float, cells: int, *, both_diagonals: bool = False) -> Assembly:
    """Six rectangles; so many cells to a unit of length."""
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    axes = np.array([[x, y, z] for z in (0.0, c) for y in (0.0, b) for x in (0.0, a)])
    panels, corners = [], []
    for face in faces:
        u, v = (float(np.linalg.norm(axes[face[k + 1]] - axes[face[k]])) for k in (0, 1))
        panel = rectangle(round(u * cells), round(v * cells), u, v)
        panels.append(crossed(panel) if both_diagonals else panel)
        corners.append(np.array([(0.0, 0.0), (u, 0.0), (u, v), (0.0, v)]))
    return sealed(panels, faces, corners)


def triangle_panel(cells: int) -> Panel:
    """An equilateral triangle of side 1."""
    number: dict[tuple[int, int], int] = {}
    for row in range(cells + 1):
        for column in range(cells + 1 - row):
            number[column, row] = len(number)
    points = np.array([(c + 0.5 * r, r * np.sqrt(0.75)) for c, r in number]) / cells
    up = [(number[c, r], number[c + 1, r], number[c, r + 1]) for c, r in number if c + r < cells]
    down = [
        (number[c + 1, r], number[c + 1, r + 1], number[c, r + 1]) for c, r in number if c + r < cells - 1
    ]
    return panel_of(points, np.array(up + down, dtype=np.int32))


def of_triangles(faces: list[list[int]], cells: int) -> Assembly:
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (0.5, np.sqrt(0.75))])
    return sealed([triangle_panel(cells) for _ in faces], faces, [corners] * len(faces))


def tetrahedron(cells: int) -> Assembly:
    return of_triangles([[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]], cells)


def octahedron(cells: int) -> Assembly:
    ring = [(1, 2), (2, 3), (3, 4), (4, 1)]
    return of_triangles([[0, a, b] for a, b in ring] + [[5, b, a] for a, b in ring], cells)


def rings(inner: float, outer: float, rows: int, count: int) -> Panel:
    """Round the origin, so many vertices in each circle; a disc with the points thinned out for inner 0."""
    radii = np.linspace(inner, outer, rows + 1)
    numbers, points, at = [], [], 0
    for radius in radii:
        here = count if inner else max(round(count * radius / outer / 6.0) * 6, 1)
        turn = 2.0 * np.pi * np.arange(here) / here
        points.append(radius * np.column_stack([np.cos(turn), np.sin(turn)]))
        numbers.append(at + np.arange(here))
        at += here
    triangles = [triangle for low, high in pairwise(numbers) for triangle in _between(low, high)]
    return panel_of(np.concatenate(points), np.array(triangles, dtype=np.int32))


def _between(low: Ints, high: Ints) -> list[tuple[int, int, int]]:
    """Triangles between two circles of vertices, by the angle of the next one."""
    found = []
    i = j = 0
    while i < len(low) or j < len(high):
        a, b = low[i % len(low)], high[j % len(high)]
        if len(low) == 1 or (j < len(high) and (j + 1) * len(low) <= (i + 1) * len(high)):
            if j == len(high):
                break
            found.append((a, b, high[(j + 1) % len(high)]))
            j += 1
        else:
            found.append((a, b, low[(i + 1) % len(low)]))
            i += 1
    return found


def drum(height: float, rows: int) -> Assembly:
    """Two discs of radius 1 and the band between them, sealed to itself along its ends."""
    count = 6 * rows
    disc = rings(0.0, 1.0, rows, count)
    around = 2.0 * count * np.sin(np.pi / count)
    band = rectangle(count, max(round(height * rows), 2), around, height)
    places = [np.array(place) for place in ((0.0, 0.0), (around, 0.0), (around, height), (0.0, height))]
    low, right, high, left = (run(2, band, places[k], places[(k + 1) % 4]) for k in range(4))
    rim = run(0, disc, np.array([1.0, 0.0]), np.array([1.0, 0.0]))
    seams = (Seam(rim, back(high)), Seam(Run(1, rim.vertices), back(low)), Seam(right, back(left)))
    return Assembly((disc, disc, band), seams)


def gored_sphere(count: int, rows: int, columns: int) -> Assembly:
    """Sinusoidal gores of a sphere of radius 1, from pole to pole."""
    along = np.linspace(-0.5 * np.pi, 0.5 * np.pi, rows + 1)
    points, lines = [], []
    for row, latitude in enumerate(along):
        here = 0 if row in (0, rows) else columns
        half = np.pi / count * np.cos(latitude) if here else 0.0
        lines.append(len(points) + np.arange(here + 1))
        points += [(x, latitude) for x in np.linspace(-half, half, here + 1)]
    triangles = []
    for row in range(rows):
        low, high = lines[row], lines[row + 1]
        for k in range(columns):
            if len(low) > 1 and len(high) > 1 and (k < columns // 2):
                triangles += [(low[k], low[k + 1], high[k]), (low[k + 1], high[k + 1], high[k])]
            elif len(low) > 1 and len(high) > 1:
                triangles += [(low[k], low[k + 1], high[k + 1]), (low[k], high[k + 1], high[k])]
            elif len(low) > 1:
                triangles.append((low[k], low[k + 1], high[0]))
            else:
                triangles.append((low[0], high[k + 1], high[k]))
    gore = panel_of(np.array(points), np.array(triangles, dtype=np.int32))
    south, north = np.array([0.0, along[0]]), np.array([0.0, along[-1]])
    east = [run(k, gore, south, north) for k in range(count)]
    west = [back(run(k, gore, north, south)) for k in range(count)]
    return Assembly((gore,) * count, tuple(Seam(east[k], west[(k + 1) % count]) for k in range(count)))


def thick_ring(inner: float, outer: float, height: float, rows: int, count: int) -> Assembly:
    """The letter O with a side band inside and outside: of genus 1."""
    face = rings(inner, outer, rows, count)
    panels, seams = [face, face], []
    for loop, radius in enumerate((outer, inner)):
        around = 2.0 * count * radius * np.sin(np.pi / count)
        band = rectangle(count, 3, around, height)
        number = len(panels)
        panels.append(band)
        places = [np.array(place) for place in ((0.0, 0.0), (around, 0.0), (around, height), (0.0, height))]
        low, right, high, left = (run(number, band, places[k], places[(k + 1) % 4]) for k in range(4))
        rim = run(0, face, np.array([radius, 0.0]), np.array([radius, 0.0]), loop)
        other = Run(1, rim.vertices)
        seams += [Seam(rim, back(high)), Seam(other, back(low)), Seam(right, back(left))]
    return Assembly(tuple(panels), tuple(seams))


def letter_l(cells: int, height: float = 0.5) -> Assembly:
    """An L of three unit squares and its side band."""
    big = rectangle(2 * cells, 2 * cells, 2.0, 2.0)
    middle = big.rest_positions[big.triangles].mean(axis=1)
    kept = big.triangles[~((middle[:, 0] > 1.0) & (middle[:, 1] > 1.0))]
    used, numbers = np.unique(kept, return_inverse=True)
    face = panel_of(big.rest_positions[used], numbers.reshape(-1, 3))
    band = rectangle(8 * cells, max(round(height * cells), 2), 8.0, height)
    places = [np.array(place) for place in ((0.0, 0.0), (8.0, 0.0), (8.0, height), (0.0, height))]
    low, right, high, left = (run(2, band, places[k], places[(k + 1) % 4]) for k in range(4))
    rim = run(0, face, places[0], places[0])
    seams = (Seam(rim, back(high)), Seam(Run(1, rim.vertices), back(low)), Seam(right, back(left)))
    return Assembly((face, face, band), seams)
