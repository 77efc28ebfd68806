# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users say of a picture: from where on it is drawn on, what is a hole or a line, how smooth it is."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_pictures import any_of, box, coloured, disc, drawn, ring

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.normals import turns
from BalloonWorkbench.core.options.drawing import TracingOptions
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.tracing.picture import STEP, placed_drawing
from BalloonWorkbench.core.tracing.segment import AUTO, SHAPE


def traced(pixels: np.ndarray, drawn_as: str = SHAPE, **options: float) -> Drawing:
    return placed_drawing(pixels, STEP, drawn_as, None, TracingOptions(**options))[0]


def two_tones() -> np.ndarray:
    """A dark body with a pale wing on white."""
    dark, pale = (
        drawn(box(40, 40, 120, 120), 240, 160, fine=2),
        drawn(box(120, 60, 200, 100), 240, 160, fine=2),
    )
    pixels = np.full((160, 240, 4), 255, np.uint8)
    pixels[dark > 0.5, :3] = 20
    pixels[(pale > 0.5) & (dark <= 0.5), :3] = 200
    return pixels


def test_a_threshold_leaves_out_what_is_pale() -> None:
    assert traced(two_tones()).size[0] == pytest.approx(160, abs=1.0)
    assert traced(two_tones(), threshold=0.5).size[0] == pytest.approx(80, abs=1.0)
    assert traced(two_tones(), threshold=0.1).size[0] == pytest.approx(160, abs=1.0)


def test_a_threshold_is_of_the_transparency_where_there_is_some() -> None:
    pixels = two_tones()
    pixels[..., 3] = 255 - pixels[..., 0]
    assert traced(pixels, threshold=0.1).size[0] == pytest.approx(160, abs=1.0)
    assert traced(pixels, threshold=0.6).size[0] == pytest.approx(80, abs=1.0)


def test_lines_are_filled_as_wide_as_is_said() -> None:
    """A mug's handle, 10 of 300 px wide: a line as usual, the rim of a hole where lines are thinner."""
    mug = coloured(drawn(any_of(disc(140, 200, 100), ring(270, 200, 65, 52)), 400, 400, fine=2))
    for width, holes in ((0.05, 0), (0.02, 1), (0.0, 1)):
        assert len(traced(mug, AUTO, line_width=width).largest.holes) == holes, width


def test_holes_count_from_a_size_on() -> None:
    """A tenth of the radius is a hundredth of the area."""
    plate = coloured(drawn(ring(200, 200, 150, 15), 400, 400, fine=3))
    for least, holes in ((0.005, 1), (0.02, 0), (0.0, 1)):
        assert len(traced(plate, smallest_hole=least).largest.holes) == holes, least
    tiny = coloured(drawn(ring(200, 200, 150, 5), 400, 400, fine=3))
    assert len(traced(tiny).largest.holes) == 0
    assert len(traced(tiny, smallest_hole=0.0).largest.holes) == 1


def test_what_no_picture_is_traced_with_is_refused() -> None:
    pixels = coloured(drawn(disc(50, 50, 30), 100, 100, fine=2))
    for name in ("threshold", "line_width", "smallest_hole", "smoothness"):
        for value in (-0.1, 1e9, float("nan")):
            with pytest.raises(InputError, match=name.replace("_", " ")):
                traced(pixels, **{name: value})


def test_a_small_hole_keeps_its_size_however_smooth() -> None:
    plate = coloured(drawn(ring(200, 200, 150, 15), 400, 400, fine=3))
    (hole,) = traced(plate, smoothness=20.0).largest.holes
    assert np.ptp(hole[:, 0]) == pytest.approx(30.0, abs=1.0)


def test_smoothing_takes_ripples_away_and_keeps_corners() -> None:
    def wavy(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return (x > 50) & (x < 350) & (y > 50) & (y < 200 + 4 * np.sin(x / 4))

    pixels = coloured(drawn(wavy, 400, 300, fine=3))
    waves = [
        np.abs(turns(traced(pixels, smoothness=smooth).largest.outer, 8.0)).sum()
        for smooth in (0.0, 1.0, 12.0)
    ]
    assert waves[2] < 0.4 * waves[1]
    box_of = traced(pixels, smoothness=12.0).size
    assert box_of == pytest.approx((300, 150), abs=8.0)
