# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as the file that a machine's program reads."""

from __future__ import annotations

from collections.abc import Sequence

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.export.drawing import Drawing, draw
from BalloonWorkbench.core.export.machine import FOLDER, Machine, read_machine
from BalloonWorkbench.core.export.machine_dxf import drawing_dxf
from BalloonWorkbench.core.export.machine_hpgl import drawing_hpgl
from BalloonWorkbench.core.export.machine_pdf import drawing_pdf, tiled_pdf
from BalloonWorkbench.core.export.machine_svg import drawing_svg
from BalloonWorkbench.core.export.preflight import ERROR, Finding, film_preflight, preflight
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.types import Say, in_english

_WRITERS = {"dxf": drawing_dxf, "svg": drawing_svg, "hpgl": drawing_hpgl}


def machine_file(
    pattern: Pattern, machine: Machine, tiled: str | None = None, say: Say = in_english
) -> bytes:
    """The content of the file; tiled on "A4", "A3" or "Letter" for a PDF, whose texts `say` gives.

    Raises ExportError when the machine's format has no pages, or nothing of the pattern is for it.
    """
    return drawing_file(draw(pattern, machine), machine, tiled, say)


def drawing_file(
    drawing: Drawing, machine: Machine, tiled: str | None = None, say: Say = in_english
) -> bytes:
    """The same for a drawing that is already made for the machine."""
    if tiled is None and machine.format == "pdf":
        return drawing_pdf(drawing, machine, say)
    if tiled is None:
        return _WRITERS[machine.format](drawing, machine)
    if machine.format != "pdf":
        raise ExportError(
            f"{machine.title} reads {machine.format.upper()}, which has no pages: choose paper."
        )
    return tiled_pdf(drawing, machine, tiled, say)


def checked_machines(film: Film, chosen: Sequence[Machine]) -> tuple[str, ...]:
    """What is doubtful about several machines for a film, a sentence each.

    Raises ExportError for a machine that the film does not bear.
    """
    return tuple(_remark(finding, machine) for machine in chosen for finding in film_preflight(film, machine))


def checked_files(
    pattern: Pattern, chosen: Sequence[Machine], paper: str | None = None
) -> tuple[dict[str, bytes], tuple[str, ...]]:
    """Contents of the files for several machines by name, and what is doubtful about them, a sentence each.

    paper adds the pattern on pages of "A4", "A3" or "Letter".
    Raises ExportError for what a machine cannot make.
    """
    contents: dict[str, bytes] = {}
    remarks: list[str] = []
    for machine in chosen:
        for finding in preflight(pattern, machine):
            remarks.append(_remark(finding, machine))
        contents[machine.file_name] = machine_file(pattern, machine)
    if paper is not None:
        contents[f"pattern-{paper.lower()}.pdf"] = machine_file(
            pattern, read_machine(FOLDER / "paper.json"), paper
        )
    return contents, tuple(remarks)


def _remark(finding: Finding, machine: Machine) -> str:
    if finding.severity == ERROR:
        raise ExportError(f"No file for {machine.title}: {finding.text}")
    return finding.text
