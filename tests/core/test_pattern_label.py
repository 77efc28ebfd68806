# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels: outlines of the right height, in the film, away from welds and holes."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.pattern import Pattern, Role


def labelled(name: str, text: str, height: float = 0.006) -> Pattern:
    return with_label(build_pattern(NAMED[name], 0.005), text, height)


def test_letters_have_their_height_and_holes() -> None:
    pattern = labelled("disc", "HOB")
    loops = [contour.points for contour in pattern.of(Role.ENGRAVE)]
    assert len(loops) == 3 + 1 + 2  # the O has one hole, the B two
    tall = max(loops, key=lambda loop: np.ptp(loop[:, 1]))
    assert np.ptp(tall[:, 1]) == pytest.approx(0.006, rel=0.05)
    assert all(contour.closed for contour in pattern.of(Role.ENGRAVE))
    assert pattern.contours[-1].role is Role.CUT


@pytest.mark.parametrize("name", ["ring", "holes", "heart"])
def test_text_is_on_free_film(name: str) -> None:
    pattern = labelled(name, "fish 300 mm", 0.004)
    text = shapely.MultiPoint(np.concatenate([contour.points for contour in pattern.of(Role.ENGRAVE)]))
    (cut,) = pattern.of(Role.CUT)
    assert shapely.Polygon(cut.points).contains(text)
    for hole in pattern.of(Role.CUT_INNER):
        assert not shapely.Polygon(hole.points).intersects(text.convex_hull)
    for seal in pattern.of(Role.SEAL):
        assert shapely.LineString(seal.points).distance(text.convex_hull) > 0.0


def test_what_cannot_be_written() -> None:
    assert not labelled("disc", "  ").of(Role.ENGRAVE)
    with pytest.raises(InputError, match="shorter"):
        labelled("S", "a text that is far too long", 0.01)
    with pytest.raises(InputError, match="60"):
        labelled("disc", "x" * 61)


def test_same_label_same_outlines() -> None:
    first, second = (labelled("disc", "Bö") for _ in range(2))
    assert all(
        np.array_equal(a.points, b.points) for a, b in zip(first.contours, second.contours, strict=True)
    )
