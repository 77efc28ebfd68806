# SPDX-License-Identifier: LGPL-2.1-or-later
"""From an assembly and a film in SI units to the dimensionless problem that the solvers take."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import length, perimeter
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import ELASTIC, ModelOptions
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.orthotropic import Grain
from BalloonWorkbench.core.solver.element.seam_band import seam_hinges
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.solver.split_along_welds import SplitFilm, split_assembly
from BalloonWorkbench.core.solver.weld_strip import with_strip
from BalloonWorkbench.core.units import number_text

BENDING_FLOOR = ModelOptions.bending_floor
#: Film that stays beyond the weld [m], as a pattern usually has it: it stiffens the sealed band, too.
BEYOND_WELD = PatternOptions.allowance
#: The continuation begins with a film this soft and grows by this factor.
SOFTEST = 6.0
STIFFENING = 5.0


@dataclass(frozen=True)
class Model(ModelOptions):
    """What is simulated; twist: how far two panels start from the plane of symmetry, so that a balloon that
    wants to warp can.
    """

    twist: float = 1e-3


def film_problem(
    body: Panel | Assembly, film: Film, pressure: float, model: Model | None = None
) -> FilmProblem:
    """The dimensionless problem of an assembly, or of a panel and its mirror image; see problem_of."""
    model = model or Model()
    return problem_of(split_assembly(simulated(body, model)), film, pressure, model)


def problem_of(split: SplitFilm, film: Film, pressure: float, model: Model) -> FilmProblem:
    """The dimensionless problem of an assembly.

    Of a mirrored panel one half: rim and welds are held in z = 0, free in the plane. Others are free in
    space. Directors are free. Seams carry the stiffness of a sealed band.
    """
    if not 0.0 <= model.bending_floor <= 1.0:
        raise InputError(
            f"The bending floor must be between 0 and 1, not {number_text(model.bending_floor)}. "
            f"Usual is {number_text(BENDING_FLOOR)}."
        )
    assembly, grain = split.assembly, grain_of(film)
    if grain is not None and assembly.surface.turned.any() and abs(np.sin(2.0 * grain.angle)) > 1e-6:
        raise InputError("Two panels with a grain aslant are no mirror images. Turn the grain along x or y.")
    size, width = assembly.size, typical_width(split.panels)
    fixed = np.zeros((len(split.origin), 5), dtype=bool)
    if assembly.mirror:
        fixed[split.panels[0].sealed, 2] = True
    fixed[:, 3:] = not model.bending
    fixed[len(fixed) - split.strip :, 2:] = True
    rigidity = 0.0
    if model.bending:
        floor = model.bending_floor * (width / size) ** 3
        rigidity = max(film.flexural_rigidity / (pressure * size**3), floor)
    problem = FilmProblem(
        split.rest_positions / size,
        split.triangles,
        fixed,
        film.membrane_stiffness / (pressure * size),
        film.poisson_ratio,
        rigidity,
        grain=grain,
        tension_field=model.tension_field,
        tied=split.tied,
        in_space=not assembly.mirror and not assembly.is_pair,
    )
    banded = film.seal_width > 0.0 and model.weld == ELASTIC
    return _with_bands(problem, split, film, pressure) if banded else problem


def split_for(assembly: Assembly, film: Film, model: Model) -> SplitFilm:
    """What the solver gets of an assembly: split along its welds, with the strip of a weld that crumples."""
    split = split_assembly(assembly)
    if model.weld == ELASTIC or not film.seal_width > 0.0:
        return split
    return with_strip(split, film.seal_width + BEYOND_WELD)


def simulated(body: Panel | Assembly, model: Model) -> Assembly:
    """What a model takes of a panel, which stands for two equal ones, or of an assembly."""
    assembly = Assembly.mirrored(body) if isinstance(body, Panel) else body
    return assembly.in_full() if model.two_panels else assembly


def _with_bands(problem: FilmProblem, split: SplitFilm, film: Film, pressure: float) -> FilmProblem:
    """The same with the stiffness of the sealed band along all seams and welds.

    Without bending nothing turns the directors, by which the band in space knows the plane of the film.
    """
    assembly = split.assembly
    if problem.in_space:
        return problem if problem.fixed[:, 3:].all() else _with_space_bands(problem, split, film, pressure)
    panel, films = split.panels[0], 1.0 if assembly.mirror else 2.0
    hinges = seam_hinges(panel.loops, panel.welds[::2])  # of the two sides of each weld
    rigidity = films * band_rigidity(film) / (pressure * assembly.size**4)
    return replace(problem, hinges=hinges, hinge_rigidities=np.full(len(hinges), rigidity))


def _with_space_bands(problem: FilmProblem, split: SplitFilm, film: Film, pressure: float) -> FilmProblem:
    """No band runs on where three corners of panels meet, and where it ends there is nothing to bend."""
    starts = np.cumsum([0, *(len(panel.rest_positions) for panel in split.panels)])
    hinges = np.concatenate(
        [seam_hinges(panel.loops, panel.welds) + at for panel, at in zip(split.panels, starts)]
    ).astype(np.int32)
    surface = split.assembly.surface
    at_poles = np.isin(surface.by_seams, surface.poles)[split.origin]
    hinges = hinges[~at_poles[hinges[:, 1]]]
    rigidities = np.full(len(hinges), band_rigidity(film) / (pressure * split.assembly.size**4))
    return replace(problem, hinges=hinges, hinge_rigidities=rigidities)


def band_rigidity(film: Film) -> float:
    """In-plane rigidity E I of what one panel has of the sealed band [N m2]; see seam_band.py."""
    return film.weld_rigidity * film.membrane_stiffness * (film.seal_width + BEYOND_WELD) ** 3 / 12.0


def grain_of(film: Film) -> Grain | None:
    """The film's grain relative to its modulus along it; None for an isotropic film."""
    if film.young_modulus_across is None:
        return None
    across = film.young_modulus_across / film.young_modulus
    shear = np.sqrt(across) / (2.0 * (1.0 + film.poisson_ratio * np.sqrt(across)))
    if film.shear_modulus is not None:
        shear = film.shear_modulus / film.young_modulus
    return Grain(across, float(shear), film.poisson_ratio, film.grain_angle)


def typical_width(panels: Sequence[Panel]) -> float:
    """Four times the area by the length of seams and welds [m]: diameter of a disc, side of a square."""
    area = sealed = 0.0
    for panel in panels:
        rest = panel.rest_positions
        area += float(gradients(rest[panel.triangles])[1].sum())
        sealed += sum(perimeter(rest[seam]) for seam in panel.loops)
        sealed += sum(length(rest[weld]) for weld in panel.welds)
    return 4.0 * area / sealed


def stiffness_levels(stiffness: float) -> tuple[float, ...]:
    """Membrane stiffnesses from soft to the film's own, in nearly equal ratios of at most STIFFENING."""
    if stiffness <= SOFTEST:
        return (stiffness,)
    count = int(np.ceil(np.log(stiffness / SOFTEST) / np.log(STIFFENING) - 1e-9))
    return tuple(float(value) for value in SOFTEST * (stiffness / SOFTEST) ** (np.arange(count + 1) / count))
