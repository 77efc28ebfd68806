# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon made smaller until its pattern fits the bed of a machine."""

from __future__ import annotations

from BalloonWorkbench.app.document.kinds import is_outline, leader
from BalloonWorkbench.app.engine.cut_sheet import patterns_in, sheet
from BalloonWorkbench.core.errors import ExportError


def hindrance(pattern_obj) -> str:
    """Why a balloon cannot be made smaller from here, and what to do instead; empty where it can.

    pattern_obj  a pattern, the group of a drawing, an artwork, or a sheet of film
    """
    from BalloonWorkbench.app.balloon import VOLUME
    from BalloonWorkbench.app.properties.size_goal import WIDTH

    patterns = patterns_in(pattern_obj)
    if getattr(pattern_obj, "Patterns", None):
        return "A layout is as large as its film: give the film the size of the bed there."
    outline = leader(patterns[0].Balloon.Outline)
    if not is_outline(outline):
        return f"The size comes from {outline.Label}: make it smaller there, or of more and narrower panels."
    if outline.Source:
        return f"The size comes from {outline.Source[0].Label}: make it smaller there."
    driven = dict(outline.ExpressionEngine)
    if "Width" in driven or "Height" in driven:
        return f"The size of {outline.Label} is set by an expression: change the value that it uses."
    balloons = [pattern.Balloon for pattern in patterns]
    if any(balloon.SizeGoal != WIDTH or balloon.Load == VOLUME for balloon in balloons):
        return "The size follows from a volume or a lift: choose a smaller one."
    return ""


def scale_to_bed(pattern_obj, machine_name: str, bed: str | None = None) -> float:
    """Make the balloons of a pattern smaller until it fits the bed; returns the scale of the drawing.

    Width and height of the drawing are changed and the balloons solved anew, those of the same drawing too;
    weld and allowance keep their widths. Raises ExportError where something else decides the size or no size
    fits; the document is then as before.
    """
    from BalloonWorkbench.app.outline import read_all
    from BalloonWorkbench.core.machines.bed import scale_to_fit
    from BalloonWorkbench.core.machines.machine import machine
    from BalloonWorkbench.core.units import to_mm

    made_for, first = machine(machine_name, bed), sheet(pattern_obj)
    why = hindrance(pattern_obj)
    if why:
        raise ExportError(why)
    outline = leader(patterns_in(pattern_obj)[0].Balloon.Outline)
    before = outline.Width.Value, outline.Height.Value
    size = before if any(before) else (to_mm(read_all(outline)[0].size[0]), 0.0)

    def make(scale: float):
        _resize(outline, [scale * length for length in size])
        return sheet(pattern_obj)

    try:
        return scale_to_fit(first, [made_for], make)
    except BaseException:
        if (outline.Width.Value, outline.Height.Value) != before:
            _resize(outline, before)
        raise


def _resize(outline, size) -> None:
    """Bring the drawing to a width and height [mm], and all its balloons up to date."""
    from BalloonWorkbench.app import balloon
    from BalloonWorkbench.app.border import status
    from BalloonWorkbench.app.document.parts import companions, parts_of

    outline.Width, outline.Height = size
    first = parts_of(outline)
    outline.Document.recompute()
    for parts in (first, *companions(first)):
        if not parts.balloon.Live and status.is_ready(parts.outline):
            balloon.inflate_now(parts.balloon)
