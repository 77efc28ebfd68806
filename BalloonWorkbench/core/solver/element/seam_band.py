# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sealed band: two welded films as a narrow beam along the seam that resists bending in its plane.

Two films of thickness t welded over a width s, with a rest of film beyond the weld, are a beam of the width
b of both together: its in-plane rigidity is E I = 2 E t b^3 / 12, of which each panel carries half. That is
the law along all seams, holes and welds. How much of it is left where a weld crumples is a number of the
film, `Film.weld_rigidity`: 1 for a weld that stays flat. A ring needs it: a curved tube wants to curve more
(Siefert et al., PNAS 116 (2019) 16692), and a closed one kinks unless its rim resists.

The band does not resist an even shortening, because it crumples at a scale far below the mesh. With e the
edges before and after a vertex, l their rest lengths, R the rotation by the turning angle at rest and a the
length of rim that belongs to the vertex, its energy is the sum of

    E I / (2 a) |e_after / l_after - R e_before / l_before|^2

which is E I (change of curvature)^2 / 2 per length where the rim keeps its length. It is quadratic in the
positions, so that edges may shrink to nothing without harm. It is for seams that stay in one plane, as those
of two equal panels do; space_band.py has the others.
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
    cosine, sine, length_before, length_after = rest_turns(corners)
    turn = np.array([[cosine, -sine], [sine, cosine]]).transpose(2, 0, 1) / length_before[:, None, None]
    straight = np.eye(2)[None] / length_after[:, None, None]
    operator = np.concatenate([turn, -turn - straight, straight], axis=2)
    return operator, 2.0 * rigidities / (length_before + length_after)


def rest_turns(corners: Numbers) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """Of hinges with these corners (h, 3, 2): cosine and sine of the turning angle, lengths of both edges."""
    previous, middle, following = np.moveaxis(corners, 1, 0)
    before, after = middle - previous, following - middle
    length_before, length_after = (np.sqrt((edge**2).sum(axis=1)) for edge in (before, after))
    cosine = np.einsum("ij,ij->i", before, after) / (length_before * length_after)
    sine = cross(before, after) / (length_before * length_after)
    return cosine, sine, length_before, length_after


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
