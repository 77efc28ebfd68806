# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that mean something are told apart by every eye, and what is written can be read on its ground."""

from __future__ import annotations

from itertools import combinations

import pytest
from eyes import EYES, apart, contrast, nearest, rgb

from BalloonWorkbench.core.as_made import comparison_picture
from BalloonWorkbench.core.assembly_sheet import pen, work_figures
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.pictures import cards, preview

_APART = 10.0  # in CIELAB: told apart at a glance, also as thin lines
_TEXT, _LINES = 4.5, 3.0  # contrasts that WCAG 2.1 asks for: 1.4.3 and 1.4.11

#: The colours of one picture, or side by side in one.
TOGETHER = {
    "preview": [preview._DRAWING, preview._BALLOON, preview._UNREACHED, preview._CREASES],
    "comparison": [
        getattr(comparison_picture, f"_{name}") for name in ("EXPECTED", "SEEN", "MORE", "LESS", "FARTHEST")
    ],
    "work": [work_figures._WATER, work_figures._TUBE, work_figures._BORE],
}

#: These follow the palette of laser programs, which go by the colour. A notch is a short tick across the rim
#: and a weld a long line inside; text and print are no lines.
ALIKE = {frozenset((Role.WELD, Role.NOTCH))}


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("name", TOGETHER)
def test_what_stands_side_by_side_is_told_apart(name: str, eye: str) -> None:
    assert nearest([rgb(colour) for colour in TOGETHER[name]], eye) > _APART


@pytest.mark.parametrize("eye", EYES)
def test_layers_are_told_apart(eye: str) -> None:
    alike = [
        (one, other)
        for one, other in combinations(LAYERS, 2)
        if apart(rgb(LAYERS[one].rgb), rgb(LAYERS[other].rgb), eye) <= _APART
        and frozenset((one, other)) not in ALIKE
    ]
    assert not alike


@pytest.mark.parametrize(
    ("ink", "ground"),
    [
        *((ink, ground) for ink in (cards.INK, cards.SOFT) for ground in (cards.PAPER, cards.CARD)),
        (preview._PARTLY, cards.CARD),
        *((ink, ground) for ink in (pen.INK, pen.SOFT, pen.ACCENT) for ground in ("#ffffff", pen.BAND)),
    ],
)
def test_texts_can_be_read(ink: str, ground: str) -> None:
    assert contrast(rgb(ink), rgb(ground)) >= _TEXT


@pytest.mark.parametrize(
    "line",
    [preview._DRAWING, preview._BALLOON, preview._CREASES, *TOGETHER["comparison"]],  # yellow has a dark rim
)
def test_lines_stand_out_from_their_card(line: str) -> None:
    assert contrast(rgb(line), rgb(cards.CARD)) >= _LINES
