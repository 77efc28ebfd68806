# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloons that are timed: outlines of 0.3 m, a common film and party pressure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from drawn_shapes import NAMED

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Floats

PRESSURE = 2000.0  # Pa
#: Of the rim that an edit takes along with the point, and how far it goes, in widths of the balloon.
EDIT_REACH, EDIT = 0.05, 0.02


def sealed_film() -> Film:
    """What the workbench takes when nothing is chosen."""
    return film(DEFAULT_FILM)


def bare_film() -> Film:
    """The same without the stiffness of a sealed band, which Surface Evolver does not have."""
    return replace(film(DEFAULT_FILM), seal_width=0.0)


def panel(shape: str, vertices: int) -> Panel:
    """The named outline of tests/core/drawn_shapes.py, meshed to about so many vertices."""
    return triangulate(NAMED[shape], size_for(NAMED[shape], vertices))


def edited(before: Panel) -> Panel:
    """The panel after a point of its rim was pulled outward by EDIT of the width, as a hand pulls a curve.

    The rim follows as a Gaussian of EDIT_REACH; the mesh is kept.
    """
    width = float(np.ptp(before.rest_positions, axis=0).max())
    outer = before.rest_positions[before.loops[0]]
    lengths = np.linalg.norm(np.roll(outer, -1, axis=0) - outer, axis=1)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    point = int(np.argmin(np.abs(along[:-1] - 0.3 * along[-1])))
    gap = np.abs(along[:-1] - along[point])
    gap = np.minimum(gap, along[-1] - gap)
    pull = np.exp(-0.5 * (gap / (EDIT_REACH * width)) ** 2)
    moved = [outer + EDIT * width * pull[:, None] * _outward(outer, point)]
    moved += [before.rest_positions[seam] for seam in before.loops[1:]]
    panel = move_rim(before, moved)
    if panel is None:
        raise RuntimeError("The mesh did not survive the edit.")
    return panel


def _outward(loop: Floats, point: int) -> Floats:
    tangent = np.roll(loop, -1, axis=0)[point] - np.roll(loop, 1, axis=0)[point]
    return np.array([tangent[1], -tangent[0]]) / np.linalg.norm(tangent)
