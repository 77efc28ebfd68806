# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python -m BalloonWorkbench design INPUT --width 300mm --out DIR."""

from __future__ import annotations

import argparse
import contextlib
import os
import stat
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli import bed, console, making, many_panels
from BalloonWorkbench.cli import document as cli_document
from BalloonWorkbench.cli.home import home
from BalloonWorkbench.cli.options import FETCH, language_of, parser, typed
from BalloonWorkbench.cli.solid import solid_reader
from BalloonWorkbench.cli.studies.arguments import STUDY
from BalloonWorkbench.cli.summary import bag_summary, summary
from BalloonWorkbench.core.bag_design.source import PANELS, Readers, form_of
from BalloonWorkbench.core.bag_job import FinishedBags, bag_makers, has_many_panels, make_bags
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.errors import (
    BalloonError,
    ExportError,
    InputError,
    MissingPackageError,
    ProgramFault,
)
from BalloonWorkbench.core.faults import UNFORESEEN, report_fault
from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.film.filling import Filling, gas
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import custom_film, film, with_grain, with_weld
from BalloonWorkbench.core.job import (
    Balloon,
    Settings,
    inflation_files,
    left_out_text,
    make_balloon,
    makers,
    report_bytes,
)
from BalloonWorkbench.core.language.speech import speech
from BalloonWorkbench.core.machines.bed import SCALE
from BalloonWorkbench.core.machines.machine import Machine, left_out
from BalloonWorkbench.core.machines.machine_file import checked_files, machines_for
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.drawing import FillingOptions, ReadingOptions
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.options.making import WeldingOptions
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.native import load, native_wheel
from BalloonWorkbench.core.tracing.raster import opencv
from BalloonWorkbench.core.types import Made, Progress, Say, in_english
from BalloonWorkbench.core.units import number_text

FAULT, INTERRUPTED = 70, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns an exit code of docs/command-line.md, with a line on stderr unless it is 0."""
    console.quiet()
    run = _Run()
    try:
        with console.signals_are_errors():
            run.say = speech(language_of(arguments))
            with home():
                for sentence in left_out():
                    run.complain(sentence)
                options = parser().parse_args(arguments)
                if options.command == STUDY:
                    return run.study(options)
                if options.command != FETCH:
                    return run.command(options)
            return run.fetch_solver()  # into the user's own home, if anywhere there
    except BalloonError as error:
        run.complain(error)
        return FAULT if isinstance(error, ProgramFault) else 2
    except KeyboardInterrupt:
        run.complain(f"stopped; {run.outcome()}.")
        return INTERRUPTED
    except console.Ended as ended:
        run.complain(f"stopped; {run.outcome()}.")
        return ended.end()
    except Exception as error:  # noqa: BLE001 - the command line is a border
        run.complain(report_fault(error, "designing a balloon"))
        return FAULT


class _Run:
    """One run: its language, the files that were written, what was left out, and the first fault."""

    def __init__(self) -> None:
        self.say: Say = in_english
        self._paths: tuple[Path, ...] = ()
        self._left_out: list[str] = []
        self._fault: ProgramFault | None = None
        self._left = "no file was written"

    def complain(self, text: object) -> None:
        """One line on stderr, in the language of the run."""
        console.complain(self.say(str(text)))

    def _progress(self, line: console.StatusLine) -> Progress:
        return lambda fraction, text: line.show(fraction, self.say(text))

    def outcome(self) -> str:
        """Whether files were written, as the end of a sentence."""
        if not self._paths:
            return self._left
        return f"all files were written before to {self._paths[0].parent}"

    def command(self, options: argparse.Namespace) -> int:
        """Do what the options say."""
        width, height = options.width, options.height
        settings = _settings(options)
        for name in (options.input, options.artwork, options.artwork_back, *options.machine):
            _refuse_streams(name)
        # a mistake shows before the work
        many = has_many_panels(settings, options.input)
        if many:
            many_panels.check(options)
        chosen, doubts = machines_for(settings.film, bed.machines_of(options))
        make = making.checked(options, _decode(), self.say)
        check_folder(options.out)
        line = console.StatusLine(sys.stderr)
        progress = self._progress(line)

        def design(size: bed.Size, scale: float = 1.0) -> Balloon | FinishedBags:
            known: dict[str, Any] = {"progress": progress, "attempt": self._attempt, **_readers(many)}
            if form_of(options.input) == PANELS:  # it has its own size; another one is refused
                asked = {"width": options.width, "height": options.height}
                return make_bags(options.input, settings, scale=scale, **asked, **known)
            making_of = make_bags if many else make_balloon
            return making_of(options.input, settings, width=size[0], height=size[1], **known)

        smaller: list[str] = []
        try:
            balloon = design((width, height))
            if options.oversize == SCALE:
                balloon, (width, height), smaller = bed.scaled_to_fit(
                    balloon, chosen, (width, height), design
                )
            if settings.goal is not None:
                width = balloon.width
            with (
                many_panels.file_of(options.input, balloon) as file,
                cli_document.document(file, settings, balloon.designs, width, height) as document,
            ):
                contents, lines = self._contents(balloon, chosen, options, make, progress)
                made = document and self._attempt(cli_document.NAME, document.content)
            if made:
                contents[cli_document.NAME] = made
        finally:
            line.clear()
        if balloon.report:
            report = self._attempt("report.json", lambda: report_bytes(balloon.report, self._left_out))
            contents |= {} if report is None else {"report.json": report}
        if not contents:
            raise self._fault or ExportError("\n".join(["No file could be made.", *self._left_out]))
        write_files(options.out, contents, self._written)
        return self._print_summary(
            balloon, [*(self.say(f"Check: {doubt}") for doubt in doubts), *map(self.say, smaller), *lines]
        )

    def study(self, options: argparse.Namespace) -> int:
        """Do what the options of a study say."""
        from BalloonWorkbench.cli.studies import command  # only here: no other command needs it

        self._left = "the balloons that were made stay, and the same command goes on"
        return command.run(options, self.say)

    def _contents(
        self,
        balloon: Balloon | FinishedBags,
        chosen: Sequence[Machine],
        options: argparse.Namespace,
        make: Callable[..., Any],
        progress: Progress,
    ) -> tuple[dict[str, bytes], list[str]]:
        """Contents of the files that can be made, by name, and lines for the user."""
        progress(1.0, "writing files")
        contents: dict[str, bytes] = {}
        pattern_makers = self._attempt("The file of the pattern", lambda: _makers(balloon, options.results))
        for name, maker in (pattern_makers or {}).items():
            content = self._attempt(name, maker)
            if content is not None:
                contents[name] = content
        if options.frames is not None:
            blown, film = [design.inflation for design in balloon.designs], balloon.settings.film
            blow_up = partial(inflation_files, blown, film, options.frames, progress)
            contents |= self._attempt("inflation.pvd", blow_up) or {}
        lines = [f"{self.say(each.title)}: {self.say(each.note)}" for each in chosen]
        asked = [(each.file_name, [each], None) for each in chosen]
        if options.tiled is not None:
            asked.append((f"pattern-{options.tiled.lower()}.pdf", [], options.tiled))
        refused: list[ExportError] = []
        for name, machines, paper in asked:
            try:
                work = partial(checked_files, balloon.sheet, machines, paper, options.oversize, self.say)
                made = self._attempt(name, work)
            except ExportError as error:
                refused.append(error)
                continue
            if made is not None:
                contents |= made[0]
                lines += [self.say(f"Check: {remark}") for remark in made[1]]
        if refused and len(refused) == len(asked):
            raise ExportError("\n".join([*map(str, refused), *bed.ways_on(balloon, chosen)]))
        self._left_out += [*map(str, refused), *(bed.ways_on(balloon, chosen) if refused else [])]
        more = self._attempt("The rest of the job", lambda: make(balloon, chosen, progress, self._attempt))
        files, remarks = more or ({}, [])
        return contents | files, [*lines, *remarks]

    def _attempt(self, what: str, make: Callable[[], Made], /) -> Made | None:
        """Make something that the other files can do without: see core/types.py."""
        try:
            return make()
        except ProgramFault as fault:
            error = fault
        except MissingPackageError as missing:
            self._left_out.append(left_out_text(what, missing))
            return None
        except BalloonError:
            raise
        except UNFORESEEN as unforeseen:
            error = report_fault(unforeseen, f"making {what}")
        self._left_out.append(left_out_text(what, error))
        self._fault = self._fault or error
        return None

    def _written(self, paths: tuple[Path, ...]) -> None:
        self._paths = paths

    def fetch_solver(self) -> int:
        """Fetch the native solver, telling before from where and where to; the exit code."""
        if load.problem_with_library() is None:
            return self._show("The native solver is here already.")
        wheel = native_wheel.wheel()
        failure = self._show(
            f"Fetching {wheel.address} ({number_text(wheel.size / 1e6, 2)} MB) "
            f"into {native_wheel.place()}; only the file with SHA-256 {wheel.sha256} is kept."
        )
        line = console.StatusLine(sys.stderr)
        try:
            native_wheel.fetch(wheel, self._progress(line))
        finally:
            line.clear()
        return failure or self._show("The native solver is in use now.")

    def _show(self, text: str) -> int:
        """Show a line; the exit code."""
        return 0 if console.show(f"{self.say(text)}\n") is None else console.UNSHOWN

    def _print_summary(self, balloon: Balloon | FinishedBags, lines: Sequence[str]) -> int:
        """Tell what was found and written; the exit code."""
        say, settings = self.say, balloon.settings
        many = isinstance(balloon, FinishedBags)
        output = (bag_summary if many else summary)(balloon.report, settings.film, settings.correct, say)
        slow = native_wheel.slow_notes() if settings.backend is None else []
        output += [say(f"Note: {say(note)}") for note in (*self._left_out, *slow)]
        output += [*lines, *(say(f"Wrote {path}") for path in self._paths)]
        problem = console.show("\n".join(output) + "\n")
        if self._fault is not None:
            self.complain(self._fault)
            return FAULT
        if problem is not None:
            self.complain(f"The summary cannot be shown ({problem.strerror}); {self.outcome()}.")
            return console.UNSHOWN
        return 0


def run_quietly(options: argparse.Namespace) -> None:
    """Do what the options say, and tell nothing of it; raises BalloonError, and what nobody foresaw."""
    with contextlib.redirect_stdout(None), contextlib.redirect_stderr(None):
        _Run().command(options)


def balloon_alone(options: argparse.Namespace) -> Balloon | FinishedBags:
    """The balloon that the options ask for, without any file. Raises what the commands raise."""
    settings = _settings(options)
    many = has_many_panels(settings, options.input)
    if many:
        many_panels.check(options)
    make = make_bags if many else make_balloon
    size = {"width": options.width, "height": options.height}
    return make(options.input, settings, **size, **_readers(many))


def _makers(balloon: Balloon | FinishedBags, results: str | None) -> dict[str, Callable[[], bytes]]:
    return bag_makers(balloon, results) if isinstance(balloon, FinishedBags) else makers(balloon, results)


def _refuse_streams(name: str | None) -> None:
    """Pipes and devices may never end, and are read more than once. InputError."""
    with contextlib.suppress(OSError):  # who reads it says what is wrong
        mode = os.stat(name or "").st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise InputError(f"'{name}' is a pipe or a device: save what comes from it, and name that file.")


def _settings(options: argparse.Namespace) -> Settings:
    filling = typed(options, FillingOptions)
    inflation = replace(typed(options, InflationOptions), correct=options.command == "design")
    return Settings(
        **vars(typed(options, ReadingOptions)),
        **vars(inflation),
        film=_film(options),
        model=Model(**vars(typed(options, ModelOptions))),
        goal=_goal(options),
        filling=Filling(**{**vars(filling), "gas": gas(filling.gas)}),
        pattern=typed(options, PatternOptions),
        body=typed(options, BodyOptions),
        side_band=typed(options, BandOptions),
        target=typed(options, TargetOptions),
        welding=typed(options, WeldingOptions),
    )


def _goal(options: argparse.Namespace) -> SizeGoal | None:
    goal = typed(options, SizeGoal)
    if goal == SizeGoal():
        return None
    if options.width is not None or options.height is not None:
        raise InputError("--target-volume and --target-lift decide the size: leave out --width and --height.")
    return goal


def _film(options: argparse.Namespace) -> Film:
    own = (options.young, options.poisson, options.thickness)
    if all(value is None for value in own):
        plain = film(options.material or DEFAULT_FILM)
    elif options.material is not None or any(value is None for value in own):
        raise InputError("Give either --material, or all of --young, --poisson and --thickness.")
    else:
        plain = custom_film(*own)
    if options.weld_rigidity is not None:
        plain = with_weld(plain, options.weld_rigidity)
    if options.young_across is not None:
        return with_grain(plain, options.young_across, options.grain)
    if options.grain:
        raise InputError("Only a film with another stiffness across has a grain: give --young-across too.")
    return plain


def _readers(many: bool) -> dict[str, Any]:
    """What reads the files that the engine does not, as the jobs ask for it; many: for many panels."""
    return {"readers": Readers(_decode(), solid_reader())} if many else {"decode": _decode()}


def _decode() -> Any:
    """Qt's picture reader where OpenCV is missing; None means OpenCV."""
    if opencv() is not None:
        return None
    try:
        from BalloonWorkbench.app.drawings import qt_picture
    except ImportError:
        return None  # the reader of pictures says what to install
    return qt_picture.decode
