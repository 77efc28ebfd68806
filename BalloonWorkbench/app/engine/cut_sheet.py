# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut for a pattern, the group of a drawing, an artwork or a sheet of film."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.core.errors import ExportError


def sheet(pattern_obj):
    """The pattern of an object in full precision, or all patterns of a group on one sheet.

    An artwork or a sheet of film gives what is cut for it.
    Raises ExportError when there is none, or one is not up to date.
    """
    from BalloonWorkbench.core.pattern.layout import on_one_sheet

    objects = [obj for obj in getattr(pattern_obj, "Group", [pattern_obj]) if is_pattern(obj)]
    if hasattr(getattr(pattern_obj, "Proxy", None), "cut_pattern"):
        objects = [pattern_obj]
    if not objects:
        raise ExportError(f"{pattern_obj.Label} has no pattern: choose a balloon.")
    for obj in objects:
        insist_on_ready(obj)
    return on_one_sheet([obj.Proxy.cut_pattern(obj) for obj in objects])


def pieces(obj):
    """The pieces of a pattern, an artwork or a sheet of film, and which edges are sealed to which: the
    core's PatternPieces.

    Raises ExportError when it is not up to date.
    """
    from BalloonWorkbench.core.pattern.pieces import sheet_pieces

    insist_on_ready(obj)
    return obj.Proxy.pieces(obj) if is_pattern(obj) else sheet_pieces(sheet(obj))


def patterns_in(obj) -> list:
    """The pattern objects of what can be exported: of itself, a group, an artwork or a sheet of film."""
    cut = getattr(obj, "Patterns", None) or [getattr(obj, "Pattern", None) or obj]
    return [each for one in cut for each in getattr(one, "Group", [one]) if is_pattern(each)]


def insist_on_ready(obj) -> None:
    """Raises ExportError for an object that is not up to date."""
    if not obj.Status:
        raise ExportError(f"{obj.Label} is not worked out yet: recompute the document.")
    if not status.is_ready(obj):
        raise ExportError(
            f"{obj.Label} is not up to date. {status.problem(obj)} Repair that, recompute and export again."
        )
