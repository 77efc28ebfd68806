# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a panel and a film in SI units to the dimensionless problem that the solvers take."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import length, perimeter
from BalloonWorkbench.core.options.simulation import ModelOptions
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.orthotropic import Grain
from BalloonWorkbench.core.solver.problem import FilmProblem
from BalloonWorkbench.core.types import Ints
from BalloonWorkbench.core.units import number_text

BENDING_FLOOR = ModelOptions.bending_floor
#: In-plane rigidity of the sealed band, in p w^4. Along the outline it crumples with the film: below the
#: floor the rim folds at mesh scale; above the ceiling the band itself would wrinkle, which no beam shows.
SEAM_FLOOR = 1e-6
SEAM_CEILING = 1e-5
#: Round a hole, and at a weld inside, the film pulls the band taut, so that it keeps all of its rigidity.
#: Without it a weld sways and a ring is unstable: a curved tube wants to curve more (Siefert et al., PNAS 116
#: (2019) 16692), a closed one kinks.
#: Near twice what a weld of 5 mm with 2 mm of film beside it has round the hole of a letter 300 mm high; a
#: fifth of it lets the letter O kink.
HOLE_FLOOR = 1e-2
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
    panel: Panel, film: Film, pressure: float, model: Model | None = None, tied: Ints | None = None
) -> FilmProblem:
    """The dimensionless problem of the upper panel: rim held in z = 0, free in the plane, directors free.

    Welds are held like the rim. Of both panels where the model asks for it.
    tied  (n,) for a panel slit along its welds, see split_along_welds.py
    """
    model = model or Model()
    if not 0.0 <= model.bending_floor <= 1.0:
        raise InputError(
            f"The bending floor must be between 0 and 1, not {number_text(model.bending_floor)}. "
            f"Usual is {number_text(BENDING_FLOOR)}."
        )
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    fixed = np.zeros((len(panel.rest_positions), 5), dtype=bool)
    fixed[panel.sealed, 2] = True
    fixed[:, 3:] = not model.bending
    width = typical_width(panel)
    seams: tuple[Ints, ...] = ()
    welds: tuple[Ints, ...] = ()
    seam_rigidities: tuple[float, ...] = ()
    if film.seal_width > 0.0:
        band = film.membrane_stiffness * film.seal_width**3 / 12.0  # the half of it that belongs to one panel
        relative = band / (pressure * width**4)
        outer, hole = min(max(relative, SEAM_FLOOR), SEAM_CEILING), max(relative, HOLE_FLOOR)
        seams = panel.seams
        welds = panel.welds[::2] if tied is not None else ()  # of the two sides of each one
        taut = len(panel.seams) - 1 + len(welds)
        seam_rigidities = tuple(rigidity * (width / size) ** 4 for rigidity in (outer, *[hole] * taut))
    rigidity = 0.0
    if model.bending:
        floor = model.bending_floor * (width / size) ** 3
        rigidity = max(film.flexural_rigidity / (pressure * size**3), floor)
    problem = FilmProblem(
        panel.rest_positions / size,
        panel.triangles,
        fixed,
        film.membrane_stiffness / (pressure * size),
        film.poisson_ratio,
        rigidity,
        seams=seams,
        welds=welds,
        seam_rigidities=seam_rigidities,
        grain=grain_of(film),
        tension_field=model.tension_field,
        tied=tied if panel.welds else None,
    )
    return both_panels(problem, panel.sealed) if model.two_panels else problem


def both_panels(problem: FilmProblem, sealed: Ints) -> FilmProblem:
    """The problem of two panels that share the positions of their sealed vertices, which are free in space.

    The lower panel follows the upper one in all arrays. Its rest positions are mirrored in x, so that its
    triangles run counter-clockwise with the outside of the balloon towards the eye.
    """
    count = len(problem.rest_positions)
    fixed = problem.fixed.copy()
    one = np.arange(count, dtype=np.int32) if problem.tied is None else problem.tied
    tied = np.concatenate([one, one + count])
    fixed[sealed, 2] = False
    tied[count + sealed] = one[sealed]
    grain = problem.grain
    if grain is not None and abs(np.sin(2.0 * grain.angle)) > 1e-6:
        raise InputError("Two panels with a grain aslant are no mirror images. Turn the grain along x or y.")
    return replace(
        problem,
        rest_positions=np.concatenate([problem.rest_positions, problem.rest_positions * (-1.0, 1.0)]),
        triangles=np.concatenate([problem.triangles, problem.triangles[:, ::-1] + count]).astype(np.int32),
        fixed=np.concatenate([fixed, fixed]),
        seam_rigidities=tuple(2.0 * rigidity for rigidity in problem.seam_rigidities),
        tied=tied,
    )


def grain_of(film: Film) -> Grain | None:
    """The film's grain relative to its modulus along it; None for an isotropic film."""
    if film.young_modulus_across is None:
        return None
    across = film.young_modulus_across / film.young_modulus
    shear = np.sqrt(across) / (2.0 * (1.0 + film.poisson_ratio * np.sqrt(across)))
    if film.shear_modulus is not None:
        shear = film.shear_modulus / film.young_modulus
    return Grain(across, float(shear), film.poisson_ratio, film.grain_angle)


def typical_width(panel: Panel) -> float:
    """Four times the area by the length of seams and welds [m]: diameter of a disc, side of a square."""
    _, areas = gradients(panel.rest_positions[panel.triangles])
    sealed = sum(perimeter(panel.rest_positions[seam]) for seam in panel.seams)
    sealed += sum(length(panel.rest_positions[weld]) for weld in panel.welds)
    return 4.0 * float(areas.sum()) / sealed


def stiffness_levels(stiffness: float) -> tuple[float, ...]:
    """Membrane stiffnesses from soft to the film's own, in nearly equal ratios of at most STIFFENING."""
    if stiffness <= SOFTEST:
        return (stiffness,)
    count = int(np.ceil(np.log(stiffness / SOFTEST) / np.log(STIFFENING) - 1e-9))
    return tuple(float(value) for value in SOFTEST * (stiffness / SOFTEST) ** (np.arange(count + 1) / count))
