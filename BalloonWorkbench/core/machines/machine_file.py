# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as the file that a machine's program reads."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from BalloonWorkbench.core.errors import ExportError, MissingPackageError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.machines.bed import fits
from BalloonWorkbench.core.machines.machine import FOLDER, Machine, read_machine
from BalloonWorkbench.core.machines.marks.over_beds import over_beds
from BalloonWorkbench.core.machines.preflight import ERROR, PreflightFinding, film_preflight, preflight
from BalloonWorkbench.core.machines.toolpaths import Toolpaths, draw
from BalloonWorkbench.core.machines.writers.dxf import drawing_dxf
from BalloonWorkbench.core.machines.writers.gcode import drawing_gcode
from BalloonWorkbench.core.machines.writers.hpgl import drawing_hpgl
from BalloonWorkbench.core.machines.writers.lightburn import drawing_lightburn
from BalloonWorkbench.core.machines.writers.svg import drawing_svg
from BalloonWorkbench.core.options.making import REFUSE, SPLIT
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.types import Say, in_english

_WRITERS = {
    "dxf": drawing_dxf,
    "svg": drawing_svg,
    "hpgl": drawing_hpgl,
    "lbrn2": drawing_lightburn,
    "gcode": drawing_gcode,
}


def machine_file(
    pattern: Pattern, machine: Machine, tiled: str | None = None, say: Say = in_english
) -> bytes:
    """The content of the file; tiled on "A4", "A3" or "Letter" for a PDF, whose texts `say` gives.

    Raises ExportError when the machine's format has no pages, or nothing of the pattern is for it.
    """
    return drawing_file(draw(pattern, machine), machine, tiled, say)


def drawing_file(
    drawing: Toolpaths, machine: Machine, tiled: str | None = None, say: Say = in_english
) -> bytes:
    """The same for a drawing that is already made for the machine."""
    if tiled is None and machine.format != "pdf":
        return _WRITERS[machine.format](drawing, machine)
    if machine.format != "pdf":
        raise ExportError(
            f"{machine.title} reads {machine.format.upper()}, which has no pages: choose paper."
        )
    from BalloonWorkbench.core.machines.writers.pdf import drawing_pdf, tiled_pdf

    if tiled is None:
        return drawing_pdf(drawing, machine, say)
    return tiled_pdf(drawing, machine, tiled, say)


def machines_for(film: Film, chosen: Sequence[Machine]) -> tuple[list[Machine], tuple[str, ...]]:
    """Those of several machines that a film bears, and what is doubtful, a sentence each.

    Raises ExportError where it bears none of them.
    """
    borne: list[Machine] = []
    doubts: list[str] = []
    refused: list[ExportError] = []
    for machine in chosen:
        try:
            doubts += _doubts(film_preflight(film, machine), machine)
            borne.append(machine)
        except ExportError as error:
            refused.append(error)
    if refused and not borne:
        raise ExportError(" ".join(map(str, refused)))
    return borne, (*doubts, *map(str, refused))


def checked_files(
    pattern: Pattern,
    chosen: Sequence[Machine],
    paper: str | None = None,
    oversize: str = REFUSE,
    say: Say = in_english,
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Contents of the files for several machines by name, and what is doubtful about them, a sentence each.

    What is cut from another film than the balloon's has files of its own. A machine that cannot make the
    pattern, or whose format needs a package that is missing, is left out with a sentence. paper adds the
    pattern on pages of "A4", "A3" or "Letter"; oversize as for `preflight`.
    Raises ExportError or MissingPackageError where nothing is left for all of them.
    """
    contents: dict[str, bytes] = {}
    remarks: list[str] = []
    left_out: list[ExportError | MissingPackageError] = []
    for machine in chosen:
        try:
            files, doubts = _files(pattern, machine, oversize)
            contents |= files
            remarks += doubts
        except (ExportError, MissingPackageError) as error:
            left_out.append(error)
    if left_out and not contents:
        raise left_out[0] if len(left_out) == 1 else ExportError("\n".join(map(str, left_out)))
    for stock in pattern.stocks if paper is not None else ():
        name = file_of_stock(f"pattern-{str(paper).lower()}.pdf", stock)
        contents[name] = machine_file(
            pattern.of_stock(stock), read_machine(FOLDER / "paper.json"), paper, say
        )
    return contents, tuple(dict.fromkeys([*remarks, *map(str, left_out)]))


def _files(pattern: Pattern, machine: Machine, oversize: str) -> tuple[dict[str, bytes], list[str]]:
    """The files for one machine, one for each film, and what is doubtful; ExportError for what it cannot."""
    contents: dict[str, bytes] = {}
    doubts: list[str] = []
    for stock in pattern.stocks:
        part = pattern.of_stock(stock)
        doubts += _doubts(preflight(part, machine, oversize), machine)
        name = file_of_stock(machine.file_name, stock)
        for number, drawing in enumerate(drawings(part, machine, oversize), 1):
            contents[numbered_file(name, number)] = drawing_file(drawing, machine)
    return contents, doubts


def drawings(pattern: Pattern, machine: Machine, oversize: str) -> list[Toolpaths]:
    """What is cut from one film: one drawing, or several where it is split over beds, in their order.

    Raises what `draw` and `over_beds` raise.
    """
    split = oversize == SPLIT and not fits(pattern, machine)
    return over_beds(pattern, machine) if split else [draw(pattern, machine)]


def numbered_file(name: str, number: int) -> str:
    """The name of the next file of several: "pattern-2.dxf"; the first has its own."""
    stem, _, ending = name.rpartition(".")
    return name if number == 1 else f"{stem}-{number}.{ending}"


def numbered_files(first: Path) -> list[Path]:
    """The files beside the first of several that are called as if they followed it."""
    stem, _, ending = first.name.rpartition(".")
    called = re.compile(rf"{re.escape(stem)}-[1-9]\d*\.{re.escape(ending)}")
    return sorted(each for each in first.parent.glob("*") if called.fullmatch(each.name))


def file_of_stock(name: str, stock: str) -> str:
    """The name of the file for pieces on another film than the balloon's: "pattern-valve.dxf"."""
    if not stock:
        return name
    stem, _, ending = name.rpartition(".")
    return f"{stem}-{stock}.{ending}"


def _doubts(findings: Sequence[PreflightFinding], machine: Machine) -> list[str]:
    """The sentences of findings; ExportError for one that leaves no file."""
    for finding in findings:
        if finding.severity == ERROR:
            raise ExportError(f"No file for {machine.title}: {finding.text}")
    return [finding.text for finding in findings]
