# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows a finished job to others: the balloons with their artwork as one GLB file, and as a web page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from BalloonWorkbench.core.artwork.carry import VisibleFilm
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.artwork.picture import Picture
from BalloonWorkbench.core.assembly_sheet.blocks import line_names
from BalloonWorkbench.core.assembly_sheet.texts import figures, material
from BalloonWorkbench.core.bag_job import BagPart, FinishedBags
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.job import Balloon, Part
from BalloonWorkbench.core.machines.machine import ANY, machines
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pictures.bag_picture import upright
from BalloonWorkbench.core.products import Artwork, box_of, pictures_of, pictures_on
from BalloonWorkbench.core.scenes.glb import glb_bytes
from BalloonWorkbench.core.scenes.mesh_picture import meshes_picture
from BalloonWorkbench.core.scenes.surface_mesh import (
    Painted,
    SurfaceMesh,
    bag_meshes,
    small_picture,
    two_panel_meshes,
)
from BalloonWorkbench.core.solver.inflation import MIRROR
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import length_text, size_text, volume_text
from BalloonWorkbench.core.web_pages.balloon_page import BalloonPage, NamedTable, balloon_page

#: The names of the files.
GLB, PAGE = "balloon.glb", "report.html"
#: Of the page's picture: width, height, dots per inch.
_PICTURE, _DPI = (720, 540), 96.0
#: Side of a small picture [pixels].
_SMALL = 96
#: The balloons of a job by their names.
Shown = Mapping[str, Sequence[SurfaceMesh]]


def shown(balloon: Balloon | FinishedBags, title: str, artwork: Artwork | None = None) -> Shown:
    """The balloons of a job as they are seen: with what is printed on them, else in their film's colour.

    Raises what of_drawing raises.
    """
    names = [title] if len(balloon.parts) == 1 else [f"{title} {k}" for k in range(1, len(balloon.parts) + 1)]
    meshes = _bags(balloon, artwork) if isinstance(balloon, FinishedBags) else _two_panels(balloon, artwork)
    return dict(zip(names, meshes, strict=True))


def glb_file(balloon: Balloon | FinishedBags, title: str, artwork: Artwork | None = None) -> bytes:
    """All balloons of a job as a GLB file. Raises what `shown` raises."""
    return glb_bytes(title, shown(balloon, title, artwork))


def _two_panels(balloon: Balloon, artwork: Artwork | None) -> list[list[SurfaceMesh]]:
    painted = Painted()
    if artwork is not None:
        front, behind = pictures_of(box_of(balloon), artwork)
        small = small_picture(front)
        painted = Painted(small, small if behind is None else small_picture(behind))
    inflations = [design.inflation for design in balloon.designs]
    seal_width = balloon.patterns[0].seal_width
    return two_panel_meshes(inflations, seal_width, balloon.settings.film.look, painted)


def _bags(bags: FinishedBags, artwork: Artwork | None) -> list[list[SurfaceMesh]]:
    look = bags.settings.film.look
    meshes = []
    for part in bags.parts:
        printed = [] if artwork is None else pictures_on(bags, artwork, part.design, part.patterns.panels)
        small = {key: small_picture(picture) for key, picture in _by_identity(printed).items()}
        meshes.append(
            bag_meshes(part.design, look, [(film, small[id(picture)]) for film, picture in printed])
        )
    return meshes


def _by_identity(printed: Sequence[tuple[VisibleFilm, Picture]]) -> dict[int, Picture]:
    return {id(picture): picture for _, picture in printed}


def page_file(
    balloon: Balloon | FinishedBags,
    title: str,
    artwork: Artwork | None = None,
    say: Say = in_english,
    language: str = "en",
) -> bytes:
    """The web page about a job; language: that of say. Raises what `shown` raises."""
    balloons, settings = shown(balloon, title, artwork), balloon.settings
    picture = meshes_picture([mesh for meshes in balloons.values() for mesh in meshes], *_PICTURE)
    sheet = balloon.sheet
    names, colours = line_names(settings.film.seam), machines()[ANY["svg"]].layers
    report = balloon.report
    advice = [finding for part in report.get("parts", ()) for finding in part["advice"]]
    warnings = report.get("warnings", ())
    subject = BalloonPage(
        title,
        say(f"inflated {size_text(*_size(balloon))}, {volume_text(_volume(balloon))}"),
        glb_bytes(title, balloons),
        png_bytes(np.rint(255.0 * picture).astype(np.uint8), _DPI),
        [_tables(part, settings.film, say) for part in balloon.parts],
        machine_file(sheet.of_stock(""), machines()[ANY["svg"]]),
        [(colours[role].rgb, say(names[role])) for role in sheet.roles if role in names and role in colours],
        [(say(each["severity"]), say(each["text"])) for each in advice if each["text"] not in warnings],
        list(map(say, warnings)),
    )
    return balloon_page(subject, language, say)


def small_png(balloon: Balloon | FinishedBags) -> bytes:
    """A small picture of a job's balloons in their film's colour, as PNG."""
    meshes = [mesh for each in shown(balloon, "").values() for mesh in each]
    picture = meshes_picture(meshes, _SMALL, _SMALL)
    return png_bytes(np.rint(255.0 * picture).astype(np.uint8), _DPI)


def _tables(part: Part | BagPart, film: Film, say: Say) -> list[NamedTable]:
    """What a balloon is made of, what it takes and bears, and how well it was met."""
    design, numbers = part.design, part.numbers
    pattern = part.patterns.sheet if isinstance(part, BagPart) else part.pattern
    met = [NamedTable(say("Form"), _met(design.residual, say))] if design.residual is not None else []
    if numbers is None:
        return met
    return [
        *met,
        NamedTable(say("Material"), material(film, pattern, numbers, say)),
        NamedTable(say("Numbers"), figures(film, numbers, say)),
    ]


def _met(error: Residual, say: Say) -> list[tuple[str, str]]:
    """How far the balloon is off what was wanted."""
    return [
        (say("Off on average"), length_text(error.mean, 2)),
        (say("95 % of it below"), length_text(error.p95, 2)),
        (say("Off at most"), length_text(error.max, 2)),
    ]


def _size(balloon: Balloon | FinishedBags) -> list[float]:
    """Width, height and depth of all of it, inflated [m]."""
    places = []
    if isinstance(balloon, FinishedBags):
        places += [upright(design)[design.film] for design in balloon.designs]
    else:
        for inflation in [design.inflation for design in balloon.designs]:
            lower = inflation.positions * MIRROR if inflation.lower is None else inflation.lower
            places += [inflation.positions, lower]
    return [float(size) for size in np.ptp(np.concatenate(places), axis=0)]


def _volume(balloon: Balloon | FinishedBags) -> float:
    return sum(design.inflation.volume for design in balloon.designs)
