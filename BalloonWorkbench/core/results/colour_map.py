# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as colours: what is shown on the film, on which scale, with which ticks in the legend.

The scale runs from dark violet to yellow; its lightness (CIE L*) grows evenly, so that equal steps look
equal, in grey too and to eyes that confuse red with green.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import trimmed
from BalloonWorkbench.core.geometry.nearest import nearest_places
from BalloonWorkbench.core.geometry.polyline import arc_lengths
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.geometry.vectors import norm
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results.result_files import Results
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import to_mm

#: Stops of the scale at equal distances, the lowest value first: the scale known as viridis.
SCALE = (
    *("#440154", "#482878", "#3e4989", "#31688e", "#26828e"),
    *("#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"),
)
TENSION, WRINKLES, STATE = "Tension", "Wrinkles", "Film state"
THICKNESS, STRAIN, RESIDUAL, DISTANCE = "Thickness", "Strain", "Residual", "Distance"
KINDS = (TENSION, WRINKLES, STATE, THICKNESS, STRAIN, RESIDUAL, DISTANCE)
UNITS = {
    TENSION: "N/m",
    WRINKLES: "%",
    STATE: "",
    THICKNESS: "mm",
    STRAIN: "%",
    RESIDUAL: "mm",
    DISTANCE: "mm",
}
STATES = ("slack", "wrinkled", "taut")
_ODD = 0.005  # part of the area that may lie beyond the end of the scale: a few triangles in sharp tips
_SAMPLES = 600  # along the longest loop of the silhouette
_PERCENT = 100.0
_NOTHING = 1e-9  # a scale needs an end


@dataclass(frozen=True)
class ColourMap:
    """Values on the film.

    shares   (m, 3) places on the scale, 0 to 1, of the three corners of each triangle of all panels
    top      value at the end of the scale, in `unit`; its begin is 0
    largest  the largest value, which may lie beyond the end of the scale
    place    (3,) mm, where that is; None where no spot stands out
    """

    kind: str
    shares: Floats
    top: float
    largest: float
    place: Floats | None = None

    @property
    def unit(self) -> str:
        """Unit of `top`, `largest` and the ticks."""
        return UNITS[self.kind]


@dataclass(frozen=True)
class Distances:
    """How far the silhouette is from the drawing, place by place.

    loops      of the silhouette, (k, 2) m, points evenly along each
    nearest    (k, 2) m, the nearest point of the drawing to each of them
    distances  (k,) mm
    missed     the point of the drawing that is farthest from the silhouette: the nearest point of that, the
               point itself, mm
    """

    loops: tuple[Floats, ...]
    nearest: tuple[Floats, ...]
    distances: tuple[Floats, ...]
    missed: tuple[Floats, Floats, float]

    @property
    def largest(self) -> tuple[Floats, Floats, float]:
        """A point of the silhouette and one of the drawing where they are farthest apart, mm, either way."""
        loop = max(range(len(self.loops)), key=lambda number: float(self.distances[number].max()))
        place = int(np.argmax(self.distances[loop]))
        own = self.loops[loop][place], self.nearest[loop][place], float(self.distances[loop][place])
        return max(own, self.missed, key=lambda each: each[2])


def colours(shares: Floats) -> NDArray[np.uint8]:
    """Colours (..., 3) from 0 to 255 of places on the scale, 0 to 1."""
    stops = np.array([[int(stop[k : k + 2], 16) for k in (1, 3, 5)] for stop in SCALE], dtype=np.float64)
    at = np.linspace(0.0, 1.0, len(stops))
    return np.stack([np.rint(np.interp(shares, at, stops[:, k])) for k in range(3)], axis=-1).astype(np.uint8)


def kinds_of(inflation: Inflation, *, compared: bool = False) -> tuple[str, ...]:
    """What can be shown; compared: many panels were made for a profile or a drawing."""
    if inflation.assembly.mirror:
        return tuple(kind for kind in KINDS if kind != DISTANCE)
    hidden = (THICKNESS, RESIDUAL) if compared else (THICKNESS, RESIDUAL, DISTANCE)
    return tuple(kind for kind in KINDS if kind not in hidden)


def film_map(results: Results, kind: str) -> ColourMap:
    """One of the results on the film: any kind but RESIDUAL and DISTANCE, see `distances`, `distance_map`.

    Values of triangles are averaged over those around a vertex, in the same panel, by area.
    """
    faces = results.triangles
    if kind == STATE:
        shares = 0.5 * results.of_triangles["state"][:, None] * np.ones(3)
        return ColourMap(kind, shares, 1.0, 1.0)
    if kind == THICKNESS:
        values = results.of_vertices["thickness_mm"]
        top = largest = max(float(values.max()), _NOTHING)
        place = results.positions[int(np.argmax(values))]
    else:
        name = {TENSION: "tension_N_per_m", WRINKLES: "wrinkle_intensity", STRAIN: "strain"}[kind]
        own = results.of_triangles[name] * (1.0 if kind == TENSION else _PERCENT)
        areas = _areas(results)
        weights = np.bincount(faces.ravel(), np.repeat(areas, 3), len(results.positions))
        sums = np.bincount(faces.ravel(), np.repeat(areas * own, 3), len(results.positions))
        values = np.maximum(sums / np.where(weights > 0.0, weights, 1.0), 0.0)
        order = np.argsort(own)
        quantile = np.searchsorted(np.cumsum(areas[order]), (1.0 - _ODD) * areas.sum())
        largest = max(float(own.max()), _NOTHING)
        top = max(float(own[order][min(quantile, len(own) - 1)]), _NOTHING)
        place = results.positions[faces[int(np.argmax(own))]].mean(axis=0)
    shares = np.clip(values / top, 0.0, 1.0)[faces]
    return ColourMap(kind, shares, top, largest, None if kind == WRINKLES else place)


def distance_map(results: Results, error: Residual | None) -> ColourMap:
    """How far the film is from what it was made for, the same colours inside and outside.

    error  of the design, by which the scale ends: discs of gores bulge farther, and folds in a few triangles
    """
    values = np.abs(results.of_vertices["distance_mm"])
    largest = float(values.max()) if error is None else to_mm(error.max)
    top = max(largest if error is None else min(largest, 2.0 * to_mm(error.p95)), _NOTHING)
    return ColourMap(
        DISTANCE, np.clip(values / top, 0.0, 1.0)[results.triangles], top, max(largest, _NOTHING)
    )


def distances(inflation: Inflation, drawing: Outline) -> Distances:
    """How far an inflated balloon's silhouette is from the drawing. Raises MissingPackageError."""
    visible = silhouette(trimmed(inflation)).loops  # as the residual is measured
    spacing = max(float(arc_lengths(loop)[-1]) for loop in visible) / _SAMPLES
    loops = tuple(evenly(loop, spacing) for loop in visible)
    nearest = tuple(nearest_places(drawing.loops, loop) for loop in loops)
    lengths = tuple(to_mm(norm(ends - loop)) for ends, loop in zip(nearest, loops, strict=True))
    places = np.concatenate([evenly(loop, spacing) for loop in drawing.loops])
    ends = nearest_places(visible, places)
    away = to_mm(norm(ends - places))
    worst = int(np.argmax(away))
    return Distances(loops, nearest, lengths, (ends[worst], places[worst], float(away[worst])))


def ticks(top: float, most: int = 6) -> list[float]:
    """Round numbers from 0 up to `top`: multiples of 1, 2 or 5 times a power of ten, at most so many."""
    rough = top / (most - 1)
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= rough * (1.0 - 1e-9))
    return [number * step for number in range(int(top / step * (1.0 + 1e-9)) + 1)]


def _areas(results: Results) -> Floats:
    """Of the flat triangles [mm2]."""
    return np.abs(signed_areas(results.of_vertices["flat_mm"][:, :2], results.triangles))
