# SPDX-License-Identifier: LGPL-2.1-or-later
"""How thick and how tight the balloon is where: predicted from the outline, or measured from a simulation."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from BalloonWorkbench.core.advice.findings import ThicknessMap
from BalloonWorkbench.core.geometry.nearest import locate
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.geometry.triangulation import Located, signed_areas
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.start import DOME, dome
from BalloonWorkbench.core.types import Bools, Floats

#: V / A^1.5 of two discs of film: 1.2185 a^3 / (pi a^2)^1.5 (Paulsen, Am. Math. Monthly 101 (1994) 953-958).
DISC = 1.218524 / np.pi**1.5
#: Volume of a balloon over that under twice the dome of its flat film, since the seam draws in: 0.646 for a
#: disc, 0.637 for a long strip, less where notches hold the seam.
DRAWN_IN = 0.645
#: What a corrected pattern changes, means of the validation study: thickness over that of the drawing's own
#: film, puffiness; and the width of its film over the drawn width in a neck, a tube's.
FITTED_THICKNESS, FITTED_PUFFINESS = 1.35, 1.07
NARROW_GROWTH = np.pi / 2.0
#: Thickness near a point over the dome's, where the film is held from two sides: as cut, and corrected.
AT_TIPS, FITTED_AT_TIPS = 0.91, 1.0
#: Tension round a notch over the median: PEAK (g / L)^2 / (m / L)^1.6 with g the mean slope of u there, m its
#: median, L the size. A twisted bar has its stress peaks where Prandtl's function u is steep; here the
#: numbers are those of the validation study.
PEAK, PEAK_POWER = 1.72, 1.6
#: With a corrected pattern it is another one, since the film is larger where it is thin: with these powers of
#: g / L, m / L and the part A / L^2 of the square that is filled, falling by e for so much puffiness and for
#: such a radius / L of the notch. From 225 shapes of the study, with seeds of their own.
FITTED_PEAK, FITTED_SLOPE, FITTED_MEDIAN, FITTED_FILLED = 3900.0, 1.84, 0.72, -1.07
FITTED_PUFFED, FITTED_ROUND = 1.0 / 4.53, 1.0 / 4.45
VERTICES = 400  # of the mesh for a prediction
STEPS = 33  # along a line across the balloon


class Gauge(ABC):
    """What the rules ask about a balloon, at places of its drawing [m]."""

    map: ThicknessMap
    puffiness: float
    inflated: bool
    at_tips: float = 1.0  # true thickness near a point over what `thickness` says

    @property
    def thickest(self) -> float:
        """Greatest thickness [m]."""
        return float(self.map.thickness.max())

    @abstractmethod
    def thickness(self, points: Floats) -> Floats:
        """Thickness (k,) m at points (k, 2)."""

    @abstractmethod
    def tube(self, start: Floats, end: Floats) -> float:
        """Flat width [m] of the tube of film with as much room inside as the balloon has between two points.

        A tube of flat width w has the cross-section w^2 / pi.
        """

    def drawn(self, place: Floats) -> Floats:
        """Where in the drawing a place (2,) m of the seam lies; the same where neither was moved."""
        return place

    @abstractmethod
    def peak(self, place: Floats, reach: float, radius: float) -> float:
        """Mean tension within `reach` [m] of a notch of a radius [m] over the balloon's median."""


class Predicted(Gauge):
    """From the outline alone: the dome z = 2 sqrt(2) / pi sqrt(u), -Laplace(u) = 1, over its film.

    It is exact for a long strip, 1.5 % low for a disc. fitted: the pattern will be made larger until the
    balloon is as large as the outline; else the outline is the pattern.
    """

    inflated = False

    def __init__(self, outline: Outline, fitted: bool) -> None:
        panel = triangulate(outline, size_for(outline, VERTICES))
        height = 2.0 * dome(panel)[:, 2]
        self._size = max(outline.size)
        shape, _ = gradients(panel.rest_positions[panel.triangles])
        u = (0.5 * height / DOME) ** 2
        self._slope = np.linalg.norm(np.einsum("mai,ma->mi", shape, u[panel.triangles]), axis=1)
        self._centres = panel.rest_positions[panel.triangles].mean(axis=1)
        areas = signed_areas(panel.rest_positions, panel.triangles)
        self._areas = areas
        self._median = _median(self._slope, areas)
        volume = DRAWN_IN * float(areas @ height[panel.triangles].mean(axis=1))
        self.puffiness = volume / float(areas.sum()) ** 1.5 / DISC
        self._growth = NARROW_GROWTH if fitted else 1.0
        self._fitted = fitted
        self.at_tips = FITTED_AT_TIPS if fitted else AT_TIPS
        if fitted:
            height *= FITTED_THICKNESS
            self.puffiness *= FITTED_PUFFINESS
        self.map = ThicknessMap(panel.rest_positions, panel.triangles, height)
        self._located = Located(panel.rest_positions, panel.triangles)

    def thickness(self, points: Floats) -> Floats:
        """Thickness (k,) m at points (k, 2)."""
        return self._located.values(self.map.thickness[:, None], points)[:, 0]

    def tube(self, start: Floats, end: Floats) -> float:
        """The film that is drawn between two points."""
        return self._growth * float(np.linalg.norm(end - start))

    def peak(self, place: Floats, reach: float, radius: float) -> float:
        """Mean tension round a place over the median."""
        near = _near(self._centres, place, reach)
        mean = float(self._slope[near] @ self._areas[near] / self._areas[near].sum())
        steep, usual = mean / self._size, self._median / self._size
        if not self._fitted:
            return PEAK * steep**2 / usual**PEAK_POWER
        filled = float(self._areas.sum()) / self._size**2
        fall = self.puffiness / FITTED_PUFFED + radius / self._size / FITTED_ROUND
        powers = steep**FITTED_SLOPE * usual**FITTED_MEDIAN * filled**FITTED_FILLED
        return float(FITTED_PEAK * powers * np.exp(-fall))


class Measured(Gauge):
    """From a simulation. fitted: the balloon lies on its drawing; else its flat film does."""

    inflated = True

    def __init__(self, inflation: Inflation, fitted: bool) -> None:
        panel = inflation.panel
        areas = signed_areas(panel.rest_positions, panel.triangles)
        self.puffiness = inflation.volume / float(areas.sum()) ** 1.5 / DISC
        flat = inflation.positions[:, :2] if fitted else panel.rest_positions
        self.map = ThicknessMap(flat, panel.triangles, 2.0 * inflation.positions[:, 2])
        self._positions = inflation.positions
        rim = panel.seams[0]
        self._cut, self._seen = panel.rest_positions[rim], flat[rim]
        self._located = Located(flat, panel.triangles)
        self._centres = flat[panel.triangles].mean(axis=1)
        self._areas = areas
        self._tension = inflation.tensions[:, 0]
        self._median = _median(self._tension, areas)

    def thickness(self, points: Floats) -> Floats:
        """Thickness (k,) m at points (k, 2)."""
        return self._located.values(self.map.thickness[:, None], points)[:, 0]

    def tube(self, start: Floats, end: Floats) -> float:
        """The room between two points, as film of a tube."""
        line = start + np.linspace(0.0, 1.0, STEPS)[:, None] * (end - start)
        x, y, z = self._located.values(self._positions, line).T
        room = float((z[1:] + z[:-1]) @ np.hypot(np.diff(x), np.diff(y)))  # twice the mean height
        return float(np.sqrt(np.pi * max(room, 0.0)))

    def drawn(self, place: Floats) -> Floats:
        """The place of the outline that the same vertices of the seam are near to."""
        return point_at(self._seen, arc_lengths(self._cut), locate(self._cut, place[None]))[0]

    def peak(self, place: Floats, reach: float, radius: float) -> float:
        """Mean tension round a place over the median."""
        near = _near(self._centres, place, reach)
        mean = float(self._tension[near] @ self._areas[near] / self._areas[near].sum())
        return mean / max(self._median, 1e-300)


def _near(centres: Floats, place: Floats, reach: float) -> Bools:
    """The triangles within reach of a place, the nearest one at least."""
    away = np.linalg.norm(centres - place, axis=1)
    return np.asarray(away <= max(reach, float(away.min())))


def _median(values: Floats, weights: Floats) -> float:
    order = np.argsort(values, kind="stable")
    share = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(share, 0.5 * share[-1])])
