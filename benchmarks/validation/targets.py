# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed bodies divided into panels, laid flat, corrected, as they are cut, against the bodies."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import solids
from divided import gored_ball
from validation.report import Row, Section, section, table

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.target_design.fit_target import fit_target, inflate_target
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Division, Target

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


def targets() -> Section:
    """Bodies by formulas and two meshes, with few and many panels."""
    rows, lines = [], []
    for count in (4, 6, 8, 12):
        design, line = _line("sphere of gores", gored_ball(count))
        lines.append(line)
        rows.append(
            Row(f"sphere of {count} gores: n^2 times mean, %", 100.0 * count**2 * _mean(design), 16.0, None)
        )
    for name, make, counts in _BODIES:
        target = make()
        for count in counts:
            design, line = _line(name, divide(target, count))
            lines.append(line)
            if name.startswith("Spot"):
                rows.append(
                    Row(f"Spot, {count} panels: mean, %", 100.0 * _mean(design), 100.0 * _SPOT[count], None)
                )
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
        table(head, lines),
    )


def _mean(design: BagDesign) -> float:
    assert design.residual is not None
    return design.residual.mean / design.size


def _line(name: str, division: Division) -> tuple[BagDesign, tuple[str, ...]]:
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
    return design, (
        name,
        str(len(division.names)),
        *(f"{100.0 * share / design.size:.3f}" for share in shares),
        f"{design.inflation.volume / division.target.volume:.4f}",
        str(design.passes),
        f"{seconds:.1f}",
    )
