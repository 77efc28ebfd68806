# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way of the work in the window: each stroke, button and value makes once what it needs."""

import hands
import pytest
from brush import close_window, fish_body, is_closed, open_window, press
from counting import counted

from BalloonWorkbench.app.border import status

pytestmark = pytest.mark.works_out

ONCE = {"trace": 1, "design": 1, "pattern": 1, "report": 1}


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


@pytest.mark.slow
def test_a_painted_balloon_is_made_once(window):
    """Fitted while the pen rests; what goes into the document was worked out before."""
    with counted() as done:
        fish_body(window)
        hands.wait_until(window.live.is_settled, 60)
        assert done == ONCE
        press("PaintSizeDone") if window.card.isVisible() else None
        hands.wait_until(window.live.is_settled, 60)
        press("PaintMake")
        hands.wait_until(is_closed, 60)
        hands.leave()
    assert done == ONCE
    assert [obj.Status for obj in window.doc.Objects if hasattr(obj, "Status")] == [status.READY] * 3


def test_a_panel_makes_what_is_changed_once(made):
    with counted() as done:
        made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
        hands.wait_until(hands.panel_is_seen)
        hands.wait(0.5)
        assert not done["trace"] + done["design"] + done["report"]
        assert done["pattern"] <= 1  # for what it takes to make it, in a file that was just opened
        done.clear()
        hands.type_into(hands.find("Pressure"), "2.4 kPa")
        hands.press("Ok")
        hands.wait_until(hands.panel_is_closed, 60)
    assert made.balloon.ActivePressure.Value == pytest.approx(2.4)
    assert done["design"] == done["report"] == 1
    assert not done["trace"]
    assert done["pattern"] <= 1
