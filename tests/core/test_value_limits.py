# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever values are given: a balloon with finite numbers comes out, or a sentence that says what to do.

BALLOON_VALUES sets how many choices are tried (`make fuzz`: 1 000).
"""

from __future__ import annotations

import json
import math
import os
import random
import time
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import custom_film, film, with_grain
from BalloonWorkbench.core.job import Settings, make_balloon
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.marks import with_notches, with_tie_tab
from BalloonWorkbench.core.solver.model import Model

COUNT = int(os.environ.get("BALLOON_VALUES", "14"))
SECONDS = 60.0  # of processor time; a plain shell of two panels, corrected, takes 27

_EDGES = (
    0.0,
    -0.0,
    -1.0,
    5e-324,
    1e-30,
    1e-9,
    1e-3,
    1.0,
    1e3,
    1e9,
    1e30,
    1e308,
    math.inf,
    -math.inf,
    math.nan,
)


def near(draw: random.Random, usual: float) -> float:
    """The usual value, something around it, or something that no balloon has."""
    chance = draw.random()
    if chance < 0.88:
        return usual
    return usual * 10.0 ** draw.uniform(-3, 3) if chance < 0.94 else draw.choice(_EDGES)


def tried(draw: random.Random, drawing: Path) -> bool:
    """Whether these values make a balloon."""
    chosen = film("mylar")
    if draw.random() < 0.6:
        chosen = custom_film(near(draw, 4e9), near(draw, 0.3), near(draw, 25e-6), near(draw, 0.035))
    if draw.random() < 0.2:
        chosen = with_grain(chosen, near(draw, 2e9), near(draw, 0.5))
    width = near(draw, 0.12)
    mesh_size = 0.1 * width if 1e-3 <= width <= 100.0 else 0.012
    if draw.random() < 0.1:
        mesh_size = draw.choice(
            [size for size in _EDGES if not 1e-9 < size < 1.0]
        )  # no fine mesh: it takes a while
    settings = Settings(
        film=chosen,
        pressure=near(draw, 2000.0),
        mesh_size=mesh_size,
        correct=draw.random() < 0.1,
        volume=near(draw, 2e-4) if draw.random() < 0.1 else None,
        model=Model(draw.random() < 0.9, draw.random() < 0.9, near(draw, 1e-6), draw.random() < 0.1),
    )
    balloon = make_balloon(drawing, settings, width=width, height=None)
    seam = balloon.design.pattern
    pattern = build_pattern(
        seam,
        near(draw, 0.005),
        PatternOptions(
            allowance=near(draw, 0.002),
            intake_width=near(draw, 0.01),
            intake_length=near(draw, 0.02),
            intake_angle=near(draw, 1.0),
        ),
    )
    if draw.random() < 0.3:
        pattern = with_tie_tab(pattern, near(draw, 1.0))
        pattern = with_label(pattern, draw.choice(("", "Ab 1", "ü☺\n" * 9, "x" * 300)), near(draw, 0.006))
        pattern = with_notches(pattern, draw.choice((-1, 0, 1, 5, 10**6)), near(draw, 0.001))
    assert all(np.isfinite(contour.points).all() for contour in pattern.contours)
    json.dumps(balloon.report, allow_nan=False)
    return True


def test_no_value_does_more_than_complain(tmp_path: Path) -> None:
    drawing = tmp_path / "drawing.json"
    drawing.write_text('{"unit": "mm", "outer": [[0, 0], [120, 0], [120, 70], [60, 90], [0, 70]]}', "utf-8")
    made = 0
    for number in range(COUNT):
        began = time.process_time()
        try:
            made += tried(random.Random(number), drawing)
        except BalloonError as error:
            assert len(str(error)) > 30, str(error)
            assert "\n" not in str(error)
        except BaseException as error:
            error.add_note(f"values number {number}")
            raise
        assert time.process_time() - began < SECONDS, number
    assert 0.05 * COUNT < made < 0.9 * COUNT
