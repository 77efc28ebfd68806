# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads of film and weld on coarse and fine meshes: they decide which pressure is safe."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from drawn_shapes import NAMED, letter, oriented, star
from solver_cases import circle
from validation.report import Row, Section, paragraphs, table

from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.job import DEFAULT_PRESSURE
from BalloonWorkbench.core.making.safety import safety
from BalloonWorkbench.core.making.trade_figures import FILE
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import matplotlib_text
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

SIZES = (1500, 4000, 12000)
#: The safe pressure may change by this part from the coarsest to the finest mesh.
CHANGE = 0.1
_PICTURES = FILE.parent / "examples" / "pictures"


@dataclass(frozen=True)
class Point:
    """A balloon on a mesh: loads [N/m], safe pressure [Pa], processor time of the loads by the solve's."""

    vertices: int
    film: float
    weld: float
    safe: float
    weakest: str
    at_rest: bool
    ratio: float


def outlines() -> dict[str, Outline]:
    """Balloons of 0.3 to 0.4 m."""
    turn = np.radians(np.linspace(0.0, 270.0, 540))
    sector = np.vstack([[0.0, 0.0], 0.2 * np.column_stack([np.cos(turn), np.sin(turn)])])
    found = {
        "disc": Outline(circle(0.2)),
        "star of 5 sharp arms": star(5, 0.2, 0.04),
        "star of 12": star(12, 0.2, 0.1),
        "sector of 270 degrees": Outline(oriented(sector)),
        "ring": Outline(circle(0.2), (circle(0.1)[::-1].copy(),)),
        "square": NAMED["square"],
        "heart": NAMED["heart"],
        "round pen A": letter("A"),
        "round pen 8": letter("8"),
    }
    for text in "BKR":
        found[f"letter {text}"] = _letter(text)
    for name in ("star", "bear", "fish"):
        found[f"picture {name}"] = read_picture(_PICTURES / f"{name}.png", 0.3, None)
    return found


def _letter(text: str, height: float = 0.3) -> Outline:
    loops = [np.asarray(loop, dtype=float)[:-1] for loop in matplotlib_text()(text, 100.0)]
    loops.sort(key=lambda loop: -np.ptp(loop[:, 1]))
    low, scale = loops[0].min(axis=0), height / np.ptp(loops[0][:, 1])
    outer, *holes = (scale * (loop - low) for loop in loops)
    return Outline(oriented(outer), tuple(oriented(hole, counter_clockwise=False) for hole in holes))


def solved(outline: Outline, vertices: int) -> Point:
    """The loads of a balloon of the usual film."""
    foil = film("mylar")
    panel = triangulate(outline, size_for(outline, vertices))
    began = time.process_time()
    inflation = inflate(panel, foil, DEFAULT_PRESSURE)
    cold = time.process_time() - began
    found = safety(inflation, foil, exact=False)
    ratio = (time.process_time() - began - cold) / cold
    loads = found.film_load.value, found.weld_load.value
    safe = found.safe_pressure or 0.0
    return Point(len(panel.rest_positions), *loads, safe, found.weakest, found.at_rest, ratio)


def strength() -> Section:
    """What is safe on coarse and fine meshes."""
    cells, rows = [], []
    for name, outline in outlines().items():
        points = [solved(outline, vertices) for vertices in SIZES]
        cells += [
            (
                name,
                str(point.vertices),
                f"{point.film:.0f}",
                f"{point.weld:.0f}",
                f"{point.safe:.0f}, {point.weakest}",
                "yes" if point.at_rest else "**no**",
                f"{point.ratio:.1f}",
            )
            for point in points
        ]
        rows.append(Row(f"{name}, coarse by fine", points[0].safe, points[-1].safe, CHANGE, 4))
    met = sum(row.met for row in rows)
    text = paragraphs(
        f"""Loads per width of flat film at {DEFAULT_PRESSURE:g} Pa, averaged over two seal widths, and the
        pressure at which a margin is left. From {SIZES[0]} to {SIZES[-1]} vertices it shall change by at most
        {100 * CHANGE:g} %: so it does for {met} of {len(rows)}. The last column is the processor time of the
        loads, with the solve that brings the film fully to rest, by that of the inflation."""
    )
    head = ("", "vertices", "film N/m", "weld N/m", "safe to Pa", "at rest", "time")
    return Section("Strength", text + "\n" + table(head, cells), tuple(rows))
