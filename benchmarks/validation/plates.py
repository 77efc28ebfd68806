# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film's parts by themselves: taut disc, bending, wrinkled beam."""

from __future__ import annotations

import numpy as np
from plate_tables import EIGENVALUES, PLATES
from solver_cases import flat_state, full_grid, grid, held, nearest, panel, quarter_grid, vertex_areas
from validation.report import Row, Section, section

from BalloonWorkbench.core.solver.element import dkt
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.element.membrane import principal_stresses, tension_field
from BalloonWorkbench.core.solver.element.shell import Shell, tangent_frames
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.native import c_interface
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.solver.start import vertex_normals
from BalloonWorkbench.core.types import Bools, Floats, Ints


def hencky() -> Section:
    """Section 7: clamped disc under pressure."""
    disc, stiffness = panel("disc", 1500), 1e5
    rest, rim = disc.rest_positions, disc.loops[0]
    fixed = held(len(rest))
    fixed[rim, :3] = True
    deflection = 0.653443 * stiffness ** (-1.0 / 3.0)
    start = np.column_stack([rest, deflection * (1.0 - (rest**2).sum(axis=1))])
    start[rim, 2] = 0.0
    problem = FilmProblem(rest, disc.triangles, fixed, stiffness, 0.3, 1e-9)
    state = c_interface.solve(
        problem, Start(start, vertex_normals(start, disc), (stiffness,)), NewtonSettings(1e-10)
    )
    corners = rest[disc.triangles]
    strain = green_strains(deformation_gradients(state.positions, disc.triangles, gradients(corners)[0]))
    tensions = stiffness * principal_stresses(tension_field(strain, 0.3).stress)
    centre = np.linalg.norm(corners.mean(axis=1), axis=1) < 0.1
    rows = [
        Row(
            "w0 / (a (p a / (E t))^(1/3))",
            float(state.positions[:, 2].max()) * stiffness ** (1 / 3),
            0.653443,
            0.001,
        ),
        Row(
            "tension at the centre / (p^2 a^2 E t)^(1/3)",
            float(tensions[centre].mean()) * stiffness ** (-1.0 / 3.0),
            0.431101,
            0.005,
        ),
    ]
    return section(
        "7. Clamped disc under pressure (Hencky)",
        "Small slopes, nu = 0.3, no wrinkles; E t / (p a) = 100 000, about 1 500 vertices.",
        rows,
    )


def bending() -> Section:
    """Section 8: DKT."""
    element = dkt.plate_stiffness(np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]), 0.3)[0]
    rows = [
        Row("one element: K11", element[0, 0], 10.05, 1e-9, 7),
        Row("one element: trace", float(np.trace(element)), 27.925, 1e-9, 7),
    ]
    found = np.linalg.eigvalsh(element)[3:]
    rows += [
        Row(f"one element: eigenvalue {index}", float(value), reference, 1e-6, 9)
        for index, (value, reference) in enumerate(zip(found, EIGENVALUES), 4)
    ]
    cases = ("supported, q", "clamped, q", "supported, P", "clamped, P")
    for cells, references in PLATES.items():
        rows += [
            Row(f"square plate, {cells} x {cells} a quarter: {case}", value, reference, 2e-5, 6)
            for case, value, reference in zip(cases, _plate(cells), references)
        ]
    rows += [
        Row(
            f"shell with directors, {cells} x {cells} a quarter: clamped, q",
            _in_shell(cells),
            PLATES[cells][1],
            2e-5,
            6,
        )
        for cells in (4, 8)
    ]
    rows.append(Row("square on three corners: w D / (P L^2)", _twisted(), 1.0 / 1.4, 1e-9, 9))
    for what, clamped, even, exact in (
        ("clamped disc, q: w D / (q a^4)", True, True, 1.0 / 64.0),
        ("supported disc, q: w D / (q a^4)", False, True, 0.063702),
        ("clamped disc, P: w D / (P a^2)", True, False, 1.0 / (16.0 * np.pi)),
    ):
        rows.append(Row(what, _disc_plate(clamped, even), exact, 0.005))
    for cells in (20, 40, 80):
        energy, moment = _rolled(cells)
        exact = 0.1 * (2.0 * np.pi) ** 2
        asked = 0.002 if cells == 80 else None
        rows += [
            Row(f"strip bent to a full circle, {cells} cells: energy", energy, exact, asked),
            Row(f"strip bent to a full circle, {cells} cells: end moment", moment, 0.2 * 2.0 * np.pi, asked),
        ]
    return section(
        "8. Bending: the discrete Kirchhoff triangle",
        f"""nu = 0.3, flexural rigidity D; deflections of the centre. The plates are the element by
        itself, the discs the shell under small loads. The strip (nu = 0, width 0.2 L) is rolled up to a
        closed circle, which is large rotation; its error falls by four when the cells are halved. In an
        irregular patch of constant curvature the largest residual is {_patch():.0e}.""",
        rows,
    )


def wrinkled_beam() -> Section:
    """Section 9: Stein and Hedgepeth."""
    rows = []
    y = np.linspace(-0.5, 0.5, 20001)
    for kappa in (0.4, 1.0, 2.0, 9.0):
        force = 1.0 / (2.0 * kappa)
        middle = force if kappa <= 1.0 else np.sqrt(2.0 * force) - 0.5
        strain = np.column_stack([middle + y, -0.3 * np.abs(middle + y), np.zeros_like(y)])
        stress = tension_field(strain, 0.3).stress[:, 0]
        moment = 2.0 * float(0.5 * (stress[1:] * y[1:] + stress[:-1] * y[:-1]) @ np.diff(y)) / force
        exact = kappa / 3.0 if kappa <= 1.0 else 1.0 - 2.0 / (3.0 * np.sqrt(kappa))
        rows.append(Row(f"the law, kappa^ = {kappa:g}: 2 M / (P h)", moment, exact, 1e-3))
        if kappa > 1.0:
            slack = float(np.mean(stress == 0.0))
            rows.append(
                Row(f"the law, kappa^ = {kappa:g}: slack part of the height", slack, 1.5 * exact - 0.5, 2e-3)
            )
    force, moment = _beam()
    rows += [
        Row("a strip of film, kappa^ = 4: P", force, 1.0, 0.02),
        Row("a strip of film, kappa^ = 4: 2 M / (P h)", moment, 1.0 - 2.0 / 3.0 / 2.0, 0.02),
    ]
    return section(
        "9. Wrinkled beam (Stein and Hedgepeth)",
        """Strip of height h under tension P and moment M; kappa^ = E t h^2 kappa / (2 P). The law is
        integrated over the height; the strip is 24 x 16 cells whose ends turn while the film between them
        finds its shape.""",
        rows,
    )


def _assembled(points: Floats, triangles: Ints) -> Floats:
    stiffness = np.zeros((3 * len(points), 3 * len(points)))
    for corners, element in zip(triangles, dkt.plate_stiffness(points[triangles], 0.3)):
        unknowns = (3 * corners[:, None] + np.arange(3)).ravel()
        stiffness[np.ix_(unknowns, unknowns)] += element
    return stiffness


def _solved(stiffness: Floats, load: Floats, fixed: Bools) -> Floats:
    force = np.zeros(fixed.shape)
    force[:, 0] = load
    free = np.flatnonzero(~fixed.ravel())
    result = np.zeros(fixed.size)
    result[free] = np.linalg.solve(stiffness[np.ix_(free, free)], force.ravel()[free])
    return result.reshape(-1, 3)


def _plate(cells: int) -> list[float]:
    points, triangles = quarter_grid(cells)
    stiffness = _assembled(points, triangles)
    x, y = points.T
    supported = np.zeros((len(points), 3), dtype=bool)  # w, w,y and -w,x
    supported[:, 0] = (x == 0.5) | (y == 0.5)
    supported[:, 1] = (y == 0.0) | (x == 0.5)
    supported[:, 2] = (x == 0.0) | (y == 0.5)
    clamped = supported | ((x == 0.5) | (y == 0.5))[:, None]
    even = vertex_areas(points, triangles)
    centre = np.where((x == 0.0) & (y == 0.0), 0.25, 0.0)
    return [
        float(_solved(stiffness, load, rim)[0, 0]) for load in (even, centre) for rim in (supported, clamped)
    ]


def _irregular() -> tuple[Floats, Ints]:
    points, triangles = full_grid(2)
    inner = np.abs(points).max(axis=1) < 0.49
    shift = np.random.default_rng(3).uniform(-0.07, 0.07, points.shape)
    return np.where(inner[:, None], points + shift, points), triangles


def _patch() -> float:
    """Largest residual inside an irregular patch of constant curvature."""
    points, triangles = _irregular()
    x, y = points.T
    state = np.column_stack([0.5 * x**2 - y**2 + 0.7 * x * y, -2.0 * y + 0.7 * x, -x - 0.7 * y])
    residual = (_assembled(points, triangles) @ state.ravel()).reshape(-1, 3)
    return float(np.abs(residual[np.abs(points).max(axis=1) < 0.49]).max())


def _twisted() -> float:
    points, triangles = _irregular()
    corners = [nearest(points, *corner) for corner in ((-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5))]
    fixed = np.zeros((len(points), 3), dtype=bool)
    fixed[corners[:3], 0] = True
    load = np.zeros(len(points))
    load[corners[3]] = 1.0
    return float(_solved(_assembled(points, triangles), load, fixed)[corners[3], 0])


def _deflection(points: Floats, triangles: Ints, fixed: Bools, load: Floats, at: int) -> float:
    """Of the shell under small loads, per load; E t = D = 1."""
    loads = np.zeros((len(points), 3))
    loads[:, 2] = 1e-5 * load
    problem = FilmProblem(points, triangles, fixed, 1.0, 0.3, 1.0, 0.0, loads)
    state = c_interface.solve(problem, Start(*flat_state(points), (1.0,)), NewtonSettings(1e-12))
    return float(state.positions[at, 2]) / 1e-5


def _in_shell(cells: int) -> float:
    points, triangles = full_grid(cells)
    fixed = held(len(points), moves="xy")
    fixed[np.abs(points).max(axis=1) == 0.5] = True
    return _deflection(points, triangles, fixed, vertex_areas(points, triangles), nearest(points, 0.0, 0.0))


def _disc_plate(clamped: bool, even: bool) -> float:
    disc = panel("disc", 400)
    points = disc.rest_positions
    fixed = held(len(points), moves="xy")
    fixed[disc.loops[0], 2] = True
    fixed[disc.loops[0], 3:] = clamped
    centre = nearest(points, 0.0, 0.0)
    load = vertex_areas(points, disc.triangles) if even else np.eye(len(points))[centre]
    return _deflection(points, disc.triangles, fixed, load, centre)


def _rolled(cells: int) -> tuple[float, float]:
    """Bending energy and end moment of a strip of length 1 and width 0.2 rolled up, D = 1, nu = 0."""
    points, triangles = grid(cells, 2, 1.0, 0.2)
    turn = 2.0 * np.pi * points[:, 0]
    rolled = np.column_stack([np.sin(turn), 2.0 * np.pi * points[:, 1], 1.0 - np.cos(turn)]) / (2.0 * np.pi)
    normals = np.column_stack([-np.sin(turn), np.zeros_like(turn), np.cos(turn)])
    fixed = held(len(points), moves="xyz")
    fixed[(points[:, 0] == 0.0) | (points[:, 0] == 1.0), 3:] = True
    problem = FilmProblem(points, triangles, fixed, 1.0, 0.0, 1.0, 0.0)
    state = newton.solve(problem, Start(rolled, normals, (1.0,)), NewtonSettings(1e-12))
    frames = tangent_frames(state.directors)
    free = FilmProblem(points, triangles, held(len(points), moves="xyz"), 1.0, 0.0, 1.0, 0.0)
    slope = Shell(free).derivatives(state.positions, state.directors, frames)[0].reshape(-1, 2)
    end = points[:, 0] == 1.0
    moment = np.einsum("nij,nj->ni", frames[end], slope[end])[:, 0].sum()
    return newton.energies(problem, state.positions, state.directors).bending, -float(moment)


def _beam() -> tuple[float, float]:
    """Tension of a bent strip, in units of the expected one, and 2 M / (P h)."""
    points, triangles = grid(24, 16, 1.5, 1.0)
    points = points - (0.75, 0.5)
    x, y = points.T
    curvature, kappa = 1e-4, 4.0
    force = curvature / (2.0 * kappa)
    strain = np.sqrt(2.0 * force * curvature) - 0.5 * curvature
    ends = np.abs(x) == 0.75
    fixed = held(len(points), moves="z", turns=True)
    fixed[ends] = True
    start, directors = flat_state(points)
    start[:, 0] += strain * x + curvature * x * y
    start[:, 1] -= 0.5 * curvature * x**2
    problem = FilmProblem(points, triangles, fixed, 1.0, 0.0, 1e-12, 0.0)
    state = newton.solve(problem, Start(start, directors, (1.0,)), NewtonSettings(1e-9))
    free = FilmProblem(points, triangles, held(len(points)), 1.0, 0.0, 1e-12, 0.0)
    pull = Shell(free).derivatives(state.positions, state.directors, tangent_frames(state.directors))[0]
    right = x == 0.75
    along = pull.reshape(-1, 5)[right, 0]
    return float(along.sum()) / force, 2.0 * float(along @ y[right]) / float(along.sum())
