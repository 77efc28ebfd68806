# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows a finished job to others: balloons with their artwork as GLB file, picture and web page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.artwork.files import png_bytes
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
from BalloonWorkbench.core.scenes.ground import WHITE, Ground, image_file, laid_on
from BalloonWorkbench.core.scenes.mesh_picture import meshes_picture
from BalloonWorkbench.core.scenes.surface_mesh import (
    Painted,
    SurfaceMesh,
    bag_meshes,
    small_picture,
    two_panel_meshes,
)
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import length_text, size_text, volume_text
from BalloonWorkbench.core.web_pages.balloon_page import BalloonPage, NamedTable, balloon_page

#: The names of the files.
GLB, PAGE, PICTURE = "balloon.glb", "report.html", "balloon.png"
#: Of the page's picture: width, height, dots per inch.
_PICTURE, _DPI = (720, 540), 96.0
#: Width and height of a picture by itself, and the side of a small one [pixels].
_LARGE, _SMALL = (1600, 1200), 96
#: The balloons of a job by their names.
Shown = Mapping[str, Sequence[SurfaceMesh]]
#: What is printed: pictures to be laid on the film, or of two equal panels those that are in their place.
Printed = Artwork | Painted
#: Gives the surfaces of each balloon of a job, from the state of each.
Surfaces = Callable[[Sequence[Inflation]], list[list[SurfaceMesh]]]


def shown(balloon: Balloon | FinishedBags, title: str, artwork: Printed | None = None) -> Shown:
    """The balloons of a job as they are seen: with what is printed on them, else in their film's colour.

    Raises what of_drawing raises.
    """
    names = [title] if len(balloon.parts) == 1 else [f"{title} {k}" for k in range(1, len(balloon.parts) + 1)]
    meshes = surfaces(balloon, artwork)([design.inflation for design in balloon.designs])
    return dict(zip(names, meshes, strict=True))


def surfaces(balloon: Balloon | FinishedBags, artwork: Printed | None = None) -> Surfaces:
    """The surfaces of a job's balloons in any state on the way to theirs.

    What is printed stays where it is on the film: that is where it is seen on the balloons of the job.
    Raises what of_drawing raises.
    """
    if isinstance(balloon, FinishedBags):
        return _bags(balloon, artwork)
    return _two_panels(balloon, artwork)


def glb_file(balloon: Balloon | FinishedBags, title: str, artwork: Printed | None = None) -> bytes:
    """All balloons of a job as a GLB file. Raises what `shown` raises."""
    return glb_bytes(title, shown(balloon, title, artwork))


def picture_file(
    balloon: Balloon | FinishedBags, artwork: Printed | None = None, ground: Ground = WHITE
) -> bytes:
    """All balloons of a job as a PNG on a ground. Raises what `shown` raises."""
    meshes = [mesh for each in shown(balloon, "", artwork).values() for mesh in each]
    picture = meshes_picture(meshes, *_LARGE)
    pixels = np.rint(255.0 * picture).astype(np.uint8)
    if ground is not None:
        pixels[..., :3], pixels[..., 3] = laid_on(picture, ground), 255
    return png_bytes(pixels, _DPI)


def _two_panels(balloon: Balloon, artwork: Printed | None) -> Surfaces:
    painted = Painted() if artwork is None else _painted(balloon, artwork)
    seal_width, look = balloon.patterns[0].seal_width, balloon.settings.film.look
    own = two_panel_meshes([design.inflation for design in balloon.designs], seal_width, look, painted)

    def make(inflations: Sequence[Inflation]) -> list[list[SurfaceMesh]]:
        moved = two_panel_meshes(inflations, seal_width, look, painted)
        return [
            [replace(mesh, places=before.places) for mesh, before in zip(meshes, at_rest, strict=True)]
            for meshes, at_rest in zip(moved, own, strict=True)
        ]

    return make


def _painted(balloon: Balloon, artwork: Printed) -> Painted:
    if isinstance(artwork, Painted):
        front, behind = artwork.front, artwork.behind
    else:
        front, behind = pictures_of(box_of(balloon), artwork)
        behind = behind or front
    small = {id(each): small_picture(each) for each in (front, behind) if each is not None}
    return Painted(small.get(id(front)), small.get(id(behind)))


def _bags(bags: FinishedBags, artwork: Printed | None) -> Surfaces:
    look = bags.settings.film.look
    prints = []
    for part in bags.parts:
        printed = (
            pictures_on(bags, artwork, part.design, part.patterns.panels)
            if isinstance(artwork, Artwork)
            else []
        )
        pictures = {id(picture): picture for _, picture in printed}
        small = {key: small_picture(picture) for key, picture in pictures.items()}
        prints.append([(film, small[id(picture)]) for film, picture in printed])

    def make(inflations: Sequence[Inflation]) -> list[list[SurfaceMesh]]:
        states = zip(bags.designs, inflations, prints, strict=True)
        return [
            bag_meshes(replace(design, inflation=inflation), look, printed)
            for design, inflation, printed in states
        ]

    return make


def page_file(
    balloon: Balloon | FinishedBags,
    title: str,
    artwork: Printed | None = None,
    say: Say = in_english,
    language: str = "en",
    ground: Ground = None,
) -> bytes:
    """The web page about a job; language: that of say; ground: None is the page's own.

    Raises what `shown` and image_file raise.
    """
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
        None if ground is None else image_file(ground),
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
