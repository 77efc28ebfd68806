# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hand on the tab of flat pieces: opens it, clicks and drags in it."""

import brush
import hands
import numpy as np

from BalloonWorkbench.gui.pattern_view import tab as tabs

Kind, Qt = hands.QtCore.QEvent, hands.QtCore.Qt


def open_tab(obj):
    tab = hands.open_flat(obj, "PatternView", tabs._tabs)
    hands.wait(0.2)
    return tab


def click(tab, place):
    """A click at a place of the pieces [m], once the tab has its size."""
    settled(tab)
    there, view = at(tab, place), tab.view.viewport()
    assert view.rect().contains(there.toPoint())
    brush.mouse_at(view, Kind.MouseMove, there, Qt.NoButton, Qt.NoButton)
    brush.mouse_at(view, Kind.MouseButtonPress, there)
    brush.mouse_at(view, Kind.MouseButtonRelease, there, held=Qt.NoButton)
    hands.wait(0.05)


def middle(edge):
    return 0.5 * (edge.line[0] + edge.line[-1])


def lit(tab):
    return len(tab.view.scene()._lit)


def settled(tab):
    """Wait until the tab has its size."""
    size = None
    while size != tab.view.size():
        size = tab.view.size()
        hands.wait(0.1)


def at(tab, place):
    """Where a place of the pieces (2,) m is in the view, as a point of the mouse."""
    return hands.QtCore.QPointF(tab.view.place_of(np.asarray(place)))


def drag(tab, start, end, modifiers=Qt.NoModifier, let_go=True):
    """Press at a point of the view, move to another one, and let go."""
    view, steps = tab.view.viewport(), 6
    brush.mouse_at(view, Kind.MouseMove, start, Qt.NoButton, Qt.NoButton)
    brush.mouse_at(view, Kind.MouseButtonPress, start)
    for step in range(1, steps + 1):
        there = start + (end - start) * step / steps
        brush.mouse_at(view, Kind.MouseMove, there, Qt.NoButton, modifiers=modifiers)
        hands.wait(0.02)
    if let_go:
        brush.mouse_at(view, Kind.MouseButtonRelease, end, held=Qt.NoButton, modifiers=modifiers)
        hands.wait(0.05)


def key(tab, code, text="", modifiers=Qt.NoModifier):
    """A key that goes down and comes up."""
    brush.key(tab.view, code, text, modifiers)
    event = hands.QtGui.QKeyEvent(Kind.KeyRelease, code, modifiers, text)
    hands.QtWidgets.QApplication.sendEvent(tab.view, event)
    hands.wait(0.05)
