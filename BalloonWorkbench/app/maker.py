# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a maker wants to know about a balloon in a document, and its assembly sheet."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from BalloonWorkbench.app import film_result, size_goal, status
from BalloonWorkbench.core.errors import ExportError


def numbers(parts, exact: bool = True):
    """The core's Numbers of a balloon that has a result. Raises BalloonError where there is none.

    exact  a balloon that bears less than its pressure is inflated anew at lower ones, which takes a second;
           else its safe pressure is a little too high
    """
    from BalloonWorkbench.app import film
    from BalloonWorkbench.app.pattern import build, values

    panel, wanted = build(parts.pattern), values(parts.pattern)
    own, filling = film.read(parts.balloon), size_goal.filling(parts.balloon)
    return _numbers(_Known(parts.balloon), panel_key(panel), _Panel(panel, wanted), own, filling, exact)


class _Known:
    """A balloon with its result: the same as another one of the same result."""

    def __init__(self, balloon):
        self.balloon = balloon
        self._key = balloon.Document.Name, balloon.Name, balloon.SolvedFor, balloon.SolvedWith

    def __eq__(self, other):
        return isinstance(other, _Known) and self._key == other._key

    def __hash__(self):
        return hash(self._key)


class _Panel:
    """A pattern that goes along with its key."""

    def __init__(self, pattern, wanted):
        self.pattern, self.wanted = pattern, wanted

    def __eq__(self, other):
        return isinstance(other, _Panel)

    def __hash__(self):
        return 0


def panel_key(pattern) -> bytes:
    """The same for the same lines."""
    import hashlib

    digest = hashlib.sha256(repr((pattern.seal_width, pattern.seam_length)).encode())
    for contour in pattern.contours:
        digest.update(contour.points.tobytes())
    return digest.digest()


@lru_cache(maxsize=8)
def _numbers(known: _Known, _key: bytes, panel: _Panel, own, filling, exact: bool):
    from BalloonWorkbench.app import shapes
    from BalloonWorkbench.core.maker.numbers import maker_numbers
    from BalloonWorkbench.core.pattern.make import sheet_of
    from BalloonWorkbench.core.solver.inflate import inflate

    balloon = known.balloon
    inflation, _ = film_result.stored(balloon)

    def again(pressure: float):
        return inflate(inflation.panel, own, pressure, start=inflation, model=inflation.report.model)

    return maker_numbers(
        inflation,
        own,
        shapes.stored(balloon, "Seam"),
        panel.pattern,
        film_result.drawing(balloon).size[0],
        filling,
        pieces=sheet_of(panel.pattern, replace(panel.wanted, mirror=True, copies=1)),
        at_pressure=again if exact else None,
    )


def write_assembly(parts, target, paper: str = "A4") -> Path:
    """Write the assembly sheet to a PDF file, or as assembly.pdf into a folder; returns the file.

    Raises ExportError when something is not up to date or cannot be written.
    """
    from BalloonWorkbench.app import film
    from BalloonWorkbench.app.pattern import build
    from BalloonWorkbench.core.assembly.page import Subject, assembly_pdf
    from BalloonWorkbench.core.export.files import write_files

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
    subject = Subject(
        group.Label if group else parts.balloon.Label,
        film.read(parts.balloon),
        inflation,
        build(parts.pattern),
        numbers(parts),
    )
    write_files(path.parent, {path.name: assembly_pdf(subject, paper)})
    return path
