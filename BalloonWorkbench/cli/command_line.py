# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python -m BalloonWorkbench design INPUT --width 300mm --out DIR."""

from __future__ import annotations

import argparse
import contextlib
import os
import stat
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from BalloonWorkbench.cli import bed, console, making, many_panels
from BalloonWorkbench.cli import document as cli_document
from BalloonWorkbench.cli.compare.arguments import COMPARE
from BalloonWorkbench.cli.freecad_process import FreecadProcess
from BalloonWorkbench.cli.home import home
from BalloonWorkbench.cli.options import FETCH, language_of, parser
from BalloonWorkbench.cli.settings import balloon_of, picture_reader, settings_of
from BalloonWorkbench.cli.studies.arguments import STUDY
from BalloonWorkbench.cli.summary import bag_summary, summary
from BalloonWorkbench.cli.test_cards.arguments import TEST_CARD
from BalloonWorkbench.core.errors import (
    BalloonError,
    ExportError,
    InputError,
    MissingPackageError,
    ProgramFault,
)
from BalloonWorkbench.core.faults import UNFORESEEN, report_fault
from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.job import (
    Balloon,
    Settings,
    inflation_files,
    left_out_text,
    makers,
    report_bytes,
    sheet_makers,
)
from BalloonWorkbench.core.language.speech import speech
from BalloonWorkbench.core.machines.machine import Machine, left_out
from BalloonWorkbench.core.machines.machine_file import checked_files, machines_for
from BalloonWorkbench.core.options.making import SCALE, is_wanted
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.targets.form import has_many_panels
from BalloonWorkbench.core.types import Made, Progress, Say, in_english
from BalloonWorkbench.core.units import number_text

if TYPE_CHECKING:  # what few commands need is loaded by them
    from BalloonWorkbench.core.bag_job import FinishedBags

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
                if options.command == COMPARE:
                    return run.compare(options)
                if options.command == TEST_CARD:
                    return run.test_card(options)
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
        self._many = False  # panels, not two equal ones
        self._fault: ProgramFault | None = None
        self._left = "no file was written"

    def complain(self, text: object) -> None:
        """One line on stderr, in the language of the run."""
        console.complain(self.say(str(text)))

    def _progress(self, line: console.StatusLine) -> Progress:
        return lambda fraction, text: line.show(fraction, self.say(text))

    def _file_of(self, path: str, balloon: Any) -> contextlib.AbstractContextManager[str]:
        """The file that the document is made of."""
        return many_panels.file_of(path, balloon) if self._many else contextlib.nullcontext(path)

    def _document(
        self, options: argparse.Namespace, file: str, balloon: Balloon | FinishedBags, size: bed.Size
    ) -> contextlib.AbstractContextManager[FreecadProcess | None]:
        """The document, begun; None where it is not wanted."""
        if not is_wanted(cli_document.NAME, options.only):
            return contextlib.nullcontext()
        return cli_document.document(file, balloon.settings, balloon.designs, *size)

    def _makers(self, balloon: Any, results: str | None) -> dict[str, Callable[[], bytes]]:
        """What makes the files of a balloon."""
        if not self._many:
            return makers(balloon, results)
        from BalloonWorkbench.core.bag_job import bag_makers

        return bag_makers(balloon, results)

    def outcome(self) -> str:
        """Whether files were written, as the end of a sentence."""
        if not self._paths:
            return self._left
        return f"all files were written before to {self._paths[0].parent}"

    def study(self, options: argparse.Namespace) -> int:
        """Do what the options of a study say."""
        from BalloonWorkbench.cli.studies import command  # only here: no other command needs it

        self._left = "the balloons that were made stay, and the same command goes on"
        return command.run(options, self.say)

    def compare(self, options: argparse.Namespace) -> int:
        """Lay a photograph over what was worked out."""
        from BalloonWorkbench.cli.compare import command  # only here: no other command needs it

        for name in (options.photo, options.input):
            _refuse_streams(name)
        return command.run(options, self.say)

    def test_card(self, options: argparse.Namespace) -> int:
        """Make a test card, or keep what came out."""
        from BalloonWorkbench.cli.test_cards import command  # only here: no other command needs it

        return command.run(options, self.say)

    def command(self, options: argparse.Namespace) -> int:
        """Do what the options say."""
        settings = settings_of(options)
        for name in (options.input, options.artwork, options.artwork_back, *options.machine):
            _refuse_streams(name)
        # a mistake shows before the work
        self._many = has_many_panels(options.input, settings.body, settings.side_band)
        if self._many:
            many_panels.check(options)
        chosen, doubts = machines_for(settings.film, bed.machines_of(options))
        make = making.checked(options, picture_reader(), self.say)
        check_folder(options.out)
        load.use_threads(options.threads)
        line = console.StatusLine(sys.stderr)
        progress = self._progress(line)
        try:
            balloon, size, smaller = self._balloon(options, settings, chosen, progress)
            progress(1.0, "writing files")
            contents = self._pattern_files(balloon, options.only)  # whose curves the document has too
            with (
                self._file_of(options.input, balloon) as file,
                self._document(options, file, balloon, size) as document,
            ):
                more, lines = self._contents(balloon, chosen, options, make, progress)
                made = document and self._attempt(cli_document.NAME, document.content)
            contents |= more
            if made:
                contents[cli_document.NAME] = made
        finally:
            line.clear()
        if balloon.report and is_wanted("report.json", options.only):
            report = self._attempt("report.json", lambda: report_bytes(balloon.report, self._left_out))
            contents |= {} if report is None else {"report.json": report}
        if not contents:
            raise self._fault or ExportError("\n".join(["No file could be made.", *self._left_out]))
        write_files(options.out, contents, self._written)
        return self._print_summary(
            balloon, [*(self.say(f"Check: {doubt}") for doubt in doubts), *map(self.say, smaller), *lines]
        )

    def _balloon(
        self, options: argparse.Namespace, settings: Settings, chosen: Sequence[Machine], progress: Progress
    ) -> tuple[Balloon | FinishedBags, bed.Size, list[str]]:
        """The finished job, the size of its drawing, and a line for the user where it is smaller."""

        def design(size: bed.Size, scale: float = 1.0) -> Balloon | FinishedBags:
            return balloon_of(options, settings, size, scale, progress=progress, attempt=self._attempt)

        size, smaller = (options.width, options.height), list[str]()
        balloon = design(size)
        if options.oversize == SCALE:
            balloon, size, smaller = bed.scaled_to_fit(balloon, chosen, size, design)
        return balloon, (size if settings.goal is None else (balloon.width, size[1])), smaller

    def _pattern_files(self, balloon: Balloon | FinishedBags, only: tuple[str, ...]) -> dict[str, bytes]:
        """Contents of the files of all that is cut, those that can be made and are wanted."""
        makers = self._attempt("The file of the pattern", lambda: sheet_makers(balloon.sheet))
        return self._made(makers or {}, only)

    def _made(self, makers: dict[str, Callable[[], bytes]], only: tuple[str, ...]) -> dict[str, bytes]:
        """Contents of the files that can be made and are wanted, by name."""
        made = {name: self._attempt(name, make) for name, make in makers.items() if is_wanted(name, only)}
        return {name: content for name, content in made.items() if content is not None}

    def _contents(
        self,
        balloon: Balloon | FinishedBags,
        chosen: Sequence[Machine],
        options: argparse.Namespace,
        make: Callable[..., Any],
        progress: Progress,
    ) -> tuple[dict[str, bytes], list[str]]:
        """Contents of the other files that can be made, by name, and lines for the user."""
        shown = self._attempt("What shows the balloon", lambda: self._makers(balloon, options.results))
        contents = self._made(shown or {}, options.only)
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
        told = [*map(str, refused), *(bed.ways_on(balloon, chosen) if refused else [])]
        nothing = bool(refused) and len(refused) == len(asked)
        if nothing and options.nest is None and options.on_remnant is None:
            raise ExportError("\n".join(told))
        more = self._attempt("The rest of the job", lambda: make(balloon, chosen, progress, self._attempt))
        files, remarks = more or ({}, [])
        if nothing and not any(name.startswith("nested") for name in files):  # nor laid out on film
            raise ExportError("\n".join(told))
        self._left_out += told
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
        from BalloonWorkbench.core.solver.native import native_wheel

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

    def _slow_notes(self) -> list[str]:
        """Sentences where the native solver is not in use."""
        if load.problem_with_library() is None:
            return []
        from BalloonWorkbench.core.solver.native import native_wheel

        return native_wheel.slow_notes()

    def _show(self, text: str) -> int:
        """Show a line; the exit code."""
        return 0 if console.show(f"{self.say(text)}\n") is None else console.UNSHOWN

    def _print_summary(self, balloon: Balloon | FinishedBags, lines: Sequence[str]) -> int:
        """Tell what was found and written; the exit code."""
        say, settings = self.say, balloon.settings
        output = (bag_summary if self._many else summary)(
            balloon.report, settings.film, settings.correct, say
        )
        slow = self._slow_notes() if settings.backend is None else []
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


def _refuse_streams(name: str | None) -> None:
    """Pipes and devices may never end, and are read more than once. InputError."""
    with contextlib.suppress(OSError):  # who reads it says what is wrong
        mode = os.stat(name or "").st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise InputError(f"'{name}' is a pipe or a device: save what comes from it, and name that file.")
