# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving a panel's rim without meshing anew, as long as the triangles stay good."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.geometry.triangulation import corner_angles
from BalloonWorkbench.core.mesh.quality import delaunay_loss, flipped, min_angles, worn
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.types import Floats, Ints

#: A triangle may not become much sharper than this [rad], or than it was before.
_SHARPEST = np.radians(20.0)
_SHARPENING = 0.8
#: Share of the interior edges that may stop being Delaunay.
_DELAUNAY_LOSS = 0.03


def move_rim(
    panel: Panel, seam_positions: Sequence[Floats], weld_positions: Sequence[Floats] = ()
) -> Panel | None:
    """The panel with its seams at new positions (k, 2) [m], in the order of `panel.loops`, and its welds.

    Same connectivity; the interior follows by a harmonic displacement (cotangent weights of the old mesh), so
    a uniform stretch stays uniform. None when triangles turn over, get thin (15 R < L) or lose the Delaunay
    property: then the caller has to mesh anew.
    """
    moved = panel.rest_positions.copy()
    # the seams last: they have the say where a weld ends on them
    for chain, positions in (*zip(panel.welds, weld_positions), *zip(panel.loops, seam_positions)):
        moved[chain] = positions
    seam = panel.sealed
    free = np.setdiff1d(np.arange(len(moved)), seam)
    if len(free):
        shift = moved[seam] - panel.rest_positions[seam]
        moved[free] += harmonic(panel, seam, free, shift)
    result = replace(panel, rest_positions=moved)
    return result if stays_good(panel, result) else None


def stays_good(before: Panel, after: Panel) -> bool:
    """Whether a panel whose vertices have moved has no triangles turned over, thin or far from Delaunay."""
    if flipped(after).any() or (worn(after) & ~worn(before)).any():
        return False
    if (min_angles(after) < _SHARPENING * np.minimum(min_angles(before), _SHARPEST)).any():
        return False
    return delaunay_loss(after) <= delaunay_loss(before) + _DELAUNAY_LOSS


def harmonic(panel: Panel, seam: Ints, free: Ints, shift: Floats) -> Floats:
    """Displacements of the free vertices for given ones (k, 2) of the seam."""
    try:
        from scipy.sparse import coo_matrix
        from scipy.sparse.linalg import splu
    except ImportError as error:
        raise without_scipy("Mesh reuse needs scipy: install it with pip install scipy.") from error
    triangles = panel.triangles
    half_cotangents = 0.5 / np.tan(corner_angles(panel.rest_positions, triangles))
    p, q = np.roll(triangles, -1, axis=1).ravel(), np.roll(triangles, -2, axis=1).ravel()
    weights = half_cotangents.ravel()
    count = len(panel.rest_positions)
    laplacian = coo_matrix(
        (
            np.concatenate([weights, weights, -weights, -weights]),
            (np.concatenate([p, q, p, q]), np.concatenate([p, q, q, p])),
        ),
        shape=(count, count),
    ).tocsc()
    inner = laplacian[free]
    return splu(inner[:, free].tocsc()).solve(-(inner[:, seam] @ shift))
