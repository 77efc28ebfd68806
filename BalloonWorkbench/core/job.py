# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main job: a drawing in, its balloons and their cutter-ready patterns out.

1. read the drawing as outlines, and for each of them   readers/read.py
2. mesh a first pattern                                 mesh/triangulate.py
3. inflate it: film, sealed seam, pressure              solver/inflate.py
4. correct the pattern until its silhouette is          correction/fit.py
   the drawing, and repeat 3
5. weld, cut and intake around the corrected seam       pattern/build.py
6. say what would inflate badly                         advice/advise.py
7. say what it takes to make it                         making/numbers.py
8. files                                                export/
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.advice.advise import advise_design
from BalloonWorkbench.core.advice.as_data import advice_report
from BalloonWorkbench.core.correction.fit import Method, fit, inflate_outline
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.size_goal import START_WIDTH, Buoyancy, SizeGoal, design_to_size
from BalloonWorkbench.core.design.to_volume import design_to_volume
from BalloonWorkbench.core.design.weld_range import with_weld_range
from BalloonWorkbench.core.errors import BalloonError, InputError, MissingPackageError
from BalloonWorkbench.core.film.filling import Filling
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.machines.machine import ANY, machines
from BalloonWorkbench.core.machines.machine_file import file_of_stock, machine_file
from BalloonWorkbench.core.making.numbers import Numbers, maker_numbers, numbers_report
from BalloonWorkbench.core.making.weight import film_and_valve
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.drawing import ReadingOptions, tracing_of
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.options.making import WeldingOptions
from BalloonWorkbench.core.options.option import unusual
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import InflationOptions
from BalloonWorkbench.core.outline.chambers import linked
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import evened
from BalloonWorkbench.core.outline.validity import scale_to
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.make import make_pattern, pieces_remarks, sheet_of
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.readers.read import read_drawing
from BalloonWorkbench.core.reports import report
from BalloonWorkbench.core.results.result_files import frame_files, results_bytes
from BalloonWorkbench.core.results.stl import stl_bytes
from BalloonWorkbench.core.rounded import rounded, rounded_outline
from BalloonWorkbench.core.solver.dynamics.animation import Frame, inflate_in_time
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.tracing.picture import Decode
from BalloonWorkbench.core.types import Attempt, Progress, insist, no_progress, part_of, rising

DEFAULT_PRESSURE = InflationOptions.pressure
_DESIGNED = 0.8  # of the progress of a design, when its pattern is found


@dataclass(frozen=True)
class Settings(ReadingOptions, InflationOptions):
    """How a balloon is made: how its drawing is read, to what it is inflated, and

    film: of what; model: what is simulated; goal: what the size has to give; filling: what lifts;
    pattern: how the pattern is made; body: of a profile; side_band: between front and back of an outline;
    target: into what a closed body is divided; welding: how fast seams are made.
    """

    film: Film = field(default_factory=lambda: film(DEFAULT_FILM))
    model: Model = field(default_factory=Model)
    goal: SizeGoal | None = None
    filling: Filling = field(default_factory=Filling)
    pattern: PatternOptions = field(default_factory=PatternOptions)
    body: BodyOptions = field(default_factory=BodyOptions)
    side_band: BandOptions = field(default_factory=BandOptions)
    target: TargetOptions = field(default_factory=TargetOptions)
    welding: WeldingOptions = field(default_factory=WeldingOptions)

    @property
    def intake(self) -> bool:
        """Whether the pattern has one."""
        return self.pattern.intake


@dataclass(frozen=True)
class Part:
    """One shape of the drawing as a balloon; numbers: None where an attempt to find them failed."""

    design: Design
    pattern: Pattern
    numbers: Numbers | None


@dataclass(frozen=True)
class Balloon:
    """A finished job: what was drawn, what was found, and the report for people and programs.

    The report is empty where an attempt to make it failed.
    """

    drawing: Drawing
    settings: Settings
    parts: tuple[Part, ...]
    report: dict[str, Any]

    @property
    def design(self) -> Design:
        """The design of the largest shape."""
        return self.parts[0].design

    @property
    def designs(self) -> list[Design]:
        """The designs of all shapes, the largest first."""
        return [part.design for part in self.parts]

    @property
    def patterns(self) -> list[Pattern]:
        """The patterns of all shapes, where the drawing has them."""
        return [part.pattern for part in self.parts]

    @property
    def width(self) -> float:
        """Of the drawing [m]."""
        return self.drawing.size[0]

    @property
    def sheet(self) -> Pattern:
        """All that is cut: the patterns with their pieces, second panels and copies as they are wanted."""
        return on_one_sheet([sheet_of(pattern, self.settings.pattern) for pattern in self.patterns])


def make_balloon(
    path: str | Path,
    settings: Settings,
    *,
    width: float | None = None,
    height: float | None = None,
    decode: Decode | None = None,
    progress: Progress = no_progress,
    attempt: Attempt = insist,
) -> Balloon:
    """Design a balloon for each shape in a drawing file; width and height [m] as in read_drawing.

    With a goal, the largest shape is brought to the size that meets it, and the others with it. decode reads
    pictures where OpenCV is missing; attempt makes what the patterns can do without. Raises BalloonError of
    some kind for anything a user can mend.
    """
    settings = rounded(settings)
    settings.filling.lightness()  # a mistake shows before the work
    remarks = pieces_remarks(settings.pattern, settings.film)
    if settings.goal is not None and width is None and height is None:
        width = START_WIDTH
    drawing, kind = read_shapes(path, settings, width, height, decode)
    drawing = replace(drawing, parts=tuple(linked(part, settings.passage) for part in drawing.parts))
    count = len(drawing.parts)
    designs = [design_outline(drawing.largest, settings, share_of(progress, 0, count))]
    if settings.goal is not None:
        scale = max(designs[0].target.size) / max(drawing.largest.size)
        drawing = drawing.map(lambda loop: loop * scale)
    alike = replace(settings, goal=None)
    outlines = [drawing.largest]
    for number, outline in enumerate(drawing.parts[1:], start=1):
        shared = share_of(progress, number, count)
        design = attempt(f"Balloon {number + 1}", partial(design_outline, outline, alike, shared))
        if design is not None:
            designs.append(design)
            outlines.append(outline)
    drawing = replace(drawing, parts=tuple(outlines))
    made = []
    for design in designs:
        pattern = make_pattern(design.pattern, settings.film.seal_width, settings.pattern)
        pattern = replace(pattern, warnings=(*pattern.warnings, *remarks))
        numbers = attempt("What it takes to make it", partial(_numbers, design, pattern, settings))
        made.append(Part(design, pattern, numbers))
    balloon = Balloon(drawing, settings, tuple(made), {})
    report_data = attempt("report.json", partial(_report, balloon, Path(path).name, kind))
    return replace(balloon, report=report_data or {})


def read_shapes(
    path: str | Path,
    settings: Settings,
    width: float | None = None,
    height: float | None = None,
    decode: Decode | None = None,
) -> tuple[Drawing, str]:
    """The shapes in a drawing file as the settings say how to read it, and what the file is."""
    drawing, kind = read_drawing(path, width, height, decode, settings.drawn_as, tracing_of(settings))
    return scale_to(evened(drawing, settings.symmetry, drawn=kind == "picture"), width, height), kind


def _report(balloon: Balloon, file: str, kind: str) -> dict[str, Any]:
    """The report; empty where the numbers of a balloon are missing."""
    of_parts, settings = [], balloon.settings
    for part, outline in zip(balloon.parts, balloon.drawing.parts, strict=True):
        if part.numbers is None:
            return {}
        source = report.Source(file, kind, outline)
        of_part = report.build(
            source,
            settings.film,
            part.design,
            part.pattern,
            settings.volume,
            settings.filling,
            settings.goal,
            part.numbers.valve,
        )
        of_part["pattern"]["options"] = unusual(settings.pattern)
        of_part["maker"] = numbers_report(part.numbers)
        of_parts.append(
            of_part | advice_report(advise_design(part.design, settings.film, options=settings.pattern))
        )
    return report.together(of_parts, balloon.drawing, balloon.sheet)


def _numbers(design: Design, pattern: Pattern, settings: Settings) -> Numbers:
    """What a maker wants to know."""
    return maker_numbers(
        design.inflation,
        settings.film,
        design.pattern,
        pattern,
        design.target.size[0],
        settings.filling,
        pieces=sheet_of(pattern, replace(settings.pattern, mirror=True, copies=1)),
    )


def share_of(progress: Progress, number: int, count: int) -> Progress:
    """The progress of one of several balloons within that of all."""
    if count == 1:
        return progress
    return lambda fraction, text: progress(
        (number + fraction) / count, f"balloon {number + 1} of {count}, {text}"
    )


def design_outline(outline: Outline, settings: Settings, progress: Progress = no_progress) -> Design:
    """The design of an outline: fitted to it, or with the outline as its pattern.

    Its seam is on the grid on which documents keep it.
    """
    settings, progress = rounded(settings), rising(progress)
    ready = _DESIGNED if settings.correct else 1.0
    design = _designed(rounded_outline(outline), settings, part_of(progress, 0.0, ready))
    design = replace(design, pattern=rounded_outline(design.pattern))
    return with_weld_range(design, settings.film, part_of(progress, ready, 1.0))


def _designed(outline: Outline, settings: Settings, progress: Progress) -> Design:
    work = partial(
        fit if settings.correct else inflate_outline,
        mesh_size=settings.mesh_size,
        backend=settings.backend,
        model=settings.model,
    )
    if settings.goal is not None:
        return _design_to_goal(outline, settings, settings.goal, progress)
    if settings.volume is not None:
        return design_to_volume(work, outline, settings.film, settings.volume, progress=progress)
    return work(outline, settings.film, settings.pressure, progress=progress)


def _design_to_goal(outline: Outline, settings: Settings, goal: SizeGoal, progress: Progress) -> Design:
    """The design of an outline at the size that meets the goal."""
    if settings.volume is not None:
        raise InputError("A volume to inflate to and a goal for the size exclude each other: leave one out.")

    def work(outline: Outline, *, start: Design | None, progress: Progress) -> Design:
        if not settings.correct:
            return _designed(outline, replace(settings, goal=None), progress)
        return fit(
            outline,
            settings.film,
            settings.pressure,
            mesh_size=settings.mesh_size,
            backend=settings.backend,
            model=settings.model,
            method=Method(start=start),
            progress=progress,
        )

    buoyancy = Buoyancy(
        settings.filling.lightness(settings.pressure),
        settings.film.areal_density,
        lambda seam: film_and_valve(seam, settings.film, settings.pattern)[0],
        film_and_valve(outline, settings.film, settings.pattern)[1],
    )
    return design_to_size(work, outline, goal, buoyancy, corrected=settings.correct, progress=progress)


def files(balloon: Balloon, results: str | None = None) -> dict[str, bytes]:
    """Contents of the files of a finished job, by name.

    A file that needs a package that is missing is left out; a warning in the report says so.
    results: "vtu" or "npz" adds a file about every triangle.
    """
    contents, left_out = {}, []
    for name, make in (sheet_makers(balloon.sheet) | makers(balloon, results)).items():
        try:
            contents[name] = make()
        except MissingPackageError as error:
            left_out.append(left_out_text(name, error))
    return contents | {"report.json": report_bytes(balloon.report, left_out)}


def makers(balloon: Balloon, results: str | None = None) -> dict[str, Callable[[], bytes]]:
    """What makes the files of a finished job by name, but the report and those of all that is cut.

    results: as in `files`. They raise MissingPackageError.
    """
    from BalloonWorkbench.core.pictures.preview import preview_png  # not every job has a picture

    film = balloon.settings.film
    named: dict[str, Callable[[], bytes]] = {
        "balloon.stl": lambda: stl_bytes([design.inflation for design in balloon.designs]),
        "preview.png": lambda: preview_png(balloon.designs, balloon.patterns, film.seam),
    }
    if results is not None:
        for number, design in enumerate(balloon.designs):
            name = f"{numbered('results', number)}.{results}"
            named[name] = partial(results_bytes, design.inflation, film, results)
    return named


def sheet_makers(sheet: Pattern) -> dict[str, Callable[[], bytes]]:
    """What makes the files of all that is cut, for any machine, by name."""
    known = machines()
    return {
        file_of_stock(f"pattern.{kind}", stock): partial(machine_file, sheet.of_stock(stock), known[name])
        for kind, name in ANY.items()
        for stock in sheet.stocks
    }


def left_out_text(name: str, why: BalloonError | str) -> str:
    """A warning about a file that could not be made."""
    return f"{name} was left out. {why}"


def report_bytes(report: dict[str, Any], left_out: Sequence[str] = ()) -> bytes:
    """The content of report.json, with warnings about what was left out."""
    data = report | {"warnings": [*report["warnings"], *left_out]}
    text = json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False)
    # letters that are none, as in names of files from other systems, as JSON writes them
    return (text + "\n").encode(errors="backslashreplace")


def inflation_files(
    inflations: Sequence[Inflation], film: Film, frames: int, progress: Progress = no_progress
) -> dict[str, bytes]:
    """Contents of the files that show so many frames of each balloon's inflation in time, by name.

    Raises what inflate_in_time raises.
    """
    contents: dict[str, bytes] = {}
    for number, (blown, strip) in enumerate(blown_up(inflations, film, frames, progress)):
        contents |= frame_files(blown, strip, film, numbered("inflation", number))
    return contents


def blown_up(
    inflations: Sequence[Inflation], film: Film, frames: int, progress: Progress = no_progress
) -> Iterator[tuple[Inflation, tuple[Frame, ...]]]:
    """Each balloon at rest, and so many frames of its inflation. Raises what inflate_in_time raises."""
    for number, inflation in enumerate(inflations):
        solved = inflation.report
        yield inflate_in_time(
            inflation.assembly,
            film,
            solved.pressure,
            frames=frames,
            model=solved.model,
            start=inflation.positions,
            lift=solved.lift,
            progress=share_of(progress, number, len(inflations)),
        )


def numbered(name: str, number: int) -> str:
    """The name of a file about one of several shapes; the largest, number 0, has the plain one."""
    return name if number == 0 else f"{name}-{number + 1}"
