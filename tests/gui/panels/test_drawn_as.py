# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel and the paint window offer how a picture is read, and show what comes of it."""

import sys
from pathlib import Path

import pytest

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.gui.paint.form import PaintForm
from BalloonWorkbench.gui.panels.balloon.file_box import FileBox
from BalloonWorkbench.gui.panels.balloon.pattern_box import PatternBox

sys.path.append(str(Path(__file__).parents[2] / "core"))
import drawn_pictures as pictures


@pytest.fixture
def parts(doc, tmp_path):
    mug = pictures.any_of(pictures.disc(140, 200, 100), pictures.ring(270, 200, 65, 52))
    file = tmp_path / "mug.png"
    file.write_bytes(pictures.png(pictures.coloured(pictures.drawn(mug, 400, 400, fine=2))[..., :3]))
    made = create.make(doc)
    set_drawing(made.outline, file)
    doc.recompute([made.outline])
    return made


def choose(combo, title):
    combo.setCurrentIndex(combo.findData(title))
    combo.activated.emit(combo.currentIndex())


def test_the_panel_tells_of_the_hole_and_has_it_back(parts):
    box = FileBox(parts.outline)
    box.refresh()
    assert "filled shape" in box.notes.text()
    heard = []
    box.changed.connect(lambda: heard.append(parts.outline.DrawnAs))
    choose(box.fields.widget("DrawnAs"), "Filled shape")
    assert heard == ["Filled shape"]
    parts.outline.Document.recompute([parts.outline])
    box.refresh()
    assert "holes: 1" in box.notes.text()
    assert "filled shape" not in box.notes.text()
    box.release()


def test_the_panel_offers_the_low_place_while_the_place_is_found(parts):
    box = PatternBox(parts.pattern)
    box.refresh()
    combo = box.fields.widget("IntakeAutoPlace")
    assert not combo.isHidden()
    choose(combo, "Low")
    assert parts.pattern.IntakeAutoPlace == "Low"
    parts.pattern.IntakeAuto = False
    box.refresh()
    assert combo.isHidden()
    box.release()


def test_the_paint_window_offers_it(parts):
    form, heard = PaintForm(300.0), []
    form.read_as.connect(heard.append)
    choose(form.drawn_as, "shape")
    assert heard == ["shape"]
    form.show_drawn_as("pen")
    assert form.drawn_as.currentData() == "pen"
