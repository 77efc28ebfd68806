# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed bodies divided into panels, laid flat, corrected, as they are cut, against the bodies."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import solids
from divided import gored_ball
from validation import figures
from validation.report import Row, Section, paragraphs, section, table

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.flattening.divide_flat import divide_flat
from BalloonWorkbench.core.target_design.fit_target import fit_target, inflate_target
from BalloonWorkbench.core.target_design.off_target import TargetSurface
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.types import Floats, Ints

_SAID = """
    Where pressure works against a flat place, no pattern holds it: film is at rest only where its tensions
    times its curvatures are the pressure, so the faces of the rounded cube and the flanks of the cow bulge
    wherever the seams are. There the correction shares the error between what lies outside and what lies
    inside, and more panels bring little. Gores are nearly right as they are laid flat, so that the correction
    gains less there; their error falls with the square of their number.

    In what could be read of published work no distances from a target are stated that could be set beside
    these: Skouras, Thomaszewski, Kaufmann, Garg, Bickel, Grinspun and Gross, Designing Inflatable Structures
    (ACM Transactions on Graphics 33 (4), 2014), which corrects panels between seams that a user has drawn;
    Furuta, Umetani, Mitani, Igarashi and Fukui, A Film Balloon Design System Integrated with Shell Element
    Simulation (Eurographics 2010), which inflates a pattern while it is drawn.
"""
_PRESSURE = 1000.0  # Pa
_MESHES = Path(__file__).resolve().parents[2] / "tests" / "resources" / "meshes"
_BODIES: tuple[tuple[str, Callable[[], Target], tuple[int, ...]], ...] = (
    ("spheroid 1 : 1 : 2", lambda: solids.ball((1.0, 1.0, 2.0)), (6, 12, 24)),
    ("egg", solids.egg, (8, 16)),
    ("pear", solids.pear, (8, 16)),
    ("capsule", solids.capsule, (8, 16)),
    ("torus", solids.torus, (8, 16)),
    ("rounded cube", solids.rounded_box, (6, 12, 24)),
    ("Spot, a cow", lambda: read_target(_MESHES / "spot.obj"), (16, 24, 60)),
    ("Blub, a fish", lambda: read_target(_MESHES / "fish.obj"), (23,)),
)
#: Mean distances that were to be reached with Spot, in parts of the diagonal.
_SPOT = {16: 0.0030, 24: 0.0025, 60: 0.0015}


#: What is shown of them, with its upper direction as the third.
_SHOWN = {
    "spheroid 1 : 1 : 2": 6,
    "pear": 8,
    "torus": 8,
    "rounded cube": 6,
    "Spot, a cow": 24,
    "Blub, a fish": 23,
}
_UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


def targets(images: Path) -> Section:
    """Bodies by formulas and two meshes, with few and many panels."""
    rows, lines, shown = [], [], []
    for count in (4, 6, 8, 12):
        plain, design, line = _line("sphere of gores", gored_ball(count))
        lines.append(line)
        rows.append(
            Row(f"sphere of {count} gores: n^2 times mean, %", 100.0 * count**2 * _mean(design), 16.0, None)
        )
    for name, make, counts in _BODIES:
        target = make()
        for count in counts:
            division = divide_flat(target, count)
            plain, design, line = _line(name, division)
            lines.append(line)
            if _SHOWN.get(name) == count:
                surface = TargetSurface(division.target)
                turn = _UPRIGHT if name.startswith(("Spot", "Blub")) else np.eye(3)
                shown.append(
                    (f"{name}, {count} panels", [_off(each, surface, turn) for each in (plain, design)])
                )
            if name.startswith("Spot"):
                rows.append(
                    Row(f"Spot, {count} panels: mean, %", 100.0 * _mean(design), 100.0 * _SPOT[count], None)
                )
    figures.bodies(shown, images / "validation-bodies.png")
    head = (
        "body",
        "panels",
        "flat: mean %",
        "95 %",
        "corrected: mean %",
        "95 %",
        "most %",
        "volume",
        "balloons",
        "s",
    )
    return section(
        "Bodies of panels",
        "Distance of the film from the body, by area, in parts of the diagonal of its box: of panels as they"
        " are laid flat, and corrected, of the pattern meshed anew; the volume beside the body's. Spheres of"
        " gores are to come within 16 %/n^2 on average. Flat panels bulge between their seams, and sharp"
        " bodies of few panels stay far. Polyester film of 25 µm at 1 kPa.",
        rows,
        table(head, lines)
        + "\n![Balloons of panels laid flat, above, and corrected, below, in the colours of their distance"
        " from the body](images/validation-bodies.png)\n\n" + paragraphs(_SAID),
    )


def _off(design: BagDesign, surface: TargetSurface, turn: Floats) -> tuple[Floats, Ints, Floats]:
    """Points, triangles and distances [%] of a balloon, upright."""
    points = design.inflation.positions
    off = 100.0 * surface.off(points).distances / design.size
    return points @ turn, design.meshed.assembly.surface.triangles, off


def _mean(design: BagDesign) -> float:
    assert design.residual is not None
    return design.residual.mean / design.size


def _line(name: str, division: Division) -> tuple[BagDesign, BagDesign, tuple[str, ...]]:
    mylar = film("mylar")
    plain = inflate_target(division, mylar, _PRESSURE)
    began = time.process_time()
    design = fit_target(division, mylar, _PRESSURE)
    seconds = time.process_time() - began
    assert plain.residual is not None
    assert design.residual is not None
    shares = (
        plain.residual.mean,
        plain.residual.p95,
        design.residual.mean,
        design.residual.p95,
        design.residual.max,
    )
    return (
        plain,
        design,
        (
            name,
            str(len(division.names)),
            *(f"{100.0 * share / design.size:.3f}" for share in shares),
            f"{design.inflation.volume / division.target.volume:.4f}",
            str(design.passes),
            f"{seconds:.1f}",
        ),
    )
