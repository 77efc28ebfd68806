# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a picture is read is a property of the outline: a thin handle is filled with a word, and had back."""

import sys
from pathlib import Path

import pytest

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import DRAWN_AS, read_all, set_drawing

sys.path.append(str(Path(__file__).parents[2] / "core"))
import drawn_pictures as pictures


@pytest.fixture
def outline(doc, tmp_path):
    mug = pictures.any_of(pictures.disc(140, 200, 100), pictures.ring(270, 200, 65, 52))
    file = tmp_path / "mug.png"
    file.write_bytes(pictures.png(pictures.coloured(pictures.drawn(mug, 400, 400, fine=2))[..., :3]))
    made = create.make(doc).outline
    set_drawing(made, file)
    doc.recompute([made])
    return made


def test_a_filled_hole_is_told_and_had_back(outline):
    assert outline.HoleCount == 0
    (note,) = [note for note in outline.Notes if "filled shape" in note]
    assert note.startswith("1 hole ")
    outline.DrawnAs = "Filled shape"
    outline.Document.recompute([outline])
    assert outline.HoleCount == 1
    assert not [note for note in outline.Notes if "filled" in note]
    outline.DrawnAs = "Pen drawing"
    outline.Document.recompute([outline])
    assert outline.HoleCount == 0


def test_the_shape_lies_in_the_picture_as_it_is_read(outline):
    """The handle's right end is at 335 of 400 px, the body's left at 40."""
    for choice in DRAWN_AS:
        outline.DrawnAs = choice
        drawing = read_all(outline)[0]
        (left, _), (right, _) = drawing.canvas
        whole, wide = right - left, drawing.size[0]
        assert (-left / whole, (wide - left) / whole) == pytest.approx((0.1, 0.8375), abs=0.003)
