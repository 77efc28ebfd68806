# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work without a progress of its own is stopped within a small part of it."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.advice.advise import advise
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.checkpoint import checkpoint, stoppable
from BalloonWorkbench.core.errors import Cancelled
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.film import DEFAULT_FILM


class Asked:
    """A progress that counts, and says stop after so many."""

    def __init__(self, most: float = np.inf) -> None:
        self.count, self.most = 0, most

    def __call__(self, fraction: float, text: str) -> bool:
        self.count += 1
        return self.count < self.most


def scattered() -> np.ndarray:
    """A loop that takes many arcs, another one at each call: curves are remembered."""
    loop = NAMED["heart"].outer
    return np.asarray(loop + np.random.default_rng().normal(0.0, 2e-5, loop.shape))


def test_the_search_for_arcs_asks_for_each_of_them() -> None:
    asked = Asked()
    with stoppable(asked):
        curve = fit_curve(scattered(), True)
    assert asked.count >= len(curve)


def test_a_search_that_was_stopped_leaves_nothing_behind() -> None:
    loop = scattered()
    asked = Asked(5)
    with pytest.raises(Cancelled), stoppable(asked):
        fit_curve(loop, True)
    assert asked.count == 5
    fitted = fit_curve(loop, True)
    with stoppable(Asked(1)):
        again = fit_curve(loop, True)  # known: nothing to stop
    assert np.array_equal(again.joints, fitted.joints)


def test_the_coach_asks_before_each_rule() -> None:
    asked = Asked()
    with stoppable(asked):
        advise(NAMED["heart"], film(DEFAULT_FILM))
    assert asked.count >= 7


def test_work_outside_is_not_stopped() -> None:
    with pytest.raises(Cancelled), stoppable(Asked(1)):
        checkpoint()
    checkpoint()
