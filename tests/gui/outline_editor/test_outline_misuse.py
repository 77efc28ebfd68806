# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of an outline with two hands at once, and over pictures that were changed or turned."""

import hands
import numpy as np
import pytest
from drawn_pictures import any_of, coloured, disc, drawn, png, ring, turned_jpeg
from outline_hands import drag, highest, key, open_in_panel, open_tab, press

from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.core.units import from_mm

Kind, Qt = hands.QtCore.QEvent, hands.QtCore.Qt


def test_another_button_does_not_leave_a_node_at_the_mouse(made):
    tab = open_tab(made.outline)
    top = highest(tab)
    drag(tab, top, (0, -30), let_go=False)
    press(tab, Kind.MouseButtonPress, top, Qt.LeftButton | Qt.MiddleButton, (0, -30), Qt.MiddleButton)
    press(tab, Kind.MouseButtonRelease, top, Qt.MiddleButton, (0, -30))
    assert len(made.outline.OutlineEdits) == 1
    press(tab, Kind.MouseButtonRelease, top, Qt.NoButton, (0, -30), Qt.MiddleButton)
    once = highest(tab)
    press(tab, Kind.MouseMove, once, Qt.NoButton, (0, -20), Qt.NoButton)
    assert tab.view.is_settled
    drag(tab, once, (0, -30), let_go=False)  # where it is let go the window is not told
    press(tab, Kind.MouseMove, once, Qt.NoButton, (0, -40), Qt.NoButton)
    press(tab, Kind.MouseMove, once, Qt.NoButton, (0, -60), Qt.NoButton)
    assert tab.view.is_settled
    assert np.allclose(highest(tab), once)


@pytest.mark.parametrize("symmetry", ["Off", "Forced"])
def test_keys_wait_until_a_node_is_let_go(made, symmetry):
    made.outline.Symmetry = symmetry
    made.outline.Document.recompute([made.outline])
    tab = open_tab(made.outline)
    top, names = highest(tab), list(made.outline.Document.UndoNames)
    drag(tab, top, (0, -30), let_go=False)
    for code, modifier in (
        (Qt.Key_Delete, Qt.NoModifier),
        (Qt.Key_Z, Qt.ControlModifier),
        (Qt.Key_Tab, Qt.NoModifier),
    ):
        key(tab, code, modifier)
    assert list(made.outline.Document.UndoNames) == names
    press(tab, Kind.MouseButtonRelease, top, Qt.NoButton, by=(0, -30))
    hands.wait(0.05)
    assert from_mm(20 / tab.view.zoom) < highest(tab)[1] - top[1] < from_mm(31 / tab.view.zoom)
    assert len(made.outline.OutlineEdits) == 1


def test_what_is_dragged_goes_back_when_the_document_changes(made):
    tab = open_tab(made.outline)
    drag(tab, highest(tab), (0, -30))
    once = highest(tab)
    drag(tab, once, (0, -30), let_go=False)
    made.outline.Document.undo()
    hands.wait_until(lambda: not np.allclose(highest(tab), once), 5)
    press(tab, Kind.MouseMove, once, by=(0, -50))
    press(tab, Kind.MouseButtonRelease, once, Qt.NoButton, by=(0, -50))
    assert not made.outline.OutlineEdits
    assert made.outline.Document.RedoNames  # nothing new was done
    assert tab.view.is_settled


def blue(tab):
    """Where the picture below the outline is blue: shares of its box (x, y), from the upper left."""
    picture = tab.view._picture.toImage()
    width, height = picture.width(), picture.height()
    at = [(x, y) for x in range(0, width, 4) for y in range(0, height, 4)]
    at = [each for each in at if picture.pixelColor(*each).blue() > picture.pixelColor(*each).red() + 60]
    return np.array(at).reshape(-1, 2) / (width, height)


def test_a_photograph_lies_upright_below_its_outline(made, tmp_path):
    """The camera was turned by a quarter: the file says which side is up."""
    cv2 = pytest.importorskip("cv2")
    shape = any_of(disc(45, 50, 40), disc(45, 100, 25))
    plain = coloured(drawn(shape, 120, 220, fine=3))[..., :3]
    _, data = cv2.imencode(".jpg", np.ascontiguousarray(np.rot90(plain)[..., ::-1]))
    path = tmp_path / "photo.jpg"
    path.write_bytes(turned_jpeg(data.tobytes(), 6))
    set_drawing(made.outline, path)
    made.outline.Document.recompute([made.outline])
    tab = open_tab(made.outline)
    box = tab.view._picture_box
    points = np.concatenate([loop.points for loop in tab.state.nodes.loops]) * 1000
    seen = blue(tab)
    low, high = points.min(axis=0), points.max(axis=0)
    assert box.left() + seen[:, 0].min() * box.width() == pytest.approx(low[0], abs=0.05 * box.width())
    assert box.left() + seen[:, 0].max() * box.width() == pytest.approx(high[0], abs=0.05 * box.width())
    assert box.bottom() - seen[:, 1].min() * box.height() == pytest.approx(high[1], abs=0.05 * box.height())
    assert box.height() > box.width()


def test_a_picture_of_other_colours_is_shown(made, tmp_path):
    tab = open_tab(made.outline)
    assert len(blue(tab))
    shape = any_of(ring(150, 90, 80, 30), disc(215, 150, 32))
    other = tmp_path / "other.png"
    other.write_bytes(png(coloured(drawn(shape, 300, 200, fine=3), (200, 60, 30))[..., :3]))
    set_drawing(made.outline, other)
    made.outline.Document.recompute([made.outline])
    hands.wait_until(lambda: not len(blue(tab)), 5)


@pytest.mark.slow
def test_steps_of_a_panel_end_with_it(doc, tmp_path):
    """Ctrl+Z in a later panel does not reach back into an earlier one."""
    tab = open_in_panel(doc, tmp_path)
    drag(tab, highest(tab), (0, -30))
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    hands.wait(0.2)
    edits = list(doc.Outline.OutlineEdits)
    assert edits
    doc.Balloon.ViewObject.doubleClicked()
    hands.wait_until(hands.panel_is_seen)
    tab.undo()
    assert list(doc.Outline.OutlineEdits) == edits
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
