# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard an inflated balloon pulls at its film and at its weld.

At a notch and at the end of a weld the film's pull is gathered in a point: the stress there has no limit as
the mesh gets finer, but the force has one. Film that gives way a little and a weld of some width share it, so
loads are averaged over two seal widths: the forces at the weld as vectors along it, the tensions of the film
over a round piece. They are forces per width of flat film, as tensile tests give them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import edge_lengths
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.results.single_panels import single_panels
from BalloonWorkbench.core.solver.element.dkt import gradients, rotation_stiffness
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.split_along_welds import split_along_welds
from BalloonWorkbench.core.solver.start import vertex_normals
from BalloonWorkbench.core.types import Floats, Ints

#: Elements over which a load that is not gathered is averaged: what single ones pull is noise of the mesh.
_EVEN = 2.5
#: Cells across the round piece of film, and at most so many along the panel.
_ACROSS, _MOST_CELLS = 6, 700
#: Solves on from the rest that suffices for the eye, each with so small an energy left in its last step,
#: until the loads stay as they are.
_TOLERANCES = (1e-7, 1e-9, 1e-11)
_SAME = 0.01
#: By so little more than 1, a ratio of two windows says nothing of what is gathered in a point.
_TOLD_APART = 1e-9


@dataclass(frozen=True)
class Load:
    """The largest load [N/m], and where on the inflated balloon (3,) [m]."""

    value: float
    place: Floats


@dataclass(frozen=True)
class Loads:
    """What the film bears, and with what each of the two films pulls at the weld."""

    film: Load
    weld: Load

    def like(self, other: Loads) -> bool:
        """Both loads are the same but for a hundredth."""
        pairs = ((self.film, other.film), (self.weld, other.weld))
        return all(abs(one.value - two.value) <= _SAME * two.value for one, two in pairs)

    def or_more(self, other: Loads) -> Loads:
        """The larger one of each."""
        film, weld = (
            max(pair, key=lambda load: load.value)
            for pair in ((self.film, other.film), (self.weld, other.weld))
        )
        return Loads(film, weld)


def _windows(panel: Panel, film: Film) -> tuple[float, float]:
    """Lengths [m] over which loads are averaged: two seal widths, and a few elements of the mesh.

    The second one for both where there is no sealed band.
    """
    _, areas = gradients(panel.rest_positions[panel.triangles])
    even = _EVEN * float(np.sqrt(4.0 / np.sqrt(3.0) * np.median(areas)))
    return 2.0 * film.seal_width or even, even


def settled_loads(inflation: Inflation, film: Film) -> tuple[Loads, bool]:
    """The loads of a balloon that is brought fully to rest, and whether that succeeded.

    The solver stops when nothing is seen to move; forces need a little longer. Where they do not come to
    rest, or no solver is there, the larger of the last two loads are given.
    """
    backend = "numpy" if inflation.report.backend == "numpy" else None
    now = loads(inflation, film)
    before = now
    for tolerance in _TOLERANCES:
        checkpoint()
        before = now
        try:
            inflation = inflate(
                inflation.assembly,
                film,
                inflation.report.pressure,
                start=inflation,
                backend=backend,
                settings=NewtonSettings(tolerance),
                model=inflation.report.model,
                lift=inflation.report.lift,
            )
        except BalloonError:  # a document is looked at where nothing can be solved
            break
        now = loads(inflation, film)
        if inflation.report.converged and now.like(before):
            return now, True
    return now.or_more(before), False


def loads(inflation: Inflation, film: Film) -> Loads:
    """The loads of an inflated balloon made of this film, as it is.

    The film bears at least what it hands on to the weld.
    """
    each = []
    for number, side in enumerate(single_panels(inflation)):
        over = number > 0 and inflation.lower is not None  # as the upper one of the balloon turned over
        for load in (_film_load(side, film), _weld_load(side, film)):
            each.append(Load(load.value, load.place * MIRROR) if over else load)
    weld = max(each[1::2], key=lambda load: load.value)
    return Loads(max([*each[::2], weld], key=lambda load: load.value), weld)


def _stress(inflation: Inflation, film: Film) -> tuple[Floats, Floats]:
    """Deformation gradients (m, 3, 2) and second Piola-Kirchhoff tensions (m, 2, 2) [N/m]."""
    panel = inflation.panel
    problem = film_problem(panel, film, inflation.characteristic_pressure, inflation.report.model)
    shape, _ = gradients(panel.rest_positions[panel.triangles])
    deformation = deformation_gradients(inflation.positions, panel.triangles, shape)
    xx, yy, xy = film.membrane_stiffness * problem.membrane(green_strains(deformation)).stress.T
    return deformation, np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], axis=1)


# --- the weld


def seam_forces(inflation: Inflation, film: Film) -> list[tuple[Ints, Floats, Floats]]:
    """With what the upper film pulls at its seams, and at the edge round each weld inside.

    For each of these loops its vertices (k,), the length of the flat edge from each to the next (k,) [m] and
    the force on each (k, 3) [N]: that of the film, and of the pressure on the film that is the vertex's.
    """
    panel = inflation.panel
    flat, origin = split_along_welds(panel)
    deformation, stress = _stress(inflation, film)
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    corners = areas[:, None, None] * np.einsum("mij,mjk,mck->mci", deformation, stress, shape)
    corners -= _pressures(inflation)
    normals = vertex_normals(inflation.positions[origin], flat)[len(panel.rest_positions) :]
    directors = np.concatenate([inflation.directors, normals])[flat.triangles]
    rigidity = inflation.report.flexural_rigidity
    stiffness = rigidity * rotation_stiffness(panel.rest_positions[panel.triangles], film.poisson_ratio)
    rotations = np.matmul(directors, deformation).reshape(-1, 6)  # as in shell.py
    moments = np.einsum("mij,mj->mi", stiffness, rotations).reshape(-1, 3, 2)
    corners += np.einsum("mck,mak,mci->mai", moments, shape, directors)
    forces = _summed(flat.triangles, corners, len(origin))
    whole = _summed(origin[:, None], forces[:, None], len(panel.rest_positions))
    lines = [(seam, edge_lengths(panel.rest_positions[seam]), whole[seam]) for seam in panel.loops]
    round_end = 0.5 * np.pi * film.seal_width
    for left, right in zip(flat.welds[::2], flat.welds[1::2], strict=True):
        ends = [left[end] == right[end] for end in (0, -1)]  # free, not at the rim
        loop = np.concatenate([left, right[::-1][int(ends[1]) : len(right) - int(ends[0])]])
        steps = edge_lengths(flat.rest_positions[loop])
        for free, vertex in zip(ends, (0, len(left) - 1), strict=True):
            if free:
                steps[[vertex - 1, vertex]] += 0.5 * round_end
        lines.append((origin[loop], steps, forces[loop]))
    return lines


def _pressures(inflation: Inflation) -> Floats:
    """Forces (m, 1, 3) [N] of the pressure at each corner of the triangles of the upper film."""
    a, b, c = np.moveaxis(inflation.positions[inflation.panel.triangles], 1, 0)
    pressures = inflation.pressures((a + b + c)[:, 2] / 3.0)
    return np.asarray(pressures[:, None] / 6.0 * np.cross(b - a, c - a))[:, None]


def _weld_load(inflation: Inflation, film: Film) -> Load:
    best = Load(0.0, np.zeros(3))
    for vertices, steps, forces in seam_forces(inflation, film):
        along = loads_along(steps, forces, *_windows(inflation.panel, film))
        place = int(np.argmax(along))
        if along[place] >= best.value:
            best = Load(float(along[place]), inflation.positions[vertices[place]])
    return best


def loads_along(steps: Floats, forces: Floats, width: float, even: float) -> Floats:
    """Load (k,) [N/m] at each vertex of a loop with forces (k, 3) [N] and edges to the next (k,) [m].

    The forces are averaged as vectors over a window that fades towards its ends, so that none enters or
    leaves at once: it reaches one width to either side, and a force in a point counts as shared over one
    width. On a mesh that is coarse beside the window, forces of single vertices are uneven where the load is
    not: there it is averaged over `even`, unless this hides a load that is gathered in a point.
    """
    own = 0.5 * (steps + np.roll(steps, 1))
    at, around = np.concatenate([[0.0], np.cumsum(steps)[:-1]]), float(steps.sum())
    near, far = (min(half, 0.5 * around) for half in (width, max(width, even)))
    gathered = np.linalg.norm(_faded(at, around, forces, near), axis=1)
    mean = np.linalg.norm(_faded(at, around, forces, far), axis=1) / _faded(at, around, own, far)
    if far <= near:
        return np.asarray(mean)
    lengths, all_lengths = (_faded(at, around, own, half) for half in (near, far))
    most = far * all_lengths / (near * lengths)  # of the ratio below, where all is in one point
    # edges longer than both windows cannot tell one from the other: there the load is even
    excess = np.where(most > 1.0 + _TOLD_APART, most - 1.0, np.inf)
    share = (gathered / lengths / np.maximum(mean, 1e-300) - 1.0) / excess
    return np.asarray(mean + np.clip(2.0 * share - 0.5, 0.0, 1.0) * np.maximum(gathered - mean, 0.0))


def _faded(at: Floats, around: float, values: Floats, half: float) -> Floats:
    """Sums (k, ...) of values (k, ...) at places along a loop, weighted 1 / half here and 0 from half on."""
    places = np.concatenate([at - around, at, at + around])
    tripled = np.concatenate([values, values, values]).reshape(len(places), -1)
    zeros = np.zeros((1, tripled.shape[1]))
    sums = np.concatenate([zeros, np.cumsum(tripled, axis=0)])
    moments = np.concatenate([zeros, np.cumsum(tripled * places[:, None], axis=0)])
    first, here, last = (np.searchsorted(places, at + shift) for shift in (-half, 0.0, half))
    before, after = 1.0 - at[:, None] / half, 1.0 + at[:, None] / half
    rising = before * (sums[here] - sums[first]) + (moments[here] - moments[first]) / half
    falling = after * (sums[last] - sums[here]) - (moments[last] - moments[here]) / half
    return np.asarray((rising + falling).reshape(values.shape) / half)


def _summed(indices: Ints, values: Floats, count: int) -> Floats:
    """Values (m, c, 3) summed at the vertices (m, c) that they belong to: (count, 3)."""
    parts = [np.bincount(indices.ravel(), values[..., axis].ravel(), count) for axis in range(3)]
    return np.column_stack(parts)


# --- the film


def _film_load(inflation: Inflation, film: Film) -> Load:
    """Largest principal tension, averaged over the film within a round piece as wide as the window."""
    panel = inflation.panel
    width, _ = _windows(panel, film)
    size = panel.size
    pitch = max(width / _ACROSS, size / _MOST_CELLS)
    cells, low = _in_cells(inflation, film, pitch)
    there = cells[..., 0] > 0.0
    sums = _round_sums(cells, 0.5 * width / pitch)
    xx, yy, xy = (sums[..., k] / np.where(there, sums[..., 0], 1.0) for k in (1, 2, 3))
    tension = np.where(there, 0.5 * (xx + yy) + np.hypot(0.5 * (xx - yy), xy), 0.0)
    best = np.unravel_index(int(np.argmax(tension)), tension.shape)
    flat = low + pitch * (np.array(best) + 0.5)
    middles = panel.rest_positions[panel.triangles].mean(axis=1)
    nearest = int(np.argmin(np.sum((middles - flat) ** 2, axis=1)))
    return Load(float(tension[best]), inflation.positions[panel.triangles[nearest]].mean(axis=0))


def _in_cells(inflation: Inflation, film: Film, pitch: float) -> tuple[Floats, Floats]:
    """Area, and tensions xx, yy, xy times area, of the flat film in square cells: (rows, columns, 4).

    And the lower left corner of the cells (2,).
    """
    panel = inflation.panel
    corners = panel.rest_positions[panel.triangles]
    _, areas = gradients(corners)
    values = areas[:, None] * np.column_stack([np.ones(len(areas)), _nominal(*_stress(inflation, film))])
    low = panel.rest_positions.min(axis=0) - pitch
    rows, columns = np.ceil((panel.rest_positions.max(axis=0) - low) / pitch).astype(int) + 1
    cells = np.zeros((rows * columns, 4))
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = np.maximum(np.ceil(longest / pitch), 1).astype(int)
    for count in np.unique(parts):  # each triangle in count^2 smaller ones
        some = parts == count
        i, j = (index.ravel() for index in np.indices((count, count)))
        upright, turned = i + j < count, i + j < count - 1
        shares = np.concatenate(
            [np.column_stack([i, j])[upright] + 1.0 / 3.0, np.column_stack([i, j])[turned] + 2.0 / 3.0]
        )
        first = corners[some, :1]
        middles = first + np.einsum("sk,mkx->msx", shares / count, corners[some, 1:] - first)
        row, column = ((middles - low) / pitch).astype(int).transpose(2, 0, 1)
        index = (row * columns + column).ravel()
        for k in range(4):
            own = np.repeat(values[some, k] / count**2, count**2)
            cells[:, k] += np.bincount(index, own, len(cells))
    return cells.reshape(rows, columns, 4), low


def _nominal(deformation: Floats, stress: Floats) -> Floats:
    """Tensions xx, yy, xy (m, 3) per width of flat film, in its own axes: stretch times stress."""
    square = np.einsum("mik,mil->mkl", deformation, deformation)
    root = np.sqrt(np.maximum(np.linalg.det(square), 0.0))
    trace = square[:, 0, 0] + square[:, 1, 1]
    scale = np.sqrt(np.maximum(trace + 2.0 * root, 1e-300))
    stretch = (square + root[:, None, None] * np.eye(2)) / scale[:, None, None]
    product = stretch @ stress
    mixed = 0.5 * (product[:, 0, 1] + product[:, 1, 0])
    return np.column_stack([product[:, 0, 0], product[:, 1, 1], mixed])


def _round_sums(cells: Floats, radius: float) -> Floats:
    """Sums of cells (rows, columns, 4) over those whose middles are within a radius, in cells."""
    count, reach = cells.shape[1], int(radius)
    sums = np.concatenate([np.zeros_like(cells[:, :1]), np.cumsum(cells, axis=1)], axis=1)
    column = np.arange(count)
    within = np.zeros_like(cells)
    for row in range(-reach, reach + 1):
        half = int(np.sqrt(radius * radius - row * row))
        last, first = np.minimum(column + half + 1, count), np.maximum(column - half, 0)
        strip = sums[:, last] - sums[:, first]
        overlap = slice(max(row, 0), len(cells) + min(row, 0))
        moved = slice(max(-row, 0), len(cells) + min(-row, 0))
        within[moved] += strip[overlap]
    return within
