# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick and how tight a balloon is at the places of its drawing, from its simulation."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.advice.findings import ThicknessMap
from BalloonWorkbench.core.geometry.nearest import locate
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.geometry.triangulation import Located, signed_areas
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats

#: V / A^1.5 of two discs of film: 1.2185 a^3 / (pi a^2)^1.5 (Paulsen, Am. Math. Monthly 101 (1994) 953-958).
DISC = 1.218524 / np.pi**1.5
_TIGHTEST = 100.0  # times as tight as elsewhere
STEPS = 33  # along a line across the balloon
_PLACES = np.arange(200) + 0.5
#: Places that cover a round of radius 1 evenly: each a golden section of the circle further than the last.
_ROUND = np.sqrt(_PLACES / len(_PLACES))[:, None] * direction(np.pi * (3.0 - np.sqrt(5.0)) * _PLACES)


class Gauge:
    """What the rules ask about a balloon; places are those of its drawing [m].

    drawn      where the vertices (n, 2) of the inflation's panel lie in the drawing
    pattern    the seam of its panels as they are cut
    tighter    by how much the notches of the finished balloon will be tighter than those of this one
    """

    def __init__(self, inflation: Inflation, drawn: Floats, pattern: Outline, tighter: float = 1.0) -> None:
        panel = inflation.panel
        self.relative_volume = inflation.volume / pattern.area**1.5 / DISC
        self.pattern = pattern
        self.map = ThicknessMap(drawn, panel.triangles, 2.0 * inflation.positions[:, 2])
        self._positions = inflation.positions
        rim = panel.loops[0]
        self._cut, self._seen = panel.rest_positions[rim], drawn[rim]
        self._located = Located(drawn, panel.triangles)
        self._areas = signed_areas(panel.rest_positions, panel.triangles)
        self._tension = inflation.tensions[:, 0]
        # where nearly all film is slack, as in a tiny balloon, no place is told as endlessly tight
        median = max(_median(self._tension, self._areas), float(self._tension.max()) / _TIGHTEST)
        self._median = median / tighter

    @property
    def thickest(self) -> float:
        """Greatest thickness [m]."""
        return float(self.map.thickness.max())

    def thickness(self, points: Floats) -> Floats:
        """Thickness (k,) m at points (k, 2)."""
        return self._located.values(self.map.thickness[:, None], points)[:, 0]

    def tube(self, start: Floats, end: Floats) -> float:
        """Flat width [m] of the tube of film with as much room inside as the balloon has between two points.

        A tube of flat width w has the cross-section w^2 / pi.
        """
        line = start + np.linspace(0.0, 1.0, STEPS)[:, None] * (end - start)
        x, y, z = self._located.values(self._positions, line).T
        room = float((z[1:] + z[:-1]) @ np.hypot(np.diff(x), np.diff(y)))  # twice the mean height
        return float(np.sqrt(np.pi * max(room, 0.0)))

    def drawn(self, place: Floats) -> Floats:
        """The place of the drawing that the same vertices of the seam are near to."""
        return point_at(self._seen, arc_lengths(self._cut), locate(self._cut, place[None]))[0]

    def peak(self, place: Floats, reach: float) -> float:
        """Mean tension within `reach` [m] of a place over the balloon's median.

        Over the area within reach, whatever the triangles: they may be as large as that.
        """
        near = self._located.under(place + reach * _ROUND)
        return float(self._tension[near].mean()) / max(self._median, 1e-300)


def _median(values: Floats, weights: Floats) -> float:
    order = np.argsort(values, kind="stable")
    share = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(share, 0.5 * share[-1])])
