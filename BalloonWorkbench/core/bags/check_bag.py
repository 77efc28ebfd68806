# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a bag can be made: each edge in one seam, equal sides, one body, an opening."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag, BagPanel, BagSeam, Side
from BalloonWorkbench.core.bags.check_panel import check_panel, check_thickness, edge_name
from BalloonWorkbench.core.bags.topology import Topology
from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.geometry.polyline import edge_lengths
from BalloonWorkbench.core.panels.surface import EASE, RELATIVE_EASE
from BalloonWorkbench.core.units import length_text

#: More are surely not sewn by anybody, and would take minutes.
MOST_PANELS, MOST_POINTS = 1000, 50_000


def check_bag(bag: Bag, seal_width: float = 0.0, *, opening_needed: bool = False) -> None:
    """Raises AssemblyError with one sentence, which names panels and edges, for a bag that cannot be made.

    seal_width      [m] no panel may be narrower than two of them; 0 does not ask
    opening_needed  whether a bag that cannot be filled is refused
    """
    _check_count(bag)
    known: set[tuple[bytes, ...]] = set()
    for panel in bag.panels:
        shape = tuple(loop.tobytes() for loop in panel.loops)
        if shape not in known:
            check_panel(panel)
            if seal_width > 0.0 and panel.cut:
                check_thickness(panel, seal_width)
        known.add(shape)
    for number, seam in enumerate(bag.seams, start=1):
        _check_points(bag, seam, number)
    for number, seam in enumerate(bag.seams, start=1):
        _check_direction(bag, seam, number)
    _check_edges(bag)
    for number, seam in enumerate(bag.seams, start=1):
        _check_lengths(bag, seam, number)
    _check_bodies(bag)
    _check_opening(bag, opening_needed=opening_needed)


def _check_count(bag: Bag) -> None:
    if not bag.panels:
        raise AssemblyError("There is no panel. Give at least one.")
    if len(bag.panels) > MOST_PANELS:
        raise AssemblyError(
            f"The bag has {len(bag.panels)} panels, more than {MOST_PANELS}. Make it of fewer, larger ones."
        )
    points = sum(len(loop) for panel in bag.panels for loop in panel.loops)
    if points > MOST_POINTS:
        raise AssemblyError(
            f"The panels have {points} points, more than {MOST_POINTS}. Simplify them in the program that"
            " they come from."
        )


def _check_points(bag: Bag, seam: BagSeam, number: int) -> None:
    """Both sides are on panels, loops and points that are there."""
    for side in seam.sides:
        if not 0 <= side.panel < len(bag.panels):
            raise AssemblyError(
                f"Seam {number} is on panel {side.panel + 1}, but there are {len(bag.panels)}. Check its"
                " sides."
            )
        panel = bag.panels[side.panel]
        if not 0 <= side.loop < len(panel.loops):
            raise AssemblyError(
                f"Seam {number} is on hole {side.loop} of panel '{panel.name}', which has"
                f" {len(panel.holes)}. Check its sides."
            )
        count = len(panel.loops[side.loop])
        for point in (side.start, side.end):
            if not 0 <= point < count:
                raise AssemblyError(
                    f"Seam {number} is on point {point} of panel '{panel.name}', whose points there are 0 to"
                    f" {count - 1}. Check its sides."
                )
    if all(side.start == side.end for side in seam.sides):
        edge = edge_name(bag.panels[seam.a.panel], seam.a.loop, seam.a.start)
        raise AssemblyError(
            f"Seam {number} has no length: it begins and ends where {edge} begins. Give two points; a whole"
            " loop is written as two seams."
        )


def _lengths(bag: Bag, seam: BagSeam) -> tuple[float, float]:
    return _side_length(bag, seam.a, against=False), _side_length(bag, seam.b, against=True)


def _side_length(bag: Bag, side: Side, *, against: bool) -> float:
    lengths = edge_lengths(bag.panels[side.panel].loops[side.loop])
    return float(lengths[list(_edges(bag, side, against=against))].sum())


def _edges(bag: Bag, side: Side, *, against: bool) -> Iterator[int]:
    """Numbers of the edges of a side, in its direction; an edge is named by the point at which it begins."""
    points = side.points(bag.panels, against=against)
    yield from (points[1:] if against else points[:-1]).tolist()


def _allowed(bag: Bag, seam: BagSeam, one: float, other: float) -> float:
    """How far the lengths of both sides may differ [m]."""
    return max(max(RELATIVE_EASE, bag.ease_of(seam)) * max(one, other), EASE)


def _check_direction(bag: Bag, seam: BagSeam, number: int) -> None:
    """Sides that would fit the other way round alone: as in a Moebius strip, or by mistake."""
    one, other = _lengths(bag, seam)
    if abs(one - other) <= _allowed(bag, seam, one, other):
        return
    turned = [_side_length(bag, seam.a, against=True), _side_length(bag, seam.b, against=False)]
    choices = [(turned[0], other, "a", seam.a, "along"), (turned[1], one, "b", seam.b, "against")]
    for length, fixed, key, side, way in sorted(choices, key=lambda choice: choice[0]):
        if abs(length - fixed) <= _allowed(bag, seam, length, fixed):
            edge = next(_edges(bag, side, against=key == "a"))
            raise AssemblyError(
                f"Side {key} of seam {number} runs the wrong way at"
                f" {edge_name(bag.panels[side.panel], side.loop, edge)}, which would seal the outside of the"
                f" film to its inside, as in a Moebius strip: it goes {way} its loop. Swap the two points of"
                f" {key}."
            )


def _check_edges(bag: Bag) -> None:
    """Each edge of each loop is in exactly one seam."""
    seam_of: dict[tuple[int, int, int], int] = {}
    for number, seam in enumerate(bag.seams, start=1):
        for side, against in ((seam.a, False), (seam.b, True)):
            for edge in _edges(bag, side, against=against):
                key = (side.panel, side.loop, edge)
                if key in seam_of:
                    name = edge_name(bag.panels[side.panel], side.loop, edge)
                    both = (
                        f"in both sides of seam {number}"
                        if seam_of[key] == number
                        else f"in seams {seam_of[key]} and {number}"
                    )
                    raise AssemblyError(
                        f"{_sentence(name)} is {both}. Seal each edge once: side a goes along its loop from"
                        " its first point to its second, b against it."
                    )
                seam_of[key] = number
    for number, panel in enumerate(bag.panels):
        for loop, points in enumerate(panel.loops):
            for edge in range(len(points)):
                if (number, loop, edge) not in seam_of:
                    name = edge_name(panel, loop, edge)
                    raise AssemblyError(f"{_sentence(name)} is in no seam. Seal it to another edge.")


def _sentence(name: str) -> str:
    return name[0].upper() + name[1:]


def _check_lengths(bag: Bag, seam: BagSeam, number: int) -> None:
    one, other = _lengths(bag, seam)
    if abs(one - other) > _allowed(bag, seam, one, other):
        names = [
            f"{length_text(length)} at {_part_name(bag, side, against=against)}"
            for length, side, against in ((one, seam.a, False), (other, seam.b, True))
        ]
        raise AssemblyError(
            f"The sides of seam {number} are not equally long: {names[0]}, {names[1]}. Make them equally"
            " long, or allow them ease."
        )


def _part_name(bag: Bag, side: Side, *, against: bool) -> str:
    """A side for people: its edge, or the first and last of its edges."""
    panel, edges = bag.panels[side.panel], list(_edges(bag, side, against=against))
    name = edge_name(panel, side.loop, edges[0])
    return name if len(edges) == 1 else name.replace(f"edge {edges[0] + 1}", _edges_text(edges), 1)


def _edges_text(edges: list[int]) -> str:
    return f"edges {edges[0] + 1} to {edges[-1] + 1}"


def _check_bodies(bag: Bag) -> None:
    topology = Topology(bag)
    if topology.bodies > 1:
        first = topology.body_of
        apart: BagPanel = bag.panels[int(np.argmax(first != first[0]))]
        raise AssemblyError(
            f"The panels are sealed to {topology.bodies} bodies: panel '{apart.name}' does not hang together"
            f" with panel '{bag.panels[0].name}'. Make a bag of each body."
        )


def _check_opening(bag: Bag, *, opening_needed: bool) -> None:
    opening = bag.opening
    if opening is None:
        if opening_needed and all(panel.cut for panel in bag.panels):
            raise AssemblyError(
                "The bag has no opening through which it is filled. Name the edge at which it stays open,"
                f" such as edge 1 of panel '{bag.panels[0].name}', or make it without an intake."
            )
        return
    if not 0 <= opening.panel < len(bag.panels):
        raise AssemblyError(
            f"The opening is on panel {opening.panel + 1}, but there are {len(bag.panels)}. Choose one of"
            " them."
        )
    panel = bag.panels[opening.panel]
    if not 0 <= opening.at < len(panel.outer):
        raise AssemblyError(
            f"The opening is at point {opening.at} of panel '{panel.name}', whose points are 0 to"
            f" {len(panel.outer) - 1}. Choose one of them."
        )
