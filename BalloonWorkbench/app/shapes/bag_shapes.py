# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags of a document: their panels side by side as FreeCAD's faces, and kept exactly as text."""

from __future__ import annotations

import json
from dataclasses import asdict

import FreeCAD as App
import numpy as np
import Part

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Opening, Side
from BalloonWorkbench.core.units import to_mm

_GAP = 0.06  # between panels, of the larger side of the largest one
_GRID = 1e-9  # m, of points that are kept


def text_of(bag: Bag) -> str:
    """A bag as text, in metres on the grid of the engine."""
    panels = [
        {
            "name": panel.name,
            "cut": panel.cut,
            "loops": [(np.round(loop / _GRID) * _GRID + 0.0).round(9).tolist() for loop in panel.loops],
        }
        for panel in bag.panels
    ]
    others = {name: value for name, value in asdict(bag).items() if name != "panels"}
    return json.dumps({"panels": panels, **others}, ensure_ascii=False)


def bag_from(text: str) -> Bag:
    """The bag of a text by `text_of`."""
    data = json.loads(text)
    panels = []
    for panel in data["panels"]:
        outer, *holes = (np.array(loop) for loop in panel["loops"])
        panels.append(BagPanel(panel["name"], outer, tuple(holes), panel["cut"]))
    return Bag(
        tuple(panels),
        tuple(BagSeam(Side(**seam["a"]), Side(**seam["b"])) for seam in data["seams"]),
        None if data["opening"] is None else Opening(**data["opening"]),
        data["ease"],
        tuple(data["notes"]),
    )


def panel_places(bag: Bag) -> list[np.ndarray]:
    """Where each panel is moved to so that all lie side by side below y = 0: (2,) m each.

    In rows, all of them about as wide as high.
    """
    corners = [panel.outer.min(axis=0) for panel in bag.panels]
    sizes = np.array([np.ptp(panel.outer, axis=0) for panel in bag.panels])
    gap = _GAP * float(sizes.max())
    row = max(1.2 * float(np.sqrt(np.prod(sizes + gap, axis=1).sum())), float(sizes[:, 0].max()))
    places, at, low, high = [], 0.0, -gap, 0.0
    for corner, (width, height) in zip(corners, sizes.tolist(), strict=True):
        if at and at + width > row:
            at, low, high = 0.0, low - high - gap, 0.0
        places.append(np.array([at, low - height]) - corner)
        at, high = at + width + gap, max(high, height)
    return places


def panel_shape(bag: Bag):
    """All panels side by side as faces; an edge for each edge of their loops."""
    from BalloonWorkbench.app.shapes.part_shapes import wire

    places = panel_places(bag)
    return Part.Compound(
        [
            Part.Face([wire(loop + place) for loop in panel.loops])
            for panel, place in zip(bag.panels, places, strict=True)
        ]
    )


def edge_names(bag: Bag, shape, names: dict[tuple[int, int, int], str]) -> list[str]:
    """What each edge of the shape is called.

    names  by panel, loop and the number of the point at which an edge of the loop begins
    """
    places: list[np.ndarray] = []
    known: list[str] = []
    for number, (panel, place) in enumerate(zip(bag.panels, panel_places(bag), strict=True)):
        for k, loop in enumerate(panel.loops):
            places.append(to_mm(0.5 * (loop + np.roll(loop, -1, axis=0)) + place))
            known += [names[number, k, at] for at in range(len(loop))]
    middles = np.concatenate(places)
    ends = ((edge.firstVertex().Point, edge.lastVertex().Point) for edge in shape.Edges)
    at = ((0.5 * (a.x + b.x), 0.5 * (a.y + b.y)) for a, b in ends)
    return [known[int(((middles - place) ** 2).sum(axis=1).argmin())] for place in at]


def moved_beside(positions: np.ndarray, gap: float) -> np.ndarray:
    """The shift (3,) m that brings a balloon behind the flat panels of its bag: above y = 0, on z = 0."""
    low = positions.min(axis=0)
    return np.array([-low[0], gap - low[1], -low[2]])


def vectors_of(points) -> list:
    """Points (n, 3) in m as vectors in mm."""
    return [App.Vector(*point) for point in to_mm(np.asarray(points, dtype=float)).tolist()]
