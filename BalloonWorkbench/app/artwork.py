# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Artwork object: what is printed on a balloon before it is cut, bent so that it reads right inflated."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.kinds import is_artwork, leader
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.drawings.drawing_file import File, drawn_pixels_of, file_of, pixels_of
from BalloonWorkbench.app.engine import panel_prints
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.properties.property_table import Property, properties_of, result, results
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.making import ArtworkOptions

FRONT, BACK = "Front", "Back"

PROPERTIES = (
    Property("Link", "Pattern", "Artwork", "The pattern that is printed"),
    *properties_of(ArtworkOptions),
    Property(
        "Enumeration",
        "Side",
        "Artwork",
        "The side that is shown and exported for a cutter",
        label="Shown side",
        entries=lambda: (FRONT, BACK),
    ),
    result("Length", "SeamLength", "Length of the weld"),
    result("Length", "PatternWidth", "Width of the print with its marks"),
    result("Length", "PatternHeight", "Height of the print with its marks"),
    result("StringList", "Roles", "What to do along each wire of the shape"),
    result("String", "Status", "Up to date, or what is wrong"),
    *arrange.PROPERTIES,
)


class ArtworkProxy(DocumentProxy):
    """Behaviour of the Artwork object (Part::Part2DObjectPython)."""

    properties = PROPERTIES

    def compute(self, obj):
        if status.waits_for(obj, obj.Pattern, bool(obj.Roles), "Choose the pattern to print on."):
            return
        with status.reported(obj, bool(obj.Roles)):
            if has_many_panels(obj.Pattern.Balloon):
                panel_prints.chosen(obj)
            else:
                _pictures(obj)
            with results(obj) as output:
                show(output, self.cut_pattern(obj))
            status.set_status(obj, status.READY)
        obj.positionBySupport()

    def cut_pattern(self, obj):
        """What a cutter gets for the side that is shown: the panel, the print's border and the marks."""
        from BalloonWorkbench.core.machines.marks.place import marked_back

        if has_many_panels(obj.Pattern.Balloon):
            return panel_prints.pattern(obj)
        front = _marked(obj)
        return marked_back(front, marks_of(obj)) if obj.Side == BACK else front


def make(pattern_obj, picture: str = "", back: str = ""):
    """An artwork for a pattern, in its group; it gets a place below it. Nothing is computed yet.

    picture, back  files; empty as in the properties. Raises OSError where there is no such file.
    """
    from BalloonWorkbench.app.border import hooks

    obj = pattern_obj.Document.addObject("Part::Part2DObjectPython", "Artwork")
    ArtworkProxy(obj)
    hooks.attach_view(obj)
    obj.Pattern = pattern_obj
    group = pattern_obj.getParentGroup()
    if group is not None:
        group.addObject(obj)
    arrange.place_when_ready(obj)
    for name, path in (("Picture", picture), ("BackPicture", back)):
        if path:
            setattr(obj, name, str(path))
    return obj


def of_balloon(balloon_obj):
    """The artwork printed on a balloon, None where there is none."""
    for pattern_obj in balloon_obj.InList:
        for obj in pattern_obj.InList:
            if is_artwork(obj) and obj.Pattern == pattern_obj:
                return obj
    return None


def on_panels(balloon_obj):
    """What an artwork prints on each panel of a balloon of many, see `panel_prints.on_film`; None where there
    is none.
    """
    obj = of_balloon(balloon_obj)
    if obj is None or not status.is_ready(obj) or not has_many_panels(balloon_obj):
        return None
    return panel_prints.on_film(obj)


def on_balloon(balloon_obj):
    """What an artwork prints on front and back of a balloon of two panels, as paintings; None where there is
    none.

    The back's is as it is seen through the front.
    """
    from BalloonWorkbench.app.drawings.painting import PaintedArtwork
    from BalloonWorkbench.core.units import to_mm

    obj = of_balloon(balloon_obj)
    if obj is None or not status.is_ready(obj) or has_many_panels(balloon_obj):
        return None
    return tuple(PaintedArtwork(each.pixels, to_mm(each.low), to_mm(each.pixel)) for each in in_place(obj))


def in_place(obj) -> tuple:
    """The core's Pictures on front and back of two equal panels, the back's as it is seen through the front.

    InputError where there is nothing to print.
    """
    front, behind = _pictures(obj)
    return front, behind or front


def sheets(obj, dpi: float | None = None):
    """Front and back, ready to print, in the object's resolution or another one.

    Of many panels both are the same. Raises ExportError when the object is not up to date, else what the
    core's artwork raises.
    """
    return printing(obj, obj.Resolution if dpi is None else dpi)()


def printing(obj, dpi: float):
    """A function that makes the sheets and does not touch the document: any thread may call it."""
    from BalloonWorkbench.app.engine import film_result
    from BalloonWorkbench.core.artwork.sheet import Print, artwork_sheets

    if not status.is_ready(obj):
        raise ExportError(f"{obj.Label} is not up to date. {status.problem(obj)} Repair that and recompute.")
    if has_many_panels(obj.Pattern.Balloon):
        return partial(panel_prints.printed, *panel_prints.chosen(obj), dpi)
    import numpy as np

    from BalloonWorkbench.app.pattern import build
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.artwork.border import bordered

    inflation, _ = film_result.stored(obj.Pattern.Balloon)
    front, behind = _pictures(obj)
    own = bordered(build(obj.Pattern), metres(obj.Bleed))
    one = Print(inflation, own, np.zeros(2), front, behind)
    return partial(artwork_sheets, [one], _marked(obj), dpi, marks_of(obj))


def write(obj, folder, machine_names=("any-dxf", "any-svg")) -> list[Path]:
    """Write both sides as PNG and PDF, and what cutters read, with the same marks; returns the files.

    The machine that the marks are for has its own files too. Without matplotlib there is no PDF. A machine
    that cannot make it is left out: the report view tells.
    Raises ExportError, and writes nothing, when something is not up to date or cannot be made.
    """
    import FreeCAD as App

    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.artwork.files import sheet_files
    from BalloonWorkbench.core.files.write import write_files
    from BalloonWorkbench.core.machines.machine import machine
    from BalloonWorkbench.core.machines.machine_file import checked_files

    make, many = printing(obj, obj.Resolution), has_many_panels(obj.Pattern.Balloon)
    machines = [machine(name) for name in dict.fromkeys((*machine_names, obj.MarksFor.strip())) if name]
    shops = {each.file_name for each in machines if each.spots}  # they have print and cut in one
    doubts: list[str] = []

    def made(_progress) -> dict[str, bytes]:
        sides = dict(zip(("artwork-front", "artwork-back"), make()))
        if many:
            sides = {"artwork": sides["artwork-front"]}
        contents, _ = sheet_files(sides, machines)
        for side, sheet in sides.items():
            cut, remarks = checked_files(sheet.pattern, machines)
            kept = {name: content for name, content in cut.items() if name not in shops}
            contents |= {f"{side.replace('artwork', 'print')}-{name}": each for name, each in kept.items()}
            doubts.extend(remarks)
        return contents

    written = list(write_files(folder, hooks.run_blocking(f"Writing {obj.Label}", made)))
    for doubt in dict.fromkeys(doubts):
        App.Console.PrintMessage(f"{doubt}\n")
    return written


def show(obj, pattern) -> None:
    """Write the lines of a side into the object."""
    import Part

    from BalloonWorkbench.app.shapes.part_shapes import wire
    from BalloonWorkbench.core.pattern.pattern import Role
    from BalloonWorkbench.core.units import to_mm

    roles = (Role.CUT, Role.CUT_INNER, Role.SEAL, Role.PRINT, Role.REGISTRATION)
    lines = [contour for role in roles for contour in pattern.of(role)]
    obj.Shape = Part.Compound([wire(line.points, line.closed) for line in lines])
    obj.Roles = [line.role.value for line in lines]
    obj.SeamLength = to_mm(pattern.seam_length)
    obj.PatternWidth, obj.PatternHeight = (to_mm(length) for length in pattern.size)


def _marked(obj):
    from BalloonWorkbench.app.pattern import build
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.artwork.border import bordered
    from BalloonWorkbench.core.machines.marks.place import marked

    return marked(bordered(build(obj.Pattern), metres(obj.Bleed)), marks_of(obj))


def marks_of(obj):
    """The registration marks round an artwork. InputError where there is no such machine."""
    from BalloonWorkbench.core.machines.marks.choose import marks_for

    return marks_for(obj.MarksFor.strip())


def _pictures(obj):
    """The pictures of front and back in their places; the back's is None where it is the front's.

    InputError where there is nothing to print.
    """
    from BalloonWorkbench.app.outline import reading_of
    from BalloonWorkbench.core.artwork.picture import covering, mirrored

    low, size, drawing = _frame(obj.Pattern.Balloon)
    path = obj.Picture or drawing
    if not path:
        raise InputError("There is no picture to print: choose one, as the outline has none of its own.")
    own = bool(drawing) and (path == drawing or Path(path).read_bytes() == Path(drawing).read_bytes())
    front = (
        _traced(file_of(path), reading_of(leader(obj.Pattern.Balloon.Outline))[1:], low, size)
        if own
        else covering(pixels_of(file_of(path)), low, size)
    )
    behind = None
    if obj.BackPicture:
        behind = mirrored(covering(pixels_of(file_of(obj.BackPicture)), low, size))
    return front, behind


def _frame(balloon):
    """Lower left corner and size (2,) [m] of all that was drawn, and its file where that is a picture."""
    import numpy as np

    from BalloonWorkbench.app.engine import film_result
    from BalloonWorkbench.app.outline import read_plain

    drawn, first = film_result.drawing(balloon), leader(balloon.Outline)
    if first.Source or first.Kind != "picture":
        return drawn.outer.min(axis=0), np.ptp(drawn.outer, axis=0), ""
    read, _ = read_plain(first)
    goal = 1.0
    if balloon.SizeGoal != "Width" and balloon.Outline.SizeX.Value:
        goal = drawn.size[0] * 1e3 / balloon.Outline.SizeX.Value
    points = np.concatenate([part.outer for part in read.parts]) * goal
    return points.min(axis=0), np.ptp(points, axis=0), first.Drawing


@memoized(most=4)
def _traced(file: File, reading: tuple, low, size):
    from BalloonWorkbench.core.artwork.picture import of_drawing

    return of_drawing(pixels_of(file), low, size, *reading, drawn_pixels_of(file))
