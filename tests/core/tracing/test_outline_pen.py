# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pen drawings: filled from outside in, gaps closed where the hand meant to close them, and only there."""

from pathlib import Path

import drawn_pictures as pictures
import numpy as np
import pytest
import shapely
from drawn_pictures import any_of, arc, box, disc, stroke

from BalloonWorkbench.core.tracing.pen_stroke_ends import free_ends
from BalloonWorkbench.core.tracing.picture import drawing_of
from BalloonWorkbench.core.tracing.picture_file import decode
from BalloonWorkbench.core.tracing.segment import PEN, SHAPE

EXAMPLES = Path("resources/examples/pictures")
INK = {"shape": (20, 20, 30)}


def outline(inside, **colours):
    return pictures.outline_of(pictures.coloured(pictures.drawn(inside, 500, 500, fine=4), **(INK | colours)))


def test_a_closed_line_is_filled():
    found = outline(arc(250, 250, 200, 0, 360, 12))
    assert found.holes == ()
    assert found.area == pytest.approx(np.pi * 206**2, rel=0.003)
    assert any("pen drawing" in note for note in found.notes)


def test_a_line_on_a_transparent_background_is_filled():
    part = pictures.drawn(arc(250, 250, 200, 0, 360, 12), 500, 500, fine=4)
    pixels = np.dstack([np.zeros((500, 500, 3)), np.rint(255 * part)]).astype(np.uint8)
    assert pictures.outline_of(pixels).area == pytest.approx(np.pi * 206**2, rel=0.003)


@pytest.mark.parametrize("degrees", [1, 6, 14])
def test_a_gap_in_the_line_is_closed_and_reported(degrees):
    found = outline(arc(250, 250, 200, degrees, 360, 12))
    assert found.area == pytest.approx(np.pi * 206**2, rel=0.01)
    assert any("1 gap between the lines closed" in note for note in found.notes)


def test_a_wide_opening_stays_open():
    found = outline(arc(250, 250, 200, 40, 360, 12))
    assert found.area == pytest.approx(12 * 200 * np.radians(320), rel=0.02)
    assert any("do not close around anything" in note for note in found.notes)


def test_dashes_become_a_line():
    found = outline(any_of(*(arc(250, 250, 200, start, start + 8, 12) for start in range(0, 360, 12))))
    assert found.area == pytest.approx(np.pi * 206**2, rel=0.015)


def test_the_bay_between_two_lines_is_no_gap():
    letter = any_of(
        stroke(230, 400, 230, 100, 12), stroke(270, 400, 270, 100, 12), stroke(230, 100, 270, 100, 12)
    )
    found = outline(letter)
    assert found.area == pytest.approx(pictures.drawn(letter, 500, 500, fine=4).sum(), rel=0.01)


def test_whiskers_stay_apart():
    head = arc(250, 250, 120, 0, 360, 10)
    whiskers = [stroke(370, 250 + 10 * k, 480, 250 + 22 * k, 10) for k in (-1, 0, 1)]
    found = outline(any_of(head, *whiskers))
    expected = pictures.drawn(any_of(disc(250, 250, 125), *whiskers), 500, 500, fine=4).sum()
    assert found.area == pytest.approx(expected, rel=0.01)


def test_lines_and_spots_inside_leave_no_mark():
    plain = outline(arc(250, 250, 200, 0, 360, 12))
    face = outline(
        any_of(
            arc(250, 250, 200, 0, 360, 12),
            disc(180, 300, 20),
            disc(320, 300, 20),
            arc(250, 250, 100, 200, 340, 12),
        )
    )
    assert shapely.hausdorff_distance(shapely.LinearRing(face.outer), shapely.LinearRing(plain.outer)) < 0.5
    assert face.holes == ()


def test_a_loose_part_is_joined():
    found = outline(any_of(arc(250, 200, 150, 0, 360, 12), stroke(250, 366, 250, 480, 12)))
    assert found.size[1] == pytest.approx(150 + 6 + 280 + 6, abs=2)
    assert any("were joined to the drawing" in note for note in found.notes)


def test_shapes_of_a_pen_drawing_are_kept_apart_from_loose_lines():
    """A head, a balloon beside it, and the ground they stand on."""
    drawn = any_of(arc(150, 300, 100, 0, 360, 10), arc(380, 330, 70, 0, 360, 10), stroke(30, 60, 470, 60, 10))
    pixels = pictures.coloured(pictures.drawn(drawn, 500, 500, fine=4), **INK)
    found = drawing_of(pixels)
    areas = [part.area for part in found.parts]
    assert areas == pytest.approx([np.pi * 105**2, np.pi * 75**2], rel=0.01)
    assert any("close around nothing" in note for note in found.notes)


def test_a_face_left_white_in_a_coloured_drawing_is_filled():
    part = pictures.drawn(any_of(arc(250, 350, 100, 0, 360, 8), box(150, 50, 350, 250)), 500, 500, fine=4)
    found = pictures.outline_of(pictures.coloured(part, (200, 60, 60)))
    assert found.holes == ()
    assert found.area > 200 * 200 + 0.95 * np.pi * 104**2


def test_free_ends_of_strokes():
    ink = (
        pictures.drawn(any_of(stroke(100, 100, 400, 100, 14), stroke(250, 100, 250, 300, 14)), 500, 500) > 0.5
    )
    points, headings = free_ends(ink, 14.0)
    found = {tuple(np.round(p).astype(int)): tuple(np.round(h).astype(int)) for p, h in zip(points, headings)}
    ends = {(100, 400): (-1, 0), (400, 400): (1, 0), (250, 200): (0, -1)}  # y down
    assert len(found) == 3
    for place, heading in found.items():
        near = [end for end in ends if np.hypot(*np.subtract(end, place)) < 4]
        assert ends[near[0]] == heading


# Points of the pictures (x right, y down) that a person sees inside or outside the drawn figure.
@pytest.mark.parametrize(
    ("name", "inside", "outside"),
    [
        (
            "line-dog",
            # muzzle, ear, chest, belly, hip, each leg, the lifted paw, tail
            [
                (140, 290),
                (235, 200),
                (280, 450),
                (480, 480),
                (690, 420),
                (325, 650),
                (720, 700),
                (655, 700),
                (180, 640),
                (200, 680),
                (755, 270),
            ],
            # over the back, in the curl of the tail, below the belly, between paw and leg, beside the legs
            [(500, 300), (690, 270), (480, 650), (245, 620), (265, 700), (550, 640), (850, 600), (110, 450)],
        ),
        (
            "line-fish",
            [(450, 300), (560, 300), (430, 500), (260, 480), (700, 460), (750, 500), (560, 440)],
            [(250, 330), (340, 660), (100, 100), (812, 494), (780, 400)],
        ),
        (
            "line-house",
            [(330, 250), (437, 300), (550, 540), (370, 600), (550, 650)],
            [(362, 180), (450, 730), (270, 300), (200, 500)],
        ),
    ],
)
def test_the_drawn_figure_is_what_a_person_sees(name, inside, outside):
    pixels = decode(EXAMPLES / f"{name}.png")
    found = pictures.outline_of(pixels)
    dark = pixels[..., :3].max(axis=2) < 128
    left, low = (
        np.flatnonzero(dark.any(axis=0))[0],
        pixels.shape[0] - 1 - np.flatnonzero(dark.any(axis=1))[-1],
    )
    figure = shapely.Polygon(found.outer + np.array([left, low]))
    for wanted, points in ((True, inside), (False, outside)):
        for x, y in points:
            assert figure.contains(shapely.Point(x + 0.5, pixels.shape[0] - y - 0.5)) == wanted, (x, y)
    y, x = np.nonzero(dark)
    assert shapely.contains_xy(figure.buffer(1.0), x + 0.5, pixels.shape[0] - y - 0.5).all()


def mug(band):
    """A body of 200 px with a ring handle of 130 px whose band is so wide, in a picture of 400 px."""
    return any_of(disc(140, 200, 100), pictures.ring(270, 200, 65, 65 - band))


def mug_pixels(band):
    return pictures.coloured(pictures.drawn(mug(band), 400, 400, fine=4))


@pytest.mark.parametrize("band", [10, 16])
def test_a_filled_hole_is_told_and_can_be_had_back(band):
    """Automatically the handle passes for a drawn line; as a filled shape it has its hole."""
    found = pictures.outline_of(mug_pixels(band))
    assert found.holes == ()
    assert any("1 hole" in note and "filled shape" in note for note in found.notes)
    shape = drawing_of(mug_pixels(band), SHAPE).largest
    (hole,) = shape.holes
    expected = pictures.drawn(
        lambda x, y: disc(270, 200, 65 - band)(x, y) & ~disc(140, 200, 100)(x, y), 400, 400, fine=4
    ).sum()
    assert shapely.Polygon(hole).area == pytest.approx(expected, rel=0.02)
    assert not any("filled" in note for note in shape.notes)


def test_a_thick_handle_keeps_its_hole_without_a_word():
    found = pictures.outline_of(mug_pixels(34))
    assert len(found.holes) == 1
    assert found.notes == ()


def test_a_line_drawing_taken_as_a_shape_is_a_ring():
    pixels = pictures.coloured(pictures.drawn(arc(250, 250, 200, 0, 360, 12), 500, 500, fine=4), **INK)
    found = drawing_of(pixels, SHAPE).largest
    assert found.area == pytest.approx(np.pi * (206**2 - 194**2), rel=0.01)
    assert len(found.holes) == 1


def test_a_broad_pen_is_a_pen_where_it_is_said():
    """A ring of 60 px is a shape by itself; as a pen drawing its inside is filled, and its gap closed."""
    pixels = pictures.coloured(pictures.drawn(arc(250, 250, 200, 8, 360, 60), 500, 500, fine=4), **INK)
    assert drawing_of(pixels).largest.area < 2 * np.pi * 200 * 60
    pen = drawing_of(pixels, PEN).largest
    assert pen.holes == ()
    assert pen.area == pytest.approx(np.pi * 230**2, rel=0.01)
