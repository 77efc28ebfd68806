# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look before a file is written: will this machine make that pattern?"""

from __future__ import annotations

import math
from collections.abc import Iterator, Set
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.arcs.curves import polyline
from BalloonWorkbench.core.arcs.fit_arcs import TOLERANCE, fit_curve
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.start_values import PAPER, PTFE, separating_layers
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import gaps, line_lengths, point_on
from BalloonWorkbench.core.machines.bed import fits_turned, fits_upright, pieces_fit, size_on
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.order import CUTS
from BalloonWorkbench.core.machines.tool import WELDS, lacking
from BalloonWorkbench.core.machines.toolpaths import fitted, not_held
from BalloonWorkbench.core.options.making import REFUSE, SPLIT, WRITE
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import (
    INCH,
    from_mm,
    length_text,
    number_text,
    place_text,
    size_text,
    temperature_text,
)

ERROR, WARNING = "error", "warning"

#: Samples along a line for the search of narrow places [m].
_SPACING = from_mm(0.25)
#: Two places of one line are a gap between them when the way along it is so many times as long as across.
_WAY_ROUND = 3.0
#: Share of the tolerance with which a radius that is too small is measured once more.
_FINE = 0.25
#: A line that turns by more goes back where it came from [rad].
_BACK = np.radians(179.95)
#: Two temperatures so near are the same [K].
_ABOUT = 0.5
#: Half of a turn beyond which a bend is as good as a corner [rad].
_SHARPEST = 1.4


@dataclass(frozen=True)
class PreflightFinding:
    """One remark: ERROR when the file would be of no use, else WARNING; a place (2,) m where it has one.

    oversize  the pattern is larger than the bed, see OVERSIZE
    """

    severity: str
    text: str
    place: Floats | None = None
    oversize: bool = False


def preflight(pattern: Pattern, machine: Machine, oversize: str = REFUSE) -> tuple[PreflightFinding, ...]:
    """Everything that is wrong or doubtful about a pattern on a machine, errors first.

    With oversize WRITE or SPLIT, that it is larger than the bed is no error.
    """
    taken = [contour for contour in pattern.contours if contour.role in machine.layers]
    findings = [*_closed(taken), *_simple(taken, machine)]
    if not any(finding.severity == ERROR for finding in findings):
        cuts = [contour for contour in taken if contour.role in CUTS]
        findings += _radius(cuts or [contour for contour in taken if contour.role in WELDS], machine)
        findings += _gap(taken, machine)
        findings += _tabs(pattern, machine)
    findings += _size(pattern, machine, oversize)
    findings += [*_laser({contour.role for contour in taken}, machine), *_tool(machine)]
    findings += [PreflightFinding(WARNING, remark) for remark in machine.remarks]
    return tuple(sorted(findings, key=lambda finding: finding.severity != ERROR))


def film_preflight(film: Film, machine: Machine) -> tuple[PreflightFinding, ...]:
    """What a machine does that a film does not take."""
    name = film.title or film.name
    if machine.process == "laser" and film.laser is False:
        return (
            PreflightFinding(ERROR, f"{name} must never be cut with a laser: choose a machine with a knife."),
        )
    if machine.process == "heat-sealing" and film.joining not in ("", "heat"):
        return (
            PreflightFinding(WARNING, f"{name} is not joined by heat: {machine.title} is not made for it."),
        )
    return _start_values(film, name, machine)


def _start_values(film: Film, name: str, machine: Machine) -> tuple[PreflightFinding, ...]:
    """A temperature of the tool beside what sources state for the film: a moving tip, or else a bar."""
    tool, known = machine.tool, film.start_values
    stated = known.tip_temperature or known.bar_temperature
    if tool is None or not tool.is_hot or tool.temperature is None or stated is None:
        return ()
    if stated.least - _ABOUT <= tool.temperature <= stated.most + _ABOUT:
        return ()
    heat, own = stated.text(temperature_text), temperature_text(tool.temperature)
    text = (
        f"{'A hot tip' if known.tip_temperature else 'A bar'} is stated to weld {name} at {heat},"
        f" this tool has {own}: peel a test card before you rely on it."
    )
    return (PreflightFinding(WARNING, text),)


def _closed(contours: list[Contour]) -> list[PreflightFinding]:
    return [
        PreflightFinding(
            ERROR,
            f"The {contour.role.value} line that begins at {place_text(contour.points[0])} is open: programs"
            " fill, offset and cut closed lines only. Close it.",
            contour.points[0],
        )
        for contour in contours
        if contour.role in CUTS and not contour.closed
    ]


def _simple(contours: list[Contour], machine: Machine) -> list[PreflightFinding]:
    """Lines that cross themselves or each other, as they are written."""
    lines = [
        (contour, curve.flattened(_FINE * machine.tolerance))
        for contour in contours
        for curve in fitted(contour, machine)
    ]
    findings = [finding for contour, points in lines for finding in _crossed(contour, points)]
    cuts = [(contour.role.value, _line(points, True)) for contour, points in lines if contour.role in CUTS]
    package = shapely()
    shapes = np.array([line for _, line in cuts], dtype=object)
    for k, other in zip(*package.STRtree(shapes).query(shapes, predicate="intersects")):
        if k < other:
            place = package.get_coordinates(shapes[k].intersection(shapes[other]))[0]
            text = (
                f"{cuts[k][0]} and {cuts[other][0]} lines meet near {place_text(place)}:"
                " move the hole inward or make the allowance narrower."
            )
            findings.append(PreflightFinding(ERROR, text, place))
    return findings


def _crossed(contour: Contour, points: Floats) -> Iterator[PreflightFinding]:
    """What is wrong with a single line."""
    if not _line(points, contour.closed).is_simple:
        met = first_crossing([points]) if contour.closed else first_crossing([], [points])
        place = points[0] if met is None else met
        yield PreflightFinding(
            ERROR,
            f"The {contour.role.value} line crosses itself near {place_text(place)}:"
            " simplify the drawing there.",
            place,
        )
        return
    turns = polyline(points, contour.closed).joint_turns
    back = int(np.argmax(np.abs(turns)))
    if abs(turns[back]) > _BACK:
        yield PreflightFinding(
            ERROR,
            f"The {contour.role.value} line runs back along itself near {place_text(points[back])}:"
            " simplify the drawing there.",
            points[back],
        )


def _radius(contours: list[Contour], machine: Machine) -> list[PreflightFinding]:
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
        PreflightFinding(
            WARNING,
            f"The smallest radius is {length_text(least[0], 2)}, near {place_text(least[1])};"
            f" {machine.title} follows {length_text(machine.least_radius)}. It will come out rounder there.",
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


def _gap(contours: list[Contour], machine: Machine) -> list[PreflightFinding]:
    """The narrowest bridge between cuts, or between parts of one cut."""
    points, along, line, lengths = _samples([contour for contour in contours if contour.role in CUTS])
    package = shapely()
    nodes = package.points(points)
    first, second = package.STRtree(nodes).query(nodes, predicate="dwithin", distance=machine.least_gap)
    across = np.hypot(*(points[first] - points[second]).T)
    way = gaps(along[first], along[second], lengths[first])
    apart = (line[first] != line[second]) | (way > _WAY_ROUND * across + 2.0 * _SPACING)
    if not apart.any():
        return []
    narrowest = int(np.argmin(np.where(apart, across, np.inf)))
    least = float(across[narrowest])
    place = 0.5 * (points[first[narrowest]] + points[second[narrowest]])
    return [
        PreflightFinding(
            WARNING,
            f"Only {length_text(least)} of film stay between two cuts near {place_text(place)};"
            f" {machine.title} wants {length_text(machine.least_gap)}. It may tear or melt there.",
            place,
        )
    ]


def _samples(contours: list[Contour]) -> tuple[Floats, Floats, Floats, Floats]:
    """Points along all lines, how far along, which line, and its length."""
    points, along, which, lengths = [np.empty((0, 2))], [np.empty(0)], [np.empty(0)], [np.empty(0)]
    for k, contour in enumerate(contours):
        ends = line_lengths(contour.line)
        places = np.linspace(0.0, ends[-1], max(int(ends[-1] / _SPACING), 8), endpoint=False)
        points.append(point_on(contour.line, ends, places))
        along.append(places)
        which.append(np.full(len(places), float(k)))
        lengths.append(np.full(len(places), ends[-1]))
    return np.concatenate(points), np.concatenate(along), np.concatenate(which), np.concatenate(lengths)


def _tabs(pattern: Pattern, machine: Machine) -> list[PreflightFinding]:
    """What no tabs hold."""
    free = not_held(pattern, machine)
    if not free:
        return []
    place = free[0].points[0]
    return [
        PreflightFinding(
            WARNING,
            f"Cuts without room for two tabs of {length_text(machine.tabs.tabs)} on a straight: {len(free)},"
            f" the first near {place_text(place)}. What they go round comes free.",
            place,
        )
    ]


def _size(pattern: Pattern, machine: Machine, oversize: str) -> list[PreflightFinding]:
    """Against the bed, upright and turned, in millimetres and inches."""
    if machine.bed is None or fits_upright(pattern, machine):
        return []
    size, bed = _both(*size_on(pattern, machine).tolist()), _both(*machine.bed)
    sizes = f"The pattern measures {size}, the bed of {machine.title} is {bed}"
    if fits_turned(pattern, machine):
        turn = (
            "turn the pattern by 90 degrees there"
            if machine.tool is None
            else "the file has it turned by 90 degrees"
        )
        return [PreflightFinding(WARNING, f"{sizes}: {turn}.")]
    if oversize == SPLIT:
        return [
            PreflightFinding(
                WARNING,
                f"{sizes}: it is split over several files. Cut them in their order, and lay the film on anew"
                " each time so that its crosses are where the next file has them.",
                oversize=True,
            )
        ]
    if oversize == WRITE:
        return [PreflightFinding(WARNING, f"{sizes}: the file is written anyway.", oversize=True)]
    text = (
        f"{sizes}: lay its pieces out on sheets of that size, make the balloon smaller, or write the file"
        " anyway."
        if pieces_fit(pattern, machine)
        else f"{sizes}: make the balloon smaller, choose another machine or paper, or write the file anyway."
    )
    return [PreflightFinding(ERROR, text, oversize=True)]


def _laser(roles: Set[Role], machine: Machine) -> Iterator[PreflightFinding]:
    """What a LightBurn project does not say, and what it says already."""
    if machine.format != "lbrn2":
        return
    lines = [line for role, line in machine.layers.items() if role in roles and line.is_burnt]
    unknown = [line.name for line in lines if line.laser is None]
    if unknown:
        yield PreflightFinding(
            WARNING,
            f"No speed and power are known for {', '.join(unknown)}, so none are written: set them in"
            " LightBurn, or give speed_mm_s and max_power_percent in a file of your machine.",
        )
    if machine.kerf:
        yield PreflightFinding(
            WARNING,
            f"The lines make up for a kerf of {length_text(machine.kerf)} already: leave LightBurn's kerf"
            " offset at 0.",
        )


def _tool(machine: Machine) -> list[PreflightFinding]:
    """What a tool lacks that only the user knows, and what it does to what lies between it and the film."""
    tool = machine.tool
    if tool is None:
        return []
    missing = lacking(tool, machine.version)
    if missing:
        return [PreflightFinding(ERROR, missing)]
    fumes = separating_layers()[PTFE]
    if tool.is_hot and (tool.temperature or 0.0) > fumes:
        return [
            PreflightFinding(
                WARNING,
                f"A separating layer of PTFE gives off poisonous fumes above {temperature_text(fumes)}, and"
                f" baking paper chars above {temperature_text(separating_layers()[PAPER])}: weld slower at a"
                " lower temperature, and air the room.",
            )
        ]
    return []


def _both(width: float, height: float) -> str:
    if math.isinf(height):
        return f"{length_text(width)} ({number_text(width / INCH, 4)} in) across"
    inches = f"{number_text(width / INCH, 4)} x {number_text(height / INCH, 4)} in"
    return f"{size_text(width, height, digits=4)} ({inches})"


def _line(points: Floats, closed: bool) -> Any:
    package = shapely()
    return (package.LinearRing if closed else package.LineString)(points)
