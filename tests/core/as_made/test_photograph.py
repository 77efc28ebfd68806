# SPDX-License-Identifier: LGPL-2.1-or-later
"""Photographs of shapes that are known: the outline comes back, and where there is none it is said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_pictures import png
from photographs import SILVER, photograph

from BalloonWorkbench.core.as_made.comparison import Comparison, Expected, compare
from BalloonWorkbench.core.as_made.photo_scale import PhotoScale, parse_photo_scale
from BalloonWorkbench.core.as_made.photograph import SeenShape, read_photograph, shape_of
from BalloonWorkbench.core.errors import InputError, PictureError
from BalloonWorkbench.core.outline.outline import Outline

PIXEL = 0.0005
#: An uneven shape of smooth lines and three corners, 180 mm wide.
_ANGLES = np.linspace(0.0, 2.0 * np.pi, 240, endpoint=False)
BEAN = 0.09 * np.column_stack([np.cos(_ANGLES), 0.6 * np.sin(_ANGLES) + 0.25 * np.cos(2.0 * _ANGLES + 0.7)])
FLAG = np.array([[0.0, 0.0], [0.18, 0.0], [0.17, 0.07], [0.1, 0.075], [0.02, 0.12], [0.0, 0.05]])
RING = [BEAN, 0.3 * BEAN[::-1] + [0.02, 0.0]]
SCENES = {
    "as it is": {},
    "turned": {"turn": 37.0},
    "turned and shifted": {"turn": -150.0, "at": (0.47, 0.55)},
    "blurred": {"blur": 3.0, "turn": 5.0},
    "noise": {"noise": 8.0, "turn": 100.0},
    "shadow": {"shadow": (15.0, 18.0), "turn": 20.0},
    "glare": {"glare": (-30.0, 5.0), "turn": 20.0},
    "uneven light": {"uneven": 0.25, "turn": -10.0},
    "silver": {"colour": SILVER, "noise": 3.0, "turn": 10.0},
    "all of it": {"turn": 200.0, "blur": 2.0, "noise": 5.0, "shadow": (-14.0, 16.0), "glare": (20.0, 0.0)},
}


def seen(loops: list[np.ndarray], scale: float | None = PIXEL, **scene: object) -> SeenShape:
    outline = shape_of(photograph(loops, **scene))
    known = None if scale is None else PhotoScale(scale, 0.0)
    return SeenShape(outline.map(lambda loop: loop * (scale or 1.0)), known, outline.notes)


def over(loops: list[np.ndarray], scale: float | None = PIXEL, **scene: object) -> Comparison:
    return compare(seen(loops, scale, **scene), [Expected(Outline(loops[0], tuple(loops[1:])))])


@pytest.mark.parametrize(
    ("name", "shape"), [*((name, "flag") for name in SCENES), ("as it is", "bean"), ("all of it", "bean")]
)
def test_the_outline_comes_back(name: str, shape: str) -> None:
    """Within 0.15 mm in the mean, a third of a pixel, in every light; the turn within 0.1 degrees."""
    loop = BEAN if shape == "bean" else FLAG
    scene = SCENES[name]
    comparison = over([loop], **scene)
    clear = not {"blur", "shadow", "noise"} & set(scene)
    assert comparison.residual.mean < (0.06e-3 if clear else 0.15e-3)
    assert comparison.residual.p95 < (0.12e-3 if clear else 0.3e-3)
    assert abs(comparison.offset) < 0.15e-3
    turn = np.degrees(comparison.placement.turn) + scene.get("turn", 0.0)
    assert abs((turn + 180.0) % 360.0 - 180.0) < 0.1
    assert comparison.placement.size == pytest.approx(1.0, abs=1e-9)


def test_the_distances_are_those_of_another_library() -> None:
    """Of a shape that is made larger by 1 %: shapely measures the same outlines."""
    comparison = over([1.01 * FLAG], turn=30.0)
    wrong = compare(seen([1.01 * FLAG], turn=30.0), [Expected(Outline(FLAG))])
    assert comparison.residual.mean < 0.1e-3
    one, other = (shapely.LinearRing(each.outer) for each in (wrong.seen, wrong.expected.outline))
    assert wrong.residual.max == pytest.approx(shapely.hausdorff_distance(one, other, 0.002), abs=0.02e-3)
    assert wrong.offset == pytest.approx(
        2.0 * (shapely.Polygon(one).area - shapely.Polygon(other).area) / (one.length + other.length),
        rel=1e-6,
    )
    away = [shapely.distance(a, shapely.Point(b.interpolate(share, normalized=True)))
            for a, b in ((one, other), (other, one)) for share in np.linspace(0.0, 1.0, 400)]  # fmt: skip
    assert wrong.residual.mean == pytest.approx(np.mean(away), rel=0.02)
    assert wrong.residual.p95 == pytest.approx(np.percentile(away, 95), rel=0.03)


def test_the_size_is_fitted_where_it_is_asked_for() -> None:
    comparison = over([FLAG], None, turn=25.0)
    assert comparison.placement.size == pytest.approx(PIXEL, rel=1e-3)
    assert comparison.residual.mean < 0.06e-3
    larger = over([1.02 * FLAG], None)
    assert larger.placement.size == pytest.approx(PIXEL, rel=1e-3)


def test_the_back_is_mirrored() -> None:
    comparison = over([FLAG], turn=15.0, mirror=True)
    assert comparison.placement.mirrored
    assert comparison.residual.mean < 0.06e-3
    assert any("back" in remark for remark in comparison.remarks)
    assert shapely.LinearRing(comparison.seen.outer).is_ccw


def test_a_hole_is_compared_and_a_glare_is_none() -> None:
    comparison = over(RING, turn=70.0, glare=(-25.0, 85.0))
    assert len(comparison.seen.holes) == 1
    assert comparison.residual.mean < 0.06e-3
    missed = compare(seen(RING[:1]), [Expected(Outline(RING[0], (RING[1],)))])
    assert any("Not all holes" in remark for remark in missed.remarks)
    assert missed.residual.max > 0.01


def test_a_grey_shape_in_a_shadow_is_told() -> None:
    notes = seen([FLAG], colour=SILVER, shadow=(15.0, 18.0)).remarks
    assert notes == ("The shape has the colour of a shadow: shadows on the background count as part of it.",)
    assert seen([FLAG], shadow=(15.0, 18.0)).remarks == ("Shadows on the background were taken off.",)
    assert seen([FLAG]).remarks == ()


def test_the_most_alike_of_several_is_taken() -> None:
    shapes = [Expected(Outline(1.1 * FLAG)), Expected(Outline(FLAG * [1.0, 0.9])), Expected(Outline(FLAG))]
    assert compare(seen([FLAG], turn=80.0), shapes).expected is shapes[2]


@pytest.mark.parametrize("at", [(0.1, 0.5), (0.5, 0.97)])
def test_a_shape_at_the_border_is_refused(at: tuple[float, float]) -> None:
    with pytest.raises(PictureError, match=r"touches the (left|lower) border") as caught:
        seen([FLAG], at=at)
    assert str(caught.value).count(". ") == 0


def pixels(colours: np.ndarray) -> np.ndarray:
    return np.dstack([colours, np.full(colours.shape[:2], 255)]).astype(np.uint8)


RANDOM = np.random.default_rng(3)
NO_BALLOON = {
    "one pixel": (pixels(np.full((1, 1, 3), 9)), "too small"),
    "nothing": (pixels(np.full((120, 150, 3), 200)), "single colour"),
    "noise": (pixels(RANDOM.integers(0, 256, (120, 150, 3))), "no plain background"),
}


@pytest.mark.parametrize("name", NO_BALLOON)
def test_a_photograph_without_a_balloon(tmp_path: Path, name: str) -> None:
    colours, text = NO_BALLOON[name]
    (tmp_path / "photo.png").write_bytes(png(colours))
    with pytest.raises(PictureError, match=text):
        read_photograph(tmp_path / "photo.png", PhotoScale(PIXEL, 0.0))


def test_another_thing_or_another_size() -> None:
    stick = np.array([[0.0, 0.0], [0.18, 0.0], [0.18, 0.02], [0.0, 0.02]])
    with pytest.raises(InputError, match="No shape in the photograph is like"):
        compare(seen([stick]), [Expected(Outline(FLAG))])
    with pytest.raises(InputError, match="measures 180 x 120 mm, 360 x 240 mm were expected"):
        compare(seen([FLAG]), [Expected(Outline(2.0 * FLAG))])


@pytest.mark.parametrize(
    ("text", "pixel"),
    [
        ("0,0,300,400,250mm", 0.0005),
        ("500,250mm", 0.0005),
        ("-500,25cm", 0.0005),
        ("10, 20, 10, 30, 1in", 0.00254),
    ],
)
def test_scales(text: str, pixel: float) -> None:
    scale = parse_photo_scale(text)
    assert scale is not None
    assert scale.pixel == pytest.approx(pixel)
    assert scale.uncertainty == pytest.approx(np.sqrt(2.0) * pixel / (0.0254 if "in" in text else 0.25))


def test_the_size_may_be_unknown() -> None:
    assert parse_photo_scale("Fit") is None


@pytest.mark.parametrize(
    "text", ["", "fits", "500", "1,2,3,250mm", "1,2,3,4,5,250mm", "nan,250mm", "a,b,c,d,1mm"]
)
def test_scales_that_are_none(text: str) -> None:
    with pytest.raises(InputError, match="cannot be used: write x1,y1,x2,y2,LENGTH"):
        parse_photo_scale(text)


@pytest.mark.parametrize("text", ["5,5,5,5,250mm", "0,250mm", "500,0mm", "500,-3mm"])
def test_scales_without_a_length(text: str) -> None:
    with pytest.raises(InputError, match="has no length: mark two points"):
        parse_photo_scale(text)


def test_a_large_photograph_keeps_its_scale(tmp_path: Path) -> None:
    """It is read at a part of its size; the marks are in its own pixels."""
    (tmp_path / "photo.png").write_bytes(png(photograph([FLAG], pixel=0.00012, size=(2000, 1300))))
    shape = read_photograph(tmp_path / "photo.png", PhotoScale(0.00012, 0.0))
    comparison = compare(shape, [Expected(Outline(FLAG))])
    assert comparison.residual.mean < 0.05e-3


def test_of_turns_that_are_nearly_equal_the_best_is_found() -> None:
    """A star of six tips one of which is a little longer."""
    angles = np.arange(12) * np.pi / 6.0
    radii = np.where(np.arange(12) % 2, 0.04, 0.09)
    radii[6] += 0.002
    star = radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    comparison = over([star], turn=130.0)
    assert np.degrees(comparison.placement.turn) == pytest.approx(-130.0, abs=0.1)
    assert comparison.residual.mean < 0.06e-3


def test_a_picture_that_is_cut_out_has_no_background() -> None:
    """What its clear pixels would show is not looked at."""
    pixels = photograph([FLAG], turn=20.0)
    shape = photograph([FLAG], turn=20.0, colour=(0, 0, 0), paper=(255, 255, 255))
    pixels[..., 3] = 255 - shape[..., 0]
    outline = shape_of(pixels).map(lambda loop: loop * PIXEL)
    comparison = compare(SeenShape(outline, PhotoScale(PIXEL, 0.0)), [Expected(Outline(FLAG))])
    assert comparison.residual.mean < 0.08e-3


def test_a_ruler_beside_it_is_no_part_of_it() -> None:
    pixels = photograph([FLAG])
    pixels[450:470, 40:560, :3] = 30
    shape = shape_of(pixels).map(lambda loop: loop * PIXEL)
    assert shape.size == pytest.approx((0.18, 0.12), abs=0.3e-3)
