# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error against mesh size, work against mesh size, and what halving the mesh size changes."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from drawn_shapes import NAMED
from solver_cases import PRESSURE, SHAPES, film
from validation import figures
from validation.axisymmetric import profile
from validation.balloons import RING_BAND
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import film as library_film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.types import Floats

SIZES = (400, 800, 1500, 3000, 6000, 12000)
#: Halving the mesh size may change the volume and the Newton steps by these parts.
VOLUME_CHANGE, STEP_CHANGE = 0.003, 0.3


@dataclass(frozen=True)
class Case:
    """A balloon, and its exact volume where that is known [m3]."""

    name: str
    outline: Outline
    film: Film
    pressure: float
    exact: float | None = None


@dataclass(frozen=True)
class Point:
    """A solve: size is the length of an edge of an even mesh relative to that of the panel."""

    vertices: int
    size: float
    volume: float
    steps: int
    factorisations: int
    seconds: float
    converged: bool


def references() -> list[Case]:
    """The balloons of the convergence study."""
    return [
        Case("disc, k = 500", SHAPES["disc"], film(500), PRESSURE, profile(500).volume),
        Case(
            "disc, k = 500, with band",
            SHAPES["disc"],
            film(500, seal_width=0.02),
            PRESSURE,
            profile(500).volume,
        ),
        Case("square, k = 1000", SHAPES["square"], film(1000), PRESSURE, 0.202864),
        Case(
            "ring, k = 10000, with band",
            SHAPES["ring"],
            film(10000, seal_width=RING_BAND),
            PRESSURE,
            profile(10000, 0.5).volume,
        ),
    ]


def everyday() -> list[Case]:
    """Balloons of 0.3 m from the library's film."""
    mylar = library_film("mylar")
    return [
        Case(f"{name}, mylar", NAMED[name], mylar, 2000.0)
        for name in ("disc", "square", "ring", "heart", "star")
    ]


def solved(case: Case, edge: float) -> Point:
    """One solve on a mesh of this edge length [m]."""
    panel = triangulate(case.outline, edge)
    began = time.process_time()
    found = inflate(panel, case.film, case.pressure, backend="native")
    seconds = time.process_time() - began
    report = found.report
    even = float(np.sqrt(4.0 / np.sqrt(3.0) * case.outline.area / len(panel.triangles)))
    return Point(
        len(panel.rest_positions),
        even / max(case.outline.size),
        found.volume,
        report.newton_steps,
        report.factorisations,
        seconds,
        report.converged,
    )


def begin_full_design(cases: list[Case]) -> dict[str, list[Point]]:
    """Every case on every size."""
    return {case.name: [solved(case, size_for(case.outline, count)) for count in SIZES] for case in cases}


def order(sizes: Floats, errors: Floats) -> float:
    """Exponent of the error in the mesh size."""
    return float(np.polyfit(np.log(sizes), np.log(np.abs(errors)), 1)[0])


def convergence(images: Path) -> tuple[Section, Section]:
    """The two sections and their figures."""
    known, plain = references(), everyday()
    found = begin_full_design([*known, *plain])
    return _errors(known, found, images), _work(found, images)


def _errors(cases: list[Case], found: dict[str, list[Point]], images: Path) -> Section:
    curves, orders, rows = {}, [], []
    for case in cases:
        points = found[case.name]
        sizes = np.array([point.size for point in points])
        errors = np.array([point.volume for point in points]) / (case.exact or 1.0) - 1.0
        curves[case.name] = (sizes, np.abs(errors))
        orders.append(
            (case.name, f"{case.exact:.6f}", f"{100 * errors[-1]:+.3f} %", f"{order(sizes, errors):.2f}")
        )
        for point, error in zip(points, errors):
            rows.append(
                (
                    case.name,
                    str(point.vertices),
                    f"{point.size:.4f}",
                    f"{point.volume:.6f}",
                    f"{100 * error:+.3f} %",
                    _steps(point),
                    f"{point.seconds:.2f}",
                )
            )
    figures.convergence(curves, images / "validation-convergence.svg")
    text = paragraphs(
        """Error of the volume against the mesh size h (edge of an even mesh, in units of the panel's
        size). The exact values of disc and ring are those of the axisymmetric profile at the same k; that
        of the square is extrapolated, with an uncertainty of 0.15 %. The order is the slope of a straight
        line through all sizes in the logarithms."""
    )
    text += "\n![Error against mesh size](images/validation-convergence.svg)\n\n"
    text += table(("", "exact V", "error on the finest mesh", "order"), orders)
    text += "\n" + table(
        ("", "vertices", "h", "V", "error", "Newton steps (factorisations)", "processor seconds"), rows
    )
    return Section("Convergence with the mesh", text)


def _work(found: dict[str, list[Point]], images: Path) -> Section:
    figures.work(
        {
            name: (
                np.array([point.vertices for point in points]),
                np.array([point.steps for point in points]),
                np.array([point.factorisations for point in points]),
            )
            for name, points in found.items()
        },
        images / "validation-steps.svg",
    )
    rows = [(name, *(_steps(point) for point in points)) for name, points in found.items()]
    text = paragraphs(
        "Newton steps of a cold inflation, and factorisations in brackets, at about so many vertices."
    )
    text += "\n![Newton steps against mesh size](images/validation-steps.svg)\n\n"
    return Section("Work against the mesh", text + table(("", *(str(size) for size in SIZES)), rows))


def _steps(point: Point) -> str:
    mark = "" if point.converged else ", not converged"
    return f"{point.steps} ({point.factorisations}{mark})"


def independence() -> Section:
    """What halving the mesh size changes, from 1 500 and from 3 000 vertices on."""
    rows, met = [], 0
    cases = [*references(), *everyday()]
    for case in cases:
        for count in (1500, 3000):
            edge = size_for(case.outline, count)
            coarse, fine = solved(case, edge), solved(case, 0.5 * edge)
            volume, steps = fine.volume / coarse.volume - 1.0, fine.steps / coarse.steps - 1.0
            good = abs(volume) < VOLUME_CHANGE and abs(steps) < STEP_CHANGE
            met += good
            rows.append(
                (
                    case.name,
                    f"{coarse.vertices} to {fine.vertices}",
                    f"{100 * volume:+.3f} %",
                    f"{coarse.steps} to {fine.steps} ({100 * steps:+.0f} %)",
                    "yes" if good else "**no**",
                )
            )
    text = paragraphs(
        f"""Halving the mesh size shall change V by less than {100 * VOLUME_CHANGE:g} % and the Newton
        steps by less than {100 * STEP_CHANGE:g} %: {met} of {len(rows)} do. The star's volume has no limit:
        the film pulls at a perfectly sharp notch with a force in one point, and an elastic film gives way to
        that without end, as the logarithm of the mesh size."""
    )
    return Section(
        "Independence of the mesh", text + "\n" + table(("", "vertices", "V", "Newton steps", "within"), rows)
    )
