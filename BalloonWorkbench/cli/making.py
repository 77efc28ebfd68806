# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making a balloon from the command line: prints, layout on film, assembly sheet."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from BalloonWorkbench.cli.console import readable
from BalloonWorkbench.core.errors import ExportError, InputError, MarksError
from BalloonWorkbench.core.job import Balloon
from BalloonWorkbench.core.language.speech import chosen_language
from BalloonWorkbench.core.machines.machine import ANY, Machine, machine, machines
from BalloonWorkbench.core.machines.machine_file import checked_files, file_of_stock
from BalloonWorkbench.core.machines.marks.choose import marks_for, other_marks
from BalloonWorkbench.core.options.making import HTML
from BalloonWorkbench.core.tracing.picture_file import decode, picture_size
from BalloonWorkbench.core.types import Attempt, Progress, Say
from BalloonWorkbench.core.units import (
    area_text,
    number_text,
    parse_size,
    percent_text,
    size_text,
)

if TYPE_CHECKING:  # only what is asked for is loaded
    from BalloonWorkbench.core.bag_job import FinishedBags
    from BalloonWorkbench.core.nesting.layout import Layout, Piece, Stock
    from BalloonWorkbench.core.nesting.remnant import Remnant
    from BalloonWorkbench.core.products import Artwork


def checked(
    options: argparse.Namespace, reader: Callable[[Path], Any] | None, say: Say
) -> Callable[..., Any]:
    """Look at the options before the work; returns what makes the files of a balloon.

    reader  of pictures, None for OpenCV; say gives texts in the user's language
    Raises InputError for options that make no sense.
    """
    artwork = _artwork(options, reader or decode)
    film = _film(options)
    grounds = _grounds(options, reader or decode)
    language = chosen_language(options.language, os.environ)

    def make(
        balloon: Balloon | FinishedBags, chosen: Sequence[Machine], progress: Progress, attempt: Attempt
    ) -> tuple[dict[str, bytes], list[str]]:
        """Contents of the files by name, and lines for the user; each option is an attempt of its own."""
        asked = list(chosen) or [machines()[name] for name in ANY.values()]
        made: list[tuple[Mapping[str, bytes], list[str]] | None] = []
        if artwork is not None:
            progress(1.0, "printing")
            made.append(
                attempt("The print on film", lambda: _print(balloon, artwork, asked, options.oversize, say))
            )
        if film is not None:
            made.append(
                attempt(
                    "The layout on film",
                    lambda: _nest(balloon, film, options, asked, progress, say),
                )
            )
        title = readable(Path(options.input).stem).capitalize()
        for name, content in _shared(balloon, title, artwork, options, grounds, say, language).items():
            made.append(attempt(name, partial(_alone, name, content)))
        if options.animation is not None:
            from BalloonWorkbench.core.shared.animation import animation_file

            name = f"inflation.{options.animation}"
            moving = partial(animation_file, balloon, options.animation, artwork, progress)
            made.append(attempt(name, lambda: ({name: moving()}, [])))
        if options.assembly is not None:
            from BalloonWorkbench.core.products import assembly_files

            sheets = partial(assembly_files, balloon, title, options.assembly, say, chosen)
            made.append(attempt("assembly.pdf", lambda: (sheets(), [])))
        done = [each for each in made if each is not None]
        contents = {name: content for files, _ in done for name, content in files.items()}
        return contents, [line for _, lines in done for line in lines]

    return make


def _grounds(options: argparse.Namespace, reader: Callable[[Path], Any]) -> tuple[Any, Any]:
    """What is behind the balloon in its picture and on its page."""
    if not (options.png or options.report == HTML):
        if options.ground is not None:
            raise InputError("Give --png or --report html with --ground: it is the ground of these.")
        return None, None
    from BalloonWorkbench.core.scenes.ground import WHITE, read_ground

    def read(path: Path) -> Any:
        picture_size(path)
        return reader(path)

    behind = read_ground(options.ground, WHITE, read)
    return behind, None if options.ground is None else behind


def _alone(name: str, content: Callable[[], bytes]) -> tuple[dict[str, bytes], list[str]]:
    return {name: content()}, []


def _shared(
    balloon: Balloon | FinishedBags,
    title: str,
    artwork: Artwork | None,
    options: argparse.Namespace,
    grounds: tuple[Any, Any],
    say: Say,
    language: str,
) -> dict[str, Callable[[], bytes]]:
    """What shows the balloon to others, by the names of the files."""
    if not (options.glb or options.png or options.report == HTML):
        return {}
    from BalloonWorkbench.core.shared import sharing

    picture, page = grounds
    made: dict[str, Callable[[], bytes]] = {}
    if options.glb:
        made[sharing.GLB] = partial(sharing.glb_file, balloon, title, artwork)
    if options.png:
        made[sharing.PICTURE] = partial(sharing.picture_file, balloon, artwork, picture)
    if options.report == HTML:
        made[sharing.PAGE] = partial(sharing.page_file, balloon, title, artwork, say, language, page)
    return made


def _print(
    balloon: Balloon | FinishedBags, artwork: Artwork, asked: Sequence[Machine], oversize: str, say: Say
) -> tuple[dict[str, bytes], list[str]]:
    """What is printed and cut; a line says why not where the marks do not fit round the print."""
    from BalloonWorkbench.core.bag_job import FinishedBags
    from BalloonWorkbench.core.products import bag_print, print_files

    try:
        if isinstance(balloon, FinishedBags):
            files, remarks, sheet = bag_print(balloon, artwork, asked)
            sides = [("", "", sheet)]
        else:
            files, remarks, front, back = print_files(balloon, artwork, asked)
            sides = [("front-", say("front"), front), ("back-", say("back"), back)]
    except MarksError as error:
        return {}, [say(f"Left out: {error}")]
    contents = dict(files)
    lines = [say(f"Note: {remark}") for remark in (*remarks, *other_marks(artwork.marks, asked))]
    shops = {each.file_name for each in asked if each.spots}  # they have print and cut in one
    for side, seen, sheet in sides:
        try:
            made, doubts = checked_files(sheet.pattern, asked, oversize=oversize)
        except ExportError as error:  # the print is as good as it is
            lines.append(say(f"Left out: {error}"))
            continue
        contents |= {f"print-{side}{name}": content for name, content in made.items() if name not in shops}
        lines += [say(f"Check, {seen}: {doubt}" if seen else f"Check: {doubt}") for doubt in doubts]
    size, dpi = size_text(*sides[0][2].size), number_text(sides[0][2].dpi)
    lines.append(say(f"Print {size} at {dpi} dpi, {'front and back' if len(sides) > 1 else 'all panels'}"))
    return contents, lines


def _artwork(options: argparse.Namespace, reader: Callable[[Path], Any]) -> Artwork | None:
    if options.artwork is None:
        if options.artwork_back is not None:
            raise InputError("Give --artwork for the front too.")
        return None
    from BalloonWorkbench.cli.options import typed
    from BalloonWorkbench.core.options.drawing import TracingOptions
    from BalloonWorkbench.core.products import Artwork

    paths = [Path(name) for name in (options.artwork, options.artwork_back) if name is not None]
    for path in paths:
        picture_size(path)
    front, *back = (reader(path) for path in paths)
    traced = Path(options.input).exists() and paths[0].read_bytes() == Path(options.input).read_bytes()
    marks = marks_for(options.marks_for, [machine(name) for name in options.machine])
    behind = back[0] if back else None
    tracing = typed(options, TracingOptions)
    return Artwork(front, traced, behind, options.dpi, options.bleed, options.drawn_as, marks, tracing)


def _film(options: argparse.Namespace) -> tuple[Stock, list[Remnant]] | None:
    """What panels are laid out on: '500mm', '500mmx700mm' or '50 x 70 cm', width and length of a sheet; and
    remnants, which are all of it where no size is given. None where nothing is laid out."""
    if options.nest is None and options.on_remnant is None:
        if options.keep_remnant:
            raise InputError("A remnant is left of a layout: give --nest too, such as --nest 500mm.")
        return None
    from BalloonWorkbench.core.nesting.layout import GrainRule, Stock
    from BalloonWorkbench.core.nesting.remnant import read_remnants

    remnants = [] if options.on_remnant is None else read_remnants(Path(options.on_remnant))
    width, length = remnants[0].size[::-1] if options.nest is None else parse_size(options.nest)
    return Stock(width, length, options.spacing, GrainRule(options.grain_lies)), remnants


def _nest(
    balloon: Balloon | FinishedBags,
    film: tuple[Stock, list[Remnant]],
    options: argparse.Namespace,
    machines: Sequence[Machine],
    progress: Progress,
    say: Say,
) -> tuple[dict[str, bytes], list[str]]:
    from BalloonWorkbench.core.products import nested

    contents: dict[str, bytes] = {}
    lines: list[str] = []
    notes: list[str] = []
    laid = nested(balloon, film[0], options.balloons, progress, film[1], options.nest is None)
    for stock, (layouts, pieces, remarks) in laid.items():
        title = f"{stock} film".strip().capitalize()
        notes += remarks
        for number, layout in enumerate(layouts, 1):
            suffix, which = "" if number == 1 else f"-{number}", f"{say(title)} {number}"
            for each in machines:
                try:
                    made, doubts = checked_files(layout.pattern(pieces), [each], oversize=options.oversize)
                except ExportError as error:
                    lines.append(say(f"Left out: {error}"))
                    continue
                contents |= {f"nested{suffix}-{name}": content for name, content in made.items()}
                lines += [say(f"Check, {which}: {doubt}") for doubt in doubts]
            lines.append(say(f"{which}: {_used(layout)}"))
        if options.keep_remnant:
            files, remark = _left(layouts, pieces, stock)
            contents |= files
            lines.append(say(f"{say(title)}: {remark}"))
    lines += [say(f"Note: {remark}") for remark in dict.fromkeys(notes)]
    return contents, lines


def _used(layout: Layout) -> str:
    """What a layout takes of its film."""
    size, used = size_text(layout.length, layout.stock.width), percent_text(layout.utilisation)
    if layout.stock.remnant:
        return f"pieces {len(layout.places)}, on a remnant of {size}, {used} used"
    return f"pieces {len(layout.places)}, on {size}, {used} used"


def _left(layouts: Sequence[Layout], pieces: Sequence[Piece], stock: str) -> tuple[dict[str, bytes], str]:
    """The file of what is left of a film, and what to say about it."""
    from BalloonWorkbench.core.nesting.layout import left_of
    from BalloonWorkbench.core.nesting.remnant import FILE, remnant_bytes

    left = [each for layout in layouts for each in left_of(layout, pieces)]
    if not left:
        return {}, "nothing is left that is large enough to be used again"
    area = area_text(sum(float(each.area.area) for each in left))
    return {file_of_stock(FILE, stock): remnant_bytes(left)}, f"remnants {len(left)}, {area}"
