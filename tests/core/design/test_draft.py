# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick look at a balloon: as large as the drawing, and near the known and the fitted balloons.

BALLOON_DRAFTS sets how many generated outlines are compared with their fitted balloons (`make fuzz`: 25, and
all pictures and letters).
"""

import os
from functools import cache

import numpy as np
import pytest
from drawn_pictures import EXAMPLES
from drawn_shapes import LETTERS, NAMED, generated, letter

from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.draft import Draft, draft
from BalloonWorkbench.core.errors import Cancelled, MeshError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.job import Settings, design_outline
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import default_pattern
from BalloonWorkbench.core.readers.read import read_outline

FILM = film(DEFAULT_FILM)
PRESSURE = 2000.0
MANY = int(os.environ.get("BALLOON_DRAFTS", "0"))
NEAR = 0.1  # of the fitted balloon's volume and size
FITTED = 500  # vertices of the fitted balloon
ROUND_HOLES = 0.13  # of the thickness between holes, where so few triangles are too stiff
FEW = ("square", "star", "wedge", "ring")


def shapes() -> dict[str, Outline]:
    """What drafts are compared on, 0.25 m wide or so."""
    found = {name: NAMED[name] for name in (NAMED if MANY else FEW)}
    found |= {f"generated {seed}": generated(seed) for seed in range(MANY)}
    if MANY:
        found |= {name: letter(name) for name in LETTERS}
    pictures = [path for path in EXAMPLES if MANY or path.stem in ("fish", "rocket")]
    return found | {path.stem: read_outline(path, 0.25, None)[0] for path in pictures}


def disc(radius: float, count: int = 240) -> np.ndarray:
    turn = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(turn), np.sin(turn)])


def test_disc_is_nearly_the_mylar_balloon() -> None:
    """Paulsen, Amer. Math. Monthly 101 (1994): one of radius r is 1.1981 r thick and holds 2.7458 r^3."""
    radius = 0.15
    look = draft(Outline(disc(radius)), FILM, PRESSURE)
    positions = look.inflation.positions
    assert np.ptp(positions[:, 0]) == pytest.approx(2 * radius, rel=0.02)
    assert 2 * positions[:, 2].max() == pytest.approx(1.1981 * radius, rel=0.04)
    assert look.inflation.volume == pytest.approx(2.7458 * radius**3, rel=0.06)
    assert np.ptp(look.pattern.outer[:, 0]) == pytest.approx(1.3110 * 2 * radius, rel=0.04)


def test_look_lies_over_the_drawing() -> None:
    """The balloon has the middle and the size of the drawing's box; its panel is the drawing."""
    shape = np.array([[0.1, 0.2], [0.5, 0.2], [0.5, 0.3], [0.1, 0.4]])
    look = draft(Outline(shape), FILM, PRESSURE)
    flat = look.inflation.positions[:, :2]
    middle = 0.5 * (flat.min(axis=0) + flat.max(axis=0))
    assert middle == pytest.approx([0.3, 0.3], abs=0.01)
    assert np.ptp(flat, axis=0) == pytest.approx([0.4, 0.2], rel=0.02)
    panel = look.inflation.panel.rest_positions
    assert panel.min(axis=0) == pytest.approx([0.1, 0.2], abs=1e-3)
    assert panel.max(axis=0) == pytest.approx([0.5, 0.4], abs=1e-3)


def test_a_hole_stays_a_hole() -> None:
    look = draft(Outline(disc(0.15), (disc(0.06)[::-1],)), FILM, PRESSURE)
    inside = np.linalg.norm(look.inflation.panel.rest_positions, axis=1)
    assert inside.min() > 0.059
    assert len(look.pattern.holes) == 1


def test_a_line_is_no_balloon_yet() -> None:
    line = np.array([[0.0, 0.0], [0.3, 0.0], [0.3, 0.004], [0.0, 0.004]])
    with pytest.raises(MeshError, match="it is a line"):
        draft(Outline(line), FILM, PRESSURE)


def test_it_stops_when_told() -> None:
    with pytest.raises(Cancelled):
        draft(Outline(disc(0.15)), FILM, PRESSURE, progress=lambda fraction, text: False)


@cache
def pair(name: str) -> tuple[Draft, Design]:
    """The draft of a shape, and the balloon that is fitted to it."""
    outline = shapes()[name]
    mesh_size = size_for(outline.map(lambda loop: 1.28 * loop), FITTED)
    return draft(outline, FILM, PRESSURE), fit(outline, FILM, PRESSURE, mesh_size=mesh_size)


def measures(inflation) -> np.ndarray:
    """Volume, width, height, thickness."""
    return np.array([inflation.volume, *(np.ptp(inflation.positions, axis=0) * (1.0, 1.0, 2.0))])


@pytest.mark.slow
@pytest.mark.parametrize("name", shapes())
def test_a_draft_is_near_the_fitted_balloon(name: str) -> None:
    """So the numbers do not jump when it comes."""
    look, design = pair(name)
    share = measures(look.inflation) / measures(design.inflation) - 1.0
    most = np.array([NEAR, NEAR, NEAR, ROUND_HOLES if shapes()[name].holes else NEAR])
    assert (np.abs(share) < most).all(), dict(zip(("volume", "width", "height", "thickness"), share))


@pytest.mark.parametrize("name", ["square", "star", "fish", "rocket"])
def test_the_neck_is_where_the_fitted_balloon_has_it(name: str) -> None:
    look, design = pair(name)
    first, last = (default_pattern(seam, FILM).intake for seam in (look.pattern, design.pattern))
    assert first is not None
    assert last is not None
    middles = [
        0.5 * (seam.outer.min(axis=0) + seam.outer.max(axis=0)) for seam in (look.pattern, design.pattern)
    ]
    away = np.linalg.norm((first.at - middles[0]) - (last.at - middles[1]))
    assert away < 0.1 * max(shapes()[name].size)


@pytest.mark.parametrize("share", [-0.01, 0.01])
def test_an_end_that_becomes_a_little_shorter_keeps_the_neck(share: float) -> None:
    """Of ends that are about as far the lowest has it, whichever is a hair farther."""
    for name in ("square", "spiky", "flower", "disc"):
        plain = NAMED[name]
        points = plain.outer - plain.outer.mean(axis=0)
        turn = np.arctan2(points[:, 1], points[:, 0])
        other = Outline(points * (1.0 + share * np.cos(turn - 0.7))[:, None])
        one, two = (default_pattern(seam, FILM).intake for seam in (Outline(points), other))
        assert one is not None
        assert two is not None
        assert np.linalg.norm(one.at - two.at) < 0.05 * max(plain.size), name


def test_without_a_correction_the_drawing_is_the_pattern() -> None:
    outline = Outline(disc(0.15))
    look = draft(outline, FILM, PRESSURE, corrected=False)
    design = design_outline(outline, Settings(correct=False))
    assert look.pattern is outline
    assert measures(look.inflation) == pytest.approx(measures(design.inflation), rel=0.05)
