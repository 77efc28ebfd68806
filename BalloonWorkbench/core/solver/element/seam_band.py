# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sealed band: two welded films as a narrow beam along the seam that resists bending in its plane.

Two films of thickness t welded over a width s have the in-plane rigidity E I = 2 E t s^3 / 12, of which each
panel carries half. The band does not resist an even shortening, because it crumples at a scale far below the
mesh; it keeps the rim from folding in the plane of symmetry. With e the edges before and after a vertex, l
their rest lengths, R the rotation by the turning angle at rest and b the length of rim that belongs to the
vertex, its energy is the sum of

    E I / (2 b) |e_after / l_after - R e_before / l_before|^2

which is E I (change of curvature)^2 / 2 per length where the rim keeps its length. It is quadratic in the
positions, so that edges may shrink to nothing without harm.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.solver.element.dkt import Numbers
from BalloonWorkbench.core.types import Floats, Ints


def kink_operators(corners: Numbers, rigidities: Floats) -> tuple[Numbers, Numbers]:
    """The kinks of hinges with these corners (h, 3, 2) from positions, (h, 2, 6), and their stiffnesses (h,).

    Analytic in the corners, as dkt.py is.
    """
    previous, middle, following = np.moveaxis(corners, 1, 0)
    before, after = middle - previous, following - middle
    length_before, length_after = (np.sqrt((edge**2).sum(axis=1)) for edge in (before, after))
    cosine = np.einsum("ij,ij->i", before, after) / (length_before * length_after)
    sine = cross(before, after) / (length_before * length_after)
    turn = np.array([[cosine, -sine], [sine, cosine]]).transpose(2, 0, 1) / length_before[:, None, None]
    straight = np.eye(2)[None] / length_after[:, None, None]
    operator = np.concatenate([turn, -turn - straight, straight], axis=2)
    return operator, 2.0 * rigidities / (length_before + length_after)


class SeamBand:
    """The band along all seams and welds of a panel.

    hinges      (h, 3) vertices that are neighbours along one of them
    rigidities  (h,) E I of the band there
    """

    def __init__(self, rest_positions: Floats, hinges: Ints, rigidities: Floats) -> None:
        self.hinges, self.rigidities = hinges, rigidities
        self._operator, self._stiffness = kink_operators(rest_positions[hinges], rigidities)

    def _kinks(self, positions: Floats) -> Floats:
        return np.einsum("hij,hj->hi", self._operator, positions[self.hinges][:, :, :2].reshape(-1, 6))

    def energy(self, positions: Floats) -> float:
        """Energy of the bent band at positions (n, 3)."""
        return 0.5 * float(self._stiffness @ np.sum(self._kinks(positions) ** 2, axis=1))

    def derivatives(self, positions: Floats) -> tuple[Floats, Floats]:
        """Forces (h, 6) and stiffnesses (h, 6, 6) in x and y of the three hinge vertices."""
        weighted = self._stiffness[:, None, None] * self._operator
        force = np.einsum("hij,hi->hj", weighted, self._kinks(positions))
        return force, np.matmul(np.swapaxes(weighted, 1, 2), self._operator)


def seam_hinges(seams: Sequence[Ints], welds: Sequence[Ints] = ()) -> Ints:
    """Vertices before, at and after each vertex of the seams, and each but the ends of the welds: (h, 3)."""
    loops = [np.column_stack([np.roll(seam, 1), seam, np.roll(seam, -1)]) for seam in seams]
    lines = [np.column_stack([weld[:-2], weld[1:-1], weld[2:]]) for weld in welds]
    return np.concatenate([np.zeros((0, 3)), *loops, *lines]).astype(np.int32)


def hinge_rigidities(
    seams: Sequence[Ints], rigidities: Sequence[float], welds: Sequence[Ints] = ()
) -> Floats:
    """The rigidity of its seam or weld for each hinge: (h,)."""
    counts = [*(len(seam) for seam in seams), *(max(len(weld) - 2, 0) for weld in welds)]
    return np.repeat(np.array(rigidities, dtype=np.float64), np.array(counts, dtype=int))
