# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a panel of a bag is a flat piece of film that can be cut: one loop round an area, holes inside."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.bags.bag import BagPanel
from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.geometry.crossings import first_crossing, inside
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.polyline import edge_lengths, extent, perimeter, signed_area
from BalloonWorkbench.core.mesh.thickness import thickness
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.units import length_text, place_text

#: Edges shorter than this part of the panel are points, and panels narrower than it are lines.
_HAIR = 1e-6
#: Nobody makes larger panels [m]; beyond, rounding would count.
_FARTHEST = 1e4
#: Samples of the rim for its thickness, for each seal width, and at most.
_PER_SEAL, _MOST_SAMPLES = 2.0, 4000


def edge_name(panel: BagPanel, loop: int, edge: int) -> str:
    """Of an edge, for people, who count from 1: edge 1 runs from point 0 to point 1."""
    hole = f"hole {loop} of " if loop else ""
    return f"edge {edge + 1} of {hole}panel '{panel.name}'"


def check_panel(panel: BagPanel) -> None:
    """Raises AssemblyError, which names the panel and the edge."""
    for loop, points in enumerate(panel.loops):
        what = f"Hole {loop} of panel '{panel.name}'" if loop else f"Panel '{panel.name}'"
        if points.ndim != 2 or points.shape[1] != 2 or len(points) < 3:
            raise AssemblyError(f"{what} has fewer than three points. Give all of its corners.")
        if not (np.abs(points) < _FARTHEST).all():
            raise AssemblyError(
                f"{what} has a point that is no number or farther away than {length_text(_FARTHEST)}."
                " Check its coordinates and the unit."
            )
        size = extent(points)
        lengths = edge_lengths(points)
        short = int(np.argmin(lengths))
        if not lengths[short] > _HAIR * size:
            name = edge_name(panel, loop, short)
            raise AssemblyError(f"{name[0].upper()}{name[1:]} has no length. Take one of its points out.")
        if np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[1] < _HAIR * size:
            raise AssemblyError(
                f"{what} has no area: all of its points lie on a line. Check its coordinates."
            )
    place = first_crossing(panel.loops)
    if place is not None:
        edge = int(nearest_on_loops(panel.loops, place[None]).edge[0])
        loop = 0
        while edge >= len(panel.loops[loop]):
            edge -= len(panel.loops[loop])
            loop += 1
        raise AssemblyError(
            f"Panel '{panel.name}' is folded over: {edge_name(panel, loop, edge)} crosses or touches another"
            f" edge at {place_text(place)}. Separate them."
        )
    _check_senses(panel)


def _check_senses(panel: BagPanel) -> None:
    """Loops that do not cross run the right way round, holes inside the outer one and not in each other."""
    if signed_area(panel.outer) < 0.0:
        raise AssemblyError(
            f"Panel '{panel.name}' is seen from inside: its points run clockwise. Mirror it, or turn their"
            " order round."
        )
    for number, hole in enumerate(panel.holes, start=1):
        if signed_area(hole) > 0.0:
            raise AssemblyError(
                f"Hole {number} of panel '{panel.name}' runs counter-clockwise. Turn the order of its points"
                " round."
            )
        others = [other for other in panel.holes if other is not hole]
        if not inside([panel.outer], hole[:1])[0] or (others and inside(others, hole[:1])[0]):
            raise AssemblyError(
                f"Hole {number} of panel '{panel.name}' lies outside its film. Move it, or take it out."
            )


def check_thickness(panel: BagPanel, seal_width: float) -> None:
    """Raises AssemblyError for a panel that is too narrow for welds so wide [m] along both of its sides."""
    outline = Outline(panel.outer, panel.holes)
    around = sum(map(perimeter, panel.loops))
    mean = 2.0 * outline.area / around  # the width of a strip, half of that of a disc or a square
    spacing = max(min(seal_width / _PER_SEAL, mean), around / _MOST_SAMPLES)
    narrowest, place = thickness(outline, 2.2 * seal_width, spacing).thinnest
    if 2.0 * mean < min(narrowest, 2.0 * seal_width):  # it is no strip
        narrowest, place = 2.0 * mean, panel.outer[0]
    if narrowest < 2.0 * seal_width:
        edge = int(nearest_on_loops([panel.outer], place[None]).edge[0])
        raise AssemblyError(
            f"Panel '{panel.name}' is only {length_text(narrowest, 2)} wide at {edge_name(panel, 0, edge)},"
            f" too narrow for welds of {length_text(seal_width)} along both of its sides. Make it wider, or"
            " the welds narrower."
        )
