# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a maker wants to know about a balloon in a document, and its assembly sheet."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.properties import size_goal
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.recent import Recent

_counted = Recent(8)  # numbers of balloons by all that they come from
_safe = Recent(8)  # what holds balloons together, by their results


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

    balloon = parts.balloon
    panel, wanted = build(parts.pattern), values(parts.pattern)
    own, filling = film.read(balloon), size_goal.filling(balloon)
    result = balloon.Document.Name, balloon.Name, balloon.SolvedFor, balloon.SolvedWith
    key = result, panel_key(panel), own, filling, exact
    if key in _counted:
        return partial(_counted.__getitem__, key)
    seam, width = part_shapes.stored(balloon, "Seam"), film_result.drawing(balloon).size[0]
    return partial(
        _count, key, film_result.stored(balloon)[0], own, seam, panel, wanted, width, filling, exact
    )


def safety_of(balloon):
    """The core's Safety of a balloon object's result, with the film it was solved with; not exact.

    Raises InputError where there is no result.
    """
    from BalloonWorkbench.core.making.safety import safety

    key = balloon.Document.Name, balloon.Name, balloon.SolvedWith
    if key not in _safe:
        _safe[key] = safety(*film_result.stored(balloon), exact=False)
    return _safe[key]


def panel_key(pattern) -> bytes:
    """The same for the same lines."""
    import hashlib

    digest = hashlib.sha256(repr((pattern.seal_width, pattern.seam_length)).encode())
    for contour in pattern.contours:
        digest.update(contour.points.tobytes())
    return digest.digest()


def _count(key, inflation, own, seam, panel, wanted, width: float, filling, exact: bool):
    from BalloonWorkbench.core.making.numbers import maker_numbers
    from BalloonWorkbench.core.pattern.make import sheet_of

    found = maker_numbers(
        inflation,
        own,
        seam,
        panel,
        width,
        filling,
        pieces=sheet_of(panel, replace(wanted, mirror=True, copies=1)),
        exact=exact,
    )
    _counted[key] = found
    return found


def write_assembly(parts, target, paper: str = "A4") -> Path:
    """Write the assembly sheet to a PDF file, or as assembly.pdf into a folder; returns the file.

    In the language of the window. Raises ExportError when something is not up to date or cannot be written.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.app.pattern import build
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.assembly_sheet.page import Subject, assembly_pdf
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
    inflation, _ = film_result.stored(parts.balloon)
    name, own, pattern = (
        group.Label if group else parts.balloon.Label,
        film.read(parts.balloon),
        build(parts.pattern),
    )
    count = counting(parts)

    def page(_progress) -> bytes:
        return assembly_pdf(Subject(name, own, inflation, pattern, count()), paper, hooks.say)

    write_files(path.parent, {path.name: hooks.work(f"Writing {path.name}", page)})
    return path
