# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures as people have them: the examples, backgrounds, holes, several shapes, and what is no picture."""

import struct
import time
import zlib

import cv2
import drawn_pictures as pictures
import numpy as np
import pytest
import shapely

from BalloonWorkbench.core.errors import InputError, MissingPackageError, PictureError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.tracing import picture_file as decoding
from BalloonWorkbench.core.tracing import raster
from BalloonWorkbench.core.tracing.picture import drawing_of, picture_drawing, read_picture

RED_DISC = pictures.coloured(pictures.drawn(pictures.disc(150, 100, 80), 300, 200), (200, 30, 30))


def saved(folder, data, name="picture.png"):
    path = folder / name
    path.write_bytes(data)
    return path


def outline(inside, width=400, height=300, **colours):
    return pictures.outline_of(pictures.coloured(pictures.drawn(inside, width, height), **colours))


def counted_area(path):
    """Area of the silhouette in px2: alpha added up, or what a flood fill of the white border leaves."""
    pixels = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if (pixels[..., 3] < 255).any():
        return float((pixels[..., 3] / 255.0).sum())
    white = (pixels[..., :3].min(axis=2) > 127).astype(np.uint8)
    padded = np.pad(white, 1, constant_values=1)
    _, filled, _, _ = cv2.floodFill(padded, None, (0, 0), 2)
    return float((filled != 2).sum())


@pytest.mark.parametrize("path", pictures.EXAMPLES, ids=lambda path: path.stem)
def test_the_example_pictures(path):
    found = read_picture(path, 0.3, None)
    assert found.size[0] == pytest.approx(0.3)
    assert found.holes == ()
    assert signed_area(found.outer) > 0
    assert shapely.Polygon(found.outer).is_valid
    pixel = pictures.outline_of(decoding.decode(path))
    if path.stem != "line-dog":  # whose lines are open: see the test of pen drawings
        assert pixel.area == pytest.approx(counted_area(path), rel=0.004)
    assert 150 < len(pixel.outer) < 900
    assert not any("left out" in note or "speck" in note or "hole" in note for note in pixel.notes)


@pytest.mark.parametrize("path", pictures.EXAMPLES, ids=lambda path: path.stem)
def test_the_same_outline_without_opencv(path, monkeypatch):
    """By SciPy: the same points, where neither is rounded."""
    pixels = decoding.decode(path)
    expected = pictures.outline_of(pixels)
    pixel = 0.3 / expected.size[0]
    ring = shapely.LinearRing(expected.outer * pixel)
    monkeypatch.setattr(raster, "opencv", lambda: None)
    found = read_picture(path, 0.3, None, decode=lambda _: pixels)
    assert shapely.hausdorff_distance(shapely.LinearRing(found.outer), ring) < 0.01 * pixel
    assert found.notes == expected.notes


def test_without_opencv_and_without_a_decoder_the_package_is_named(tmp_path, monkeypatch):
    path = saved(tmp_path, pictures.png(RED_DISC))
    monkeypatch.setattr(decoding, "opencv", lambda: None)
    with pytest.raises(MissingPackageError, match="OpenCV"):
        read_picture(path, 0.3, None)


def test_an_opencv_that_fails_at_its_first_call_is_not_used(monkeypatch):
    def fail(*_):
        raise cv2.error("no codec")

    raster.opencv.cache_clear()
    try:
        monkeypatch.setattr(cv2, "imencode", fail)
        assert raster.opencv() is None
    finally:
        raster.opencv.cache_clear()


def test_a_ring_of_solid_colour_keeps_its_hole():
    found = outline(pictures.ring(200, 150, 130, 70))
    assert len(found.holes) == 1
    assert signed_area(found.outer) == pytest.approx(np.pi * 130**2, rel=0.003)
    assert signed_area(found.holes[0]) == pytest.approx(-np.pi * 70**2, rel=0.005)
    centre = found.outer.mean(axis=0)
    assert np.linalg.norm(found.holes[0].mean(axis=0) - centre) < 1.5


def test_a_tiny_hole_is_filled_and_reported():
    inside = pictures.any_of(pictures.ring(200, 150, 130, 8))
    found = outline(inside)
    assert found.holes == ()
    assert any("1 tiny hole was filled" in note for note in found.notes)


def test_other_colours_inside_are_no_holes():
    part = pictures.drawn(pictures.disc(200, 150, 120), 400, 300)
    spot = pictures.drawn(pictures.disc(200, 150, 60), 400, 300)[..., None]
    pixels = pictures.coloured(part).astype(float)
    for colour in ((250, 240, 200), (0, 0, 0), (235, 235, 235)):
        mixed = pixels.copy()
        mixed[..., :3] = (1 - spot) * pixels[..., :3] + spot * np.array(colour)
        assert pictures.outline_of(mixed.astype(np.uint8)).holes == ()


def several(inside, **colours):
    return drawing_of(pictures.coloured(pictures.drawn(inside, 400, 300), **colours))


def test_separate_shapes_are_separate_outlines_in_their_places():
    found = several(
        pictures.any_of(
            pictures.disc(330, 60, 40),
            pictures.box(30, 30, 200, 250),
            pictures.disc(340, 270, 4),
            pictures.disc(240, 270, 4),
        )
    )
    box, disc = found.parts
    assert box.size == pytest.approx((170, 220), abs=1)
    assert disc.area == pytest.approx(np.pi * 40**2, rel=0.01)
    # seen from the corner of all shapes, which is at (30, 20)
    assert disc.outer.mean(axis=0) == pytest.approx((300, 40), abs=0.5)
    assert found.size == pytest.approx((340, 230), abs=1)
    assert box.notes == ("2 small specks were dropped.",)
    assert disc.notes == ()


def test_an_island_in_a_hole_is_a_shape_of_its_own():
    ring, island = several(
        pictures.any_of(pictures.ring(200, 150, 140, 100), pictures.ring(200, 150, 60, 30))
    ).parts
    for part, radii in ((ring, (140, 100)), (island, (60, 30))):
        (inside,) = part.holes
        found = np.sqrt(np.array([signed_area(part.outer), -signed_area(inside)]) / np.pi)
        assert found == pytest.approx(radii, abs=0.5)


def test_a_thin_line_beside_the_shape_is_no_balloon():
    found = several(pictures.any_of(pictures.disc(150, 150, 100), pictures.box(280, 20, 282, 280)))
    assert len(found.parts) == 1
    assert found.size == pytest.approx((200, 200), abs=1)
    assert found.notes == ("1 thin line is left out (right).",)


def test_the_width_is_that_of_all_shapes(tmp_path):
    shapes = pictures.any_of(pictures.disc(100, 150, 60), pictures.disc(300, 150, 40))
    pixels = pictures.coloured(pictures.drawn(shapes, 400, 300))
    found = picture_drawing(saved(tmp_path, pictures.png(pixels)), 0.3, None)
    assert found.size == pytest.approx((0.3, 0.12), rel=0.01)
    areas = [part.area for part in found.parts]
    assert areas == pytest.approx([np.pi * 0.06**2, np.pi * 0.04**2], rel=0.01)


def test_a_shape_cut_off_at_the_border_is_used_and_reported():
    found = outline(pictures.disc(390, 150, 100))
    assert found.size == pytest.approx((110, 200), abs=1)
    assert any("touches the right border" in note for note in found.notes)
    assert outline(pictures.disc(200, 150, 100)).notes == ()


@pytest.mark.parametrize("background", [(255, 255, 255), (0, 0, 0), (30, 140, 60), (128, 128, 128)])
def test_plain_backgrounds_of_any_colour(background):
    found = outline(pictures.disc(200, 150, 100), shape=(240, 180, 40), background=background)
    assert found.area == pytest.approx(np.pi * 100**2, rel=0.003)


def test_paper_in_uneven_light_is_a_background():
    part = pictures.drawn(pictures.disc(200, 150, 90), 400, 300)
    y, x = np.mgrid[-1:1:300j, -1:1:400j]
    light = (0.85 - 0.12 * (x * x + y * y) + 0.1 * x - 0.05 * y)[..., None]
    pixels = pictures.coloured(part, (60, 60, 90)).astype(float)
    pixels[..., :3] = pixels[..., :3] * light + np.random.default_rng(4).normal(0, 3, (300, 400, 3))
    found = pictures.outline_of(np.clip(pixels, 0, 255).astype(np.uint8))
    assert found.area == pytest.approx(np.pi * 90**2, rel=0.006)


def test_a_soft_shadow_in_the_transparency_is_no_shape():
    body, shadow = (pictures.drawn(pictures.disc(x, y, 80), 400, 300) for x, y in ((180, 160), (200, 140)))
    alpha = np.maximum(body, 0.3 * shadow)
    pixels = np.dstack([np.full((300, 400, 3), 90), np.rint(255 * alpha)]).astype(np.uint8)
    assert pictures.outline_of(pixels).area == pytest.approx(np.pi * 80**2, rel=0.005)


def test_a_large_picture_is_shrunk_without_a_shift(tmp_path):
    pixels = pictures.coloured(pictures.drawn(pictures.disc(1500, 1000, 800), 3000, 2000, fine=1))
    found = read_picture(saved(tmp_path, pictures.png(pixels)), 0.3, None)
    assert found.area == pytest.approx(np.pi * 0.15**2, rel=0.003)
    assert found.size == pytest.approx((0.3, 0.3), rel=0.003)


def test_width_and_height_bound_the_outline(tmp_path):
    pixels = pictures.coloured(pictures.drawn(pictures.box(50, 50, 250, 150), 300, 200))
    path = saved(tmp_path, pictures.png(pixels))
    for wanted, size in (((0.4, None), (0.4, 0.2)), ((None, 0.4), (0.8, 0.4)), ((0.4, 0.1), (0.2, 0.1))):
        found = read_picture(path, *wanted)
        assert found.size == pytest.approx(size, rel=0.01)
        assert found.outer.min(axis=0) == pytest.approx((0, 0), abs=1e-9)


def test_a_picture_without_a_wanted_size_asks_for_one(tmp_path):
    with pytest.raises(InputError, match="width or the height"):
        read_picture(saved(tmp_path, pictures.png(RED_DISC)), None, None)


@pytest.mark.parametrize("width", [0.0, -0.3, 1e5])
def test_impossible_widths_are_refused(width, tmp_path):
    with pytest.raises(InputError, match="between 1 mm and 100 m"):
        read_picture(saved(tmp_path, pictures.png(RED_DISC)), width, None)


@pytest.mark.parametrize(
    "pixels",
    [
        RED_DISC[..., :3],
        RED_DISC.astype(np.uint16) * 257,
        RED_DISC[..., 1],
        np.dstack([RED_DISC[..., 1], RED_DISC[..., 3]]),
        (RED_DISC[..., 1] > 127).astype(np.uint16) * 65535,
    ],
    ids=["colour", "16 bit", "grey", "grey with alpha", "16 bit grey"],
)
def test_kinds_of_png(pixels, tmp_path):
    found = read_picture(saved(tmp_path, pictures.png(pixels), "Bär ✿ 图.png"), 0.16, None)
    assert found.area == pytest.approx(np.pi * 0.08**2, rel=0.005)


@pytest.mark.parametrize("kind", [".jpg", ".bmp", ".webp"])
def test_other_kinds_of_pictures(kind, tmp_path):
    _, data = cv2.imencode(kind, RED_DISC[..., 2::-1].copy())
    path = saved(tmp_path, data.tobytes(), "Käfer" + kind)
    assert decoding.picture_size(path) == (300, 200)
    assert read_picture(path, 0.16, None).area == pytest.approx(np.pi * 0.08**2, rel=0.01)


@pytest.mark.parametrize(
    ("orientation", "size"), [(1, (0.3, 0.1)), (6, (0.1, 0.3)), (8, (0.1, 0.3)), (3, (0.3, 0.1))]
)
def test_a_camera_picture_is_upright(orientation, size, tmp_path):
    pixels = pictures.coloured(pictures.drawn(pictures.box(50, 50, 350, 150), 400, 200))
    _, data = cv2.imencode(".jpg", pixels[..., 2::-1].copy())
    path = saved(tmp_path, pictures.turned_jpeg(data.tobytes(), orientation), "photo.jpg")
    assert read_picture(path, size[0], None).size == pytest.approx(size, rel=0.01)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match=r"no file .*nothing\.png"):
        read_picture(tmp_path / "nothing.png", 0.3, None)
    with pytest.raises(InputError, match="cannot be read"):
        read_picture(tmp_path, 0.3, None)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "not a picture"),
        (b"Just a letter to grandmother.", "not a picture"),
        (b"\x89PNG\r\n\x1a\n", "not a picture"),
        (b"\xff\xd8\xff\xe0\x00\x10JFIF", "not a picture"),
        (b"BM" + bytes(10), "not a picture"),
        (pictures.png_with(300, 200, 8, 6, b"no pixels"), "damaged"),
        (pictures.png_with(100_000, 50_000, 8, 6, zlib.compress(bytes(1000))), "100000 x 50000 pixels"),
        (b"BM" + bytes(12) + struct.pack("<Iii", 40, 40_000, -40_000) + bytes(100), "40000 x 40000 pixels"),
        (b"\xff\xd8\xff\xc0\x00\x11\x08\xff\xff\xff\xff" + bytes(20), "65535 x 65535 pixels"),
    ],
)
def test_what_is_no_picture_is_refused(data, message, tmp_path):
    with pytest.raises(PictureError, match=message):
        read_picture(saved(tmp_path, data), 0.3, None)


@pytest.mark.parametrize(
    ("pixels", "message"),
    [
        (np.zeros((100, 100, 4), np.uint8), "all of it is transparent"),
        (np.full((100, 100, 4), 255, np.uint8), "single colour"),
        (np.full((100, 100, 4), [9, 90, 200, 255], np.uint8), "single colour"),
        (
            np.random.default_rng(1).integers(0, 256, (200, 200, 4)).astype(np.uint8) | [[[0, 0, 0, 255]]],
            "no plain",
        ),
        (RED_DISC[:10, :10], "too small"),
    ],
)
def test_pictures_without_a_shape_are_refused(pixels, message):
    with pytest.raises(PictureError, match=message):
        pictures.outline_of(pixels.astype(np.uint8))


def test_the_same_picture_gives_the_same_bytes():
    first, second = (read_picture(pictures.EXAMPLES[0], 0.3, None) for _ in range(2))
    assert first.outer.tobytes() == second.outer.tobytes()


@pytest.mark.parametrize("part", [0.1, 0.3, 0.5])
def test_a_texture_takes_no_endless_time(part):
    pixels = np.full((600, 600, 4), 255, np.uint8)
    dots = np.random.default_rng(8).random((560, 560)) < part
    pixels[20:-20, 20:-20, :3][dots] = 0
    start = time.process_time()
    try:
        found = pictures.outline_of(pixels)
    except PictureError as error:
        assert "frayed" in str(error)
    else:
        assert found.notes
    assert time.process_time() - start < 30


def test_a_frayed_shape_is_refused():
    pixels = np.full((400, 400, 4), 255, np.uint8)
    comb = pixels[20:-20, 20:-20, :3]
    comb[:, :20] = comb[::2] = 0
    pixels[40:60, 200:380, :3] = comb[20:40, 180:360] = 0
    with pytest.raises(PictureError, match="frayed"):
        pictures.outline_of(pixels)
