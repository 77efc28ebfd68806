# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing a pattern object as a file for the cutter, and what the simulation found as a file for science."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app.document.kinds import is_artwork
from BalloonWorkbench.app.engine.cut_sheet import insist_on_ready, patterns_in, sheet
from BalloonWorkbench.app.machines.bed import scale_to_bed
from BalloonWorkbench.core.errors import ExportError, InputError


def export_pattern(pattern_obj, target) -> Path:
    """Write the pattern to a file, in the format of its ending, or into a folder as DXF; returns the file.

    Given the group of a drawing, all its patterns go on one sheet, none over another.
    Raises ExportError for another ending, a pattern that is not up to date, a place that cannot be written.
    """
    from BalloonWorkbench.core.machines.machine import ANY

    path = Path(target)
    if path.is_dir():
        path = path / "pattern.dxf"
    kind = path.suffix.lower().lstrip(".")
    if kind not in ANY:
        raise ExportError(f"{path.name} is neither DXF nor SVG: let the name end in .dxf or .svg.")
    return export_for(pattern_obj, ANY[kind], path)


def check_for(pattern_obj, machine_name: str, bed=None, oversize: str = "refuse", tabs=None, tabs_below=None):
    """What a machine may find wrong with a pattern: `preflight`'s findings, errors first.

    bed, oversize, tabs and tabs_below as for `export_for`. Raises what `sheet` and `machine` raise.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.machines.preflight import ERROR, preflight

    made_for, pattern = machine_of(machine_name, bed, tabs, tabs_below), sheet(pattern_obj)
    parts = [pattern.of_stock(stock) for stock in pattern.stocks]

    def findings(_progress) -> list:
        return [finding for part in parts for finding in preflight(part, made_for, oversize)]

    both = (*_other_findings(pattern_obj, made_for), *hooks.run_blocking("Checking the pattern", findings))
    each_once = {finding.text: finding for finding in both}.values()
    return tuple(sorted(each_once, key=lambda finding: finding.severity != ERROR))


def machine_of(name: str, bed: str | None, tabs: str | None, tabs_below: str | None):
    """The machine of a name with another bed, and with tabs: lengths as text, such as "0.4 mm"."""
    from BalloonWorkbench.core.machines.contour.tabs import with_tabs
    from BalloonWorkbench.core.machines.machine import machine
    from BalloonWorkbench.core.options.making import TabOptions
    from BalloonWorkbench.core.units import parse_length

    width, below = (None if text is None else parse_length(text) for text in (tabs, tabs_below))
    return with_tabs(machine(name, bed), TabOptions(width or 0.0, below or None))


def _other_findings(pattern_obj, made_for) -> tuple:
    """What the machine does that the films of the patterns do not take, and marks of a print that it does not
    look for: the core's findings.
    """
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.machines.marks.choose import marks_for, other_marks
    from BalloonWorkbench.core.machines.preflight import WARNING, PreflightFinding, film_preflight

    films = dict.fromkeys(film.read(obj.Balloon) for obj in patterns_in(pattern_obj))
    marks = (
        other_marks(marks_for(pattern_obj.MarksFor.strip()), [made_for]) if is_artwork(pattern_obj) else ()
    )
    return (
        *(finding for each in films for finding in film_preflight(each, made_for)),
        *(PreflightFinding(WARNING, sentence) for sentence in marks),
    )


def files_of(pattern_obj, path, oversize: str = "refuse") -> list[Path]:
    """The files that `export_for` writes for a path: what is cut from another film has one of its own.

    Of a pattern that may be split, with all numbered ones that are there: those of an earlier split that are
    not written anew belong to another balloon. Raises what `sheet` raises.
    """
    from BalloonWorkbench.core.machines.machine_file import file_of_stock, numbered_files
    from BalloonWorkbench.core.options.making import SPLIT

    path, (_, *others) = Path(path), sheet(pattern_obj).stocks
    files = [path, *(path.with_name(file_of_stock(path.name, stock)) for stock in others)]
    return [*files, *(each for file in files for each in numbered_files(file) if oversize == SPLIT)]


def export_for(
    pattern_obj,
    machine_name: str,
    target,
    paper: str | None = None,
    bed: str | None = None,
    oversize: str = "refuse",
    tabs: str | None = None,
    tabs_below: str | None = None,
) -> Path:
    """Write the file that a machine reads, to a file or under its usual name into a folder; returns the file.

    What is cut from another film than the balloon's goes into a file of its own beside it.
    paper divides a PDF into pages of "A4", "A3" or "Letter"; bed is another one than in the machine's file,
    such as "600 x 400 mm", "600 mm" for a roll, or "none". A pattern that is larger is refused; with oversize
    "write" it is written all the same, with "split" in several files ("-2" and so on beside the first), with
    "scale" the balloon is made smaller first, see `scale_to_bed`. tabs of a width such as "0.4 mm" hold
    pieces in the film, only those below a size with tabs_below "50 mm".
    Raises ExportError, and writes nothing, when the machine cannot make the pattern.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.files.write import write_files
    from BalloonWorkbench.core.machines.bed import OVERSIZE, SCALE
    from BalloonWorkbench.core.machines.machine_file import file_of_stock

    if oversize not in OVERSIZE:
        raise InputError(
            f'"{oversize}" is no choice for a pattern larger than the bed: choose {", ".join(OVERSIZE)}.'
        )
    if oversize == SCALE:
        scale_to_bed(pattern_obj, machine_name, bed)
    made_for, pattern = machine_of(machine_name, bed, tabs, tabs_below), sheet(pattern_obj)
    doubts = _other_findings(pattern_obj, made_for)
    path = Path(target)
    if path.is_dir():
        path = path / made_for.file_name

    def contents(progress) -> dict[str, bytes]:
        files = {}
        for number, stock in enumerate(pattern.stocks):
            name = file_of_stock(path.name, stock) if number else path.name
            files |= _files(name, pattern.of_stock(stock), made_for, (paper, oversize), doubts)
        return files

    write_files(path.parent, hooks.run_blocking(f"Writing {path.name}", contents))
    return path


def _files(name: str, part, made_for, how: tuple, doubts) -> dict[str, bytes]:
    """The file of what is cut from one film, or one for each place of the bed; how: paper and oversize.

    Raises ExportError for the first error of the check, or of the doubts about it.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.machines.machine_file import (
        drawing_file,
        drawings,
        machine_file,
        numbered_file,
    )
    from BalloonWorkbench.core.machines.preflight import ERROR, preflight

    paper, oversize = how
    for finding in (*doubts, *preflight(part, made_for, oversize)):
        if finding.severity == ERROR:
            raise ExportError(finding.text)
    if paper is not None:
        return {name: machine_file(part, made_for, paper, hooks.say)}
    return {
        numbered_file(name, place): drawing_file(drawing, made_for, None, hooks.say)
        for place, drawing in enumerate(drawings(part, made_for, oversize), 1)
    }


def print_pieces(obj, target, paper: str, artwork=None) -> Path:
    """Write the flat pieces of a pattern as they lie in the pattern view, in real size on pages of "A4", "A3"
    or "Letter", to a PDF, with what an artwork of it prints on them; returns the file. Of a sheet of film
    they lie as it has them.

    Raises ExportError for an object that is not up to date, a place that cannot be written.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.app.engine import piece_pictures
    from BalloonWorkbench.app.shapes import piece_places
    from BalloonWorkbench.core.files.write import write_files
    from BalloonWorkbench.core.machines.piece_pages import paper_pdf

    path, laid, pictures = Path(target), piece_places.laid(obj), {}
    if artwork is not None:
        insist_on_ready(artwork)
        if artwork.Pattern != obj:
            raise ExportError(
                f"{artwork.Label} is not printed on {obj.Label}: choose an artwork of this pattern."
            )
        pictures = piece_pictures.of_print(artwork, laid.base, piece_pictures.PAPER)

    def content(_progress) -> bytes:
        return paper_pdf(laid, pictures, paper, hooks.say)

    write_files(path.parent, {path.name: hooks.run_blocking(f"Writing {path.name}", content)})
    return path


def export_results(balloon_obj, target) -> Path:
    """Write what the film does in every triangle to a .vtu (ParaView) or .npz file (NumPy), or the closed
    mesh to an .stl file; returns it.

    Raises ExportError for another ending, a balloon that is not up to date, a place that cannot be written.
    """
    from BalloonWorkbench.app.engine import bag_result, film_result
    from BalloonWorkbench.core.files.write import write_files
    from BalloonWorkbench.core.results.result_files import FORMATS as KINDS
    from BalloonWorkbench.core.results.result_files import results_bytes
    from BalloonWorkbench.core.results.stl import stl_bytes

    path = Path(target)
    kind = path.suffix.lower().lstrip(".")
    if kind not in (*KINDS, "stl"):
        raise ExportError(f"{path.name} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.")
    insist_on_ready(balloon_obj)
    inflation, film = film_result.stored(balloon_obj)
    if kind == "stl":
        content = stl_bytes([inflation])
    else:
        content = results_bytes(inflation, film, kind, bag_result.off_target(balloon_obj))
    write_files(path.parent, {path.name: content})
    return path
