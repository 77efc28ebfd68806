# SPDX-License-Identifier: LGPL-2.1-or-later
"""Global balance of an inflated balloon: what the film carries across planes, against pressure times area.

Independent of core/results/strength.py: integrals over the lines in which planes cut the triangles.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, facet_volume, green_strains
from BalloonWorkbench.core.solver.element.seam_band import SeamBand
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import film_problem
from BalloonWorkbench.core.types import Floats


def balance(inflation: Inflation, film: Film, angle: float, places: Floats) -> float:
    """Tension across planes at right angles to a direction, relative to pressure times section: 1 at rest.

    places  of the planes along the direction, 0 to 1 from end to end of the balloon. Forces and sections of
            all of them are summed: the tension of a single triangle is as rough as the mesh
    """
    ahead = np.array([np.cos(angle), np.sin(angle), 0.0])
    along = inflation.positions @ ahead
    force = section = 0.0
    for at in along.min() + places * np.ptp(along):
        one, other = _cut(inflation, film, ahead, float(at))
        force, section = force + one, section + other
    return force / (inflation.report.pressure * section)


def balance_of_all(inflation: Inflation, film: Film, angle: float) -> float:
    """The same for all planes there are: the integral of the tension along the direction over the film, and
    of what the bent weld carries across them, relative to pressure times volume."""
    ahead = np.array([np.cos(angle), np.sin(angle), 0.0])
    panel = inflation.panel
    shape, areas = gradients(panel.rest_positions[panel.triangles])
    deformation = deformation_gradients(inflation.positions, panel.triangles, shape)
    nominal = _nominal(inflation, film, deformation)
    pull = np.einsum("m,i,mik,mjk,j->", areas, ahead, nominal, deformation, ahead)
    pull += _of_the_weld(inflation, film, ahead)
    return float(pull) / (inflation.report.pressure * facet_volume(inflation.positions, panel.triangles))


def _of_the_weld(inflation: Inflation, film: Film, ahead: Floats) -> float:
    """The shear across all planes in the sealed band of the upper film [N m]: its forces by their places."""
    size, pressure = inflation.panel.size, inflation.report.pressure
    problem = film_problem(inflation.panel, film, pressure, inflation.report.model)
    if problem.hinges is None or problem.hinge_rigidities is None:
        return 0.0
    places = inflation.positions / size
    band = SeamBand(problem.rest_positions, problem.hinges, problem.hinge_rigidities)
    forces = band.derivatives(places)[0].reshape(-1, 3, 2) @ ahead[:2]
    return float((forces * (places[problem.hinges] @ ahead)).sum()) * pressure * size**3


def _nominal(inflation: Inflation, film: Film, deformation: Floats) -> Floats:
    """Forces (m, 3, 2) [N/m] across lines in the flat film."""
    problem = film_problem(inflation.panel, film, inflation.report.pressure, inflation.report.model)
    xx, yy, xy = film.membrane_stiffness * problem.membrane(green_strains(deformation)).stress.T
    return deformation @ np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], axis=1)


def _cut(inflation: Inflation, film: Film, ahead: Floats, at: float) -> tuple[float, float]:
    """Pull [N] along `ahead` of the upper film across a plane, and the area [m2] below it there."""
    panel = inflation.panel
    beyond = (inflation.positions @ ahead - at)[panel.triangles]
    crossed = np.isin((beyond > 0.0).sum(axis=1), (1, 2))
    corners, beyond = panel.triangles[crossed], beyond[crossed]
    shape, _ = gradients(panel.rest_positions[corners])
    deformation = deformation_gradients(inflation.positions, corners, shape)
    nominal = _nominal(inflation, film, deformation)

    # the corner that is alone on its side, and where the two edges from it are cut
    alone = np.argmax((beyond > 0.0) == ((beyond > 0.0).sum(axis=1) == 1)[:, None], axis=1)
    rows = np.arange(len(corners))
    first, others = corners[rows, alone], [corners[rows, (alone + k) % 3] for k in (1, 2)]
    own = beyond[rows, alone]
    shares = [own / (own - beyond[rows, (alone + k) % 3]) for k in (1, 2)]

    def ends(points: Floats) -> tuple[Floats, Floats]:
        one, two = (
            points[first] + share[:, None] * (points[other] - points[first])
            for share, other in zip(shares, others, strict=True)
        )
        return one, two

    start, end = ends(panel.rest_positions)
    normals = np.column_stack([(end - start)[:, 1], -(end - start)[:, 0]])  # as long as the cut
    rising = np.einsum("mak,ma->mk", shape, beyond)
    normals *= np.sign(np.einsum("mk,mk->m", normals, rising))[:, None]
    force = np.einsum("i,mik,mk->", ahead, nominal, normals)
    here, there = ends(inflation.positions)
    aside = np.array([-ahead[1], ahead[0], 0.0])
    places = inflation.positions[corners]
    up = np.sign(np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])[:, 2])
    widths = up * np.abs((there - here) @ aside)
    return float(force), float(widths @ (here[:, 2] + there[:, 2])) / 2.0
