# SPDX-License-Identifier: LGPL-2.1-or-later
"""From outline to panel: an even triangle mesh with evenly spaced seams."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.mesh.boundary import seam_points
from BalloonWorkbench.core.mesh.lattice import lattice
from BalloonWorkbench.core.mesh.panel import Panel
from BalloonWorkbench.core.mesh.relax import relax
from BalloonWorkbench.core.mesh.sizing import size_field
from BalloonWorkbench.core.outline.outline import Outline


def triangulate(outline: Outline, size: float) -> Panel:
    """Constrained Delaunay triangulation of an outline with edges about `size` [m] long.

    The seams run along the outline's loops, evenly spaced, with sharp corners kept; parts thinner than four
    elements get smaller ones, down to size / 4. The vertices of the seams come first, loop by loop.
    Raises MeshError when the outline is too thin for the size or its parts touch.
    """
    width, height = outline.size
    if not (np.isfinite(size) and 0.0 < size):
        raise MeshError(f"The mesh size is {1e3 * size:g} mm: give one above 0.")
    if size > 0.5 * max(width, height):
        raise MeshError(
            f"A mesh of {1e3 * size:.3g} mm is too coarse for a shape of {1e3 * width:.3g} x {1e3 * height:.3g} mm:"
            f" use at most {100 * max(width, height):.3g} mm."
        )
    field = size_field(outline, size)
    seams, field = seam_points(outline.loops, field)
    starts = np.cumsum([0, *(len(seam) for seam in seams)])
    loops = tuple(np.arange(a, b, dtype=np.int32) for a, b in zip(starts[:-1], starts[1:], strict=True))
    points, triangles = relax(np.concatenate([*seams, lattice(seams, field)]), loops, field)
    return Panel(points, triangles, loops)
