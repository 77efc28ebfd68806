# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the film of each panel does: how much of it there is, how hard it pulls, how much of it wrinkles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.results.film_state import FilmState, State, film_state
from BalloonWorkbench.core.solver.inflation import Inflation


@dataclass(frozen=True)
class PanelState:
    """One panel of an inflated balloon.

    area                     m2, of the flat panel
    largest_tension          N/m, the largest principal tension that a hundredth of its area does not exceed
    taut, wrinkled, slack    parts of its area
    """

    area: float
    largest_tension: float
    taut: float
    wrinkled: float
    slack: float


def panel_states(inflation: Inflation, film: Film) -> list[PanelState]:
    """The state of each panel of a balloon made of this film, in their order in the assembly."""
    whole = film_state(inflation, film)
    ends = np.cumsum([len(panel.triangles) for panel in inflation.assembly.panels])
    return [
        _of(whole, slice(end - len(panel.triangles), end))
        for panel, end in zip(inflation.assembly.panels, ends)
    ]


def _of(whole: FilmState, part: slice) -> PanelState:
    areas, tensions = whole.areas[part], whole.tensions[part, 0]
    order = np.argsort(tensions)
    most = np.searchsorted(np.cumsum(areas[order]), 0.99 * areas.sum())
    shares = {state: float(areas[whole.state[part] == state].sum() / areas.sum()) for state in State}
    return PanelState(
        float(areas.sum()),
        float(tensions[order][min(int(most), len(order) - 1)]),
        shares[State.TAUT],
        shares[State.WRINKLED],
        shares[State.SLACK],
    )
