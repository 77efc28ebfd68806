# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns of many seams, measured with the polygons they enclose."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, Outline, corners_of, generated, hole, polar
from shapely import LineString, Point, Polygon

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

SEAL, ALLOWANCE, WIDTH = 0.005, 0.002, 0.010
MICRON = 1e-6


def line(contour: Contour) -> LineString:
    points = np.concatenate([contour.points, contour.points[:1]]) if contour.closed else contour.points
    return LineString(points)


def film_of(pattern: Pattern) -> Polygon:
    """The sheet that is left when everything is cut."""
    (cut,) = pattern.of(Role.CUT)
    return Polygon(cut.points, [inner.points for inner in pattern.of(Role.CUT_INNER)])


def welds_of(pattern: Pattern) -> shapely.Geometry:
    lines = [line(contour) for contour in pattern.of(Role.SEAL)]
    return shapely.union_all([seal.buffer(0.5 * pattern.seal_width, cap_style="square") for seal in lines])


def mouth_of(pattern: Pattern) -> np.ndarray:
    intake = pattern.intake
    assert intake is not None
    return intake.at + intake.length * np.array([np.cos(intake.angle), np.sin(intake.angle)])


def assert_makeable(pattern: Pattern, seam: Outline) -> None:
    film, welds, mouth = film_of(pattern), welds_of(pattern), mouth_of(pattern)
    assert film.is_valid
    for contour in pattern.contours:
        steps = np.diff(np.asarray(line(contour).coords), axis=0)
        assert np.linalg.norm(steps, axis=1).min() >= 0.05e-3
        assert line(contour).is_simple
        if contour.closed:
            assert (signed_area(contour.points) > 0.0) == (contour.role is Role.CUT)
    assert pattern.contours[-1].role is Role.CUT
    # The cut leaves the whole weld and the allowance on the film.
    (cut,) = pattern.of(Role.CUT)
    (open_seal,) = (contour for contour in pattern.of(Role.SEAL) if not contour.closed)
    at_mouth = Point(mouth).buffer(0.5 * WIDTH + SEAL + 2.0 * ALLOWANCE)
    side = line(cut).difference(at_mouth)
    assert side.distance(line(open_seal)) == pytest.approx(0.5 * SEAL + ALLOWANCE, abs=15 * MICRON)
    for inner in pattern.of(Role.CUT_INNER):
        nearest = min(line(inner).distance(line(seal)) for seal in pattern.of(Role.SEAL))
        assert nearest > 0.5 * SEAL + ALLOWANCE - 15 * MICRON
    # The seal ends at the mouth, half a seal width beside the air path, and the cut closes it there.
    for end in open_seal.points[[0, -1]]:
        assert np.linalg.norm(end - mouth) == pytest.approx(0.5 * (WIDTH + SEAL), abs=20 * MICRON)
    assert line(cut).distance(Point(mouth)) < 20 * MICRON
    assert not film.contains(Point(mouth + 1e-4 * (mouth - pattern.intake.at)))
    # Between the welds an air path of the full width leads from the mouth into the balloon.
    free = film.difference(welds)
    widest = free.buffer(-0.5 * WIDTH + 20 * MICRON)
    air = [
        piece
        for piece in shapely.get_parts(widest)
        if piece.distance(Point(mouth)) < 0.5 * WIDTH + 20 * MICRON
    ]
    assert len(air) == 1
    inside = Polygon(seam.outer, seam.holes)
    core = inside.buffer(-0.5 * WIDTH + 10 * MICRON)
    assert core.is_empty or air[0].intersection(core).area > 0.0
    # Free film is the seam's inside, plus the neck and nothing else worth mentioning.
    neck = LineString([pattern.intake.at, mouth]).buffer(0.5 * WIDTH + SEAL)
    body = max(shapely.get_parts(free), key=lambda piece: piece.area)
    extra = body.difference(inside.buffer(30 * MICRON)).difference(neck)
    assert extra.area < 0.01 * inside.area
    assert inside.difference(body).area < 0.01 * inside.area


@pytest.mark.parametrize("name", NAMED)
def test_named_seams(name: str) -> None:
    pattern = build_pattern(NAMED[name], SEAL)
    assert len(pattern.warnings) <= (name == "neck")  # which of its equal halves is the roomier one is open
    assert_makeable(pattern, NAMED[name])
    assert len(pattern.of(Role.CUT_INNER)) == len(NAMED[name].holes)


def test_a_waist_narrower_than_the_intake_is_told() -> None:
    """The right half is the larger one, the intake at the left end."""
    halves = NAMED["neck"].outer * np.where(NAMED["neck"].outer[:, :1] > 0.0, 1.2, 1.0)
    right, left = (
        build_pattern(Outline(halves), SEAL, PatternOptions(intake_angle=angle)).warnings
        for angle in (0.0, np.pi)
    )
    assert not right
    assert len(left) == 1
    assert "narrows to 8" in left[0] or "narrows to 7.9" in left[0]


@pytest.mark.parametrize("seed", range(40))
def test_generated_seams(seed: int) -> None:
    seam = generated(seed)
    assert_makeable(build_pattern(seam, SEAL), seam)


def test_square_by_hand() -> None:
    """Side 300 without intake: seal 2.5 outside the seam, cut 7 outside it."""
    pattern = build_pattern(NAMED["square"], SEAL, PatternOptions(intake=False))
    assert [(contour.role, contour.closed) for contour in pattern.contours] == [
        (Role.SEAL, True),
        (Role.CUT, True),
    ]
    seal, cut = (np.sort(np.unique(contour.points.round(9))) for contour in pattern.contours)
    assert {-0.0025, 0.3025} <= set(seal.tolist())
    assert {-0.007, 0.307} <= set(cut.tolist())
    assert pattern.size == pytest.approx((0.314, 0.314))
    assert pattern.seam_length == pytest.approx(4 * 0.305)
    assert pattern.intake is None


def test_disc_with_intake_by_hand() -> None:
    pattern = build_pattern(NAMED["disc"], SEAL)
    intake = pattern.intake
    assert intake is not None
    assert intake.length == pytest.approx(0.030)
    assert np.degrees(intake.angle) == pytest.approx(-90.0)
    np.testing.assert_allclose(intake.at, [0.0, -0.15], atol=1e-12)
    assert pattern.size == pytest.approx((0.314, 0.157 + 0.18), abs=1e-4)
    # Once round, less the chord of the neck (15 mm between its seals), plus its two sides.
    radius = 0.1525
    gap = 2.0 * np.arcsin(0.0075 / radius)
    side = 0.18 - radius * np.cos(gap / 2.0)
    assert pattern.seam_length == pytest.approx((2.0 * np.pi - gap) * radius + 2.0 * side, rel=2e-4)


def test_ring_sizes() -> None:
    pattern = build_pattern(NAMED["ring"], SEAL)
    (inner,) = pattern.of(Role.CUT_INNER)
    assert np.linalg.norm(inner.points, axis=1) == pytest.approx(0.075 - 0.007, abs=20 * MICRON)
    closed = next(contour for contour in pattern.of(Role.SEAL) if contour.closed)
    assert np.linalg.norm(closed.points, axis=1) == pytest.approx(0.075 - 0.0025, abs=20 * MICRON)


def test_sharp_tip_is_opened_to_the_full_width() -> None:
    """The wedge is 15 degrees sharp: the neck reaches back to where it is 10 mm wide."""
    pattern = build_pattern(NAMED["wedge"], SEAL)
    assert_makeable(pattern, NAMED["wedge"])
    free = film_of(pattern).difference(welds_of(pattern))
    for x in np.linspace(-0.029, 0.06, 30):
        across = free.intersection(LineString([(x, -0.1), (x, 0.1)]))
        assert across.length >= WIDTH - 20 * MICRON


def test_the_neck_stays_in_a_tail_that_turns_away_from_the_centre() -> None:
    """The way straight back from the tip of the tail to the centre leads through the bay beside it."""
    s = np.linspace(0.0, 1.0, 60)
    back = np.stack([0.1 + 0.2 * s, 0.1 * s**2], axis=1)
    tail = np.concatenate([back, (back + np.stack([0.0 * s, 0.002 + 0.04 * (1.0 - s)], axis=1))[::-1]])
    seam = Outline(np.concatenate([polar(0.1, np.linspace(0.45, 2.0 * np.pi, 300)), tail]))
    pattern = build_pattern(seam, SEAL)
    assert pattern.intake is not None
    assert pattern.intake.at[0] > 0.29
    assert_makeable(pattern, seam)
    assert not pattern.of(Role.CUT_INNER)


@pytest.mark.parametrize("degrees", [0.0, 45.0, 90.0, 200.0, -60.0])
@pytest.mark.parametrize("name", ["disc", "flower", "square", "ring"])
def test_chosen_direction(name: str, degrees: float) -> None:
    pattern = build_pattern(
        NAMED[name], SEAL, PatternOptions(intake_angle=np.radians(degrees), intake_length=0.05)
    )
    assert pattern.intake is not None
    assert np.cos(pattern.intake.angle - np.radians(degrees)) == pytest.approx(1.0)
    assert pattern.intake.length == 0.05
    assert_makeable(pattern, NAMED[name])


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [0.0, 77.0, 190.0, 300.0])
def test_slanting_necks_are_right_or_refused(degrees: float) -> None:
    built = 0
    for seed in range(6):
        try:
            pattern = build_pattern(generated(seed), SEAL, PatternOptions(intake_angle=np.radians(degrees)))
        except InputError:
            continue
        assert_makeable(pattern, generated(seed))
        built += 1
    assert built >= 5


def test_an_intake_into_another_arm_is_refused() -> None:
    def u_shape(gap: float) -> Outline:
        left, right = 0.15 - 0.5 * gap, 0.15 + 0.5 * gap
        arms = [(0.3, 0.3), (right, 0.3), (right, 0.2), (left, 0.2), (left, 0.3), (0.0, 0.3)]
        return corners_of((0.0, 0.0), (0.3, 0.0), *arms)

    up = {"intake_angle": np.pi / 2.0, "intake_length": 0.08}
    with pytest.raises(InputError, match="another angle"):
        build_pattern(u_shape(0.014), SEAL, PatternOptions(**up))
    assert_makeable(build_pattern(u_shape(0.06), SEAL, PatternOptions(**up)), u_shape(0.06))


def test_a_ray_that_meets_nothing_is_refused() -> None:
    """The centre of a C lies outside it, and its opening has no outline."""
    turn = np.radians(np.linspace(30.0, 330.0, 200))
    shape = Outline(np.concatenate([polar(0.15, turn), polar(0.11, turn[::-1])]))
    with pytest.raises(InputError, match="no outline"):
        build_pattern(shape, SEAL, PatternOptions(intake_angle=0.0))


def test_weld_closing_a_bay_is_cut_like_a_hole() -> None:
    shape = corners_of(
        (0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.153, 0.2), (0.153, 0.15), (0.2, 0.15), (0.2, 0.05),
        (0.1, 0.05), (0.1, 0.15), (0.145, 0.15), (0.145, 0.2), (0.0, 0.2),
    )  # fmt: skip
    pattern = build_pattern(shape, SEAL)
    assert len(pattern.of(Role.CUT_INNER)) == 1
    assert_makeable(pattern, shape)


@pytest.mark.parametrize(
    ("radius", "seals", "cuts", "said"),
    [(0.012, 1, 1, None), (0.005, 1, 0, "not cut out"), (0.002, 1, 0, "too small")],
)
def test_small_holes(radius: float, seals: int, cuts: int, said: str | None) -> None:
    pattern = build_pattern(Outline(polar(0.15), (hole(radius, 0.05, 0.02),)), SEAL)
    assert len([contour for contour in pattern.of(Role.SEAL) if contour.closed]) == seals
    assert len(pattern.of(Role.CUT_INNER)) == cuts
    assert len(pattern.warnings) == (said is not None)
    if said:
        assert said in pattern.warnings[0]
        assert "(50, 20) mm" in pattern.warnings[0]


def test_balloon_thinner_than_its_intake() -> None:
    thin = corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.006), (0.0, 0.006))
    pattern = build_pattern(thin, SEAL, PatternOptions(intake_angle=0.0))
    assert len(pattern.warnings) == 1
    assert "narrower intake" in pattern.warnings[0]


def test_contours_start_away_from_corners() -> None:
    for name in ("square", "star", "L", "heart"):
        (cut,) = build_pattern(NAMED[name], SEAL).of(Role.CUT)
        back, ahead = cut.points[0] - cut.points[-1], cut.points[1] - cut.points[0]
        sine = (back[0] * ahead[1] - back[1] * ahead[0]) / np.linalg.norm(back) / np.linalg.norm(ahead)
        assert back @ ahead > 0.0
        assert abs(np.degrees(np.arcsin(sine))) < 25.0


@pytest.mark.parametrize(
    "options",
    [
        {"seal_width": 0.0},
        {"seal_width": np.nan},
        {"seal_width": SEAL, "allowance": -0.001},
        {"seal_width": SEAL, "intake_width": 0.0},
        {"seal_width": SEAL, "intake_length": 0.005},
        {"seal_width": SEAL, "intake_length": np.inf},
        {"seal_width": SEAL, "intake_angle": np.nan},
    ],
)
def test_senseless_values(options: dict[str, float]) -> None:
    with pytest.raises(InputError):
        build_pattern(NAMED["disc"], SEAL, PatternOptions(**options))


def test_crossing_seam() -> None:
    with pytest.raises(OutlineError, match=r"near \(\d"):
        build_pattern(corners_of((0.0, 0.0), (0.2, 0.2), (0.2, 0.0), (0.0, 0.21)), SEAL)


def test_simplified_within_ten_micrometres() -> None:
    dense = Outline(polar(0.15, np.linspace(0.0, 2.0 * np.pi, 20_000, endpoint=False)))
    (cut,) = build_pattern(dense, SEAL, PatternOptions(intake=False)).of(Role.CUT)
    assert len(cut.points) < 1000
    radii = np.linalg.norm(
        np.concatenate([cut.points, 0.5 * (cut.points + np.roll(cut.points, -1, axis=0))]), axis=1
    )
    assert np.abs(radii - 0.157).max() < 0.01e-3


def test_same_input_same_pattern() -> None:
    first, second = (build_pattern(generated(4), SEAL) for _ in range(2))
    assert [c.points.tobytes() for c in first.contours] == [c.points.tobytes() for c in second.contours]
