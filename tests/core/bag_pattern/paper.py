# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of cut files that knows nothing of the program: panels, edges between marks, numbers beside them.

What it knows is what is told to people who make the balloon: the weld's inner edge is half a seal width
inside its middle; a line across the weld tells where a seam ends; the number stands on the film, to be read
with the seam below, and the arrow behind it runs along the seam.
"""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import Any

import ezdxf
import numpy as np
import shapely

#: What digits look like: crossings of a grid of 3 columns and 5 rows that their lines go through.
DIGITS = {
    "111 101 101 101 111": "0",
    "010 110 010 010 010": "1",
    "111 001 111 100 111": "2",
    "111 001 011 001 111": "3",
    "100 110 110 111 010": "4",
    "111 100 111 001 111": "5",
    "111 100 111 101 111": "6",
    "111 101 111 101 111": "8",
    "111 101 111 001 111": "9",
}
NEAR = 0.05  # mm


@dataclass
class Edge:
    """A side of a seam: panel, number of the seam, length [mm], whether the seam runs along the loop."""

    panel: int
    number: int
    length: float
    along: bool


@dataclass
class Sheet:
    """What was read: areas of the panels' free film [mm2], and their edges."""

    areas: list[float]
    edges: list[Edge]


def read(content: bytes, seal_width: float, middles: np.ndarray) -> Sheet:
    """The panels of a DXF, in the order of the middles (n, 2) mm of what is cut; seal_width [mm].

    In a file they follow each other as the way of the tool is short.
    """
    document = ezdxf.read(io.StringIO(content.decode()))
    lines: dict[str, list[tuple[np.ndarray, bool]]] = {}
    for entity in document.modelspace().query("LWPOLYLINE"):
        points = np.array([(x, y) for x, y, *_ in entity.get_points("xy")])
        lines.setdefault(entity.dxf.layer, []).append((points, bool(entity.closed)))
    sheet = Sheet([], [])
    cuts = [cut for cut, _ in lines["CUT"]]
    found = np.array([0.5 * (cut.min(axis=0) + cut.max(axis=0)) for cut in cuts])
    order = [int(np.argmin(np.linalg.norm(found - middle, axis=1))) for middle in middles]
    assert sorted(order) == list(range(len(cuts)))
    for cut in (cuts[number] for number in order):
        film = shapely.Polygon(cut)
        seals = [
            points for points, closed in lines["SEAL"] if closed and film.contains(shapely.Point(points[0]))
        ]
        if not seals:
            continue  # a cap
        drawn = [points for points, _ in lines["PEN"] if film.contains(shapely.Point(points[0]))]
        loops = inner_edges(seals, seal_width)
        sheet.areas.append(signed_area(loops[0]) + sum(map(signed_area, loops[1:])))
        sheet.edges += edges(len(sheet.areas) - 1, loops, drawn)
    return sheet


def signed_area(loop: np.ndarray) -> float:
    x, y = loop.T
    return 0.5 * float(x @ np.roll(y, -1) - np.roll(x, -1) @ y)


def inner_edges(seals: list[np.ndarray], seal_width: float) -> list[np.ndarray]:
    """The loops where the film becomes free: the outer one counter-clockwise, then holes clockwise."""
    areas = sorted((shapely.Polygon(points) for points in seals), key=lambda area: -area.area)
    grown = [-0.5 * seal_width, *(0.5 * seal_width for _ in areas[1:])]
    loops = []
    for k, (area, by) in enumerate(zip(areas, grown)):
        ring = area.buffer(by, join_style="mitre", mitre_limit=100.0).exterior
        points = np.array(ring.coords)[:-1]
        loops.append(points if (signed_area(points) > 0.0) == (k == 0) else points[::-1])
    return loops


def edges(panel: int, loops: list[np.ndarray], drawn: list[np.ndarray]) -> list[Edge]:
    rings = [shapely.LinearRing(loop) for loop in loops]
    ends: list[list[float]] = [[] for _ in loops]
    for line in drawn:
        for number, ring in enumerate(rings):
            if len(line) == 2 and ring.distance(shapely.Point(line[0])) < NEAR:
                ends[number].append(ring.project(shapely.Point(line[0])))
    found = []
    for shaft in arrows(drawn):
        middle = shapely.Point(shaft.mean(axis=0))
        number = int(np.argmin([ring.distance(middle) for ring in rings]))
        ring, stops = rings[number], sorted(ends[number])
        at = ring.project(middle)
        step = 0.01
        here = np.array(ring.interpolate(at).coords[0])
        ahead = np.array(ring.interpolate((at + step) % ring.length).coords[0]) - here
        ahead /= np.linalg.norm(ahead)
        before = max((stop for stop in stops if stop <= at), default=stops[-1] - ring.length)
        after = min((stop for stop in stops if stop > at), default=stops[0] + ring.length)
        along = float((shaft[1] - shaft[0]) @ ahead) > 0.0
        direction = (shaft[1] - shaft[0]) * (1.0 if along else -1.0)
        found.append(Edge(panel, digits(drawn, shaft, direction), after - before, along))
    return found


def arrows(drawn: list[np.ndarray]) -> list[np.ndarray]:
    """Lines with one head: from their tail to their head."""
    tips = [line[1] for line in drawn if len(line) == 3]

    def is_tip(point: np.ndarray) -> bool:
        return any(np.linalg.norm(point - tip) < 1e-3 for tip in tips)

    straight = [line for line in drawn if len(line) == 2]
    one_way = [line for line in straight if is_tip(line[0]) != is_tip(line[1])]
    return [line if is_tip(line[1]) else line[::-1] for line in one_way]


def digits(drawn: list[np.ndarray], shaft: np.ndarray, direction: np.ndarray) -> int:
    """The number before an arrow; direction: in which it is read, as long as the digits are high."""
    height = float(np.linalg.norm(direction))
    x = direction / height
    y = np.array([-x[1], x[0]])
    start = min(shaft, key=lambda point: float(point @ x))
    text = ""
    for place in range(6):
        corner = start - height * ((0.9 + 0.8 * place) * x + 0.5 * y)
        strokes = [np.column_stack([(line - corner) @ x, (line - corner) @ y]) / height for line in drawn]
        cell = shapely.box(-0.1, -0.1, 0.6, 1.1)
        mine = [shapely.LineString(line) for line in strokes if cell.contains(shapely.LineString(line))]
        if not mine:
            break
        text = digit(shapely.union_all(mine)) + text
    return int(text)


def digit(lines: Any) -> str:
    met = [
        "".join(
            "1" if lines.distance(shapely.Point(0.25 * column, 0.25 * row)) < 0.01 else "0"
            for column in range(3)
        )
        for row in range(4, -1, -1)
    ]
    seen = " ".join(met)
    return DIGITS.get(seen) or ("7" if seen.startswith("111") and seen.endswith("100") else seen)
