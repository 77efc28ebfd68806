# SPDX-License-Identifier: LGPL-2.1-or-later
"""When a balloon is at rest, by its outline and its volume.

The eye sees the outline, which is the seam, and the volume. The last steps of a solve move only crumples. A
balloon that still sinks slowly shows it in both, step after step, though a step hardly lowers its energy.

Neither shows the tensions of a stiff film, which change while it hardly moves. What the film stores is a
small part of the energy of the pressure, some 0.1 to 1.3 over its membrane stiffness k = E t / (p L), and it
grows with the tensions squared: a step that lowers the energy by a tenth of it changes them by a third. So
what a step may still bring is a part of what the film stores. The forces across planes through hearts, stars,
animals, rings, letters and strips are then within 2.2 % of what the pressure asks for; they were 5 to 25 %
off for some of them where it was a part of the whole energy.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.solver.problem import Energies
from BalloonWorkbench.core.types import Bools, Floats

# The native solver is given these numbers (c_interface.py): both must take the same steps. In units of
# the tolerance on the energy, or of its root for the seam, whose movements the energy grows with squared.
STILL_DECREMENT = 600.0  # predicted decrease, relative, times the membrane stiffness
STILL_VOLUME = 10.0  # change in a whole step, relative
STILL_SEAM = 0.1  # movement in a whole step, root mean square
STILL_STEPS = 2  # in a row


def film_tolerance(tolerance: float, stiffness: float) -> float:
    """The tolerance on the energy where a film is so stiff that it stores little of it."""
    return tolerance * min(1.0, STILL_DECREMENT / stiffness)


class Convergence:
    """Counts the steps of a solve after which outline and volume stay.

    fixed (n, 5) as in the problem, whose membrane stiffness is given; tolerance as film_tolerance gives it
    """

    def __init__(self, fixed: Bools, tolerance: float, stiffness: float) -> None:
        self._seam = np.flatnonzero(fixed[:, 2] & ~fixed[:, 0] & ~fixed[:, 1])
        self._tolerance = tolerance
        self._decrement = STILL_DECREMENT / stiffness * tolerance
        self._steps = 0

    def at_rest(
        self,
        before: Floats,
        after: Floats,
        energy: Energies,
        next_energy: Energies,
        length: float,
        decrement: float,
        held_back: bool,
    ) -> bool:
        """Whether this step and the one before left the balloon as it was; never without a seam, nor for a
        step that was held back, which says little.

        Positions (n, 3) and energies before and after a part, length, of a Newton step, and its decrement.
        """
        whole = self._tolerance * length
        still = (
            not held_back
            and len(self._seam) > 0
            and decrement <= self._decrement * abs(next_energy.total)
            and abs(next_energy.pressure - energy.pressure)
            <= STILL_VOLUME * whole * abs(next_energy.pressure)
            and self._movement(before, after) <= STILL_SEAM * np.sqrt(self._tolerance) * length
        )
        self._steps = self._steps + 1 if still else 0
        return self._steps >= STILL_STEPS

    def _movement(self, before: Floats, after: Floats) -> float:
        """Of the seam, root mean square, without what it moves and turns as a whole."""
        place = before[self._seam, :2]
        move = after[self._seam, :2] - place
        place = place - place.mean(axis=0)
        move = move - move.mean(axis=0)
        turn = (place[:, 0] @ move[:, 1] - place[:, 1] @ move[:, 0]) / np.sum(place**2)
        move += turn * place[:, ::-1] * (1.0, -1.0)
        return float(np.sqrt(np.sum(move**2) / len(move)))
