# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a balloon of many panels: what was measured on it, and what making its panels will be like.

Places are on the inflated balloon, (x, y, z) m.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from BalloonWorkbench.core.advice.findings import Finding, Severity
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.caps import capped_poles
from BalloonWorkbench.core.bag_pattern.seams import SeamMark
from BalloonWorkbench.core.bodies.banded import BACK, FRONT
from BalloonWorkbench.core.bodies.gores import gores_of
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.correction.summary import NOT_AT_REST
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import point_on
from BalloonWorkbench.core.making.safety import WELD, Safety
from BalloonWorkbench.core.options.body import ACCURACY
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.panels.seam import Run
from BalloonWorkbench.core.pattern.intake.places import film_of
from BalloonWorkbench.core.results.self_contact import self_contact, through_itself
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text, number_text, pressure_text

#: A panel nowhere wider than that many welds is more weld than film; one: it hardly holds air.
_NARROW, _HARDLY = 2.0, 1.0
#: A band may lean so far between front and back; more is a warning [rad].
_LEANING, _LYING = np.radians(15.0), np.radians(30.0)
#: Part of a piece of the band that leans at least: its ends always do a little.
_PART = 0.1


def bag_advice(
    design: BagDesign, patterns: BagPatterns, film: Film, strong: Safety, accuracy: float = ACCURACY
) -> list[Finding]:
    """All findings about a balloon of many panels, the worst first.

    strong    what holds it together; accuracy: how far it may be from its profile, in parts of the profile's
              diagonal
    """
    findings = [
        *design_findings(design, accuracy),
        *_pressure(strong, film),
        *_narrow_panels(design, patterns),
        *_poles(design),
        *_turning(design, patterns.seams),
    ]
    return sorted(findings, key=lambda finding: -finding.severity.rank)


def design_findings(design: BagDesign, accuracy: float = ACCURACY) -> list[Finding]:
    """What the balloon alone tells, the worst first; accuracy as in `bag_advice`."""
    findings = [*_unrest(design), *_contact(design), *_apart(design, accuracy), *_leaning(design)]
    return sorted(findings, key=lambda finding: -finding.severity.rank)


def _finding(
    rule: str, severity: Severity, text: str, place: Floats, measured: float, limit: float
) -> Finding:
    at = tuple(float(value) for value in place)
    return Finding(rule, severity, text, at, (), measured, limit)


def _degrees(angle: float) -> str:
    return f"{number_text(float(np.degrees(angle)))}°"


def _unrest(design: BagDesign) -> Iterator[Finding]:
    if not design.inflation.report.converged:
        middle = design.inflation.positions.mean(axis=0)
        yield _finding("unrest", Severity.WARNING, NOT_AT_REST, middle, 1.0, 0.0)


def _contact(design: BagDesign) -> Iterator[Finding]:
    contact = self_contact(design.inflation)
    if contact.place is not None:
        text = through_itself(contact.place)
        yield _finding("contact", Severity.WARNING, text, contact.place, float(contact.count), 0.0)


def _pressure(strong: Safety, film: Film) -> Iterator[Finding]:
    safe, pressure, place = strong.safe_pressure, strong.pressure, strong.place
    if safe is None or place is None or safe >= pressure:
        return
    weakest = film.seam if strong.weakest == WELD else strong.weakest
    severity = Severity.SERIOUS if safe * strong.margin < pressure else Severity.WARNING
    text = (
        f"The {weakest} bears {pressure_text(safe)} here with a margin of {number_text(strong.margin)}, and"
        f" the pressure is {pressure_text(pressure)}. Inflate it to less, or take a stronger film."
    )
    yield _finding("pressure", severity, text, place, safe, pressure)


def _apart(design: BagDesign, accuracy: float) -> Iterator[Finding]:
    """Seams of gores that stand out over their middles."""
    if not isinstance(design.source, Profile) or not design.apart > accuracy * design.size:
        return
    count = gores_of(design.bag, design.source)
    text = (
        f"The seams of {number_text(count)} gores stand out by up to {length_text(design.apart, 2)} over"
        " their middles. More gores make the body rounder."
    )
    positions = design.inflation.positions
    widest = positions[int(np.argmax(np.hypot(positions[:, 0], positions[:, 1])))]
    yield _finding("apart", Severity.HINT, text, widest, design.apart / design.size, accuracy)


def _leaning(design: BagDesign) -> Iterator[Finding]:
    """Pieces of a side band that do not stand upright between front and back."""
    if not isinstance(design.source, Outline):
        return
    upper: dict[int, Run] = {}
    lower: dict[int, Run] = {}
    for seam, run in zip(design.bag.seams, design.inflation.assembly.seams, strict=True):
        if seam.a.panel == FRONT:
            upper[seam.b.panel] = run.first
        elif seam.b.panel == BACK:
            lower[seam.a.panel] = run.second
    for panel in sorted(upper.keys() & lower.keys()):
        top, under = (_even(_line(design, runs[panel])) for runs in (upper, lower))
        way = top - under
        leans = np.arctan2(np.hypot(way[:, 0], way[:, 1]), np.abs(way[:, 2]))
        angle = float(np.quantile(leans, 1.0 - _PART))
        if angle > _LEANING:
            name = design.bag.panels[panel].name
            text = (
                f"Panel {name} leans by {_degrees(angle)} between front and back. Make the side band"
                " narrower there, or the parts of the drawing wider."
            )
            worst = int(np.argmax(leans))
            severity = Severity.WARNING if angle > _LYING else Severity.HINT
            place = 0.5 * (top[worst] + under[worst])
            yield _finding("leaning", severity, text, place, angle, float(_LEANING))


def _line(design: BagDesign, run: Run) -> Floats:
    """The vertices (k, 3) of a side of a seam on the balloon [m]."""
    inflation = design.inflation
    return np.asarray(inflation.positions[inflation.assembly.offsets[run.panel] + run.vertices])


def _even(line: Floats, count: int = 101) -> Floats:
    """Points (count, 3) of a line of vertices at even shares of their number."""
    at, own = np.linspace(0.0, 1.0, count), np.linspace(0.0, 1.0, len(line))
    return point_on(line, own, at)


def _narrow_panels(design: BagDesign, patterns: BagPatterns) -> Iterator[Finding]:
    """Panels that are more weld than film."""
    offsets, seal = design.inflation.assembly.offsets, patterns.seal_width
    for number in patterns.panels:
        panel = design.bag.panels[number]
        width = 2.0 * float(
            shapely().maximum_inscribed_circle(film_of(Outline(panel.outer, panel.holes))).length
        )
        if width < _NARROW * seal:
            text = (
                f"Panel {panel.name} is nowhere wider than {length_text(width, 2)}, and its welds are"
                f" {length_text(seal, 2)} wide: it hardly bulges. Make the balloon larger, the panel wider or"
                " the seal narrower."
            )
            severity = Severity.SERIOUS if width < _HARDLY * seal else Severity.WARNING
            own = design.inflation.positions[offsets[number] : offsets[number + 1]]
            yield _finding("narrow", severity, text, own.mean(axis=0), width, _NARROW * seal)


def _poles(design: BagDesign) -> Iterator[Finding]:
    """Points where so many panels meet that welds alone leave a hole."""
    for corners in capped_poles(design.bag):
        text = (
            f"{number_text(len(corners))} panels meet at one point, which no weld closes: seal the cap from"
            " the sheet over it, or tape it."
        )
        place = _corner(design, corners)
        if place is not None:
            yield _finding("pole", Severity.HINT, text, place, float(len(corners)), 3.0)


def _corner(design: BagDesign, corners: Sequence[tuple[int, int, int]]) -> Floats | None:
    """The place (3,) of the first corner of a panel that a seam ends at."""
    for seam, run in zip(design.bag.seams, design.inflation.assembly.seams, strict=True):
        for side, own in zip(seam.sides, run.runs):
            for point, end in ((side.start, 0), (side.end, -1)):
                if (side.panel, side.loop, point) in corners:
                    place: Floats = _line(design, own)[end]
                    return place
    return None


def _turning(design: BagDesign, seams: Sequence[SeamMark]) -> Iterator[Finding]:
    """Seams that are not sealed lying flat, at the one that turns most."""
    turned = [seam for seam in seams if seam.made and not seam.flat]
    if not turned:
        return
    most = max(turned, key=lambda seam: seam.flatness)
    names = " and ".join(design.bag.panels[panel].name for panel in most.panels)
    text = (
        f"{number_text(len(turned))} seams cannot be sealed lying flat, least of all seam"
        f" {number_text(most.number)} of panels {names}: one edge turns by {_degrees(most.flatness)} in"
        " all to follow the other. Seal them bit by bit, or round the corners."
    )
    line = _line(design, design.inflation.assembly.seams[most.number - 1].first)
    yield _finding("turning", Severity.HINT, text, line[len(line) // 2], most.flatness, 0.2)
