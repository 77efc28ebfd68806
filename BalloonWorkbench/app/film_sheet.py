# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FilmSheet object: panels of balloons laid out on a roll or on sheets of film."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.properties.property_table import (
    Property,
    options_from,
    properties_of,
    result,
    results,
)
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.making import SheetOptions

#: What is laid out, and the name of its film in the core.
FILMS = {"Balloon film": "", "Valve film": "valve"}

PROPERTIES = (
    Property("LinkList", "Patterns", "Film", "The patterns that are laid out"),
    Property(
        "Enumeration",
        "Film",
        "Film",
        "Which film is laid out: pieces of a valve are on one of their own",
        label="Film",
        entries=lambda: FILMS,
    ),
    *properties_of(SheetOptions),
    Property("Integer", "Shown", "Film", "Number of the sheet that is shown and exported", 1),
    result("Float", "Used", "Part of the film that the pieces take, in per cent"),
    result("Length", "UsedLength", "Length of the roll that is used"),
    result("Integer", "Sheets", "Number of sheets"),
    result("Integer", "Pieces", "Number of pieces on what is shown"),
    result("Length", "SeamLength", "Length of all welds on it"),
    result("Length", "PatternWidth", "Width of all that is cut"),
    result("Length", "PatternHeight", "Height of all that is cut"),
    result("StringList", "Roles", "What to do along each wire of the shape"),
    result("StringList", "Warnings", "Remarks on the layout"),
    result("String", "Status", "Up to date, or what is wrong"),
    result("String", "Layouts", "Where all pieces lie, as JSON", hidden=True),
    result("IntegerList", "OnRemnants", "On which remnant each sheet is, -1 for none", hidden=True),
    result("String", "LaidOutFor", "Label of what was laid out", hidden=True),
    *arrange.PROPERTIES,
)

#: The file of what is left of another layout.
REMNANT = next(item for item in PROPERTIES if item.name == "Remnant")


class FilmSheetProxy(DocumentProxy):
    """Behaviour of the FilmSheet object (Part::Part2DObjectPython)."""

    properties = PROPERTIES

    def compute(self, obj):
        has_result = bool(obj.LaidOutFor)
        if not obj.Patterns:
            status.set_problem(obj, has_result, "Choose the patterns to lay out.")
            return
        for pattern_obj in obj.Patterns:
            if status.waits_for(obj, pattern_obj, has_result, ""):
                return
        with status.reported(obj, has_result):
            with results(obj) as output:
                self.lay_out(obj, output)
            status.set_status(obj, status.READY)

    def lay_out(self, obj, output):
        """The layout that is shown, laid out anew where something changed."""
        from BalloonWorkbench.app.border import hooks

        parted, stock = _by_film(obj), _stock(obj)
        films, remnants = _chosen(obj, parted), _remnants(obj)
        if remnants and len(films) > 1:
            raise InputError("What is left of other film is of one film: choose patterns of one film for it.")
        label = _label(films, stock, remnants)
        if label != obj.LaidOutFor:
            layouts, remarks = hooks.run_blocking(
                f"Laying out {obj.Label}", lambda progress: _laid_out(films, stock, progress, remnants)
            )
            _keep(output, layouts, remnants)
            output.Warnings, output.LaidOutFor = [*remarks, *_left_out(obj, parted)], label
        show(output, _together(films), stock)

    def cut_pattern(self, obj):
        """All pieces of the sheet that is shown, as one pattern."""
        pieces, stock = _up_to_date(obj)
        return _layout(obj, stock, pieces).pattern(pieces)


def make(doc, patterns):
    """A sheet of film with patterns; it gets a place below all of them. Nothing is laid out yet."""
    from BalloonWorkbench.app.border import hooks

    obj = doc.addObject("Part::Part2DObjectPython", "FilmSheet")
    obj.Label = "Film sheet"
    FilmSheetProxy(obj)
    hooks.attach_view(obj)
    obj.Patterns = list(patterns)
    arrange.place_when_ready(obj)
    return obj


def keep_remnant(obj, target) -> Path:
    """Write what is left of all its film, for another layout; returns the file.

    Raises InputError where the object is not up to date or nothing is left that can be used, ExportError for
    a place that cannot be written.
    """
    from BalloonWorkbench.core.files.write import write_files
    from BalloonWorkbench.core.nesting.layout import left_of
    from BalloonWorkbench.core.nesting.remnant import FILE, remnant_bytes

    path = Path(target)
    path = path / FILE if path.is_dir() else path
    pieces, stock = _up_to_date(obj)
    numbers = range(1, obj.Sheets + 1)
    left = [each for number in numbers for each in left_of(_layout(obj, stock, pieces, number), pieces)]
    if not left:
        raise InputError(f"Of the film of {obj.Label} nothing is left that is large enough to be used again.")
    write_files(path.parent, {path.name: remnant_bytes(left)})
    return path


def _up_to_date(obj):
    """Pieces and film of what is laid out. InputError where it is older than its patterns."""
    films, stock = _chosen(obj, _by_film(obj)), _stock(obj)
    if _label(films, stock, _remnants(obj)) != obj.LaidOutFor:
        raise InputError(f"The layout of {obj.Label} is older than its patterns: recompute it.")
    return _together(films), stock


def show(obj, pieces, stock) -> None:
    """Write the chosen sheet into the object: the pieces, and the edge of the film."""
    from dataclasses import replace

    import numpy as np
    import Part

    from BalloonWorkbench.app.shapes.part_shapes import wire
    from BalloonWorkbench.core.pattern.pattern import Role
    from BalloonWorkbench.core.units import to_mm

    layout = _layout(obj, stock, pieces)
    pattern = layout.pattern(pieces)
    cuts, inner = pattern.of(Role.CUT), pattern.of(Role.CUT_INNER)
    beside = (Role.SEAL, Role.WELD, Role.NOTCH, Role.FOLD, Role.PEN, Role.ENGRAVE)
    lines = [*cuts, *inner, *(contour for role in beside for contour in pattern.of(role))]
    film = replace(layout.stock, length=layout.length).film
    edges = [wire(np.asarray(ring.coords)[:-1], True) for ring in (film.exterior, *film.interiors)]
    obj.Shape = Part.Compound([*edges, *(wire(line.points, line.closed) for line in lines)])
    obj.Roles = [*([""] * len(edges)), *(line.role.value for line in lines)]
    obj.Used, obj.UsedLength = 100.0 * layout.utilisation, to_mm(layout.length)
    obj.Pieces, obj.Sheets = len(layout.places), len(json.loads(obj.Layouts))
    obj.SeamLength = to_mm(pattern.seam_length)
    obj.PatternWidth, obj.PatternHeight = (to_mm(length) for length in pattern.size)


def _chosen(obj, parted) -> dict:
    """The pieces that are laid out, by the title of their film. InputError where the patterns have none."""
    films = parted.get(FILMS[obj.Film], {})
    if not films:
        raise InputError(f'No pattern here has pieces of "{obj.Film}": choose another film.')
    return films


def _together(films) -> list:
    """The pieces of all films, one after the other, as they are numbered."""
    return [piece for pieces in films.values() for piece in pieces]


def _laid_out(films, stock, progress, remnants) -> tuple[list, list[str]]:
    """Layouts of one film after the other, never two films on one sheet, and remarks."""
    from dataclasses import replace

    from BalloonWorkbench.core.nesting.nest import nest

    layouts, remarks, number = [], [], 0
    for title, pieces in films.items():
        laid, more = nest(pieces, stock, progress, remnants)
        for layout in laid:
            places = [replace(place, piece=place.piece + number) for place in layout.places]
            layouts.append(replace(layout, places=tuple(places)))
        number += len(pieces)
        remarks += [remark for remark in more if remark not in remarks]
        if len(films) > 1:
            sheets = [str(len(layouts) - count) for count in reversed(range(len(laid)))]
            remarks.append(f"Of {title}: sheet {', '.join(sheets)}.")
    return layouts, remarks


def _left_out(obj, parted) -> list[str]:
    """What to say about pieces of valves while the balloons' film is laid out."""
    if FILMS[obj.Film] or len(parted) == 1:
        return []
    return ['The strips of valves are not here: lay them out on a sheet of their own, with "Valve film".']


def _by_film(obj) -> dict:
    """Panels, and the pieces of intakes: by the name of their film in the core, then by the title of the
    balloon's film. Valves are of one film, whatever the balloon is of."""
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.products import by_stock

    if obj.Balloons < 1:
        raise InputError(f"{obj.Balloons} balloons cannot be laid out: give 1 or more.")
    parted, titles = {}, {}
    for each in obj.Patterns:
        used = film.read(each.Balloon)
        title = _title(used, titles)
        for stock, pieces in by_stock(_pieces(each, obj.Balloons, used.lies)).items():
            if pieces:
                parted.setdefault(stock, {}).setdefault("" if stock else title, []).extend(pieces)
    return parted


def _title(used, titles: dict) -> str:
    """What a film is called among those in titles, which gets it; its grain and weld make no other."""
    if used.roll not in titles:
        same = sum(title == used.title for title, *_ in titles)
        titles[used.roll] = f"{used.title} ({same + 1})" if same else used.title
    return titles[used.roll]


def _pieces(pattern_obj, balloons: int, grain) -> list:
    """All that is cut for so many balloons of a pattern."""
    from dataclasses import replace

    from BalloonWorkbench.app import pattern
    from BalloonWorkbench.app.engine.bag_result import has_many_panels
    from BalloonWorkbench.core.making.bag_numbers import bag_pieces
    from BalloonWorkbench.core.pattern.make import sheet_of
    from BalloonWorkbench.core.products import pieces_of

    if has_many_panels(pattern_obj.Balloon):
        return bag_pieces(pattern.bag_patterns(pattern_obj), balloons, grain)
    panel = pattern.build(pattern_obj)
    whole = sheet_of(panel, replace(pattern.values(pattern_obj), mirror=True, copies=1))
    return pieces_of(panel, whole, balloons, grain)


def _stock(obj):
    from BalloonWorkbench.core.nesting.layout import GrainRule, Stock

    options = options_from(obj, SheetOptions)
    return Stock(options.film_width, options.film_length, options.spacing, GrainRule(options.grain))


def _remnants(obj) -> list:
    """What is left of other layouts, on which pieces are laid first."""
    from BalloonWorkbench.core.nesting.remnant import read_remnants
    from BalloonWorkbench.core.products import insist_on_films

    remnants = read_remnants(Path(obj.Remnant)) if obj.Remnant else []
    insist_on_films(remnants, [FILMS[obj.Film]])
    return remnants


def _label(films, stock, remnants) -> str:
    """The same for the same layout: pieces and film without their last digits."""
    import numpy as np

    digest = hashlib.sha256()
    if len(films) > 1:
        digest.update(f"{[(title, len(pieces)) for title, pieces in films.items()]}".encode())
    for piece in _together(films):
        grain = "any" if piece.grain is None else f"{piece.grain:.6g}"
        digest.update(f"{piece.count} {piece.backs} {grain}".encode())
        for contour in piece.pattern.contours:
            digest.update((np.round(contour.points, 7) + 0.0).tobytes())
    for remnant in remnants:
        for ring in (remnant.area.exterior, *remnant.area.interiors):
            digest.update((np.round(ring.coords, 7) + 0.0).tobytes())
    numbers = (stock.width, stock.length or 0.0, stock.spacing)
    digest.update(f"{' '.join(f'{number:.9g}' for number in numbers)} {stock.grain.value}".encode())
    return digest.hexdigest()


def _keep(obj, layouts, remnants) -> None:
    """Write where all pieces lie into the object."""
    used = [layout.stock.remnant for layout in layouts]
    obj.OnRemnants = [-1 if each is None else remnants.index(each) for each in used]
    places = [
        [[place.piece, place.mirrored, place.angle, *place.shift.tolist()] for place in layout.places]
        for layout in layouts
    ]
    obj.Layouts = json.dumps(places)


def _layout(obj, stock, pieces, number=None):
    """The layout of a number, else that which is shown, from what `_keep` has written. InputError for a
    number that there is not."""
    import numpy as np

    from BalloonWorkbench.core.nesting.layout import Place, layout_of, of_remnant

    sheets, number = json.loads(obj.Layouts), number or obj.Shown
    if not 1 <= number <= len(sheets):
        raise InputError(f"There is no sheet {number}: give a number from 1 to {len(sheets)}.")
    places = [
        Place(int(piece), bool(mirrored), angle, np.array([x, y]))
        for piece, mirrored, angle, x, y in sheets[number - 1]
    ]
    on = [*obj.OnRemnants, *[-1] * len(sheets)][number - 1]  # older documents know of none
    return layout_of(stock if on < 0 else of_remnant(_remnants(obj)[on], stock), pieces, places)
