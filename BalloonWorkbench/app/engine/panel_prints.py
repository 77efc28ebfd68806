# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an Artwork object prints on many panels: one picture, wrapped round the balloon."""

from __future__ import annotations

from BalloonWorkbench.app.document.kinds import is_outline, leader


def chosen(obj) -> tuple:
    """The finished balloon, and the core's Artwork of it. InputError where there is nothing to print."""
    from pathlib import Path

    from BalloonWorkbench.app.drawings.drawing_file import file_of, pixels_of
    from BalloonWorkbench.app.outline import reading_of
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.machines.marks.choose import marks_for
    from BalloonWorkbench.core.products import Artwork

    source = leader(obj.Pattern.Balloon.Outline)
    drawn = is_outline(source) and not source.Source and source.Kind == "picture"
    drawing = source.Drawing if drawn else ""
    path = obj.Picture or drawing
    if not path:
        raise InputError("There is no picture to print: choose one, as the balloon has none of its own.")
    own = bool(drawing) and (path == drawing or Path(path).read_bytes() == Path(drawing).read_bytes())
    return finished(obj.Pattern), Artwork(
        pixels_of(file_of(path)),
        own,
        pixels_of(file_of(obj.BackPicture)) if obj.BackPicture else None,
        obj.Resolution,
        metres(obj.Bleed),
        marks=marks_for(obj.MarksFor.strip()),
        **(dict(zip(("drawn_as", "tracing"), reading_of(source)[1:])) if own else {}),
    )


def finished(pattern_obj):
    """The balloon and its patterns as a finished job."""
    from BalloonWorkbench.app.engine import bag_result
    from BalloonWorkbench.app.pattern import bag_patterns
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.bag_job import BagPart, FinishedBags
    from BalloonWorkbench.core.job import Settings

    balloon = pattern_obj.Balloon
    design, _ = bag_result.stored(balloon)
    part = BagPart(design, bag_patterns(pattern_obj), None)
    return FinishedBags(Settings(film=film.read(balloon)), (part,), {})


def on_film(obj) -> list[tuple]:
    """Of each panel of the balloon its places (n, 3) mm, triangles (m, 3), the picture on it as a painting
    and the places (m, 3, 2) mm of the corners of its triangles in that.
    """
    import numpy as np

    from BalloonWorkbench.app.drawings.painting import PaintedArtwork
    from BalloonWorkbench.core.products import pictures_on
    from BalloonWorkbench.core.units import to_mm

    bags, artwork = chosen(obj)
    design = bags.parts[0].design
    assembly = design.inflation.assembly
    places = np.split(to_mm(design.inflation.positions), assembly.offsets[1:-1])
    paintings: dict = {}
    panels = []
    for number, (film, picture) in enumerate(pictures_on(bags, artwork, design, range(len(places)))):
        if id(picture) not in paintings:  # front and back are one each for all panels
            paintings[id(picture)] = PaintedArtwork(picture.pixels, to_mm(picture.low), to_mm(picture.pixel))
        corners = to_mm(film.seen[film.triangles])
        panels.append((places[number], assembly.panels[number].triangles, paintings[id(picture)], corners))
    return panels


def printed(bags, artwork, dpi: float) -> tuple:
    """The sheet to print, for front and back alike; touches no document."""
    from dataclasses import replace

    from BalloonWorkbench.core.products import bag_print

    *_, sheet = bag_print(bags, replace(artwork, dpi=dpi))
    return sheet, sheet


def pattern(obj):
    """What a cutter gets: all panels, the border of their print and marks."""
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.machines.marks.choose import marks_for
    from BalloonWorkbench.core.products import panels_to_print

    marks = marks_for(obj.MarksFor.strip())
    return panels_to_print(finished(obj.Pattern).parts, metres(obj.Bleed), marks)[1]
