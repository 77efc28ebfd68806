# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a balloon does the body that it was made for: distance, strain of its panels, slack film, clearance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.flattening.bag_of import flat_body
from BalloonWorkbench.core.flattening.conformal import own_planes
from BalloonWorkbench.core.results.film_state import State, film_state
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.target_design.curved_film import curved_film
from BalloonWorkbench.core.target_design.off_target import TargetSurface, both_ways
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Strain:
    """By how much a panel is stretched or shrunk as it is laid flat, before the correction, by area."""

    mean: float
    largest: float


@dataclass(frozen=True)
class BodyFigures:
    """What there is to say of a balloon beside the body that it was made for.

    flattening  of all panels together
    of_panels   of each panel
    slack       part of the film's area that carries nothing
    wrinkled    part that carries tension along one direction only
    hidden      part of the film's width that wrinkles hide, by area, over all of the film
    inmost      how far outside of the body the film lies where that is least [m], below 0 inside
    outmost     the same where it is most
    from_film   distances [m] of the film from the body, by its area
    from_body   of the body from the film: more where the film leaves out a part
    """

    flattening: Strain
    of_panels: tuple[Strain, ...]
    slack: float
    wrinkled: float
    hidden: float
    inmost: float
    outmost: float
    from_film: Residual
    from_body: Residual


def body_figures(design: BagDesign, film: Film) -> BodyFigures | None:
    """Those of a balloon of this film; None of one that was not made for a closed body."""
    division = design.source
    if not isinstance(division, Division):
        return None
    surface = design.meshed.assembly.surface
    strains, areas = _stretch(division), division.target.areas
    panels = [division.panels == number for number in range(len(division.names))]
    state = film_state(design.inflation, film)
    shares = state.shares()
    body = TargetSurface(division.target)
    curved = curved_film(design.inflation.positions, design.inflation.directors, surface)
    from_film, from_body, (inmost, outmost) = both_ways(body, *curved)
    return BodyFigures(
        _strain(strains, areas),
        tuple(_strain(strains[own], areas[own]) for own in panels),
        shares[State.SLACK],
        shares[State.WRINKLED],
        float(state.intensity @ state.areas / state.areas.sum()),
        inmost,
        outmost,
        from_film,
        from_body,
    )


def _stretch(division: Division) -> Floats:
    """By how much each triangle (m,) of the body is stretched or shrunk as it is laid flat, at most."""
    target, opened = division.target, division.opened
    corners = own_planes(target.points, target.triangles)
    shape, _ = gradients(np.stack([corners.real, corners.imag], axis=-1))
    flat = np.concatenate(flat_body(division).flats)[opened.triangles]
    stretches = np.linalg.svd(np.einsum("mai,mak->mik", flat, shape), compute_uv=False)
    return np.asarray(np.abs(stretches - 1.0).max(axis=1))


def _strain(strains: Floats, areas: Floats) -> Strain:
    return Strain(float(strains @ areas / areas.sum()), float(strains.max()))
