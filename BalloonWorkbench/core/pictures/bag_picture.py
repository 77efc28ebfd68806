# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shaded picture of a balloon of many panels, or of some of them, with its seams in colours."""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bags.seam_colours import seam_colour
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.geometry.normals import vertex_normals
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.geometry.vectors import unit
from BalloonWorkbench.core.panels.seam import Run
from BalloonWorkbench.core.pictures.render import (
    FILM_COLOUR,
    INNER_SHADE,
    Coloured,
    rgb,
    surface_picture,
    together,
)
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats, Ints

#: Width of a seam's colour on each side of it, and how far it lies over the film; of the balloon's size.
_RIBBON, _ABOVE = 0.011, 0.004
#: What is sealed already: its colour, and its width beside that of a seam in colour.
_SEALED, _THIN = "#1f2937", 0.5
#: The ends of names of files in which y is up.
_Y_UP = ".obj"
#: How far a seam above or below turns toward the eye.
_LEAN = 0.8


def bag_picture(
    design: BagDesign,
    width: int,
    height: int,
    colour: str | Floats = FILM_COLOUR,
    *,
    seams: Mapping[int, str] | None = None,
    panels: Collection[int] | None = None,
    facing: int | None = None,
    sealed: Collection[int] = (),
) -> Floats:
    """RGBA (height, width, 4) of the balloon.

    colour  of the film; or those of all vertices (n, 3), 0 to 1
    seams   colours by number of those that are seen, from 1; None for all in their own
    panels  numbers of those that are seen, from 0; None for all that are cut
    facing  the seam that is turned toward the eye; None shows the front
    sealed  numbers of seams that are seen as thin dark lines
    """
    count = len(design.bag.seams)
    seams = {number: seam_colour(number) for number in range(1, count + 1)} if seams is None else seams
    cut = [number for number, panel in enumerate(design.bag.panels) if panel.cut]
    shown = sorted(cut if panels is None else panels)
    places = upright(design)
    if facing is not None:
        places = _turned(design, places, facing)
    colours = np.tile(rgb(colour), (len(places), 1)) if isinstance(colour, str) else colour
    parts = [_film(design, places, panel, colours, inside=len(shown) < len(cut)) for panel in shown]
    for number, of_seam in sorted(seams.items()):
        for run in _runs(design, number):
            if run.panel in shown:
                parts.append(_ribbon(design, places, run, rgb(of_seam)))
    for number in sealed:
        for run in _runs(design, number):
            if run.panel in shown:
                parts.append(_ribbon(design, places, run, rgb(_SEALED), _THIN))
    return surface_picture(together(parts), width, height)


def upright(design: BagDesign) -> Floats:
    """Places (n, 3) m of all vertices, y up and z to the front: a gored body stands on its axis.

    Of bodies z is up, as in CAD and on 3D printers, but for OBJ files: what writes those has y up.
    """
    places = design.inflation.positions
    if isinstance(design.source, Division) and design.source.target.source.lower().endswith(_Y_UP):
        return places
    if isinstance(design.source, Profile | Division):
        return np.ascontiguousarray(places[:, [0, 2, 1]] * (1.0, 1.0, -1.0))
    return places


def _runs(design: BagDesign, number: int) -> tuple[Run, Run]:
    return design.inflation.assembly.seams[number - 1].runs


def _turned(design: BagDesign, places: Floats, number: int) -> Floats:
    """The balloon turned about its upright axis, and a little over, until a seam is in front."""
    middle = 0.5 * (places.min(axis=0) + places.max(axis=0))
    x, y, z = sum(
        panel_surface(design, places, run.panel)[2][run.vertices[len(run.vertices) // 2]]
        for run in _runs(design, number)
    )
    around, over = np.arctan2(x, z), -_LEAN * np.arctan2(y, np.hypot(x, z))
    ca, sa, co, so = np.cos(around), np.sin(around), np.cos(over), np.sin(over)
    about_y = np.array([[ca, 0.0, -sa], [0.0, 1.0, 0.0], [sa, 0.0, ca]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, co, so], [0.0, -so, co]])
    return np.asarray((places - middle) @ (about_x @ about_y).T)


def panel_surface(design: BagDesign, places: Floats, number: int) -> tuple[Floats, Ints, Floats]:
    """Places, triangles and normals of a panel, seen from outside."""
    assembly = design.inflation.assembly
    start = assembly.offsets[number]
    panel = assembly.panels[number]
    own = places[start : start + len(panel.rest_positions)]
    over = bool(assembly.surface.turned[number])
    triangles = panel.triangles[:, ::-1] if over else panel.triangles
    return own, triangles, vertex_normals(own, triangles)


def _film(design: BagDesign, places: Floats, number: int, film: Floats, *, inside: bool) -> Coloured:
    """The film of a panel in the colours of all vertices; inside: its other side is seen as well."""
    own, triangles, normals = panel_surface(design, places, number)
    start = design.inflation.assembly.offsets[number]
    film = film[start : start + len(own)]
    if not inside:
        return own, triangles, normals, film
    return together(
        [(own, triangles, normals, film), (own, triangles[:, ::-1], -normals, INNER_SHADE * film)]
    )


def _ribbon(design: BagDesign, places: Floats, run: Run, colour: Floats, share: float = 1.0) -> Coloured:
    """A strip of a panel along a seam, a hair over the film on both its sides; share: of the usual width."""
    own, _, normals = panel_surface(design, places, run.panel)
    size = extent(places)
    line, up = own[run.vertices], normals[run.vertices]
    along = np.gradient(line, axis=0)
    panel = design.inflation.assembly.panels[run.panel]
    towards = unit(np.cross(up, along))
    # the film lies to the left of its loops: of a run against them to the right
    first = next(loop for loop in panel.loops if run.vertices[0] in loop)
    place = int(np.flatnonzero(first == run.vertices[0])[0])
    sense = 1.0 if first[(place + 1) % len(first)] == run.vertices[1] else -1.0
    wide = share * min(_RIBBON * size, 0.3 * float(np.ptp(panel.rest_positions, axis=0).min()))
    parts = []
    for side in (1.0, -1.0):
        lifted = side * _ABOVE * size * up
        points = np.concatenate([line + lifted, line + sense * wide * towards + lifted])
        k = np.arange(len(line) - 1)
        n = len(line)
        quads = np.concatenate([np.stack([k, k + 1, k + n + 1], 1), np.stack([k, k + n + 1, k + n], 1)])
        quads = quads if side * sense > 0.0 else quads[:, ::-1]
        parts.append(
            (points, quads.astype(np.int32), side * np.tile(up, (2, 1)), np.tile(colour, (2 * n, 1)))
        )
    return together(parts)
