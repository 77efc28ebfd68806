# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Outline object: what the user wants to see inflated, from a drawing or from a sketch."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.kinds import is_outline, leader
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.engine import repairs
from BalloonWorkbench.app.properties.property_table import (
    Property,
    options_from,
    properties_of,
    result,
    results,
    show_in_editor,
)
from BalloonWorkbench.core.options.drawing import ReadingOptions, SizeOptions, TracingOptions
from BalloonWorkbench.core.options.option import option_of

SYMMETRY, DRAWN_AS = (
    {title: value for value, title in option_of(ReadingOptions, name).titles.items()}
    for name in ("symmetry", "drawn_as")
)

PROPERTIES = (
    Property(
        "FileIncluded", "Drawing", "Drawing", "Picture, SVG, DXF or JSON file; a copy travels in the document"
    ),
    Property(
        "LinkSubGlobal",
        "Source",
        "Drawing",
        "Sketch, wire or face that the outline follows instead of a file",
    ),
    *properties_of(SizeOptions),
    Property("Link", "Leader", "Drawing", "The outline whose drawing this one shares; empty: its own"),
    Property("Integer", "Part", "Drawing", "Which shape of the drawing it is; 1 is the largest", 1),
    Property(
        "Bool",
        "KeepAspect",
        "Drawing",
        "Fit inside width and height instead of stretching to both",
        True,
        label="Keep the proportions",
    ),
    *properties_of(ReadingOptions),
    Property(
        "StringList",
        "OutlineEdits",
        "Drawing",
        "How the outline was edited by hand: nodes moved, added and removed, one JSON text each",
    ),
    *repairs.PROPERTIES,
    *arrange.PROPERTIES,
    arrange.FROM_SKETCH,
    result("String", "Kind", "What the outline was read from", group="Outline"),
    result("Length", "SizeX", "Width of the outline", group="Outline"),
    result("Length", "SizeY", "Height of the outline", group="Outline"),
    result("Integer", "HoleCount", "Number of holes", group="Outline"),
    result("StringList", "Notes", "Remarks made while the outline was found", group="Outline"),
    result("String", "Status", "Up to date, or what is wrong", group="Outline"),
    result("VectorList", "LoopPoints", "Corners of all loops", hidden=True, group="Outline"),
    result("IntegerList", "LoopCounts", "Number of corners of each loop", hidden=True, group="Outline"),
    result("VectorList", "LoopWeldPoints", "Corners of all welds", hidden=True, group="Outline"),
    result("IntegerList", "LoopWeldCounts", "Number of corners of each weld", hidden=True, group="Outline"),
)


class OutlineProxy(DocumentProxy):
    """Behaviour of the Outline object (Part::Part2DObjectPython)."""

    properties = PROPERTIES

    def __init__(self, obj):
        super().__init__(obj)
        self.follow_source(obj)

    def onChanged(self, obj, name):
        if name in ("Source", "Leader") and "Status" in obj.PropertiesList:
            self.follow_source(obj)

    def follow_source(self, obj):
        """A sketch brings its own size: hide the wanted one. The leader has all of them."""
        mode = "hide" if obj.Source or obj.Leader else "edit"
        own = ("Drawing", "Width", "Height", "KeepAspect", "DrawnAs", "OutlineEdits")
        own += tuple(item.name for item in properties_of(TracingOptions))
        show_in_editor(obj, **dict.fromkeys(own, mode))
        shared = "hide" if obj.Leader else "edit"
        show_in_editor(obj, Source=shared, Symmetry=shared, Passage=shared)

    def compute(self, obj):
        from BalloonWorkbench.app.properties.quantities import metres
        from BalloonWorkbench.core.outline.chambers import linked

        has_result = bool(obj.LoopCounts)
        if not has_drawing(obj):
            status.set_problem(obj, has_result, "Choose a picture or a sketch.")
            return
        with status.reported(obj, has_result):
            first = leader(obj)
            if not first.Source:
                trace(first)
            outline, kind, placement = read(obj)
            outline = linked(outline, metres(first.Passage))
            outline = repairs.repair_outline(obj, outline, scales=not first.Source)
            show(obj, outline, kind)
            if placement is not None:
                obj.Placement = placement * obj.FromSketch
            status.set_status(obj, status.READY)
        obj.positionBySupport()


def set_drawing(obj, path) -> None:
    """Copy a file into the document as the drawing, keeping its name; OSError if it cannot be read."""
    import os
    import shutil
    import tempfile

    path, plain = os.fspath(path), in_letters(path)
    with tempfile.TemporaryDirectory() as folder:
        if plain != path:
            path = shutil.copy(path, os.path.join(folder, os.path.basename(plain)))
        obj.Drawing = (path, os.path.basename(path))


def in_letters(path) -> str:
    """A path without what FreeCAD breaks off at, bytes that are no letters, or takes for a slash."""
    import os
    import re

    return re.sub("[\\\\\ud800-\udfff]" if os.sep == "/" else "[\ud800-\udfff]", "_", os.fspath(path))


def has_drawing(obj) -> bool:
    """Whether there is anything to read."""
    return bool(leader(obj).Source or leader(obj).Drawing)


def shape_count(obj) -> int:
    """How many shapes the drawing of an outline has; 0 where it cannot be read, and of what is no outline."""
    from BalloonWorkbench.core.errors import BalloonError

    if not is_outline(obj):
        return 0
    try:
        return len(read_all(obj)[0].parts) if has_drawing(obj) else 0
    except BalloonError:
        return 0


def read(obj):
    """The outline, what it was read from, and the placement of a linked source (None for a drawing)."""
    from BalloonWorkbench.core.errors import OutlineError

    drawing, kind, placement = read_all(leader(obj))
    if not 1 <= obj.Part <= len(drawing.parts):
        count = len(drawing.parts)
        raise OutlineError(
            f"The drawing has {count} shape{'s' * (count > 1)} and no number {obj.Part}: choose another Part,"
            " or delete this balloon."
        )
    outline = drawing.parts[obj.Part - 1]
    if len(drawing.parts) > 1:
        note = f"This is shape {obj.Part} of the {len(drawing.parts)} in the drawing."
        outline = replace(outline, notes=(note, *outline.notes))
    return outline, kind, placement


def read_all(obj):
    """All shapes of an outline's drawing, what it was read from, and the placement as for `read`."""
    if obj.Source:
        from BalloonWorkbench.app.drawings.sketch import drawing_of
        from BalloonWorkbench.core.outline.symmetry import evened

        drawing, placement = drawing_of(*obj.Source)
        return evened(drawing, SYMMETRY[obj.Symmetry], drawn=False), "sketch", placement
    drawing, kind = read_plain(obj)
    return (edited(obj, drawing).drawing if obj.OutlineEdits else drawing), kind, None


def trace(obj) -> None:
    """Read the file of an outline beside the window: `read_plain` has it at once then."""
    from BalloonWorkbench.app.drawings import drawing_file

    drawing_file.trace(f"Tracing {obj.Label}", obj.Drawing, obj.Width, obj.Height, *reading_of(obj))


def edited(obj, drawing):
    """A drawing after the edits of an outline, a core's EditedDrawing."""
    from BalloonWorkbench.core.outline_edits.apply_edits import apply_edits
    from BalloonWorkbench.core.outline_edits.edit import edits_of

    return apply_edits(drawing, edits_of(obj.OutlineEdits))


def read_plain(obj):
    """All shapes of the file of an outline before they were edited by hand, and what it is."""
    from BalloonWorkbench.app.drawings.drawing_file import read_drawing

    return read_drawing(obj.Drawing, obj.Width, obj.Height, obj.KeepAspect, *reading_of(obj))


def reading_of(obj) -> tuple:
    """How a picture is read, as `read_drawing` takes it: symmetry, drawn_as and tracing."""
    return SYMMETRY[obj.Symmetry], DRAWN_AS[obj.DrawnAs], options_from(obj, TracingOptions)


def show(obj, outline, kind: str) -> None:
    """Write an outline into the object."""
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.units import to_mm

    with results(obj) as output:
        part_shapes.store(output, "Loop", outline)
        width, height = outline.size
        output.Shape = part_shapes.face(outline)
        output.Kind = kind
        output.SizeX, output.SizeY = to_mm(width), to_mm(height)
        output.HoleCount = len(outline.holes)
        output.Notes = list(outline.notes)
