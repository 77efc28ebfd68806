# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strip outside the seams: as wide as wanted where there is room, no triangle turned where it is not."""

import numpy as np
import pytest
from drawn_shapes import NAMED, TURN, corners_of, hole, polar, star

from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.strip import LAYERS, OuterStrip, strip_outside
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.panels.panel import Panel

WIDTH = 0.05


def meshed(outline: Outline, vertices: int = 600) -> Panel:
    return triangulate(outline, size_for(outline, vertices))


def area(strip: OuterStrip) -> float:
    return float(signed_areas(strip.rest_positions, strip.triangles).sum())


def room(panel: Panel, width: float) -> float:
    """Area of all that is within the width of the panel, outside it."""
    outer, *holes = (panel.rest_positions[loop] for loop in panel.loops)
    film = shapely().Polygon(outer, holes)
    return float(film.buffer(width).area - film.area)


@pytest.mark.parametrize("radius", [0.2, 1.0])
def test_area_round_a_disc_and_in_its_hole(radius: float) -> None:
    """Of a ring pi ((r + b)^2 - r^2) outside and pi (r^2 - (r - b)^2) inside, but for the facets."""
    disc = meshed(Outline(polar(radius)))
    wanted = np.pi * ((radius + WIDTH) ** 2 - radius**2)
    assert area(strip_outside(disc, WIDTH)) == pytest.approx(wanted, rel=0.01)
    ring = meshed(Outline(polar(2.0), (hole(radius, 0.0, 0.0),)), 1500)
    wanted = np.pi * (2.05**2 - 2.0**2 + radius**2 - (radius - WIDTH) ** 2)
    assert area(strip_outside(ring, WIDTH)) == pytest.approx(wanted, rel=0.01)


def test_a_square_has_its_corners() -> None:
    square = meshed(corners_of((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)))
    assert area(strip_outside(square, WIDTH)) == pytest.approx(1.1**2 - 1.0, rel=1e-9)


def test_it_begins_with_the_rim_in_two_layers() -> None:
    ring = meshed(NAMED["ring"])
    strip = strip_outside(ring, 0.01)
    count = sum(map(len, ring.loops))
    assert strip.rim.tolist() == np.concatenate(ring.loops).tolist()
    assert len(strip.rest_positions) == (LAYERS + 1) * count
    assert len(strip.triangles) == 2 * LAYERS * count
    assert np.array_equal(strip.rest_positions[:count], ring.rest_positions[strip.rim])
    middle = 0.5 * (strip.rest_positions[:count] + strip.rest_positions[2 * count :])
    assert strip.rest_positions[count : 2 * count] == pytest.approx(middle, abs=1e-12)


#: A slit of which the sides are nearer than the strip is wide; a notch that ends in a point; a small hole.
SLIT = corners_of((0, 0), (1, 0), (1, 1), (0.53, 1), (0.53, 0.3), (0.47, 0.3), (0.47, 1), (0, 1))
NOTCH = corners_of((0, 0), (1, 0), (1, 1), (0.52, 1), (0.5, 0.2), (0.48, 1), (0, 1))
TIGHT = {
    "slit": SLIT,
    "notch": NOTCH,
    "star": star(5, 1.0, 0.35),
    "needles": star(9, 1.0, 0.15),
    "small hole": Outline(polar(1.0), (hole(0.6 * WIDTH, 0.0, 0.0),)),
    "tiny hole": Outline(polar(1.0), (hole(0.1 * WIDTH, 0.3, 0.1),)),
    "flat hole": Outline(polar(1.0), (hole(1.0, 0.0, 0.0) * (0.4, 0.02),)),
    "two near holes": Outline(polar(1.0), (hole(0.03, -0.2, 0.0), hole(0.04, 0.2, 0.0))),
    "wavy": Outline(polar(1.0 + 0.2 * np.cos(12.0 * TURN))),
    **{name: NAMED[name] for name in sorted(NAMED)},
}


@pytest.mark.parametrize("name", TIGHT)
@pytest.mark.parametrize("width", [0.02, 0.07, 0.3])
def test_no_triangle_is_turned_and_no_film_lies_twice(name: str, width: float) -> None:
    """However sharp the notch and however small the hole; the strip holds no more film than there is room."""
    panel = meshed(TIGHT[name])
    width *= 0.5 * panel.size
    strip = strip_outside(panel, width)
    assert signed_areas(strip.rest_positions, strip.triangles).min() > 0.0
    assert np.isfinite(strip.rest_positions).all()
    reach = 2.0 * width  # of corners
    assert 0.0 < area(strip) <= room(panel, reach)
    count = len(strip.rim)
    out = np.linalg.norm(strip.rest_positions[2 * count :] - strip.rest_positions[:count], axis=1)
    assert out.max() <= reach * (1.0 + 1e-9)


def test_a_small_hole_is_filled_but_for_its_middle() -> None:
    """But for a tenth of its radius."""
    panel = meshed(TIGHT["small hole"])
    strip = strip_outside(panel, WIDTH)
    inside = (strip.triangles % len(strip.rim) >= len(panel.loops[0])).all(axis=1)
    filled = signed_areas(strip.rest_positions, strip.triangles[inside]).sum()
    assert filled == pytest.approx(-0.99 * signed_area(panel.rest_positions[panel.loops[1]]), rel=0.02)
