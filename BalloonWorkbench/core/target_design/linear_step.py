# SPDX-License-Identifier: LGPL-2.1-or-later
"""The change of the seams that brings a balloon nearest to its target, as far as it follows linearly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.target_design.iterate import TargetIterate
from BalloonWorkbench.core.target_design.mirrored_panels import MirroredPanels
from BalloonWorkbench.core.target_design.off_target import rigid_moves
from BalloonWorkbench.core.target_design.seam_unknowns import SeamUnknowns
from BalloonWorkbench.core.types import Floats

#: Weight of the bends of the bulges of a seam.
BENDS = 1e-2
#: A panel that would cross itself is held so much more, so often.
_STIFFER, _TRIES = 30.0, 6


@dataclass(frozen=True)
class LinearStep:
    """Least squares: weighted distances (n,) m plus matrix @ values shall be small.

    basis   (size, k) of the unknowns' values that keep the seams equally long
    matrix  (n, k + 6), the last six for the balloon's shifts and turns as a whole
    """

    unknowns: SeamUnknowns
    basis: Floats
    matrix: Floats
    away: Floats

    @classmethod
    def of(
        cls, current: TargetIterate, spans: list[int], film: Film, margin: float, backend: str | None
    ) -> LinearStep:
        """That of an iterate; margin [m] from the target to the surface that is wanted."""
        unknowns = SeamUnknowns.of(current.bag, spans)
        moves = unknowns.rest_moves(current.meshed)
        changes = position_changes(current.inflation, film, moves, backend).changes
        follows = np.einsum("ni,nik->nk", current.off.directions, changes)
        basis = unknowns.allowed()
        positions = current.positions - current.positions.mean(axis=0)
        rigid = rigid_moves(positions / np.ptp(positions), current.off.directions)
        matrix = current.weights[:, None] * np.column_stack([follows @ basis, rigid])
        return cls(unknowns, basis, matrix, current.weights * (current.off.distances - margin))

    def solved(self, damping: Floats) -> tuple[Floats, float]:
        """The values (size,) m, and the error [m] that they would leave.

        damping  weights (size,) of the values, in parts of what they do on average
        """
        free = self.basis.shape[1]
        strength = np.sqrt((self.matrix[:, :free] ** 2).sum() / free)
        small = strength * np.sqrt(damping)[:, None] * self.basis
        bends = BENDS * self.unknowns.bends @ self.basis
        held = np.pad(np.concatenate([small, bends]), ((0, 0), (0, 6)))
        goals = np.concatenate([-self.away, np.zeros(len(held))])
        values = np.linalg.lstsq(np.concatenate([self.matrix, held]), goals, rcond=None)[0]
        left = float(np.linalg.norm(self.matrix @ values + self.away))
        return np.asarray(self.basis @ values[:free]), left

    def unfolded(self, damping: float, mirrored: MirroredPanels) -> tuple[Bag, float]:
        """The pattern for the values, with mirrored panels, and the error [m] that it would leave.

        Where a panel would cross itself, its own values are damped more.
        """
        weights = np.full(self.unknowns.size, damping)
        for _ in range(_TRIES):
            values, left = self.solved(weights)
            bag = self.unknowns.moved(values, mirrored)
            folded = [k for k, panel in enumerate(bag.panels) if _folds(panel)]
            if not folded:
                return bag, left
            weights[np.isin(self.unknowns.owners, folded)] *= _STIFFER
        raise MeshError(
            f"Panel '{bag.panels[folded[0]].name}' crosses itself: divide the body otherwise there."
        )


def _folds(panel: BagPanel) -> bool:
    areas = [signed_area(loop) for loop in panel.loops]
    return areas[0] <= 0.0 or max(areas[1:], default=-1.0) >= 0.0 or first_crossing(panel.loops) is not None
