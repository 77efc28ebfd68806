# SPDX-License-Identifier: LGPL-2.1-or-later
"""The change of the seams that brings a balloon nearest to its target, as far as it follows linearly."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.target_design.aim import Aim
from BalloonWorkbench.core.target_design.iterate import TargetIterate
from BalloonWorkbench.core.target_design.mirrored_panels import MirroredPanels
from BalloonWorkbench.core.target_design.off_target import rigid_moves
from BalloonWorkbench.core.target_design.seam_unknowns import SeamUnknowns
from BalloonWorkbench.core.types import Floats

#: Weight of the bends of the bulges of a seam.
BENDS = 3e-3
#: A panel that would cross itself is held so much more, so often.
_STIFFER, _TRIES = 30.0, 6
#: Passes of least squares, in which each distance is weighted anew.
_PASSES = 3
_TINY = 1e-12  # of the largest diagonal entry, so that what moves nothing stays


@dataclass(frozen=True)
class LinearStep:
    """Distances (n,) m from the target follow the values: distances + matrix @ values.

    matrix  (n, size + 6), the last six for the balloon's shifts and turns as a whole
    fresh   whether the matrix is that of this balloon, and not learnt from one before it
    """

    unknowns: SeamUnknowns
    current: TargetIterate
    matrix: Floats
    fresh: bool = True

    @classmethod
    def of(
        cls, current: TargetIterate, unknowns: SeamUnknowns, film: Film, backend: str | None
    ) -> LinearStep:
        """That of an iterate, whose seams the unknowns move."""
        moves = unknowns.rest_moves(current.meshed)
        changes = position_changes(current.inflation, film, moves, backend).changes
        positions = current.positions - current.positions.mean(axis=0)
        whole = np.concatenate([changes, rigid_moves(positions / np.ptp(positions))], axis=2)
        return cls(unknowns, current, current.follow(whole))

    def followed(self, values: Floats, reached: TargetIterate) -> LinearStep:
        """That of the balloon on the same mesh which the values (size + 6,) led to.

        The matrix is changed as little as can be so that it gives what has come out (Broyden 1965).
        """
        missed = reached.distances - self.current.distances - self.matrix @ values
        learnt = self.matrix + np.outer(missed, values) / (values @ values)
        return replace(self, current=reached, matrix=learnt, fresh=False)

    def solved(self, aim: Aim, damping: Floats) -> tuple[Floats, float]:
        """The values (size + 6,) m, and the error [m] that they would leave.

        damping  weights (k,) of the moves that the values consist of, in parts of what they do on average
        """
        size, weights = self.unknowns.size, self.current.weights
        away = self.current.distances
        basis, bends = self.unknowns.basis, BENDS * self.unknowns.bends
        values = np.zeros(size + 6)
        for _ in range(_PASSES):
            shares = weights**2 * aim.shares(away + self.matrix @ values)
            normal = self.matrix.T @ (shares[:, None] * self.matrix)
            scale = float(shares.sum())
            strength = float(np.trace(normal[:size, :size])) / size
            normal[:size, :size] += strength * (basis.T * damping) @ basis + scale * (bends.T @ bends)
            normal[np.diag_indices_from(normal)] += _TINY * float(normal.diagonal().max())
            values = np.linalg.solve(normal, self.matrix.T @ (shares * (aim.margin - away)))
        return values, aim.cost(weights, away + self.matrix @ values)

    def unfolded(self, aim: Aim, damping: float, mirrored: MirroredPanels) -> tuple[Bag, Floats, float]:
        """The pattern for the values, these (size + 6,), and the error [m] that they would leave.

        Where a panel would cross itself, its own values are damped more.
        """
        owners = self.unknowns.owners
        weights = np.full(len(owners), damping)
        for _ in range(_TRIES):
            values, left = self.solved(aim, weights)
            bag = self.unknowns.moved(self.current.bag, values[:-6], mirrored)
            folded = [k for k, panel in enumerate(bag.panels) if _folds(panel)]
            if not folded:
                return bag, values, left
            weights[np.isin(owners, [mirrored.first_of(k) for k in folded])] *= _STIFFER
        raise MeshError(
            f"Panel '{bag.panels[folded[0]].name}' crosses itself: divide the body otherwise there."
        )


def _folds(panel: BagPanel) -> bool:
    areas = [signed_area(loop) for loop in panel.loops]
    return areas[0] <= 0.0 or max(areas[1:], default=-1.0) >= 0.0 or first_crossing(panel.loops) is not None
