# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as the file that a machine's program reads."""

from __future__ import annotations

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.export.drawing import Drawing, draw
from BalloonWorkbench.core.export.machine import Machine
from BalloonWorkbench.core.export.machine_dxf import drawing_dxf
from BalloonWorkbench.core.export.machine_hpgl import drawing_hpgl
from BalloonWorkbench.core.export.machine_pdf import drawing_pdf, tiled_pdf
from BalloonWorkbench.core.export.machine_svg import drawing_svg
from BalloonWorkbench.core.pattern.pattern import Pattern

_WRITERS = {"dxf": drawing_dxf, "svg": drawing_svg, "pdf": drawing_pdf, "hpgl": drawing_hpgl}


def machine_file(pattern: Pattern, machine: Machine, tiled: str | None = None) -> bytes:
    """The content of the file; tiled on "A4", "A3" or "Letter" for a PDF.

    Raises ExportError when the machine's format has no pages, or nothing of the pattern is for it.
    """
    return drawing_file(draw(pattern, machine), machine, tiled)


def drawing_file(drawing: Drawing, machine: Machine, tiled: str | None = None) -> bytes:
    """The same for a drawing that is already made for the machine."""
    if tiled is None:
        return _WRITERS[machine.format](drawing, machine)
    if machine.format != "pdf":
        raise ExportError(
            f"{machine.title} reads {machine.format.upper()}, which has no pages: choose paper."
        )
    return tiled_pdf(drawing, machine, tiled)
