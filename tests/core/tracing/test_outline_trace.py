# SPDX-License-Identifier: LGPL-2.1-or-later
"""The traced outline against known shapes, and the walk against the seed system's own, pixel by pixel."""

from functools import cache

import cv2
import drawn_pictures as pictures
import numpy as np
import pytest
import shapely

from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import arc_lengths, point_at
from BalloonWorkbench.core.tracing.contour import contours
from BalloonWorkbench.core.tracing.segment import segment
from BalloonWorkbench.core.tracing.trace import trace, walk

SIZE = 512
TURN = np.radians(17.0)
TURNED = np.array([[-150, -120], [150, -120], [150, 120], [-150, 120]]) @ np.array(
    [[np.cos(TURN), np.sin(TURN)], [-np.sin(TURN), np.cos(TURN)]]
) + [256.4, 251.3]


def in_turned(x, y):
    along = (x - 256.4) * np.cos(TURN) + (y - 251.3) * np.sin(TURN)
    across = (y - 251.3) * np.cos(TURN) - (x - 256.4) * np.sin(TURN)
    return (np.abs(along) < 150) & (np.abs(across) < 120)


SHAPES = {
    "circle": (pictures.disc(250.3, 251.7, 200), shapely.Point(250.3, 251.7).buffer(200, quad_segs=500)),
    "square": (pictures.box(100.3, 90.6, 400.2, 430.9), shapely.box(100.3, 90.6, 400.2, 430.9)),
    "turned": (in_turned, shapely.Polygon(TURNED)),
}


@cache
def painted(name, fine):
    return pictures.drawn(SHAPES[name][0], SIZE, SIZE, fine)


def jpeg(pixels, quality):
    _, data = cv2.imencode(".jpg", pixels[..., 2::-1].copy(), [cv2.IMWRITE_JPEG_QUALITY, quality])
    colours = cv2.imdecode(data, cv2.IMREAD_COLOR)
    return np.dstack([colours[..., ::-1], np.full(colours.shape[:2], 255, np.uint8)])


def noisy(pixels):
    colours = pixels[..., :3] + np.random.default_rng(2).normal(0, 10, pixels[..., :3].shape)
    return np.dstack([np.clip(colours, 0, 255), pixels[..., 3]]).astype(np.uint8)


SURFACES = {
    "soft edges": (8, pictures.coloured),
    "hard edges": (1, pictures.coloured),
    "pale on white": (8, lambda part: pictures.coloured(part, (255, 250, 200))),
    "pale on dark": (1, lambda part: pictures.coloured(part, (230, 240, 20), (20, 30, 40))),
    "transparent": (
        8,
        lambda part: np.dstack([np.full((SIZE, SIZE, 3), 90), 255 * part]).round().astype(np.uint8),
    ),
    "jpeg 75": (8, lambda part: jpeg(pictures.coloured(part), 75)),
    "jpeg 30, hard": (1, lambda part: jpeg(pictures.coloured(part), 30)),
    "red on green, jpeg": (8, lambda part: jpeg(pictures.coloured(part, (200, 30, 40), (40, 120, 60)), 85)),
    "noise": (8, lambda part: noisy(pictures.coloured(part))),
}


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("name", SHAPES)
def test_known_shapes_come_back(name, surface):
    truth = SHAPES[name][1]
    fine, paint = SURFACES[surface]
    pixels = paint(painted(name, fine))
    outline = pictures.outline_of(pixels)
    assert outline.holes == ()
    # An outline starts at its own lower left corner; the boundary it was traced from says where that is.
    boundary, _ = max(contours(segment(pixels)[0]), key=lambda loop: loop[1])
    found = shapely.Polygon(trace(boundary, 5.12))
    assert np.ptp(outline.outer, axis=0) == pytest.approx(np.subtract(found.bounds[2:], found.bounds[:2]))
    assert found.is_valid
    assert found.area == pytest.approx(truth.area, rel=0.005)
    points = shapely.points(np.array(found.exterior.segmentize(1.0).coords))
    away = shapely.distance(points, truth.exterior)
    assert away.max() < 1.5
    corners = shapely.MultiPoint(TURNED if name == "turned" else list(truth.envelope.exterior.coords))
    if name != "circle":
        assert shapely.distance(corners, found.exterior) < 1.0
        away = away[shapely.distance(points, corners) > 4]
    assert away.max() < 1.0
    assert np.sqrt((away**2).mean()) < 0.5


def seed_walk(mask, radius):
    """The walk as the seed paper gives it, on the pixels: a circle sampled clockwise, the first way out."""
    rows, columns = np.nonzero(mask)
    first = np.array([columns[0], rows[0]], dtype=float)
    before, here = first + np.array([0, radius]), first
    steps = [first]
    while len(steps) < 10_000:
        start = np.arctan2(before[1] - here[1], before[0] - here[0])
        angle = start + np.linspace(0, 2 * np.pi, 721)[1:]  # y down: a growing angle turns clockwise
        x = np.rint(here[0] + radius * np.cos(angle)).astype(int)
        y = np.rint(here[1] + radius * np.sin(angle)).astype(int)
        inside = mask[y, x]
        out = np.flatnonzero(inside[:-1] & ~inside[1:])[0]
        before, here = here, here + radius * np.array([np.cos(angle[out]), np.sin(angle[out])])
        if len(steps) > 1 and np.linalg.norm(here - first) < radius:
            return np.array(steps)
        steps.append(here)
    raise AssertionError("the walk does not come round")


@pytest.mark.parametrize("name", SHAPES)
def test_the_walk_is_that_of_the_seed_system(name):
    part = painted(name, 8)
    boundary, _ = contours(part.astype(np.float32))[0]
    steps = point_at(boundary, arc_lengths(boundary), walk(boundary, 10.0))
    expected = seed_walk(part > 0.5, 10.0) + 0.5
    expected[:, 1] = SIZE - expected[:, 1]
    assert abs(len(steps) - len(expected)) <= 1
    assert np.linalg.norm(steps[1:] - steps[:-1], axis=1) == pytest.approx(10.0, abs=1e-6)
    assert np.linalg.norm(steps[:8] - expected[:8], axis=1).max() < 1.5
    # Pixels round each step of the seed's walk, so that its points slide along the boundary, and corners are
    # cut elsewhere: compare the lines, to less than the deepest cut of a right angle, half a step.
    assert shapely.hausdorff_distance(shapely.LinearRing(steps), shapely.LinearRing(expected)) < 4


def test_arms_thinner_than_the_circle_are_not_cut_short():
    comb = pictures.any_of(
        pictures.box(50, 50, 450, 150), *(pictures.box(x, 140, x + 4, 400) for x in range(80, 440, 9))
    )
    boundary, area = contours(pictures.drawn(comb, SIZE, SIZE, fine=2).astype(np.float32))[0]
    loop = trace(boundary, 10.0)
    assert first_crossing([loop]) is None
    assert shapely.Polygon(loop).area == pytest.approx(area, rel=0.005)
    assert shapely.hausdorff_distance(shapely.LinearRing(loop), shapely.LinearRing(boundary)) < 1.5


def test_contours_part_and_join_as_the_pixels_do():
    part = np.zeros((12, 12), dtype=np.float32)
    part[2:6, 2:6] = part[6:10, 6:10] = 1  # meeting at a corner
    part[3:5, 3:5] = 0
    loops = contours(part)
    assert sorted(round(area, 1) for _, area in loops) == [-3.5, 15.5, 15.5]
    assert first_crossing([loop for loop, _ in loops]) is None
    part[5, 6] = part[6, 5] = 0.4  # now the middle between the four is inside
    assert len(contours(part)) == 2
