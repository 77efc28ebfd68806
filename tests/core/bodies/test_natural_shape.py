# SPDX-License-Identifier: LGPL-2.1-or-later
"""The natural shape against its published numbers."""

import numpy as np
import pytest

from BalloonWorkbench.core.bodies.natural_shape import natural_shape
from BalloonWorkbench.core.geometry.polyline import length


def test_natural_shape_has_its_published_numbers() -> None:
    """Half angle at the bottom 50.149 degrees; volume, height and radius for gores of length 1."""
    line = natural_shape(2.0).points / 2.0
    r, z = line.T
    widest = int(np.argmax(r))
    below = length(line[: widest + 1])
    volume = np.pi * float(np.sum(0.5 * (r[1:] ** 2 + r[:-1] ** 2) * np.diff(z)))
    assert length(line) == pytest.approx(1.0, rel=1e-9)
    assert np.degrees(np.arctan2(r[1], z[1])) == pytest.approx(50.14926, abs=1e-3)
    assert volume == pytest.approx(0.126055, rel=1e-4)
    assert z[-1] == pytest.approx(0.64390, rel=1e-4)
    assert r[widest] == pytest.approx(0.32701, rel=1e-4)
    assert below == pytest.approx(0.5531, abs=2e-3)
    assert r[0] == r[-1] == 0.0
