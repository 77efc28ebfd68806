# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel opens and closes while the window answers; test_paint_fish.py looks at a whole job."""

import FreeCADGui as Gui
import hands
import pytest
from brush import close_window, open_window
from heartbeat import Heartbeat

pytestmark = pytest.mark.works_out


@pytest.fixture
def beat():
    heart = Heartbeat()
    hands.wait(0.1)
    heart.reset()
    yield heart
    heart.stop()


def test_paint_window(doc, beat):
    for _ in range(2):
        open_window()
        hands.wait(0.1)
        close_window()
        hands.wait(0.1)
    assert beat.answers(), beat.most


@pytest.mark.slow
def test_panels(made, beat):
    """Those of the balloon, of what is seen of it, and of what is made with it."""
    Gui.Selection.addSelection(made.balloon)
    slow = {}
    for name in (
        "Advice",
        "ColourMap",
        "Animate",
        "ExportPattern",
        "Artwork",
        "Nest",
        "AssemblySheet",
        "ExportForWeb",
        "Study",
        "Compare",
        "Machines",
        "TestCard",
    ):
        beat.reset()
        Gui.runCommand(f"BalloonWorkbench_{name}")
        close(beat, name, slow)
    for name, obj in made._asdict().items():
        beat.reset()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        close(beat, name, slow)
    assert not slow


def close(beat, name, slow):
    """The panel that was opened; the longest work is kept where it was too long [s]."""
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.1)
    hands.leave()
    hands.wait_until(hands.panel_is_closed)
    if not beat.answers():
        slow[name] = beat.most
