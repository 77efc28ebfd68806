# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles from JSON, SVG and DXF files; and what is none."""

import json
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from profiles import PROFILES, profile_json, sphere

from BalloonWorkbench.core.bodies.check_profile import CAP_RADIUS, checked_profile, with_ends
from BalloonWorkbench.core.bodies.drawn_profile import profile_of_lines
from BalloonWorkbench.core.bodies.profile import DISC, OPEN, POINT
from BalloonWorkbench.core.bodies.read_profile import profile_of_json, read_profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.types import Floats

HALF = 0.1 * np.array([(np.cos(t), np.sin(t)) for t in np.linspace(-0.5 * np.pi, 0.5 * np.pi, 61)])


def text(**data: object) -> bytes:
    return json.dumps({"unit": "mm", **data}).encode()


@pytest.mark.parametrize("name", PROFILES)
def test_a_profile_comes_back_from_its_text(name: str) -> None:
    profile = PROFILES[name]()
    again = profile_of_json(profile_json(profile))
    assert again is not None and (again.lower, again.upper) == (profile.lower, profile.upper)
    assert again.points == pytest.approx(profile.points, abs=1e-7)


def test_json_in_any_unit_and_direction() -> None:
    inches = profile_of_json(text(unit="in", profile=[[0, 10], [3, 5], [0, 0]]))
    assert inches is not None and inches.points[1] == pytest.approx([0.0762, 0.127])
    assert inches.points[0, 1] == 0.0 and (inches.lower, inches.upper) == (POINT, POINT)
    unnamed = profile_of_json(b'{"profile": [[0, 0], [30, 50], [0, 90]]}')
    assert unnamed is not None and "millimetres" in unnamed.notes[0]


def test_other_json_is_no_profile() -> None:
    assert profile_of_json(text(outer=[[0, 0], [1, 0], [0, 1]])) is None
    assert profile_of_json(b"[1, 2]") is None


def test_natural_shape_by_the_length_of_its_gores() -> None:
    profile = profile_of_json(text(natural_shape=2000))
    assert profile is not None and profile.points[-1, 1] == pytest.approx(2.0 * 0.64390, rel=1e-4)


def test_ends_that_run_square_to_the_axis_are_discs() -> None:
    drum = checked_profile(np.array([(0.0, 0.0), (0.2, 0.0), (0.2, 0.5), (0.0, 0.5)]))
    assert (drum.lower, drum.upper) == (DISC, DISC) and len(drum.points) == 2
    gores_over_the_end = checked_profile(
        np.array([(0.0, 0.0), (0.2, 0.0), (0.2, 0.5), (0.0, 0.5)]), POINT, POINT
    )
    assert len(gores_over_the_end.points) == 4


def test_a_disc_cuts_off_a_point() -> None:
    capped = with_ends(sphere(0.5), DISC, "auto")
    assert (capped.lower, capped.upper) == (DISC, POINT)
    assert capped.points[0, 0] == pytest.approx(CAP_RADIUS)
    assert with_ends(capped, OPEN, "auto").lower == OPEN


@pytest.mark.parametrize(
    ("points", "ends", "sentence"),
    [
        ([(0.0, 0.0)], (), "at least two points"),
        ([(0.0, 0.0), (np.nan, 1.0)], (), "at least two points"),
        ([(0.1, 0.0), (-0.1, 0.2), (0.0, 0.4)], (), "other side of its axis"),
        ([(0.1, 0.1), (0.1, 0.1)], (), "Give it a size"),
        ([(0.1, 0.0), (0.1, 4e5)], (), "Give it a size"),
        ([(0.0, 0.0), (0.0, 0.4)], (), "lies on its axis"),
        ([(0.0, 0.0), (0.2, 0.0)], (), "no balloon is so flat"),
        ([(0.0, 0.0), (0.2, 0.0005), (0.0, 0.001)], (), "no balloon is so flat"),
        ([(0.0, 0.0), (0.2, 0.2), (0.0, 0.3), (0.2, 0.5), (0.0, 0.7)], (), "touches its axis"),
        ([(0.0, 0.0), (0.3, 0.1), (0.3, 0.4), (0.1, 0.0), (0.0, 0.6)], (), "crosses or touches itself"),
        ([(0.1, 0.0), (0.1, 0.4)], (POINT,), "away from the axis"),
        ([(0.0, 0.0), (0.02, 0.2), (0.0, 0.4)], (DISC,), "too slender for a disc"),
        ([(0.1, 0.0), (0.1, 0.4)], ("ring",), "Use one of"),
    ],
)
def test_what_is_no_profile_is_refused(
    points: list[tuple[float, float]], ends: tuple[str, ...], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        checked_profile(np.array(points), *ends)


@pytest.mark.parametrize(
    "data",
    [
        text(profile=[[0, 0]]),
        text(profile=[[0, 0], [1]]),
        text(profile=[[0, 0], [True, 1]]),
        text(profile={"a": 1}),
        text(profile=[[0, 0], [1e400, 1]]),
        text(unit="furlong", profile=[[0, 0], [10, 20]]),
        text(natural_shape="long"),
        text(natural_shape=-3),
        b'{"profile": [[0, 0], [NaN, 1]]}',
        b'{"profile": ',
    ],
)
def test_damaged_json_is_refused(data: bytes) -> None:
    with pytest.raises(InputError):
        profile_of_json(data)


def closed(line: Floats) -> Floats:
    return np.concatenate([line, line[:1]])


@pytest.mark.parametrize("turned", [False, True])
def test_a_closed_half_outline_has_its_axis_on_its_left(turned: bool) -> None:
    loop = np.roll(HALF + np.array([0.3, 0.7]), 17, axis=0)
    profile = profile_of_lines([closed(loop[::-1] if turned else loop)])
    assert profile.points == pytest.approx(HALF + np.array([0.0, 0.7]), abs=1e-9)


def test_an_open_half_outline_with_an_axis_beside_it() -> None:
    axis = np.array([(0.3, 0.4), (0.3, 1.0)])
    profile = profile_of_lines([axis, HALF[10:-10] + np.array([0.3, 0.7])])
    assert profile.points == pytest.approx(HALF[10:-10] + np.array([0.0, 0.7]), abs=1e-9)
    assert (profile.lower, profile.upper) == (DISC, DISC)


def test_an_open_line_alone_begins_at_the_axis_or_at_its_leftmost_point() -> None:
    shifted = HALF[10:] + np.array([0.2, 0.0])
    assert profile_of_lines([shifted], axis=0.2).points[0, 0] == pytest.approx(HALF[10, 0])
    assert profile_of_lines([shifted]).points[:, 0].min() == 0.0


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        ([], "no line"),
        ([closed(np.array([(np.cos(t), np.sin(t)) for t in np.arange(0.0, 6.2, 0.1)]))], "axis is missing"),
        ([HALF, HALF + np.array([0.5, 0.0])], "lines beside the axis"),
        (
            [closed(np.array([(0.0, 0.0), (0.2, 0.1), (0.0, 0.2), (0.0, 0.3), (0.2, 0.4), (0.0, 0.5)]))],
            "more than once",
        ),
    ],
)
def test_drawings_without_a_profile_are_refused(lines: list[Floats], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        profile_of_lines(lines)


def test_profiles_from_files(tmp_path: Path) -> None:
    svg = tmp_path / "ball.svg"
    svg.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="300mm" viewBox="0 0 200 300">'
        '<path fill="none" stroke="black" d="M 20 50 A 100 100 0 0 1 20 250 Z"/></svg>'
    )
    dxf = tmp_path / "ball.dxf"
    document = ezdxf.new(units=4)
    document.modelspace().add_arc((0.0, 150.0), 100.0, -90.0, 90.0)
    document.saveas(dxf)
    (tmp_path / "ball.json").write_bytes(profile_json(sphere(0.1)))
    for name in ("ball.svg", "ball.dxf", "ball.json"):
        profile = read_profile(tmp_path / name)
        assert profile is not None and (profile.lower, profile.upper) == (POINT, POINT)
        assert profile.points[:, 0].max() == pytest.approx(0.1, rel=1e-3)
        assert np.ptp(profile.points[:, 1]) == pytest.approx(0.2, rel=1e-3)
        assert (again := read_profile(tmp_path / name, DISC)) is not None and again.lower == DISC
    (tmp_path / "ball.txt").write_text("hello")
    assert read_profile(tmp_path / "ball.txt") is None


@pytest.mark.parametrize("turned", [0, 2])
def test_a_profile_that_is_closed_along_its_axis_is_opened_there(turned: int) -> None:
    corners = np.roll([(0.0, 0.0), (0.1, 0.05), (0.1, 0.15), (0.0, 0.2)], turned, axis=0)
    closed = np.concatenate([corners, corners[:1]])
    profile = checked_profile(closed)
    assert profile.points[[0, -1]] == pytest.approx(np.array([(0.0, 0.0), (0.0, 0.2)]))
    assert len(profile.points) == 4
    with pytest.raises(InputError, match="closed line"):
        checked_profile(closed + np.array([0.1, 0.0]))
