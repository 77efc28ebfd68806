# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the intake sits: the coach and the pattern agree, and the low place is one that carries.

BALLOON_INTAKES sets in how many steps the symmetric shapes are turned (`make fuzz`: 24, and all pictures).
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import LETTERS, NAMED, TURN, generated, letter, oriented, polar

from BalloonWorkbench.core.advice.advise import advise
from BalloonWorkbench.core.advice.findings import RepairKind
from BalloonWorkbench.core.advice.gauge import Gauge
from BalloonWorkbench.core.advice.places import whole
from BalloonWorkbench.core.advice.subject import Subject
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.options.pattern import FARTHEST, LOW, PatternOptions
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.intake.places import PLACES
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Intake
from BalloonWorkbench.core.readers.read import read_outline

FILM = film("mylar")
STEPS = int(os.environ.get("BALLOON_INTAKES", "1"))
PICTURES = sorted(Path("resources/examples/pictures").glob("*.png"))
FEW = [path for path in PICTURES if path.stem == "heart"]
WIDTH = 0.010


class Unmoved(Gauge):
    """Of a balloon whose seam lies where it was drawn."""

    def __init__(self) -> None:
        pass

    def drawn(self, place: np.ndarray) -> np.ndarray:
        return place


def outline_of(*areas: shapely.Geometry) -> Outline:
    area = shapely.union_all(areas)
    holes = tuple(oriented(np.array(ring.coords)[:-1], False) for ring in area.interiors)
    return Outline(oriented(np.array(area.exterior.coords)[:-1]), holes)


def both(*points: tuple[float, float]) -> list[shapely.Geometry]:
    """A polygon and its mirror image."""
    return [shapely.Polygon(points), shapely.Polygon([(-x, y) for x, y in points])]


def disc(x: float, y: float, radius: float) -> shapely.Geometry:
    return shapely.Point(x, y).buffer(radius, quad_segs=24)


#: Symmetric about the y axis, 250 to 300 mm large.
SYMMETRIC = {
    "dumb-bell": outline_of(disc(-0.1, 0.0, 0.05), disc(0.1, 0.0, 0.05), shapely.box(-0.1, -0.02, 0.1, 0.02)),
    "cat": outline_of(disc(0.0, 0.0, 0.1), *both((0.09, 0.03), (0.085, 0.15), (0.02, 0.08))),
    "pumpkin": outline_of(
        *(disc(x, 0.0, 0.07) for x in (-0.08, 0.0, 0.08)), shapely.box(-0.01, 0.05, 0.01, 0.11)
    ),
    "egg": Outline(polar(0.12 * (1.0 + 0.25 * np.sin(TURN) ** 3))),
    "heart": NAMED["heart"],
    "star": NAMED["star"],
    "ring": NAMED["ring"],
    "bowl": outline_of(disc(0.0, 0.0, 0.12).difference(disc(0.0, -0.16, 0.07))),
    "feet": outline_of(disc(0.0, 0.0, 0.1), *both((0.03, 0.0), (0.03, -0.16), (0.07, -0.16), (0.07, 0.0))),
}
#: Those whose lowest part lies on the axis.
ON_AXIS = ("cat", "pumpkin", "egg", "heart", "ring")


def turned(outline: Outline, degrees: float) -> Outline:
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return outline.map(lambda loop: loop @ np.array([[cos, sin], [-sin, cos]]))


def intake_of(outline: Outline, wanted: PatternOptions) -> Intake:
    found = make_pattern(outline, FILM.seal_width, wanted).intake
    assert found is not None
    return found


def coached(outline: Outline, wanted: PatternOptions) -> np.ndarray:
    """Where the coach sees the intake."""
    subject = Subject(outline, FILM, Unmoved(), False, faired_seam(outline), wanted)
    return subject.intakes(subject.wish)[0]


def agreed(outline: Outline) -> None:
    for place in PLACES:
        wanted = PatternOptions(intake_place=place)
        assert coached(outline, wanted) == pytest.approx(intake_of(outline, wanted).at, abs=1e-9), place


@pytest.mark.parametrize("name", SYMMETRIC if STEPS > 8 else ("dumb-bell", "star"))
def test_coach_and_pattern_agree_on_turned_symmetric_shapes(name: str) -> None:
    for degrees in 30.0 + 360.0 / STEPS * np.arange(STEPS):
        agreed(turned(SYMMETRIC[name], degrees))


@pytest.mark.parametrize("name", LETTERS if STEPS > 8 else LETTERS[:1])
def test_coach_and_pattern_agree_on_letters(name: str) -> None:
    agreed(letter(name))


@pytest.mark.parametrize("path", PICTURES if STEPS > 8 else FEW, ids=lambda path: path.stem)
def test_coach_and_pattern_agree_on_pictures(path: Path) -> None:
    agreed(read_outline(path, 0.3)[0])


@pytest.mark.parametrize("name", SYMMETRIC if STEPS > 8 else ("dumb-bell", "cat", "egg", "heart"))
def test_farthest_of_a_symmetric_shape_is_on_its_axis_or_left_of_it(name: str) -> None:
    """None is farther from the centre; of two mirror images the left is taken, of a wide end its middle."""
    outline = SYMMETRIC[name]
    intake = intake_of(outline, PatternOptions())
    away = np.hypot(*(outline.outer - np.asarray(whole(outline).centroid.coords[0])).T)
    at = intake.at - np.asarray(whole(outline).centroid.coords[0])
    assert np.hypot(*at) == pytest.approx(away.max(), rel=2e-3)
    assert intake.at[0] < 1e-4
    mirrored = turned(outline, 0.0).map(lambda loop: loop[::-1] * [-1.0, 1.0])
    assert intake_of(mirrored, PatternOptions()).at == pytest.approx(intake.at, abs=5e-4)


def carries(outline: Outline, intake: Intake) -> None:
    """As low as a place can be behind which a disc of the intake's width fits, and pointing down."""
    inside = whole(outline)
    wide = inside.buffer(-0.5 * WIDTH)
    assert wide.distance(shapely.Point(intake.at)) < 1.71 * WIDTH
    assert np.sin(intake.angle) < -0.5
    ahead = np.array([np.cos(intake.angle), np.sin(intake.angle)])
    neck = shapely.LineString([intake.at + 0.007 * ahead, intake.at + intake.length * ahead])
    assert not neck.buffer(0.5 * WIDTH, cap_style="flat").intersects(inside)


@pytest.mark.parametrize("name", ON_AXIS)
def test_low_place_of_a_symmetric_shape_is_on_its_axis(name: str) -> None:
    outline = SYMMETRIC[name]
    intake = intake_of(outline, PatternOptions(intake_place=LOW))
    carries(outline, intake)
    assert intake.at[0] == pytest.approx(0.0, abs=1e-5)
    assert np.degrees(intake.angle) == pytest.approx(-90.0, abs=3.0)
    assert intake.at[1] < outline.outer[:, 1].min() + 0.02 * max(outline.size)


def test_low_place_is_the_middle_of_the_left_one_of_two_feet() -> None:
    intake = intake_of(SYMMETRIC["feet"], PatternOptions(intake_place=LOW))
    assert intake.at == pytest.approx([-0.05, -0.16], abs=1e-3)
    assert np.degrees(intake.angle) == pytest.approx(-90.0)


def test_low_place_is_below_the_centre_of_a_level_bottom() -> None:
    """A trapezium with sides a, b from x = 0 on: its centre is at (a^2 + a b + b^2) / (3 (a + b))."""
    a, b = 0.3, 0.1
    shape = outline_of(shapely.Polygon([(0.0, 0.0), (a, 0.0), (b, 0.2), (0.0, 0.2)]))
    intake = intake_of(shape, PatternOptions(intake_place=LOW))
    assert intake.at == pytest.approx([(a * a + a * b + b * b) / (3.0 * (a + b)), 0.0], abs=1e-6)


def test_low_place_is_in_no_notch_and_on_no_thin_part() -> None:
    """A disc with a slot from below, beside it a leg of 5 mm: the places lowest of all are refused."""
    slot = shapely.Polygon([(0.0, 0.0), (-0.006, -0.2), (0.006, -0.2)])
    leg = shapely.box(0.05, -0.15, 0.055, 0.0)
    shape = outline_of(disc(0.0, 0.0, 0.1).difference(slot).union(leg))
    intake = intake_of(shape, PatternOptions(intake_place=LOW))
    carries(shape, intake)
    assert -0.102 < intake.at[1] < -0.09
    assert abs(intake.at[0]) > 0.009


def test_low_place_keeps_clear_of_welds() -> None:
    """A weld down the middle of a disc: the place straight below is refused, as a disc does not fit there."""
    shape = Outline(polar(0.1), welds=(np.array([[0.0, 0.05], [0.0, -0.1]]),))
    intake = intake_of(shape, PatternOptions(intake_place=LOW))
    assert 0.4 * WIDTH < abs(intake.at[0]) < 0.03


def test_each_chamber_has_its_low_place() -> None:
    shape = Outline(polar(0.1), welds=(np.array([[0.0, 0.1], [0.0, -0.1]]),))
    pattern = make_pattern(
        shape, FILM.seal_width, PatternOptions(intake_place=LOW, intake_length=0.05, allowance=0.0)
    )
    assert sorted(np.sign(intake.at[0]) for intake in pattern.intakes) == [-1.0, 1.0]


def test_low_place_of_generated_shapes_carries() -> None:
    count = 0
    for seed in range(5 * STEPS):
        shape = generated(seed)
        try:
            intake = intake_of(shape, PatternOptions(intake_place=LOW))
        except InputError as error:
            assert "choose" in str(error)
            continue
        if whole(shape).buffer(-0.5 * WIDTH).distance(shapely.Point(intake.at)) < 1.71 * WIDTH:
            carries(shape, intake)
            count += 1
    assert count >= 2 * STEPS


def test_unknown_place_is_refused() -> None:
    with pytest.raises(InputError, match="farthest or low"):
        make_pattern(NAMED["disc"], FILM.seal_width, PatternOptions(intake_place="high"))


def test_intake_on_an_ear_gets_a_hint_and_a_low_place() -> None:
    """An ear of 45 degrees is a fifth as thick as the head within 15 % of the size."""
    (hint,) = [found for found in advise(SYMMETRIC["cat"], FILM).findings if found.rule == "delicate_intake"]
    assert hint.place == pytest.approx((-0.085, 0.15), abs=2e-3)
    assert hint.repair is not None
    assert hint.repair.kind is RepairKind.LOWER_INTAKE
    assert hint.repair.points[0] == pytest.approx([0.0, -0.1], abs=1e-3)


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("pumpkin", PatternOptions()),
        ("egg", PatternOptions()),
        ("heart", PatternOptions()),
        ("cat", PatternOptions(intake_place=LOW)),
        ("cat", PatternOptions(intake_angle=1.0)),
        ("cat", PatternOptions(intake=False)),
    ],
)
def test_no_hint_without_a_reason(name: str, wanted: PatternOptions) -> None:
    rules = {found.rule for found in advise(SYMMETRIC[name], FILM, options=wanted).findings}
    assert not rules & {"delicate_intake", "hidden_intake"}


def test_the_usual_place_is_the_farthest() -> None:
    assert PatternOptions().intake_place == FARTHEST
