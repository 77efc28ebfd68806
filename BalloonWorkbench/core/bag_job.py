# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job for balloons of many panels: a profile, a letter, a closed body or a bag in, its panels out.

1. read what is wanted                              bag_design/source.py, readers/read.py, bags/read_bag.py
2. its panels, inflated and corrected               bag_design/gore_fit.py, band_fit.py, inflate_bag.py,
                                                    target_design/fit_target.py
3. weld, cut, marks that match, order of assembly   bag_pattern/make.py
4. say what it takes to make it                     making/bag_numbers.py
5. report and files                                 reports/bag_report.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.as_data import finding_data
from BalloonWorkbench.core.advice.many_panels.bag_advice import bag_advice
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.band_fit import fit_band
from BalloonWorkbench.core.bag_design.band_width import band_for_thickness
from BalloonWorkbench.core.bag_design.gore_count import fit_to_accuracy, gores_needed, judged
from BalloonWorkbench.core.bag_design.gore_fit import RisingPressure, fit_gores, inflate_gores
from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bag_design.source import (
    NO_READERS,
    Readers,
    Source,
    check_together,
    division_of_size,
    profile_of_size,
    scaled,
    size_of,
)
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.make import make_bag_patterns
from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.read_bag import read_bag
from BalloonWorkbench.core.bodies.banded import SideBand, band_joints, band_places, banded_bag, divided
from BalloonWorkbench.core.bodies.gores import folds_at
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.design.size_goal import START_WIDTH, Buoyancy, Scaling, tried_sizes
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import GRAVITY
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.job import Settings, numbered, read_shapes, share_of
from BalloonWorkbench.core.making.bag_numbers import bag_numbers, inner_film, width_of
from BalloonWorkbench.core.making.numbers import Numbers, numbers_report
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.making.welding import welding_report, welding_time
from BalloonWorkbench.core.options.body import ACCURACY, BandOptions, BodyOptions
from BalloonWorkbench.core.options.option import unusual
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.readers.vector import read_bytes
from BalloonWorkbench.core.reports.bag_report import build_bag, together_bags
from BalloonWorkbench.core.results.off_target import off_target
from BalloonWorkbench.core.results.result_files import results_bytes
from BalloonWorkbench.core.results.self_contact import self_contact, through_itself
from BalloonWorkbench.core.results.stl import stl_bytes
from BalloonWorkbench.core.rounded import rounded
from BalloonWorkbench.core.solver.volume_load import search_pressure
from BalloonWorkbench.core.target_design.fit_target import TargetMode, fit_target, inflate_target
from BalloonWorkbench.core.target_design.panel_count import fit_body_to_accuracy
from BalloonWorkbench.core.targets.form import MESH, PANELS, SOLID, form_of
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Attempt, Progress, insist, no_progress, part_of, rising

_OFF = 1e-3  # of a volume that was asked for


def read_sources(
    path: str | Path,
    settings: Settings,
    width: float | None = None,
    height: float | None = None,
    readers: Readers = NO_READERS,
) -> tuple[Source, ...]:
    """What a file and the options ask for in many panels, the largest first; empty: two equal panels.

    A bag or a profile is one; of a drawing with a side band each shape is one. width, height [m]: of all of
    it; the sizes of a bag are those of its panels. Raises InputError for what does not go together, and what
    the readers raise.
    """
    form = form_of(path)
    asked = settings.body, settings.side_band, settings.target
    check_together(path, form, *asked, sized=width is not None or height is not None)
    if form == PANELS:
        bag, seal = read_bag(read_bytes(Path(path)), Budget()), settings.pattern.seal_width
        width_of_weld = settings.film.seal_width if seal is None else seal
        needed = settings.pattern.intake and not settings.pattern.opening
        check_bag(bag, width_of_weld, opening_needed=needed)
        return (bag,)
    if form in (MESH, SOLID):
        return (division_of_size(path, settings.target, width, height, readers.solid),)
    if form or settings.body != BodyOptions():
        return (profile_of_size(path, settings.body, width, height),)
    if settings.side_band == BandOptions():
        return ()
    return read_shapes(path, settings, width, height, readers.decode)[0].parts


def design_bag(source: Source, settings: Settings, progress: Progress = no_progress) -> BagDesign:
    """The panels of a source and their balloon: corrected to it, or as they are; of a bag always as they are.

    At the pressure of the settings, or at that of their volume. Raises what the designs raise.
    """
    settings = rounded(settings)
    if settings.volume is None:
        return _with_contact(_designed(source, settings, settings.pressure, rising(progress)))
    tried: list[BagDesign] = []

    def at_pressure(pressure: float) -> BagDesign:
        first, last = (1.0 - 0.7 ** (len(tried) + k) for k in (0, 1))
        tried.append(_designed(source, settings, pressure, part_of(progress, first, last)))
        return tried[-1]

    unit = settings.film.membrane_stiffness / size_of(source)
    best = search_pressure(settings.volume, unit, at_pressure, lambda design: design.inflation.volume, _OFF)
    return _with_contact(replace(best, seconds=sum(design.seconds for design in tried)))


def _with_contact(design: BagDesign) -> BagDesign:
    """With a warning where the film passes through itself."""
    place, source = self_contact(design.inflation).place, design.source
    if place is None or (isinstance(source, Profile) and folds_at(source, place)):
        return design
    return replace(design, warnings=(*design.warnings, through_itself(place)))


def _designed(source: Source, settings: Settings, pressure: float, progress: Progress) -> BagDesign:
    if isinstance(source, Profile):
        return _gored(source, settings, pressure, progress)
    if isinstance(source, Outline):
        return _banded(source, settings, pressure, progress)
    if isinstance(source, Division):
        return _divided(source, settings, pressure, progress)
    return inflate_bag(
        source,
        settings.film,
        pressure,
        mesh_size=settings.mesh_size,
        backend=settings.backend,
        model=settings.model,
        progress=progress,
    )


def _gored(profile: Profile, settings: Settings, pressure: float, progress: Progress) -> BagDesign:
    """A body of so many gores, or of as many as the accuracy needs; without correction of plain gores."""
    body, film = settings.body, settings.film
    accuracy, gradient = body.accuracy or ACCURACY, 0.0
    if body.hydrostatic:
        gradient = max(settings.filling.lightness(pressure), 0.0) * GRAVITY
    own: dict[str, Any] = {
        "mesh_size": settings.mesh_size,
        "backend": settings.backend,
        "model": settings.model,
        "progress": progress,
    }
    load = RisingPressure(pressure, gradient) if gradient > 0.0 else pressure
    if settings.correct and not body.gores:
        return fit_to_accuracy(profile, accuracy, film, load, **own)
    make = fit_gores if settings.correct else inflate_gores
    design = make(profile, body.gores or gores_needed(profile, accuracy), film, load, **own)
    return judged(design, accuracy) if settings.correct and body.accuracy is not None else design


def _divided(division: Division, settings: Settings, pressure: float, progress: Progress) -> BagDesign:
    """The panels of a body, corrected until the balloon lies on it, or as they are laid flat."""
    film, target = settings.film, settings.target
    own: dict[str, Any] = {
        "mesh_size": settings.mesh_size,
        "backend": settings.backend,
        "model": settings.model,
        "progress": progress,
    }
    if not settings.correct:
        return inflate_target(division, film, pressure, **own)
    if settings.body.accuracy is not None:
        return fit_body_to_accuracy(division.target, settings.body.accuracy, film, pressure, **own)
    return fit_target(division, film, pressure, mode=TargetMode(target.lies, target.margin), **own)


def _banded(outline: Outline, settings: Settings, pressure: float, progress: Progress) -> BagDesign:
    """Front, back and a band between them; without correction both faces are the drawing."""
    film = settings.film
    own: dict[str, Any] = {
        "mesh_size": settings.mesh_size,
        "backend": settings.backend,
        "model": settings.model,
        "progress": progress,
    }
    band = settings.side_band.band or band_for_thickness(outline, settings.side_band.body_thickness)
    piece = settings.side_band.band_piece or making().roll_width
    if settings.correct:
        return fit_band(outline, SideBand(band, piece), film, pressure, **own)
    fine = divided(outline, piece)
    joints = band_joints(fine.loops, piece)
    places = band_places(fine.loops, joints, band)
    bag = banded_bag(fine, band, piece, joints)
    design = inflate_bag(bag, film, pressure, places=places, **own)
    return replace(
        design, source=outline, size=max(outline.size), warnings=(*outline.notes, *design.warnings)
    )


@dataclass(frozen=True)
class BagPart:
    """One balloon of many panels; numbers: None where an attempt to find them failed."""

    design: BagDesign
    patterns: BagPatterns
    numbers: Numbers | None


@dataclass(frozen=True)
class FinishedBags:
    """A finished job of many panels; the report is empty where an attempt to make it failed."""

    settings: Settings
    parts: tuple[BagPart, ...]
    report: dict[str, Any]

    @property
    def designs(self) -> list[BagDesign]:
        """The designs of all balloons, the largest first."""
        return [part.design for part in self.parts]

    @property
    def sources(self) -> list[Source]:
        """What each balloon was made for."""
        return [part.design.source for part in self.parts]

    @property
    def sheet(self) -> Pattern:
        """All that is cut, side by side."""
        return on_one_sheet([part.patterns.sheet for part in self.parts])

    @property
    def width(self) -> float:
        """Of all that is wanted [m]; of a bag that of its balloon."""
        outlines = [source.outer for source in self.sources if isinstance(source, Outline)]
        if outlines:
            return float(np.ptp(np.concatenate(outlines)[:, 0]))
        return width_of(self.parts[0].design)


def make_bags(
    path: str | Path,
    settings: Settings,
    *,
    width: float | None = None,
    height: float | None = None,
    scale: float = 1.0,
    readers: Readers = NO_READERS,
    progress: Progress = no_progress,
    attempt: Attempt = insist,
) -> FinishedBags:
    """Make what a file and the settings ask for in many panels; width and height [m] as in `read_sources`.

    scale  how many times as large as it was read; panels have no other size
    With a goal, the largest is brought to the size that meets it, and the others with it. Raises BalloonError
    of some kind for anything a user can mend.
    """
    settings = rounded(settings)
    settings.filling.lightness()  # a mistake shows before the work
    outlined = settings.side_band != BandOptions() and width is None and height is None
    width = START_WIDTH if settings.goal is not None and outlined else width
    sources = read_sources(path, settings, width, height, readers)
    if not sources:
        raise InputError(
            f"'{Path(path).name}' has no panels of its own: give gores, or the width of a side band."
        )
    sources = tuple(scaled(source, scale) for source in sources)
    count = len(sources)
    first, grown = design_at_goal(sources[0], settings, share_of(progress, 0, count))
    designs = [first]
    for number, source in enumerate(sources[1:], start=1):
        work = partial(design_bag, scaled(source, grown), settings, share_of(progress, number, count))
        design = attempt(f"Balloon {number + 1}", work)
        designs += [] if design is None else [design]
    parts = []
    for design in designs:
        patterns = make_bag_patterns(design, settings.film, settings.pattern)
        numbers = attempt(
            "What it takes to make it",
            partial(bag_numbers, design, patterns, settings.film, settings.filling),
        )
        parts.append(BagPart(design, patterns, numbers))
    made = FinishedBags(settings, tuple(parts), {})
    report = attempt("report.json", partial(_report, made, Path(path).name))
    return replace(made, report=report or {})


def design_at_goal(source: Source, settings: Settings, progress: Progress) -> tuple[BagDesign, float]:
    """The design of a source at the size that meets the goal, and how much larger than asked that is."""
    goal = settings.goal
    if goal is None:
        return design_bag(source, settings, progress), 1.0
    if settings.volume is not None:
        raise InputError("A volume to inflate to and a goal for the size exclude each other: leave one out.")
    scales: list[float] = []

    def make(scale: float, start: BagDesign | None, progress: Progress) -> BagDesign:
        scales.append(scale)
        return design_bag(scaled(source, scale), settings, progress)

    def scaling(design: BagDesign) -> Scaling:
        patterns = make_bag_patterns(design, settings.film, settings.pattern)
        inner, whole = inner_film(design), patterns.film_area
        return Scaling(size_of(design.source), design.inflation.volume, 0.5 * inner, 0.5 * (whole - inner))

    buoyancy = Buoyancy(
        settings.filling.lightness(settings.pressure), settings.film.areal_density, lambda seam: 0.0
    )
    draft = replace(settings, correct=False)
    known = scaling(design_bag(source, draft, part_of(progress, 0.0, 0.2)))
    tried, remarks = tried_sizes(make, scaling, known, goal, buoyancy, progress=part_of(progress, 0.2, 1.0))
    best = tried[-1]
    best = replace(
        best,
        passes=sum(design.passes for design in tried),
        seconds=sum(design.seconds for design in tried),
        warnings=(*best.warnings, *remarks),
    )
    return best, scales[-1]


def _report(bags: FinishedBags, file: str) -> dict[str, Any]:
    """The report; empty where the numbers of a balloon are missing."""
    parts, settings = [], bags.settings
    for part in bags.parts:
        if part.numbers is None:
            return {}
        data = build_bag(
            part.design, part.patterns, settings.film, file=file, volume=settings.volume, goal=settings.goal
        )
        own, accuracy = (part.design, part.patterns, settings.film), settings.body.accuracy or ACCURACY
        advice = [finding_data(finding) for finding in bag_advice(*own, part.numbers.safety, accuracy)]
        maker = numbers_report(part.numbers) | {"welding": _welding(part, settings)}
        parts.append(data | {"maker": maker, "advice": advice})
    return together_bags(parts, bags.sheet) | {"options": unusual(settings.pattern)}


def _welding(part: BagPart, settings: Settings) -> dict[str, Any]:
    """How long its seams take."""
    made, asked = part.patterns, settings.welding
    return welding_report(
        welding_time(
            made.seam_length,
            sum(seam.made for seam in made.seams),
            asked.weld_speed,
            asked.weld_handling,
        )
    )


def bag_makers(bags: FinishedBags, results: str | None = None) -> dict[str, Callable[[], bytes]]:
    """What makes files of a finished job by name; as `makers` for two panels."""
    from BalloonWorkbench.core.pictures.bag_preview import bag_preview_png

    film = bags.settings.film
    named: dict[str, Callable[[], bytes]] = {
        "balloon.stl": lambda: stl_bytes([design.inflation for design in bags.designs])
    }
    for number, part in enumerate(bags.parts):
        named[f"{numbered('preview', number)}.png"] = partial(bag_preview_png, part.design, part.patterns)
        if results is not None:
            name = f"{numbered('results', number)}.{results}"
            named[name] = partial(_results, part.design, film, results)
    return named


def _results(design: BagDesign, film: Film, kind: str) -> bytes:
    return results_bytes(design.inflation, film, kind, off_target(design))
