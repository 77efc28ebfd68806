# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API: what macros use, and what the commands of the window write into macros.

`import BalloonWorkbench` offers these functions by name; docs/api.md has examples. A balloon is a `Parts`:
its outline, balloon and pattern object. Values are given by the names of the objects' properties in small
letters, such as mesh_size for MeshSize: as numbers in FreeCAD's units, quantities, or text such as "300 mm".
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from pathlib import Path
from typing import TypeVar

from BalloonWorkbench.app import balloon
from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.kinds import is_artwork, is_balloon
from BalloonWorkbench.app.document.parts import Parts, panels_of, parts_of
from BalloonWorkbench.app.drawings import outline_edits
from BalloonWorkbench.app.engine import advice, repairs
from BalloonWorkbench.app.engine import export as writer
from BalloonWorkbench.app.properties import values
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError, InputError

_Result = TypeVar("_Result")
_done: list = []  # what the window has made already and a call being recorded shall return


def _bordered(function: Callable[..., _Result]) -> Callable[..., _Result]:
    """The function with a border: what nobody foresaw is raised as ProgramFault, from what it was.

    One that works on Parts takes any object of a balloon for them.
    """
    taken = signature(function)
    made = next((each.name for each in taken.parameters.values() if each.annotation == Parts.__name__), None)

    @wraps(function)
    def call(*positional, **named):
        bound = taken.bind(*positional, **named)  # a call that does not fit is the caller's TypeError
        try:
            if made is not None and not isinstance(bound.arguments[made], Parts):
                bound.arguments[made] = _parts_with(bound.arguments[made])
            return function(*bound.args, **bound.kwargs)
        except BalloonError:
            raise
        except faults.UNFORESEEN as error:
            raise faults.report_fault(error, f"{function.__name__}: Python API") from error

    return call


@_bordered
def from_picture(doc, path, width=None, height=None, **options) -> Parts:
    """A new balloon from a picture, SVG, DXF or JSON file; pictures need a width or a height.

    A painting that the paint window has saved is such a picture. Raises BalloonError when no balloon comes
    out; the document is then as before.
    """
    return _done[-1] if _done else create.balloon_from_picture(doc, path, width, height, values=options)


@_bordered
def from_sketch(doc, source, elements=(), **options) -> Parts:
    """A new balloon that follows a sketch, wire or face; elements such as ["Face6"] pick a part of it.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return _done[-1] if _done else create.balloon_from_sketch(doc, source, elements, values=options)


@_bordered
def from_profile(doc, source=None, elements=(), **options) -> Parts:
    """A new balloon of gores from a profile: a sketch or wire, or an SVG, DXF or JSON file; None makes the
    natural shape, whose gores are `gore_length` long.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return _done[-1] if _done else create.balloon_from_profile(doc, source, elements, values=options)


@_bordered
def from_panels(doc, source, seams=(), **options) -> Parts:
    """A new balloon of flat panels: a JSON file, the name of a ready body such as "Box", or a list of
    sketches and pairs (object, ["Face1", "Face2"]); seams are texts such as "Sketch.Edge1=Sketch001.Edge3".

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return _done[-1] if _done else create.balloon_from_panels(doc, source, seams, values=options)


@_bordered
def from_body(doc, source, **options) -> Parts:
    """A new balloon that fills a closed body: a solid or a mesh, or an STL, OBJ, PLY, 3MF or STEP file;
    panels says into how many pieces it is divided, 0 takes the faces of a solid, 1 only the seams that are
    drawn: seam_edits has texts of what is done to the seams, seam_sketches sketches that are projected.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return _done[-1] if _done else create.balloon_from_body(doc, source, values=options)


@_bordered
def parts(obj) -> Parts:
    """The balloon that an object or its group belongs to; InputError for other objects."""
    return _parts_with(obj)


def _parts_with(obj) -> Parts:
    balloon_parts = parts_of(obj) if hasattr(obj, "TypeId") else None
    if balloon_parts is None:
        label = getattr(obj, "Label", obj)
        raise InputError(f"{label} belongs to no balloon: choose an outline, a balloon or a pattern.")
    return balloon_parts


@_bordered
def panels(made: Parts) -> list:
    """The Panel objects of a balloon of many panels: each piece that is cut for it, to name, hide, measure
    and export alone. Two equal panels have none."""
    return panels_of(made.pattern)


@_bordered
def change(made: Parts, **options) -> None:
    """Change values of a balloon and bring the document up to date; InputError for unknown names."""
    if not _done:
        values.assign(made, options)
        made.balloon.Document.recompute()


@_bordered
def inflate(made: Parts) -> None:
    """Inflate a balloon that does not do so by itself, `live` being off; its Status tells what came of it."""
    if not _done:
        balloon.inflate_now(made.balloon)


@_bordered
def edit_outline(made: Parts, do: str, at, to=None, mirrored: bool = False) -> None:
    """Edit an outline by hand: "move" the node nearest to `at` [mm] `to` a place, "add" one, "remove" it, or
    make it "sharp" or "round", or "fill" its hole; mirrored: on both sides of a symmetric one. InputError."""
    if not _done:
        outline_edits.edit(made.outline, do, at, to, mirrored)
        made.balloon.Document.recompute()


@_bordered
def findings(made: Parts) -> list:
    """The findings about a balloon, the worst first: rule, severity, text, place and repair."""
    return advice.findings(made)


@_bordered
def repair(made: Parts, rule: str, near=(0.0, 0.0)) -> None:
    """Take the repair of a finding: the one of this rule whose place is nearest to `near` [mm].

    Raises InputError when there is none.
    """
    from BalloonWorkbench.core.units import to_mm

    if _done:
        return
    repairable = [each for each in advice.findings(made) if each.rule == rule and each.repair is not None]
    if not repairable:
        raise InputError(f'There is no "{rule}" to repair in {made.balloon.Label}: see its advice.')
    x, y = near
    nearest = min(
        repairable, key=lambda each: (to_mm(each.place[0]) - x) ** 2 + (to_mm(each.place[1]) - y) ** 2
    )
    repairs.take(made, nearest.repair)
    made.balloon.Document.recompute()


@_bordered
def export(
    obj,
    path,
    machine: str | None = None,
    paper: str | None = None,
    bed: str | None = None,
    oversize: str = "refuse",
    tabs: str | None = None,
    tabs_below: str | None = None,
) -> Path:
    """Write a pattern, or all of a group, to a DXF or SVG file, or as a machine reads it; returns the file.

    A pattern larger than the machine's bed (`bed` gives another one, such as "600 x 400 mm", "600 mm" for a
    roll, or "none") is refused; with oversize "write" it is written all the same, with "split" in several
    files between which the film is moved, with "scale" the balloon is made smaller until it fits. With tabs
    of a width such as "0.4 mm" pieces stay in the film, only those no larger than tabs_below, such as
    "50 mm", where that is given. Given a Balloon object it writes what the film does everywhere, as .vtu,
    .npz or .stl; given an artwork, all its files into a folder. Raises ExportError.
    """
    from BalloonWorkbench.app import artwork as prints

    if _done:
        return Path(path)
    if is_artwork(obj):
        prints.write(obj, path)
        return Path(path)
    if machine:
        return writer.export_for(obj, machine, path, paper, bed, oversize, tabs, tabs_below)
    results = is_balloon(obj)
    return (writer.export_results if results else writer.export_pattern)(obj, path)


@_bordered
def tool_paths(
    obj,
    machine: str,
    bed: str | None = None,
    oversize: str = "refuse",
    tabs: str | None = None,
    tabs_below: str | None = None,
) -> list:
    """Jobs of FreeCAD's workbench Path (CAM since 1.0) with the moves of a pattern's G-code.

    machine, one that reads G-code, and all others as for `export`; one job for each film. Raises ExportError.
    """
    from BalloonWorkbench.app.machines import tool_paths as paths

    return _done[-1] if _done else paths.tool_paths(obj, machine, bed, oversize, tabs, tabs_below)


@_bordered
def artwork(pattern_obj, **options):
    """The artwork of a pattern, made if there is none, with these values: picture, back_picture, bleed ...

    Returns the Artwork object; `export` with a folder writes its files. Raises InputError.
    """
    from BalloonWorkbench.app import artwork as prints

    if _done:
        return _done[-1]
    artworks = [obj for obj in pattern_obj.InList if is_artwork(obj) and obj.Pattern == pattern_obj]
    made = artworks[0] if artworks else prints.make(pattern_obj)
    values.assign_to(made, prints.PROPERTIES, options)
    made.Document.recompute()
    return made


@_bordered
def sketch(pattern_obj):
    """A new Sketcher sketch of a pattern's cuts, of lines and arcs; InputError while it is not up to date."""
    from BalloonWorkbench.app.shapes.pattern_sketch import make_sketch

    return _done[-1] if _done else make_sketch(pattern_obj)


@_bordered
def nest(patterns, sheet=None, **options):
    """Lay out patterns closely on a new roll or sheet, or on one that is there; returns the object.

    Values are film, film_width, film_length, spacing, balloons, grain, remnant, shown. Raises InputError.
    """
    from BalloonWorkbench.app import film_sheet

    if _done:
        return _done[-1]
    made = sheet or film_sheet.make(patterns[0].Document, patterns)
    made.Patterns = list(patterns)
    values.assign_to(made, film_sheet.PROPERTIES, options)
    made.Document.recompute()
    return made


@_bordered
def keep_remnant(sheet, path) -> Path:
    """Write what is left of the film of a layout, an object of `nest`, as remnant.json into a folder or to a
    file; `nest(patterns, remnant=path)` lays pieces out on it. Returns the file. Raises InputError."""
    from BalloonWorkbench.app import film_sheet

    return Path(path) if _done else film_sheet.keep_remnant(sheet, path)


@_bordered
def study(made: Parts, variants=None, table=None, jobs: int = 0):
    """Work out variants of a balloon, in processes beside this one; returns the object with its Table.

    variants  values by what is varied, such as {"Width": ["200 mm", "300 mm"]}: each with each of all others;
              or a list of single balloons such as {"Width": "200 mm"}
    table     a spreadsheet of headings and rows instead
    A variant that cannot be made is a row with its sentence. Raises InputError, ExportError.
    """
    from BalloonWorkbench.app.studies import study as studies

    if _done:
        return _done[-1]
    obj = studies.make(made.balloon.Document, made, table=table, variants=variants)
    obj.Jobs = jobs
    rows = studies.read(obj)
    task = studies.core_study(obj, rows)
    studies.work_out(task, obj)
    studies.keep_results(obj, rows, studies.known(rows, studies.jobs_of(rows, task), studies.folder(obj)))
    obj.Document.recompute()
    return obj


@_bordered
def assembly_sheet(made: Parts, path, paper: str = "A4", machine: str | None = None) -> Path:
    """Write the page on how to make a balloon, a PDF on A4 or Letter; returns it. Raises ExportError.

    machine  by its name, one on which it is made: what its file says of its tool is told
    """
    from BalloonWorkbench.app.engine import maker

    return Path(path) if _done else maker.write_assembly(made, path, paper, machine)


@_bordered
def share(made: Parts, path, transparent: bool = False) -> Path:
    """Write a balloon as it is shown, with what is printed on it, for others; returns the file.

    The ending says what: .glb a 3D model, .html a page that turns it under the mouse and needs no network,
    .png a picture on white (or transparent), .gif or .mp4 its inflation. Raises BalloonError.
    """
    from BalloonWorkbench.app.sharing.share import write_shared

    return Path(path) if _done else write_shared(made, path, transparent=transparent)


@_bordered
def test_card(machine: str, folder, bed: str | None = None, **tried) -> list[Path]:
    """Write the files of a card on which a machine's tool tries settings into a folder; returns them.

    tried  tool, feed [mm/min], power [%], spindle_speed [1/min], tip_temperature [degrees Celsius], depth
           [mm]: numbers, or texts such as "140C"; of one or two of them a list
    Raises InputError, ExportError.
    """
    from BalloonWorkbench.core.test_cards.job import write_card
    from BalloonWorkbench.core.test_cards.tried import read_tried

    if _done:
        return _done[-1]
    values = read_tried(tried)
    _, paths = hooks.run_blocking(
        "Writing the test card", lambda _progress: write_card(machine, values, folder, bed)
    )
    return list(paths)


@_bordered
def keep_field(card, field: str, name: str) -> Path:
    """Keep what a field of a card (test-card.json) tried as a machine of your own of that name; returns its
    file. Raises InputError, ExportError."""
    from BalloonWorkbench.core.test_cards.job import keep_field

    return _done[-1] if _done else keep_field(card, field, name)


@_bordered
def compare(made: Parts, photo, scale: str, rim=None, folder=None):
    """A photograph of an inflated balloon of two equal panels beside it: `comparison.residual` has the mean,
    95 % and largest difference [m]. Writes compare.png and compare.json into a folder.

    scale  "812,300mm" (pixels and length), "x1,y1,x2,y2,300mm" or "fit"; rim: how far weld and film reach
           beyond the seam in the photograph [mm], as in the pattern without it
    Raises BalloonError, also where the photograph shows no balloon, or another one.
    """
    from BalloonWorkbench.app.as_made import photo_comparison

    if _done:
        return _done[-1]
    job = photo_comparison.comparing(made, photo, scale, rim)
    compared = hooks.run_blocking("Comparing with the photograph", job)
    if folder is not None:
        photo_comparison.write(compared, folder)
    return compared


@_bordered
def fit_film(made: Parts, photo, scale: str, rim=None, replace: bool = False) -> Path:
    """Find from a photograph how much a balloon's film has stretched and how far the weld drew the seam in,
    and keep both as a film of your own, such as mylar-as-made; returns its file.

    photo, scale, rim as for `compare`; replace: a film of this name may be replaced. Raises BalloonError.
    """
    from BalloonWorkbench.app.as_made import photo_comparison

    if _done:
        return _done[-1]
    job = photo_comparison.comparing(made, photo, scale, rim, fit=True)
    compared = hooks.run_blocking("Comparing with the photograph", job)
    return photo_comparison.keep_film(made.balloon, compared, photo, replace)


@contextmanager
def already_done(result):
    """Calls return this instead of working: the window has worked, and writes the call into the macro."""
    _done.append(result)
    try:
        yield
    finally:
        _done.pop()
