# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture wrapped round a balloon of many panels: each panel has the part of it that is seen there."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from BalloonWorkbench.core.artwork.picture import Pixels
from BalloonWorkbench.core.artwork.sheet import Sheet
from BalloonWorkbench.core.artwork.wrap import faces_away, wrapped
from BalloonWorkbench.core.bag_job import FinishedBags, Settings, make_bags
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.products import Artwork, bag_print
from BalloonWorkbench.core.units import INCH

EXAMPLES = Path(__file__).parents[3] / "resources" / "examples"
GORES = 6
DPI = 40.0


@pytest.fixture(scope="module")
def ball() -> FinishedBags:
    settings = Settings(correct=False, pressure=500.0, mesh_size=0.03, body=BodyOptions(gores=GORES))
    return make_bags(EXAMPLES / "profiles" / "sphere.json", settings)


@pytest.fixture(scope="module")
def cube() -> FinishedBags:
    return make_bags(EXAMPLES / "bags" / "cube.json", Settings(correct=False, mesh_size=0.02))


def coloured(values: np.ndarray) -> Pixels:
    """Pixels (h, w, 4) whose red is 100 times and a bit the value (h, w)."""
    return np.dstack([values, 0 * values, 0 * values, 0 * values + 255]).astype(np.uint8)


def middle(sheet: Sheet, number: int, count: int, across: float = 0.0) -> int:
    """Red in the middle of a panel by its number, so far to the right of it [m]."""
    borders = sheet.pattern.of(Role.PRINT)
    assert len(borders) == count
    low, high = bounds(borders[number].points)
    x, y = (0.5 * (low + high) + (across, 0.0) - sheet.origin) * DPI / INCH
    return int(sheet.pixels[len(sheet.pixels) - 1 - int(y), int(x), 0])


def test_gores_have_the_picture_one_after_the_other(ball: FinishedBags) -> None:
    """A step of red for each gore: each is printed with its own, to both of its seams."""
    picture = coloured(np.tile(np.repeat(10 + 30 * np.arange(GORES), 50), (200, 1)))
    sheet = bag_print(ball, Artwork(picture, dpi=DPI))[2]
    for number in range(GORES):
        for across in (-0.1, 0.0, 0.1):
            assert middle(sheet, number, GORES, across) == pytest.approx(10 + 30 * number, abs=2)


def test_a_picture_goes_once_round_a_body(ball: FinishedBags) -> None:
    """At its widest place it is as long as the balloon is round, and as high as that is."""
    films, low, size = wrapped(ball.designs[0], range(GORES))
    positions = ball.designs[0].inflation.positions
    assert size[0] == pytest.approx(2.0 * np.pi * np.linalg.norm(positions[:, :2], axis=1).max())
    assert size[1] == pytest.approx(np.ptp(positions[:, 2]))
    seen = np.concatenate([film.seen[film.triangles.ravel()] for film in films])
    assert seen[:, 0].min() == pytest.approx(0.0, abs=0.02 * size[0])
    assert seen[:, 0].max() == pytest.approx(size[0], abs=0.02 * size[0])
    assert seen[:, 1].min() == pytest.approx(low[1], abs=1e-9)


def test_a_box_has_it_on_what_faces_the_viewer_and_another_behind(cube: FinishedBags) -> None:
    """The first panel of the file faces up, the second away: from there the other picture reads right."""
    design = cube.designs[0]
    assert faces_away(design, [0, 1]).tolist() == [False, True]
    ramp = np.tile(np.linspace(0, 200, 200), (200, 1))
    sheet = bag_print(cube, Artwork(coloured(ramp), back=coloured(200 + 0 * ramp), dpi=DPI))[2]
    left, right = (middle(sheet, 0, 6, across) for across in (-0.05, 0.05))
    assert right - left == pytest.approx(200 * 0.1 / np.ptp(design.inflation.positions[:, 0]), abs=15)
    assert middle(sheet, 1, 6) == 200


def test_a_letter_has_the_picture_where_it_was_drawn(tmp_path: Path) -> None:
    """Front and back of a banded shape carry its left and its right half."""
    path = tmp_path / "bar.json"
    path.write_text('{"unit": "mm", "outer": [[0, 0], [200, 0], [200, 100], [0, 100]]}', encoding="utf-8")
    settings = Settings(correct=False, mesh_size=0.015, side_band=BandOptions(band=0.04))
    bags = make_bags(path, settings)
    halves = np.where(np.arange(200) < 100, 20, 220)
    sheet = bag_print(bags, Artwork(coloured(np.tile(halves, (100, 1))), dpi=DPI))[2]
    count = len(bags.parts[0].patterns.panels)
    assert [middle(sheet, 0, count, across) for across in (-0.05, 0.05)] == [20, 220]
    assert [middle(sheet, 1, count, across) for across in (-0.05, 0.05)] == [220, 20], "seen from behind"
