# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies stand upright in pictures: z is up in CAD, STL and 3MF, y in OBJ files."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from solids import ball

from BalloonWorkbench.core.pictures.bag_picture import upright
from BalloonWorkbench.core.targets.target import Division, Target


@pytest.mark.parametrize(
    ("source", "up"), [("Housing", 2), ("cow.stl", 2), ("cow.3mf", 2), ("cow.obj", 1), ("COW.OBJ", 1)]
)
def test_what_is_up(source: str, up: int) -> None:
    body = ball(count=4)
    target = Target(body.points, body.triangles, source)
    cuts = np.zeros((0, 2), dtype=np.int32)
    division = Division(target, np.zeros(len(body.triangles), dtype=np.int32), ("1",), cuts)
    places = np.eye(3)
    design: Any = SimpleNamespace(source=division, inflation=SimpleNamespace(positions=places))
    seen = upright(design)
    assert seen[:, 1].tolist() == places[:, up].tolist()
    assert np.linalg.det(seen) == pytest.approx(1.0), "turned, not mirrored"
