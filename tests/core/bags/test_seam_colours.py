# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of seams are told apart, with and without all cones of the eye."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from BalloonWorkbench.core.bags.seam_colours import seam_colour, seam_rgb
from BalloonWorkbench.core.types import Floats

#: Machado, Oliveira and Fernandes 2009, severity 1: how linear colours look without one kind of cone.
EYES = {
    "all": np.eye(3),
    "no red": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "no green": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "no blue": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
_TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def seen(number: int, eye: str) -> Floats:
    """CIELAB of a seam's colour, as an eye sees it."""
    colour = np.array(seam_rgb(number))
    linear = np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
    x, y, z = _TO_XYZ @ np.clip(EYES[eye] @ linear, 0.0, 1.0) / (0.9505, 1.0, 1.089)
    fx, fy, fz = (np.cbrt(v) if v > 216 / 24389 else (24389 / 27 * v + 16) / 116 for v in (x, y, z))
    return np.array([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)])


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("start", [1, 13, 37])
def test_twelve_seams_are_told_apart(eye: str, start: int) -> None:
    colours = [seen(number, eye) for number in range(start, start + 12)]
    assert min(np.linalg.norm(one - other) for one, other in combinations(colours, 2)) > 12.0


def test_colours_stand_out_from_paper_and_come_once() -> None:
    assert all(seen(number, "all")[0] < 80.0 for number in range(1, 61))
    assert len({seam_colour(number) for number in range(1, 61)}) == 60
