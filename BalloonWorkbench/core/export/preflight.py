# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look before a file is written: will this machine make that pattern?"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.export.drawing import BAR, BAR_ROOM
from BalloonWorkbench.core.export.machine import Machine
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.arcs import TOLERANCE, fit_curve
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import INCH, from_mm, mm_text, place_text, to_mm

ERROR, WARNING = "error", "warning"

#: Samples along a line for the search of narrow places [m].
_SPACING = from_mm(0.25)
#: Two places of one line are a gap between them when the way along it is so many times as long as across.
_WAY_ROUND = 3.0
#: Share of the tolerance with which a radius that is too small is measured once more.
_FINE = 0.25
#: Half of a turn beyond which a bend is as good as a corner [rad].
_SHARPEST = 1.4
_CUTS = (Role.CUT_INNER, Role.CUT)
#: Lines whose bends matter to a machine that only welds; to one that cuts they are marks.
_WELDS = (Role.SEAL, Role.WELD)


@dataclass(frozen=True)
class Finding:
    """One remark: ERROR when the file would be of no use, else WARNING; a place (2,) m where it has one."""

    severity: str
    text: str
    place: Floats | None = None


def preflight(pattern: Pattern, machine: Machine) -> tuple[Finding, ...]:
    """Everything that is wrong or doubtful about a pattern on a machine, errors first."""
    taken = [contour for contour in pattern.contours if contour.role in machine.layers]
    findings = [*_closed(taken), *_simple(taken)]
    if not any(finding.severity == ERROR for finding in findings):
        cuts = [contour for contour in taken if contour.role in _CUTS]
        findings += _radius(cuts or [contour for contour in taken if contour.role in _WELDS], machine)
        findings += _gap(taken, machine)
    findings += _size(pattern, machine)
    return tuple(sorted(findings, key=lambda finding: finding.severity != ERROR))


def film_preflight(film: Film, machine: Machine) -> tuple[Finding, ...]:
    """What a machine does that a film does not take."""
    name = film.title or film.name
    if machine.process == "laser" and film.laser is False:
        return (Finding(ERROR, f"{name} must never be cut with a laser: choose a machine with a knife."),)
    if machine.process == "heat-sealing" and film.joining not in ("", "heat"):
        return (Finding(WARNING, f"{name} is not joined by heat: {machine.title} is not made for it."),)
    return ()


def _closed(contours: list[Contour]) -> list[Finding]:
    return [
        Finding(
            ERROR,
            f"The {contour.role.value} line that begins at {place_text(contour.points[0])} is open: programs"
            " fill, offset and cut closed lines only. Close it.",
            contour.points[0],
        )
        for contour in contours
        if contour.role in _CUTS and not contour.closed
    ]


def _simple(contours: list[Contour]) -> list[Finding]:
    """Lines that cross themselves or each other."""
    package = shapely()
    findings = []
    lines = [_line(contour) for contour in contours]
    for contour, line in zip(contours, lines):
        if not line.is_simple:
            place = _crossing(contour)
            findings.append(
                Finding(
                    ERROR,
                    f"The {contour.role.value} line crosses itself near {place_text(place)}:"
                    " simplify the drawing there.",
                    place,
                )
            )
    cuts = [(contour, line) for contour, line in zip(contours, lines) if contour.role in _CUTS]
    for k, (contour, line) in enumerate(cuts):
        for other, other_line in cuts[k + 1 :]:
            met = line.intersection(other_line)
            if not met.is_empty:
                place = package.get_coordinates(met)[0]
                findings.append(
                    Finding(
                        ERROR,
                        f"{contour.role.value} and {other.role.value} lines meet near {place_text(place)}:"
                        " move the hole inward or make the allowance narrower.",
                        place,
                    )
                )
    return findings


def _radius(contours: list[Contour], machine: Machine) -> list[Finding]:
    """The tightest bend between corners; corners themselves are meant."""
    least: tuple[float, Floats] | None = None
    for contour in contours:
        radius, place = _tightest(contour, TOLERANCE, machine.least_radius)
        if radius < machine.least_radius:
            radius, place = _tightest(contour, _FINE * TOLERANCE, machine.least_radius)
        if least is None or radius < least[0]:
            least = radius, place
    if least is None or least[0] >= machine.least_radius - TOLERANCE:
        return []
    return [
        Finding(
            WARNING,
            f"The smallest radius is {to_mm(least[0]):.2g} mm, near {place_text(least[1])};"
            f" {machine.title} follows {mm_text(machine.least_radius)}. It will come out rounder there.",
            least[1],
        )
    ]


def _tightest(contour: Contour, tolerance: float, followed: float) -> tuple[float, Floats]:
    """The smallest radius of a contour, and where it is.

    Bends do not count that a tool which follows some radius [m] leaves by less than the curves' tolerance.
    """
    curve = fit_curve(contour.points, contour.closed, tolerance)
    radii, turns = curve.radii, curve.turns
    together = turns.copy()  # neighbouring tight arcs are one bend
    tight = (radii < followed) & (np.append(False, turns[1:] * turns[:-1] > 0.0))
    for k in np.flatnonzero(tight & np.append(False, radii[:-1] < followed)):
        together[k] += together[k - 1]
    half = np.minimum(0.5 * np.abs(together), _SHARPEST)
    counts = (followed - np.minimum(radii, followed)) * (1.0 / np.cos(half) - 1.0) > TOLERANCE
    number = int(np.argmin(np.where(counts | (radii >= followed), radii, np.inf)))
    return float(radii[number]), curve.starts[number]


def _gap(contours: list[Contour], machine: Machine) -> list[Finding]:
    """The narrowest bridge between cuts, or between parts of one cut."""
    points, along, line, lengths = _samples([contour for contour in contours if contour.role in _CUTS])
    package = shapely()
    nodes = package.points(points)
    first, second = package.STRtree(nodes).query(nodes, predicate="dwithin", distance=machine.least_gap)
    across = np.hypot(*(points[first] - points[second]).T)
    way = np.abs(along[first] - along[second])
    way = np.minimum(way, lengths[first] - way)
    apart = (line[first] != line[second]) | (way > _WAY_ROUND * across + 2.0 * _SPACING)
    if not apart.any():
        return []
    narrowest = int(np.argmin(np.where(apart, across, np.inf)))
    least = float(across[narrowest])
    place = 0.5 * (points[first[narrowest]] + points[second[narrowest]])
    return [
        Finding(
            WARNING,
            f"Only {mm_text(least)} of film stay between two cuts near {place_text(place)};"
            f" {machine.title} wants {mm_text(machine.least_gap)}. It may tear or melt there.",
            place,
        )
    ]


def _samples(contours: list[Contour]) -> tuple[Floats, Floats, Floats, Floats]:
    """Points along all lines, how far along, which line, and its length."""
    points, along, which, lengths = [np.empty((0, 2))], [np.empty(0)], [np.empty(0)], [np.empty(0)]
    for k, contour in enumerate(contours):
        loop = np.concatenate([contour.points, contour.points[:1]]) if contour.closed else contour.points
        ends = np.append(0.0, np.cumsum(np.hypot(*np.diff(loop, axis=0).T)))
        places = np.linspace(0.0, ends[-1], max(int(ends[-1] / _SPACING), 8), endpoint=False)
        points.append(np.stack([np.interp(places, ends, loop[:, axis]) for axis in range(2)], axis=1))
        along.append(places)
        which.append(np.full(len(places), float(k)))
        lengths.append(np.full(len(places), ends[-1]))
    return np.concatenate(points), np.concatenate(along), np.concatenate(which), np.concatenate(lengths)


def _size(pattern: Pattern, machine: Machine) -> list[Finding]:
    """Against the bed, upright and turned, in millimetres and inches."""
    if machine.bed is None:
        return []
    width, height = pattern.size
    if machine.control_bar and Role.REGISTRATION in machine.layers:
        width, height = max(width, from_mm(BAR)), height + from_mm(BAR_ROOM)
    bed_width, bed_height = machine.bed
    if width <= bed_width and height <= bed_height:
        return []
    bed = _both(bed_width, bed_height)
    sizes = f"The pattern measures {_both(width, height)}, the bed of {machine.title} {bed}"
    if width <= bed_height and height <= bed_width:
        return [Finding(WARNING, f"{sizes}: turn the pattern by 90 degrees there.")]
    return [Finding(ERROR, f"{sizes}: make the balloon smaller, or choose another machine or paper.")]


def _both(width: float, height: float) -> str:
    return (
        f"{mm_text(width).removesuffix(' mm')} x {mm_text(height)}"
        f" ({width / INCH:.2f} x {height / INCH:.2f} in)"
    )


def _line(contour: Contour) -> Any:
    package = shapely()
    return (package.LinearRing if contour.closed else package.LineString)(contour.points)


def _crossing(contour: Contour) -> Floats:
    """The first point (2,) where a line meets itself."""
    package = shapely()
    points = np.concatenate([contour.points, contour.points[:1]]) if contour.closed else contour.points
    edges = package.linestrings(np.stack([points[:-1], points[1:]], axis=1))
    first, second = package.STRtree(edges).query(edges, predicate="intersects")
    apart = np.abs(first - second)
    strange = (first < second) & (apart > 1) & ~(contour.closed & (apart == len(edges) - 1))
    for a, b in zip(first[strange], second[strange]):
        return np.asarray(package.get_coordinates(package.intersection(edges[a], edges[b]))[0])
    return contour.points[0]
