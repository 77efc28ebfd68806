# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fins and sheets are told, round bodies are not."""

from __future__ import annotations

from pathlib import Path

import pytest
from solids import ball, box, torus

from BalloonWorkbench.core.segmentation.thin_parts import thin_notes, thin_share
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Target

MESHES = Path(__file__).parents[2] / "resources" / "meshes"


@pytest.mark.parametrize("target", [ball(), torus(), box(), read_target(MESHES / "spot.obj", width=0.3)])
def test_thick_bodies(target: Target) -> None:
    assert thin_notes(target) == ()


def test_a_sheet_is_thin_but_at_its_rim() -> None:
    """All of both faces but for a rim as wide as a part may be thin: 0.035 of a square of 1."""
    share = thin_share(box((1.0, 1.0, 0.03), 20))
    assert share == pytest.approx(2.0 / (2.0 + 4.0 * 0.03), abs=0.02)


def test_fins_are_told() -> None:
    assert "thinner than" in thin_notes(read_target(MESHES / "fish.obj", width=0.3))[0]
