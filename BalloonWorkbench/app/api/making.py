# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API on what is made of a balloon: files, prints, layouts, studies, comparisons."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app.api.call import bordered, done
from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.app.document.kinds import is_artwork, is_balloon
from BalloonWorkbench.app.document.parts import Parts
from BalloonWorkbench.app.engine import export as writer
from BalloonWorkbench.app.properties import values
from BalloonWorkbench.app.shapes import piece_places


@bordered
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

    if done:
        return Path(path)
    if is_artwork(obj):
        prints.write(obj, path)
        return Path(path)
    if machine:
        return writer.export_for(obj, machine, path, paper, bed, oversize, tabs, tabs_below)
    results = is_balloon(obj)
    return (writer.export_results if results else writer.export_pattern)(obj, path)


@bordered
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

    return done[-1] if done else paths.tool_paths(obj, machine, bed, oversize, tabs, tabs_below)


@bordered
def artwork(pattern_obj, **options):
    """The artwork of a pattern, made if there is none, with these values: picture, back_picture, bleed ...

    Returns the Artwork object; `export` with a folder writes its files. Raises InputError.
    """
    from BalloonWorkbench.app import artwork as prints

    if done:
        return done[-1]
    artworks = [obj for obj in pattern_obj.InList if is_artwork(obj) and obj.Pattern == pattern_obj]
    made = artworks[0] if artworks else prints.make(pattern_obj)
    values.assign_to(made, prints.PROPERTIES, options)
    made.Document.recompute()
    return made


@bordered
def arrange(pattern_obj, piece=None, at=(0.0, 0.0), angle=0.0, mirrored=False) -> None:
    """Lay a flat piece in the pattern view, its middle at (x, y) mm; without one all lie as they are made.

    angle  in degrees. Raises InputError where there is no such piece.
    """
    if not done:
        piece_places.lay(pattern_obj, piece, at, angle, mirrored)


@bordered
def print_pieces(obj, path, paper: str = "A4", artwork=None) -> Path:
    """Write the flat pieces as they lie in the pattern view to a PDF, in real size on pages of "A4", "A3" or
    "Letter", with what an artwork prints on them; returns the file. Raises ExportError."""
    return Path(path) if done else writer.print_pieces(obj, path, paper, artwork)


@bordered
def sketch(pattern_obj):
    """A new Sketcher sketch of a pattern's cuts, of lines and arcs; InputError while it is not up to date."""
    from BalloonWorkbench.app.shapes.pattern_sketch import make_sketch

    return done[-1] if done else make_sketch(pattern_obj)


@bordered
def nest(patterns, sheet=None, **options):
    """Lay out patterns closely on a new roll or sheet, or on one that is there; returns the object.

    Values are film, film_width, film_length, spacing, balloons, grain, remnant, shown. Raises InputError.
    """
    from BalloonWorkbench.app import film_sheet

    if done:
        return done[-1]
    made = sheet or film_sheet.make(patterns[0].Document, patterns)
    made.Patterns = list(patterns)
    values.assign_to(made, film_sheet.PROPERTIES, options)
    made.Document.recompute()
    return made


@bordered
def keep_remnant(sheet, path) -> Path:
    """Write what is left of the film of a layout, an object of `nest`, as remnant.json into a folder or to a
    file; `nest(patterns, remnant=path)` lays pieces out on it. Returns the file. Raises InputError."""
    from BalloonWorkbench.app import film_sheet

    return Path(path) if done else film_sheet.keep_remnant(sheet, path)


@bordered
def study(made: Parts, variants=None, table=None, jobs: int = 0):
    """Work out variants of a balloon, in processes beside this one; returns the object with its Table.

    variants  values by what is varied, such as {"Width": ["200 mm", "300 mm"]}: each with each of all others;
              or a list of single balloons such as {"Width": "200 mm"}
    table     a spreadsheet of headings and rows instead
    A variant that cannot be made is a row with its sentence. Raises InputError, ExportError.
    """
    from BalloonWorkbench.app.studies import study as studies

    if done:
        return done[-1]
    obj = studies.make(made.balloon.Document, made, table=table, variants=variants)
    obj.Jobs = jobs
    rows = studies.read(obj)
    task = studies.core_study(obj, rows)
    studies.work_out(task, obj)
    studies.keep_results(obj, rows, studies.known(rows, studies.jobs_of(rows, task), studies.folder(obj)))
    obj.Document.recompute()
    return obj


@bordered
def assembly_sheet(made: Parts, path, paper: str = "A4", machine: str | None = None) -> Path:
    """Write the page on how to make a balloon, a PDF on A4 or Letter; returns it. Raises ExportError.

    machine  by its name, one on which it is made: what its file says of its tool is told
    """
    from BalloonWorkbench.app.engine import maker

    return Path(path) if done else maker.write_assembly(made, path, paper, machine)


@bordered
def share(made: Parts, path, ground: str | None = None) -> Path:
    """Write a balloon as it is shown, with what is printed on it, for others; returns the file.

    The ending says what: .glb a 3D model, .html a page that turns it under the mouse and needs no network,
    .png a picture, .gif or .mp4 its inflation.

    ground  behind it, of a page or picture: a colour such as "#3060a0", "transparent" or the path of a
            picture; by default white, and the page's own
    Raises BalloonError.
    """
    from BalloonWorkbench.app.sharing.share import write_shared

    return Path(path) if done else write_shared(made, path, ground=ground)


@bordered
def test_card(machine: str, folder, bed: str | None = None, **tried) -> list[Path]:
    """Write the files of a card on which a machine's tool tries settings into a folder; returns them.

    tried  tool, feed [mm/min], power [%], spindle_speed [1/min], tip_temperature [degrees Celsius], depth
           [mm]: numbers, or texts such as "140C"; of one or two of them a list
    Raises InputError, ExportError.
    """
    from BalloonWorkbench.core.test_cards.job import write_card
    from BalloonWorkbench.core.test_cards.tried import read_tried

    if done:
        return done[-1]
    values = read_tried(tried)
    _, paths = hooks.run_blocking(
        "Writing the test card", lambda _progress: write_card(machine, values, folder, bed)
    )
    return list(paths)


@bordered
def keep_field(card, field: str, name: str) -> Path:
    """Keep what a field of a card (test-card.json) tried as a machine of your own of that name; returns its
    file. Raises InputError, ExportError."""
    from BalloonWorkbench.core.test_cards.job import keep_field

    return done[-1] if done else keep_field(card, field, name)


@bordered
def compare(made: Parts, photo, scale: str, rim=None, folder=None):
    """A photograph of an inflated balloon of two equal panels beside it: `comparison.residual` has the mean,
    95 % and largest difference [m]. Writes compare.png and compare.json into a folder.

    scale  "812,300mm" (pixels and length), "x1,y1,x2,y2,300mm" or "fit"; rim: how far weld and film reach
           beyond the seam in the photograph [mm], as in the pattern without it
    Raises BalloonError, also where the photograph shows no balloon, or another one.
    """
    from BalloonWorkbench.app.as_made import photo_comparison

    if done:
        return done[-1]
    job = photo_comparison.comparing(made, photo, scale, rim)
    compared = hooks.run_blocking("Comparing with the photograph", job)
    if folder is not None:
        photo_comparison.write(compared, folder)
    return compared


@bordered
def fit_film(made: Parts, photo, scale: str, rim=None, replace: bool = False) -> Path:
    """Find from a photograph how much a balloon's film has stretched and how far the weld drew the seam in,
    and keep both as a film of your own, such as mylar-as-made; returns its file.

    photo, scale, rim as for `compare`. A film of this name gets the mean of all its photographs; replace:
    earlier ones are forgotten. Raises BalloonError.
    """
    from BalloonWorkbench.app.as_made import photo_comparison

    if done:
        return done[-1]
    job = photo_comparison.comparing(made, photo, scale, rim, fit=True)
    compared = hooks.run_blocking("Comparing with the photograph", job)
    return photo_comparison.keep_film(made.balloon, compared, photo, replace)
