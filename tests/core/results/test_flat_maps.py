# SPDX-License-Identifier: LGPL-2.1-or-later
"""A result as a picture of a flat panel."""

import numpy as np
import pytest

from BalloonWorkbench.core.results.colour_map import colours
from BalloonWorkbench.core.results.flat_maps import flat_map

POINTS = np.array([[1.0, 2.0], [1.2, 2.0], [1.2, 2.1], [1.0, 2.1]])


def test_values_lie_where_they_belong():
    triangles = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)
    values = np.array([0.0, 1.0, 1.0, 0.0])  # grows with x
    picture = flat_map(POINTS, triangles, values[triangles])
    height, width = picture.pixels.shape[:2]
    assert (width, height) == (400, 200)
    assert picture.low == pytest.approx([1.0, 2.0])
    assert picture.high == pytest.approx([1.2, 2.1])
    assert (picture.pixels[..., 3] == 255).all()
    for column in (0, 100, 399):
        wanted = colours(np.array((column + 0.5) / 400)).astype(int)
        assert np.abs(picture.pixels[:, column, :3].astype(int) - wanted).max() <= 1


def test_the_first_row_is_the_upper_one_and_the_rest_is_clear():
    picture = flat_map(POINTS, np.array([[0, 1, 2]], dtype=np.int32), np.ones((1, 3)))
    assert picture.pixels[0, 0, 3] == 0
    assert picture.pixels[-1, 10, 3] == 255
    mirrored = picture.mirrored().moved(np.array([5.0, 0.0]))
    assert mirrored.low == pytest.approx([3.8, 2.0])
    assert mirrored.high == pytest.approx([4.0, 2.1])
    assert mirrored.pixels[-1, -11, 3] == 255
