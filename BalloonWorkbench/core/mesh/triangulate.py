# SPDX-License-Identifier: LGPL-2.1-or-later
"""From outline to panel: an even triangle mesh with evenly spaced seams."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.mesh.boundary import seam_points, weld_points
from BalloonWorkbench.core.mesh.lattice import lattice
from BalloonWorkbench.core.mesh.relax import SWEEPS, relax
from BalloonWorkbench.core.mesh.sizing import size_field
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel

#: Sweeps of the relaxation for a quick look.
_ROUGH = 4


def triangulate(outline: Outline, size: float, rough: bool = False) -> Panel:
    """Constrained Delaunay triangulation of an outline with edges about `size` [m] long.

    The seams run along the outline's loops, evenly spaced, with sharp corners kept; parts thinner than four
    elements get smaller ones, down to size / 4. The vertices of the seams come first, loop by loop, then
    those of the welds. Only at tips sharper than 40 degrees a triangle has all its vertices on the seam.
    rough: parts much thinner than the size may be overlooked, for a quick look.

    Raises MeshError when the outline is too thin for the size or its parts touch.
    """
    field = size_field(outline, size, rough)
    seams, field = seam_points(outline.loops, field)
    welds = weld_points(outline.welds, seams, field)
    starts = np.cumsum([0, *(len(seam) for seam in seams), *(len(weld.points) for weld in welds)])
    loops = tuple(
        np.arange(first, last, dtype=np.int32) for first, last in pairwise(starts[: len(seams) + 1])
    )
    lines = tuple(weld.chain(int(first)) for weld, first in zip(welds, starts[len(seams) :]))
    own = [weld.points for weld in welds]
    inner = lattice(seams, field, [line for line in own if len(line)])
    sweeps = _ROUGH if rough else SWEEPS
    points, triangles = relax(np.concatenate([*seams, *own, inner]), loops, field, lines, sweeps)
    return Panel(points, triangles, loops, lines)
