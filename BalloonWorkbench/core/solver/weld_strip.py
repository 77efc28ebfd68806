# SPDX-License-Identifier: LGPL-2.1-or-later
"""A weld that crumples freely: the film outside the seams, resolved like all other film.

It is the lower bound beside the sealed band, which stays elastic (seam_band.py): film of the same law that
carries no compression, as wide as weld and allowance, held in the plane of the seam. The film folds at the
seam, so the strip shares the places of the rim, not its normals.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.normals import tangents
from BalloonWorkbench.core.mesh.strip import strip_outside
from BalloonWorkbench.core.solver.problem import Start
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm
from BalloonWorkbench.core.types import Floats

_FLAT = np.array([0.0, 0.0, 1.0])


def with_strip(split: SplitFilm, width: float) -> SplitFilm:
    """The film of a mirrored panel with the strip outside its seams, whose vertices and triangles are the
    last ones. The origin of each vertex of the strip is that of the rim beside it.

    Raises InputError for other balloons.
    """
    if not split.assembly.mirror:
        raise InputError(
            "A weld that crumples can be simulated of one panel and its mirror image alone: choose the"
            " elastic weld, or one panel and its mirror image."
        )
    strip, count = strip_outside(split.assembly.panels[0], width), len(split.origin)
    rim = len(strip.rim)
    tied = np.arange(count + len(strip.rest_positions), dtype=np.int32)
    tied[:count] = tied[:count] if split.tied is None else split.tied
    tied[count : count + rim] = tied[strip.rim]
    return replace(
        split,
        rest_positions=np.concatenate([split.rest_positions, strip.rest_positions]),
        triangles=np.concatenate([split.triangles, strip.triangles + count]).astype(np.int32),
        origin=np.concatenate([split.origin, np.tile(strip.rim, len(strip.rest_positions) // rim)]),
        tied=tied,
        strip=len(strip.rest_positions),
    )


def started_strip(split: SplitFilm, start: Start) -> Start:
    """The start of a panel's own film with that of the strip: moved, turned and stretched with its rim."""
    size, panel = split.assembly.size, split.assembly.panels[0]
    rest = split.rest_positions / size
    change = np.ones(len(rest), dtype=complex)
    for loop in panel.loops:
        now, before = tangents(start.positions[loop, :2]), tangents(rest[loop])
        change[loop] = _number(now) / _number(before)
    rim = split.origin[-split.strip :]
    out = change[rim] * _number(rest[-split.strip :] - rest[rim])
    moved = np.column_stack([out.real, out.imag, np.zeros(len(out))])
    return Start(
        np.concatenate([start.positions, start.positions[rim] * (1.0, 1.0, 0.0) + moved]),
        np.concatenate([start.directors, np.tile(_FLAT, (split.strip, 1))]),
        start.levels,
    )


def _number(vectors: Floats) -> NDArray[np.complex128]:
    """Vectors (n, 2) as complex numbers (n,): their quotients turn and stretch."""
    return np.asarray(vectors[:, 0] + 1j * vectors[:, 1])
