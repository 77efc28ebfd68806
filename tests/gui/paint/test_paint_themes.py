# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window in themes that make frames transparent, words light, and chosen buttons like others."""

import sys
from pathlib import Path

import hands
import pytest
from brush import close_window, open_window

sys.path.append(str(Path(__file__).resolve().parents[2] / "users"))

from checks import contrast

from BalloonWorkbench.app.drawings.qt_picture import pixels

_THEME = """
QFrame { background: transparent }
QLabel { color: #f0f0f0 }
QToolButton { background: transparent; border: none }
"""


@pytest.fixture
def window(doc):
    application = hands.QtWidgets.QApplication.instance()
    before = application.styleSheet()
    application.setStyleSheet(_THEME)
    yield open_window()
    close_window()
    application.setStyleSheet(before)


def seen(widget):
    """What the screen shows of a widget (h, w, 3)."""
    hands.wait(0.3)
    place = hands.QtCore.QRect(widget.mapToGlobal(hands.QtCore.QPoint(0, 0)), widget.size())
    screen = hands.QtWidgets.QApplication.primaryScreen()
    return pixels(screen.grabWindow(0, *place.getRect()).toImage())[..., :3]


def test_the_question_for_the_width_can_be_read(window):
    window.card.ask(300.0)
    words = window.card.findChild(hands.QtWidgets.QLabel)
    assert contrast(seen(words)[2:-2, 2:-2]) > 4.5


def test_the_chosen_tool_is_seen(window):
    pen, brush = (hands.find(name) for name in ("PaintPen", "PaintBrush"))
    chosen, other = (seen(button)[:, :3].astype(int).mean(axis=(0, 1)) for button in (pen, brush))
    assert abs(chosen - other).max() > 20
