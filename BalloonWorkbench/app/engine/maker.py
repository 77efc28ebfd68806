# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a maker wants to know about a balloon in a document, and its assembly sheet."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import bag_result, film_result
from BalloonWorkbench.app.properties import size_goal
from BalloonWorkbench.core.errors import ExportError


def numbers(parts, exact: bool = True):
    """The core's Numbers of a balloon that has a result. Raises BalloonError where there is none.

    exact  a balloon that bears less than its pressure is inflated anew at lower ones, which takes a second;
           else its safe pressure is a little too high
    """
    return counting(parts, exact)()


def counting(parts, exact: bool = True):
    """A function that gives these numbers and does not touch the document: any thread may call it."""
    from BalloonWorkbench.app.pattern import build, values
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.making.numbers import maker_numbers
    from BalloonWorkbench.core.pattern.make import sheet_of

    balloon = parts.balloon
    if bag_result.has_many_panels(balloon):
        return _counting_many(parts, exact)
    panel, whole = build(parts.pattern), replace(values(parts.pattern), mirror=True, copies=1)
    own, filling = film.read(balloon), size_goal.filling(balloon)
    seam, width = part_shapes.stored(balloon, "Seam"), film_result.drawing(balloon).size[0]
    inflation, _ = film_result.stored(balloon)

    def count():
        pieces = sheet_of(panel, whole)
        return maker_numbers(inflation, own, seam, panel, width, filling, pieces=pieces, exact=exact)

    return count


def _counting_many(parts, exact: bool):
    """The same for many panels."""
    from BalloonWorkbench.app.pattern import bag_patterns
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.making.bag_numbers import bag_numbers

    balloon = parts.balloon
    patterns, filling = bag_patterns(parts.pattern), size_goal.filling(balloon)
    own, (design, _) = film.read(balloon), bag_result.stored(balloon)
    return lambda: bag_numbers(design, patterns, own, filling, exact=exact)


def safety_of(balloon):
    """The core's Safety of a balloon object's result, with the film it was solved with; not exact.

    Raises InputError where there is no result.
    """
    return working_out_safety(balloon)()


def is_safety_known(balloon) -> bool:
    """safety_of is there at once. Raises InputError where there is no result."""
    from BalloonWorkbench.core.making.safety import safety

    return safety.knows(*film_result.stored(balloon), exact=False)


def working_out_safety(balloon):
    """A function that does what safety_of does and does not touch the document: any thread may call it."""
    from BalloonWorkbench.core.making.safety import safety

    inflation, film = film_result.stored(balloon)
    return lambda: safety(inflation, film, exact=False)


def write_assembly(parts, target, paper: str = "A4", machine: str | None = None) -> Path:
    """Write the assembly sheet to a PDF file, or as assembly.pdf into a folder; returns the file.

    In the language of the window. machine: by its name, one whose settings are told.
    Raises ExportError when something is not up to date or cannot be written.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.files.write import write_files

    for obj in parts:
        if not status.is_ready(obj):
            raise ExportError(
                f"{obj.Label} is not up to date. {status.problem(obj)} Repair that and recompute."
            )
    path = Path(target)
    if path.is_dir():
        path = path / "assembly.pdf"
    group = parts.balloon.getParentGroup()
    page = _page(parts, group.Label if group else parts.balloon.Label, machine)
    content = hooks.run_blocking(f"Writing {path.name}", lambda progress: page(paper, hooks.say))
    write_files(path.parent, {path.name: content})
    return path


def told_of(machine: str) -> str | None:
    """The machine again where its file has settings that an assembly sheet tells; else None."""
    from BalloonWorkbench.core.assembly_sheet.work_settings import WorkSettings, work_settings
    from BalloonWorkbench.core.machines.machine import machine as known_machine

    return machine if work_settings([known_machine(machine)]) != WorkSettings() else None


def _page(parts, name: str, machine: str | None):
    """A function that makes the sheet, on paper and in a language, and does not touch the document."""
    from BalloonWorkbench.app.pattern import bag_patterns, build
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.assembly_sheet.bag_pages import BagSubject, bag_assembly_pdf
    from BalloonWorkbench.core.assembly_sheet.page import SheetSubject, assembly_pdf
    from BalloonWorkbench.core.assembly_sheet.work_settings import work_settings
    from BalloonWorkbench.core.machines.machine import machine as known_machine

    machines = [] if machine is None else [known_machine(machine)]
    own, count = film.read(parts.balloon), counting(parts)
    if bag_result.has_many_panels(parts.balloon):
        (design, _), patterns = bag_result.stored(parts.balloon), bag_patterns(parts.pattern)

        def bag_page(paper: str, say) -> bytes:
            about = BagSubject(name, own, design, patterns, count(), work_settings(machines, say))
            return bag_assembly_pdf(about, paper, say)

        return bag_page
    (inflation, _), pattern = film_result.stored(parts.balloon), build(parts.pattern)

    def page(paper: str, say) -> bytes:
        about = SheetSubject(name, own, inflation, pattern, count(), work_settings(machines, say))
        return assembly_pdf(about, paper, say)

    return page
