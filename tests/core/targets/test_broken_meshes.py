# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged meshes become one closed body that can be divided, or are refused in one sentence."""

from __future__ import annotations

import numpy as np
import pytest
from broken_meshes import DAMAGES, broken_mesh

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.read_target import target_of


@pytest.mark.parametrize("number", [*range(len(DAMAGES)), 18, 30, 256])
def test_a_body_or_one_sentence(number: int) -> None:
    name, raw = broken_mesh(number)
    try:
        target = target_of(raw, name)
    except InputError as error:
        assert str(error).endswith("."), name
        return
    assert (target.twins >= 0).all(), name
    assert target.volume > 0.0, name
    if number in (2, 3, 18, 30, 256):
        made = divide(target, 6)
        assert len(made.names) == 6, name
        assert np.isfinite(made.target.points).all(), name
