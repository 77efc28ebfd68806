# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start shapes, for a flat film is singular under pressure: domes, a shape in space, an earlier balloon."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.embedding import embedding
from BalloonWorkbench.core.solver.equilibrium.linear import conjugate_gradients
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.model import stiffness_levels
from BalloonWorkbench.core.solver.problem import FilmProblem, Start
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm
from BalloonWorkbench.core.solver.weld_strip import started_strip
from BalloonWorkbench.core.types import Floats

ACCURATE = 1e-3  # a start need not be better
# z = DOME sqrt(u) has the height of a long pillow, w/pi, over a strip of width w (u = w^2/8 at the middle)
DOME = 2.0 * np.sqrt(2.0) / np.pi
# A slack film has no stiffness to start from: an earlier balloon is stretched by twice the strain of the edit
# (root mean square), within these bounds. After a larger edit it is stretched more and softened first.
LEAST_STRETCH, MOST_STRETCH = 0.01, 0.03
LARGE_EDIT = 0.03
LARGE_STRETCH = 0.08
SOFTENING = (16.0, 4.0, 1.0)


def start_of(split: SplitFilm, problem: FilmProblem, start: Inflation | Floats | None, twist: float) -> Start:
    """From an earlier balloon or from places (n, 3) [m] of the vertices; its own shape where neither fits.

    twist  how far two panels start from one plane, as a saddle
    """
    assembly, panel = split.assembly, split.assembly.panels[0]
    in_plane = assembly.mirror or assembly.is_pair
    earlier = start if isinstance(start, Inflation) else None
    if in_plane and earlier is not None and earlier.assembly.mirror and _fits(earlier.positions, panel):
        moved, softening = carried_over(earlier, panel)
        half = moved[split.origin[: len(split.panels[0].rest_positions)]] / assembly.size
        normals = vertex_normals(half, split.panels[0])
        directors = np.concatenate([earlier.directors, normals[len(panel.rest_positions) :]])
        levels = tuple(problem.membrane_stiffness / factor for factor in softening)
        return _of_half(split, half, directors, levels, twist)
    levels = stiffness_levels(problem.membrane_stiffness)
    places = start.positions if isinstance(start, Inflation) else start
    if places is None or len(places) != assembly.offsets[-1]:
        if in_plane:
            half = dome(split.panels[0]) / assembly.size
            return _of_half(split, half, vertex_normals(half, split.panels[0]), levels, twist)
        positions = _in_space(split)
    else:
        positions = places[split.origin]
        levels = levels[-1:] if earlier is not None and earlier.assembly is assembly else levels
    positions = (positions if split.tied is None else positions[split.tied]) / assembly.size
    return Start(positions, vertex_normals(positions, problem), levels)


def _fits(positions: Floats, panel: Panel) -> bool:
    return len(positions) == len(panel.rest_positions)


def _of_half(
    split: SplitFilm, half: Floats, directors: Floats, levels: tuple[float, ...], twist: float
) -> Start:
    """The upper half (n, 3), and the lower one where both panels are simulated."""
    if split.assembly.mirror:
        own = Start(half, directors, levels)
        return started_strip(split, own) if split.strip else own
    assert split.tied is not None
    positions, directors = (np.concatenate([part, part * MIRROR]) for part in (half, directors))
    x, y = (positions - positions.mean(axis=0))[:, :2].T
    # a saddle along no axis: one along an axis of symmetry of the outline may never leave it
    positions[:, 2] += twist * (x * y + 0.5 * (x**2 - y**2)) / np.sqrt(2.0)
    return Start(positions[split.tied], directors, levels)  # an earlier seam is not quite in the plane


def _in_space(split: SplitFilm) -> Floats:
    """Places (n, 3) [m] for panels that lie anywhere."""
    if (bodies := split.assembly.surface.bodies) > 1:
        raise AssemblyError(f"The panels are sealed to {bodies} bodies. Inflate each by itself.")
    _, corners = np.unique(np.asarray(split.tied), return_inverse=True)
    places = embedding(split.rest_positions[split.triangles], corners.ravel()[split.triangles])
    return places[corners.ravel()]


def dome(panel: Panel) -> Floats:
    """Positions (n, 3) over the flat panel: z = DOME sqrt(u), -Laplace(u) = 1, u = 0 on seams and welds."""
    count = len(panel.rest_positions)
    corners = np.ascontiguousarray(panel.triangles.T, dtype=np.intp)  # as bincount takes them
    after, before = [1, 2, 0], [2, 0, 1]
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    # between each corner and the next; the rows of the stiffness sum to zero
    coupling = -areas * np.einsum("mai,mai->am", shape, shape[:, after])

    def at_vertices(corner_values: Floats) -> Floats:
        return np.bincount(corners.ravel(), corner_values.ravel(), count).astype(np.float64, copy=False)

    load = at_vertices(np.tile(areas / 3.0, 3))
    held = panel.sealed
    load[held] = 0.0

    def laplace(values: Floats) -> Floats:
        here = values[corners]
        flow = coupling * (here - here[after])
        result = at_vertices(flow - flow[before])
        result[held] = 0.0
        return result

    diagonal = at_vertices(coupling + coupling[before])
    height = conjugate_gradients(laplace, load, lambda residual: residual / diagonal, ACCURATE).solution
    return np.column_stack([panel.rest_positions, DOME * np.sqrt(np.maximum(height, 0.0))])


def vertex_normals(positions: Floats, panel: Panel | FilmProblem) -> Floats:
    """Area-weighted unit normals (n, 3); of one triangle where they cancel, as in a corner folded
    flat; upwards where no triangle has an area.
    """
    a, b, c = np.moveaxis(positions[panel.triangles], 1, 0)
    area_vectors = np.cross(b - a, c - a)
    corners = panel.triangles.astype(np.intp).ravel()
    normals = np.column_stack(
        [np.bincount(corners, np.repeat(part, 3), len(positions)) for part in area_vectors.T]
    )
    lengths = np.linalg.norm(normals, axis=1)
    cancelled = lengths <= 1e-9 * lengths.max()
    if cancelled.any():
        of_one = np.zeros_like(normals)
        of_one[corners] = np.repeat(area_vectors, 3, axis=0)
        normals[cancelled] = of_one[cancelled]
        lengths[cancelled] = np.linalg.norm(of_one[cancelled], axis=1)
        bare = lengths == 0.0  # only triangles without an area lie there
        normals[bare], lengths[bare] = (0.0, 0.0, 1.0), 1.0
    return np.asarray(normals / lengths[:, None])


def carried_over(start: Inflation, panel: Panel) -> tuple[Floats, tuple[float, ...]]:
    """Positions (n, 3) of an earlier balloon moved with the panel, and how soft its film has to begin.

    The positions are stretched until nothing is slack; the film's stiffness is to be divided by each of the
    numbers in turn. A panel that stays as it is goes on from where the balloon was.
    """
    if panel is start.panel:
        return start.positions.copy(), (1.0,)
    moved = panel.rest_positions - start.panel.rest_positions
    shape, areas = gradients(start.panel.rest_positions[panel.triangles])
    slopes = np.einsum("mai,mak->mik", moved[panel.triangles], shape)
    edit = float(np.sqrt(areas @ np.einsum("mik,mik->m", slopes, slopes) / areas.sum()))
    large = edit > LARGE_EDIT
    stretch = 1.0 + (LARGE_STRETCH if large else float(np.clip(2.0 * edit, LEAST_STRETCH, MOST_STRETCH)))
    positions = start.positions.copy()
    positions[:, :2] += moved
    positions[:, 2] -= positions[np.concatenate(panel.loops), 2].mean()
    centre = positions.mean(axis=0) * (1.0, 1.0, 0.0)
    return centre + stretch * (positions - centre), SOFTENING if large else (1.0,)
