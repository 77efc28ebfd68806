# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hand that is quicker than the window: a stroke keeps every place that the mouse passed through."""

import math
import time

import hands
import numpy as np
import pytest
from brush import close_window, on_screen, open_window
from player import Player

from BalloonWorkbench.gui.paint.painting.layers import SIDE

pytestmark = pytest.mark.works_out

Qt = hands.QtCore.Qt
_BUSY = 0.08  # s that the window is deaf at a time, as by a picture that it draws


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


@pytest.fixture
def player():
    hand = Player()
    yield hand
    hand.close()


@pytest.fixture
def deaf():
    """The window does something else nearly all the time."""
    timer = hands.QtCore.QTimer()
    timer.timeout.connect(lambda: time.sleep(_BUSY))
    timer.start(5)
    yield timer
    timer.stop()


def scribble(count):
    """Zigzag with loops, as a child fills an area."""
    turns = np.linspace(0.0, 14.0 * math.pi, count)
    return np.column_stack([0.3 + 0.4 * turns / turns[-1] + 0.06 * np.cos(turns), 0.5 + 0.2 * np.sin(turns)])


def test_no_place_of_a_quick_stroke_is_lost(window, player, deaf):
    places = scribble(160)
    player.play([on_screen(window.canvas, place) for place in places], 0.4)
    hands.wait_until(lambda: bool(window.painting.steps), 20)
    drawn = np.array(window.painting.steps[0].points)[:, :2] / SIDE
    away = np.linalg.norm(places[:, None] - drawn[None], axis=2).min(axis=1) * SIDE * window.canvas.paper.zoom
    assert away.max() <= 2.0, f"{len(drawn)} points of {len(places)}, up to {away.max():.1f} px away"


def test_the_mouse_is_as_before_when_the_window_is_closed(window):
    application, attribute = hands.QtWidgets.QApplication, Qt.AA_CompressHighFrequencyEvents
    assert not application.testAttribute(attribute)
    window.close()
    assert application.testAttribute(attribute)
    window.reveal()
    hands.wait(0.05)
    assert not application.testAttribute(attribute)
    close_window()
    hands.wait(0.05)
    assert application.testAttribute(attribute)
