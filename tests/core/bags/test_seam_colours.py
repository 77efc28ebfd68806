# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of seams are told apart, with and without all cones of the eye."""

from __future__ import annotations

import pytest
from eyes import EYES, lab, nearest

from BalloonWorkbench.core.bags.seam_colours import seam_colour, seam_rgb


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("start", [1, 13, 37])
def test_twelve_seams_are_told_apart(eye: str, start: int) -> None:
    assert nearest([seam_rgb(number) for number in range(start, start + 12)], eye) > 12.0


def test_colours_stand_out_from_paper_and_come_once() -> None:
    assert all(lab(seam_rgb(number))[0] < 80.0 for number in range(1, 61))
    assert len({seam_colour(number) for number in range(1, 61)}) == 60
