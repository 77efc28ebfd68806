# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD document of a balloon that was designed outside FreeCAD."""

from __future__ import annotations

import tempfile
from pathlib import Path

import FreeCAD as App

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.bag import set_file
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target
from BalloonWorkbench.app.gored_body import set_profile
from BalloonWorkbench.app.group import BAG, GORED_BODY, OUTLINE, TARGET
from BalloonWorkbench.app.outline import in_letters, set_drawing
from BalloonWorkbench.app.properties import film, size_goal
from BalloonWorkbench.app.properties.property_table import write_options
from BalloonWorkbench.app.target import set_body
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.files.write import write_files
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions
from BalloonWorkbench.core.seam_edits.read_seams import edit_text, edits_in
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.units import to_mm


def save_fcstd(path, drawing, settings, designs, *, width=None, height=None) -> None:
    """Write a document with the live objects of balloons; see `fcstd_bytes`.

    Raises ExportError when the file cannot be written.
    """
    target = Path(path)
    content = fcstd_bytes(drawing, settings, designs, label=target.stem, width=width, height=height)
    write_files(target.parent, {target.name: content})


def fcstd_bytes(drawing, settings, designs, *, label: str = "balloon", width=None, height=None) -> bytes:
    """A document with the live objects of balloons: they can be edited and recomputed in FreeCAD.

    drawing        the file the outline was read from; a copy goes into the document
    settings       the job's settings
    designs        the core's results for them, one for each shape of the drawing, in their order; they are
                   taken over, not solved again
    label          name of the document
    width, height  of the drawing [m], as they were asked for; None where they were left open

    Raises BalloonError when the drawing cannot be read.
    """
    doc = App.newDocument("Balloon", hidden=True, temp=True)
    try:
        parts = create.make(doc, Path(in_letters(drawing)).stem, _source_of(designs))
        if is_bag(parts.outline):
            set_file(parts.outline, drawing)
        elif is_target(parts.outline):
            set_body(parts.outline, drawing)
            parts.outline.Width = 0.0 if width is None else to_mm(width)
            parts.outline.Height = 0.0 if height is None else to_mm(height)
        else:
            (set_profile if is_gored_body(parts.outline) else set_drawing)(parts.outline, drawing)
            parts.outline.Width = 0.0 if width is None else to_mm(width)
            parts.outline.Height = 0.0 if height is None else to_mm(height)
        write_settings(parts, settings)
        everyone = [parts, *create.add_companions(parts)]
        for each, design in zip(everyone, designs):
            each.outline.recompute()
            if status.is_ready(each.outline):
                balloon.show(each.balloon, balloon.request(each.balloon), design)
        create.compute(*everyone)
        with tempfile.TemporaryDirectory() as folder:
            written = Path(folder) / f"{label}.FCStd"  # FreeCAD labels a document by its file
            doc.saveAs(str(written))
            return written.read_bytes()
    finally:
        App.closeDocument(doc.Name)


def _source_of(designs) -> str:
    """What the balloons are made from: outlines, a body or a bag."""
    source = getattr(designs[0], "source", None)
    kinds = {Profile: GORED_BODY, Bag: BAG, Division: TARGET}
    return kinds.get(type(source), OUTLINE)


def write_settings(parts, settings) -> None:
    """Give the objects of a balloon what the engine's settings say; nothing is computed."""
    film.choose(parts.balloon, settings.film)
    write_options(parts.balloon, settings, InflationOptions)
    if settings.volume is not None:
        parts.balloon.Load = balloon.VOLUME
    write_options(parts.balloon, settings.model, ModelOptions)
    if is_gored_body(parts.outline):
        write_options(parts.outline, settings.body, BodyOptions)
    elif is_target(parts.outline):
        write_options(parts.outline, settings.target, TargetOptions)
        parts.outline.SeamEdits = [edit_text(edit) for edit in edits_in(settings.target.seams)]
    elif not is_bag(parts.outline):
        write_options(parts.outline, settings, ReadingOptions)
        write_options(parts.balloon, settings.side_band, BandOptions)
    pattern.set_values(parts.pattern, settings.pattern)
    size_goal.set_filling(parts.balloon, settings.filling)
