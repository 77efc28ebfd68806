# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted balloon is shown first; what the document needs waits until the pen has rested."""

import hands
import pytest
from brush import close_window, draw, ellipse, is_closed, open_window, press
from pivy import coin

from BalloonWorkbench.core.arcs import fit_arcs
from BalloonWorkbench.core.design import fairing
from BalloonWorkbench.gui.paint.preview import requests

pytestmark = pytest.mark.works_out

_LONG = 45.0  # s


@pytest.fixture
def window(doc):
    yield open_window()
    close_window()


@pytest.fixture
def searches(monkeypatch):
    """The searches for arcs so far: they take most of the time of a pattern.

    But the fairing's: the error that is shown is that of the faired seam.
    """
    found, search, fit_curve = [], fit_arcs._fit, fit_arcs.fit_curve

    def searched(*arguments):
        found.append(arguments[0])
        return search(*arguments)

    def unrecorded(*arguments):
        count = len(found)
        curve = fit_curve(*arguments)
        del found[count:]
        return curve

    monkeypatch.setattr(fit_arcs, "_fit", searched)
    monkeypatch.setattr(fairing, "fit_curve", unrecorded)
    return found


@pytest.mark.slow
def test_no_arc_is_looked_for_before_the_fitted_balloon_is_shown(window, searches, monkeypatch):
    before, pause = [], requests.FullDesign._pause

    def shown(begin_full_design):
        before.append(len(searches))
        pause(begin_full_design)

    monkeypatch.setattr(requests.FullDesign, "_pause", shown)
    looks = []
    window.live.shown.connect(looks.append)
    egg = [(x + 0.3 * max(0.0, x - 0.5), y) for x, y in ellipse(0.5, 0.5, 0.31, 0.23)]
    draw(window.canvas, egg)
    hands.wait_until(window.live.is_settled, 60)
    assert before == [0]
    assert searches
    draft, *_, fitted, settled = looks
    assert not draft.fitted
    assert fitted.fitted
    assert fitted.solved is None
    assert settled.solved is not None
    assert settled.skins is fitted.skins
    assert settled.volume == fitted.volume
    cut = [max(abs(points).max() for role, points in look.contours if role == "CUT") for look in looks[-2:]]
    assert cut[0] == pytest.approx(cut[1], abs=0.2)  # mm: the same pattern, faired


@pytest.mark.slow
def test_make_it_does_not_wait_for_a_rest(window, monkeypatch):
    monkeypatch.setattr(requests, "_PAUSE", _LONG)
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.wait_until(window.live.is_fitted, 60)
    assert not window.live.is_settled()
    press("PaintMake")
    hands.wait_until(is_closed, 30)
    assert len(window.doc.Objects) >= 3


@pytest.mark.slow
def test_the_next_stroke_ends_a_study_that_rests(window, monkeypatch):
    monkeypatch.setattr(requests, "_PAUSE", _LONG)
    live = window.live
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.wait_until(live.is_fitted, 60)
    resting = live._full_design
    draw(window.canvas, ellipse(0.5, 0.7, 0.1, 0.2))
    assert live._full_design is not resting
    hands.wait_until(lambda: resting not in live._retired, 20)
    hands.wait_until(live.is_fitted, 60)


@pytest.mark.slow
def test_the_balloon_comes_with_the_next_frame_of_the_window(window):
    """Not with the one after it: each takes its time without a graphics card."""
    draw(window.canvas, ellipse(0.5, 0.5, 0.3, 0.2))
    hands.wait_until(window.live.is_fitted, 60)
    frames, rendered = [], []
    view = hands.Gui.activeDocument().activeView()
    callback = coin.SoCallback()
    callback.setCallback(
        lambda _, action: rendered.append(action.isOfType(coin.SoGLRenderAction.getClassTypeId()))
    )
    view.getSceneGraph().addChild(callback)

    def swapped():
        frames.append(any(rendered))

    def begin(_look):
        rendered.clear()
        frames.clear()

    surface = next(area.viewport() for area in views() if is_drawn_by_opengl(area.viewport()))
    hands.wait(0.3)
    hands.QtCore.QObject.connect(surface, hands.QtCore.SIGNAL("frameSwapped()"), swapped)
    window.live.shown.connect(begin)
    window._show(window.live.latest)
    begin(None)
    hands.wait_until(lambda: bool(frames), 10)
    assert frames[0]


def views():
    return hands.Gui.getMainWindow().findChildren(hands.QtWidgets.QAbstractScrollArea)


def is_drawn_by_opengl(widget):
    kind = widget.metaObject()
    while kind is not None and kind.className() != "QOpenGLWidget":
        kind = kind.superClass()
    return kind is not None
