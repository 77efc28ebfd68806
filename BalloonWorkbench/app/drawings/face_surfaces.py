# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a solid that unroll: planes, cylinders, cones, and curves that were moved straight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD as App
import numpy as np

from BalloonWorkbench.core.flattening.developable import CONE, CYLINDER, EXTRUSION, PLANE, Developable
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, to_mm

#: Places and weights of the integration between two points of a section.
_GAUSS = np.polynomial.legendre.leggauss(8)
#: A section is integrated in so many spans at least.
_SPANS = 64
#: Rulings that turn from each other by less are parallel.
_PARALLEL = 1e-9
#: Newton's method, for the parameter of a point.
_PASSES = 4


def developable_of(face) -> Developable | None:
    """The surface of a face, if it unrolls."""
    surface = face.Surface
    kind = type(surface).__name__
    if kind == "Plane" or surface.isPlanar():
        plane = surface if kind == "Plane" else face.findPlane()
        return Developable(PLANE, _place(plane.Position), _direction(plane.Axis))
    if kind == "Cylinder":
        return Developable(
            CYLINDER, _place(surface.Center), _direction(surface.Axis), from_mm(surface.Radius)
        )
    if kind == "Cone":
        return Developable(CONE, _place(surface.Apex), _direction(surface.Axis), abs(surface.SemiAngle))
    section = None
    if kind == "SurfaceOfExtrusion":
        section = _Section(
            surface, surface.BasisCurve, 0, _direction(surface.Direction), face.ParameterRange[0]
        )
    elif kind == "BSplineSurface":
        section = _spline_section(face)
    if section is None:
        return None
    return Developable(EXTRUSION, np.zeros(3), section.axis, section.round(), section.along)


def _spline_section(face) -> _Section | None:
    """The section of a spline surface whose rulings are all parallel."""
    surface = face.Surface
    low, _, left, _ = face.ParameterRange
    kinds = (
        (0, surface.NbVPoles, surface.VDegree, lambda: surface.vIso(left)),
        (1, surface.NbUPoles, surface.UDegree, lambda: surface.uIso(low)),
    )
    poles, weights = (
        np.array([[tuple(at) for at in row] for row in surface.getPoles()]),
        np.array(surface.getWeights()),
    )
    for index, count, degree, section in kinds:
        if (count, degree) != (2, 1):
            continue
        ends, loads = (each if index == 0 else np.swapaxes(each, 0, 1) for each in (poles, weights))
        rulings = ends[:, 1] - ends[:, 0]
        mean = rulings.mean(axis=0)
        off = np.linalg.norm(np.cross(rulings, mean), axis=1).max()
        if off <= _PARALLEL * float(mean @ mean) and np.ptp(loads, axis=1).max() <= _PARALLEL:
            start = (low, left)[index]
            return _Section(surface, section(), index, _direction(mean), start)
    return None


@dataclass(frozen=True)
class _Section:
    """The section of an extrusion, square to its axis.

    curve  along the section; index: which parameter of the surface is that of the curve
    start  the parameter at which lengths begin
    """

    surface: Any
    curve: Any
    index: int
    axis: Floats
    start: float

    def round(self) -> float:
        """Its length all round [m]; 0 where it is not closed."""
        first, last = self.surface.bounds()[2 * self.index : 2 * self.index + 2]
        closed = self.surface.isUClosed() if self.index == 0 else self.surface.isVClosed()
        return float(np.ptp(self.lengths(np.array([first, last])))) if closed else 0.0

    def along(self, points: Floats) -> Floats:
        """How far along it places (k, 3) m lie: (k,) m."""
        places = to_mm(points)
        values = np.array([self.surface.parameter(App.Vector(*at))[self.index] for at in places.tolist()])
        curve = self.curve
        first, last = (-np.inf, np.inf) if curve.isPeriodic() else (curve.FirstParameter, curve.LastParameter)
        for _ in range(_PASSES):  # what FreeCAD finds is not exact, and at the ends of a section not near
            here, ahead = (self._square(each) for each in self._curve(values))
            steps = ((self._square(places) - here) * ahead).sum(axis=1) / (ahead**2).sum(axis=1)
            values = np.clip(values + steps, first, last)
        return self.lengths(values)

    def _curve(self, values: Floats) -> tuple[Floats, Floats]:
        """Places (k, 3) mm of the section's curve at parameters (k,), and its derivatives there."""
        derivatives = [[tuple(each) for each in self.curve.getD1(value)] for value in values.tolist()]
        both = np.array(derivatives).reshape(-1, 2, 3)
        return both[:, 0], both[:, 1]

    def _square(self, vectors: Floats) -> Floats:
        """The parts of vectors (k, 3) that are square to the axis."""
        return vectors - np.outer(vectors @ self.axis, self.axis)

    def lengths(self, values: Floats) -> Floats:
        """Lengths (k,) m up to parameters (k,)."""
        knots = getattr(self.curve, "getKnots", list)()
        ends = np.append(values, self.start)
        inner = [knot for knot in knots if ends.min() < knot < ends.max()]
        even = np.linspace(ends.min(), ends.max(), _SPANS)
        stops = np.unique(np.concatenate([ends, inner, even]))
        middles, halves = 0.5 * (stops[1:] + stops[:-1]), 0.5 * np.diff(stops)
        at = middles[:, None] + halves[:, None] * _GAUSS[0]
        speeds = np.linalg.norm(self._square(self._curve(at.ravel())[1]), axis=1).reshape(at.shape)
        lengths = np.append(0.0, np.cumsum(halves * (speeds @ _GAUSS[1])))
        here = lengths[np.searchsorted(stops, ends)]
        return np.asarray(from_mm(here[:-1] - here[-1]))


def _place(at) -> Floats:
    return np.asarray(from_mm(np.array(tuple(at))))


def _direction(of) -> Floats:
    there = np.array(tuple(of))
    return np.asarray(there / np.linalg.norm(there))
