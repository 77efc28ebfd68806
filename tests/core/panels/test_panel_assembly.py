# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an assembly knows of itself, and what it says of panels that do not fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import bodies
import numpy as np
import pytest
from bodies import back, rectangle, run
from solver_cases import PRESSURE, film, panel

from BalloonWorkbench.core.errors import AssemblyError
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.panels.seam import Run, Seam
from BalloonWorkbench.core.solver.inflate import inflate

CUBE = bodies.box(1.0, 1.0, 1.0, 2)


@pytest.mark.parametrize(
    ("body", "euler_number", "poles"),
    [
        (CUBE, 2, 8),
        (bodies.tetrahedron(3), 2, 4),
        (bodies.octahedron(3), 2, 6),
        (bodies.drum(1.0, 3), 2, 2),
        (bodies.gored_sphere(6, 6, 2), 2, 2),
        (bodies.thick_ring(0.5, 1.0, 0.3, 2, 18), 0, 4),
        (Assembly.mirrored(panel("disc", 150)).in_full(), 2, 0),
        (Assembly.mirrored(panel("ring", 150)).in_full(), 0, 0),
    ],
    ids=["cube", "tetrahedron", "octahedron", "drum", "gores", "thick-ring", "disc", "ring"],
)
def test_topology(body: Assembly, euler_number: int, poles: int) -> None:
    surface = body.surface
    assert (surface.euler_number, len(surface.poles), surface.bodies) == (euler_number, poles, 1)
    # each edge of the closed surface has two triangles, which pass it in opposite directions
    corners = surface.first[surface.triangles]
    ahead = {tuple(pair) for k in range(3) for pair in corners[:, [k, (k + 1) % 3]].tolist()}
    assert len(ahead) == 3 * len(corners)
    assert ahead == {(end, start) for start, end in ahead}


def test_panels_lie_side_by_side() -> None:
    body = bodies.drum(1.0, 3)
    placed = np.split(body.surface.rest_positions, body.offsets[1:-1])
    for before, after in pairwise(placed):
        assert after[:, 0].min() >= before[:, 0].max()
    for flat, own in zip(placed, body.panels):
        assert np.ptp(flat, axis=0) == pytest.approx(np.ptp(own.rest_positions, axis=0), rel=1e-12)


def test_a_panel_seen_from_inside_is_turned_over() -> None:
    whole = Assembly.mirrored(panel("square", 60)).in_full()
    assert whole.surface.turned.tolist() == [False, True]
    assert CUBE.surface.turned.tolist() == [False] * 6


def without(*numbers: int) -> Assembly:
    return replace(CUBE, seams=tuple(seam for n, seam in enumerate(CUBE.seams, 1) if n not in numbers))


def changed(number: int, **sides: Run) -> Assembly:
    seams = list(CUBE.seams)
    seams[number - 1] = replace(seams[number - 1], **sides)
    return replace(CUBE, seams=tuple(seams))


def with_panel(number: int, other: Panel) -> Assembly:
    panels = list(CUBE.panels)
    panels[number - 1] = other
    return replace(CUBE, panels=tuple(panels))


def moved(vertex: int, place: tuple[float, float]) -> Panel:
    points = CUBE.panels[1].rest_positions.copy()
    points[vertex] = place
    return replace(CUBE.panels[1], rest_positions=points)


def strip(turned: bool) -> Assembly:
    """A strip closed to a ring, or to a Moebius strip, whose edges are sealed to each other."""
    band = rectangle(12, 2, 3.0, 0.5)
    places = [np.array(place) for place in ((0.0, 0.0), (3.0, 0.0), (3.0, 0.5), (0.0, 0.5))]
    low, right, high, left = (run(0, band, places[k], places[(k + 1) % 4]) for k in range(4))
    return Assembly((band,), (Seam(right, left if turned else back(left)), Seam(low, back(high))))


def pinched() -> Assembly:
    """A triangle two of whose sides are sealed to each other: the third closes upon itself."""
    one = bodies.triangle_panel(1)
    sides = [run(0, one, one.rest_positions[a], one.rest_positions[b]) for a, b in ((0, 1), (1, 2), (2, 0))]
    third = run(1, one, one.rest_positions[2], one.rest_positions[0])
    others = [Run(1, side.vertices) for side in sides[:2]]
    seams = (Seam(sides[0], back(sides[1])), Seam(others[0], back(others[1])), Seam(sides[2], back(third)))
    return Assembly((one, one), seams)


BAD: dict[str, tuple[Callable[[], Assembly], str]] = {
    "no-panel": (lambda: Assembly(()), "There is no panel"),
    "unequal-seam": (
        lambda: with_panel(2, rectangle(2, 2, 1.0, 1.1)),
        "sides of seam 4 are 1100 mm and 1000 mm long. Make them equally long",
    ),
    "hardly-unequal": (lambda: with_panel(2, rectangle(2, 2, 1.0, 1.002)), "equally long"),
    "uneven-seam": (lambda: with_panel(2, moved(1, (0.0, 0.4))), "100 mm apart. Put them at equal lengths"),
    "more-vertices": (
        lambda: changed(1, second=replace(CUBE.seams[0].second, vertices=CUBE.seams[0].second.vertices[:-1])),
        "Seam 1 joins 3 vertices to 2",
    ),
    "missing-seam": (
        lambda: without(3),
        r"is open between its vertices \d+ and \d+: the boundary is in no seam",
    ),
    "sealed-twice": (
        lambda: replace(CUBE, seams=(*CUBE.seams, CUBE.seams[4])),
        "Seams 5 and 13 hold the same piece of the boundary",
    ),
    "to-itself": (lambda: changed(1, second=back(CUBE.seams[0].first)), "Seams 1 and 1 hold the same piece"),
    "moebius": (lambda: strip(turned=True), "Moebius"),
    "turned-seam": (lambda: changed(1, second=back(CUBE.seams[0].second)), "Moebius"),
    "degenerate": (lambda: with_panel(2, moved(4, (0.5, 0.0))), r"Triangle \d+ of panel 2 has no area"),
    "not-a-number": (lambda: with_panel(2, moved(4, (np.nan, 0.0))), r"Triangle \d+ of panel 2 has no area"),
    "clockwise": (
        lambda: with_panel(2, replace(CUBE.panels[1], triangles=CUBE.panels[1].triangles[:, ::-1])),
        "Triangle 1 of panel 2 runs clockwise",
    ),
    "lonely-vertex": (
        lambda: with_panel(2, replace(CUBE.panels[1], rest_positions=np.zeros((20, 2)))),
        "panel 2 has a vertex without triangles|Panel 2 has a vertex without triangles",
    ),
    "vertex-off": (
        lambda: with_panel(2, replace(CUBE.panels[1], triangles=CUBE.panels[1].triangles + 5)),
        "vertex that is not there",
    ),
    "inside": (
        lambda: changed(1, second=Run(CUBE.seams[0].second.panel, np.array([3, 4, 5], dtype=np.int32))),
        "Seam 1 leaves the boundary of panel",
    ),
    "no-such-panel": (lambda: changed(1, second=replace(CUBE.seams[0].second, panel=6)), "there are 6"),
    "no-such-vertex": (
        lambda: changed(1, second=replace(CUBE.seams[0].second, vertices=np.array([0, 1, 99]))),
        "vertices that panel . does not have",
    ),
    "pinched": (pinched, "closes an edge of a triangle to a point"),
    "triangle-twice": (
        lambda: with_panel(
            2,
            replace(CUBE.panels[1], triangles=np.concatenate([CUBE.panels[1].triangles] * 2)),
        ),
        "more than two triangles",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_what_does_not_fit_is_named(name: str) -> None:
    make, text = BAD[name]
    with pytest.raises(AssemblyError, match=text):
        inflate(make(), film(1000.0), PRESSURE)


def test_a_mirrored_panel_may_overlap_a_little() -> None:
    """A quick preview has such panels; one without an area has no balloon."""
    overlapping = Assembly.mirrored(moved(4, (0.5, -0.1)))
    assert overlapping.surface.turned.tolist() == [False]
    with pytest.raises(AssemblyError, match="Triangle 1 of panel 1 has no area"):
        inflate(replace(CUBE.panels[0], rest_positions=np.zeros((9, 2))), film(1000.0), PRESSURE)


def test_hardly_unequal_seams_are_sealed() -> None:
    """0.1 % of the length, or 0.3 mm, is within what hands do."""
    with_panel(2, rectangle(2, 2, 1.0, 1.0009)).surface  # noqa: B018
    small = [replace(one, rest_positions=0.01 * one.rest_positions) for one in CUBE.panels]
    points = small[1].rest_positions * (1.0, 1.02)
    small[1] = replace(small[1], rest_positions=points)
    assert replace(CUBE, panels=tuple(small)).surface.euler_number == 2


def test_a_panel_may_be_sealed_to_itself() -> None:
    """A strip, end to end and edge to edge, is a ring of Euler number 0, though edges share their ends."""
    assert strip(turned=False).surface.euler_number == 0
