# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows a finished job to others: the balloons with their artwork as one GLB file, and as a web page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from BalloonWorkbench.core.artwork.carry import VisibleFilm
from BalloonWorkbench.core.artwork.picture import Picture
from BalloonWorkbench.core.bag_job import BagPart, FinishedBags
from BalloonWorkbench.core.job import Balloon, Part
from BalloonWorkbench.core.products import Artwork, box_of, pictures_of, pictures_on
from BalloonWorkbench.core.scenes.glb import glb_bytes
from BalloonWorkbench.core.scenes.surface_mesh import (
    Painted,
    SurfaceMesh,
    bag_meshes,
    small_picture,
    two_panel_meshes,
)

#: The names of the files.
GLB, PAGE = "balloon.glb", "report.html"
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
        meshes.append(bag_meshes(part.design, look, [(film, small[id(picture)]) for film, picture in printed]))
    return meshes


def _by_identity(printed: Sequence[tuple[VisibleFilm, Picture]]) -> dict[int, Picture]:
    return {id(picture): picture for _, picture in printed}
