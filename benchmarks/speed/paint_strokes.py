# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a stroke takes to become a balloon; runs in FreeCAD's window, `strokes.py` starts it.

From the moment the button of the X server's mouse comes up to the end of the frame in which the 3D view shows
the balloon of the painting as it is then: of a draft, and of the fitted one. The first strokes come as soon
as the window is there. Written to build/bench/strokes$SUITE.json.
"""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

sys.path[:0] = ["tests/gui", "tools"]

import fish_painting as fish  # noqa: E402 - its folder has just become known
from brush import on_screen  # noqa: E402
from player import Player  # noqa: E402

_PATIENCE = 20.0  # s for one stroke
_QUIET = (0.4, 1.2)  # s between a fitted balloon and the next stroke, in turn: the study may still be at work
_WAY = 0.2  # s of the hand from the button that opens the window to the paper
_BEAT = 10  # ms between two looks at what has come


def _ellipse(x, y, a, b):
    return [(x + a * u, y + b * v) for u, v in fish.circle(0.0, 0.0, 1.0, 60)]


_HEART = fish.curve(
    (0.5, 0.35), (0.62, 0.2), (0.8, 0.25), (0.82, 0.45), (0.5, 0.85), (0.18, 0.45), (0.2, 0.25), (0.38, 0.2),
    (0.5, 0.35),
)  # fmt: skip
_STAR = fish.curve(
    *((0.5 + r * x, 0.5 + r * y) for (x, y), r in zip(fish.circle(0, 0, 1.0, 10), [0.4, 0.2] * 5 + [0.4])),
    count=8,
)
_WAVE = fish.curve((0.15, 0.5), (0.3, 0.35), (0.45, 0.6), (0.6, 0.35), (0.75, 0.6), (0.88, 0.45))
_SCRIBBLE = fish.curve(*((0.2 + 0.05 * k, 0.3 if k % 2 else 0.62) for k in range(12)), count=6)
_SNAKE = fish.curve((0.1, 0.2), (0.5, 0.15), (0.85, 0.25), (0.5, 0.45), (0.15, 0.6), (0.5, 0.8), (0.9, 0.75))

#: What is drawn, one after the other: name, tool, colour, width [px], places on the paper, seconds of the
#: stroke; a name alone is a button. The fish of the examples, then other shapes, quick and small ones.
STROKES = (
    ("rim of the fish", "Pen", fish.BODY, 16, fish.RIM, 1.2),
    ("line of its tail", "Pen", fish.BODY, 12, fish.TAIL_LINE, 0.3),
    *(
        (f"fill {number}", "Fill", colour, 0, [(x, y)], 0.05)
        for number, (x, y, colour) in enumerate(fish.FILLS, 1)
    ),
    *(
        (f"stripe {number}", "Brush", fish.STRIPE, 38, places, 0.3)
        for number, places in enumerate(fish.STRIPES, 1)
    ),
    ("mouth", "Pen", fish.DARK, 10, fish.MOUTH, 0.15),
    ("fin", "Brush", fish.FIN, 60, fish.curve((0.42, 0.3), (0.36, 0.14), (0.5, 0.1), (0.55, 0.28)), 0.3),
    ("bitten off", "Eraser", fish.FIN, 60, fish.curve((0.96, 0.15), (0.88, 0.28), (0.97, 0.36)), 0.2),
    ("clear",),
    ("heart", "Pen", fish.STRIPE, 14, _HEART, 0.8),
    (
        "small heart beside it",
        "Pen",
        fish.BODY,
        14,
        [(0.7 + 0.25 * x, 0.7 + 0.25 * y) for x, y in _HEART],
        0.3,
    ),
    ("clear",),
    ("quick ellipse", "Pen", fish.BELLY, 10, _ellipse(0.45, 0.5, 0.3, 0.2), 0.25),
    ("second ellipse", "Pen", fish.FIN, 10, _ellipse(0.86, 0.5, 0.08, 0.2), 0.2),
    ("clear",),
    ("star", "Pen", fish.BODY, 12, _STAR, 0.8),
    ("clear",),
    ("wave", "Brush", fish.BODY, 80, _WAVE, 0.4),
    ("quick scribble on it", "Brush", fish.FIN, 80, _SCRIBBLE, 0.3),
    ("clear",),
    ("snake", "Brush", fish.BODY, 110, _SNAKE, 0.6),
    ("its head", "Brush", fish.STRIPE, 200, [(0.88, 0.74), (0.9, 0.76)], 0.1),
    ("clear",),
    ("dot", "Brush", fish.BODY, 200, [(0.5, 0.5), (0.55, 0.5)], 0.1),
)


class _Screen:
    """When the view shows the balloon of the painting as it is.

    draft, fitted  (time.monotonic(), processor time of this process) at the end of the first frame with it;
                   None as long as there is none
    changed        the same when the window had the whole stroke
    """

    def __init__(self, window):
        from pivy import coin

        from BalloonWorkbench.gui.qt import QtWidgets

        self._window = window
        self._rendered = False
        window.painting.changed.connect(self._changed)
        self.reset()
        view = Gui.activeDocument().activeView()
        callback = coin.SoCallback()
        callback.setCallback(self._render)
        view.getSceneGraph().addChild(callback)
        area = next(
            widget
            for widget in Gui.getMainWindow().findChildren(QtWidgets.QAbstractScrollArea)
            if hasattr(widget, "viewport") and "QOpenGLWidget" in _ancestry(widget.viewport())
        )
        self._surface = area.viewport()
        QtCore.QObject.connect(self._surface, QtCore.SIGNAL("frameSwapped()"), self._swapped)

    def reset(self):
        self.draft = self.fitted = self.changed = None
        self.before = self._window.painting.revision

    def _changed(self):
        self.changed = _now()

    def _render(self, _data, action):
        from pivy import coin

        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self._rendered = True

    def _swapped(self):
        if not self._rendered:
            return  # another part of the window was drawn
        self._rendered = False
        window = self._window
        look, now = window.live.latest, window.painting.revision
        if window.hand.stroke is not None or now == self.before or look is None or look.revision != now:
            return
        self.draft = self.draft or _now()
        if window.live.is_fitted():
            self.fitted = self.fitted or _now()


def _ancestry(widget):
    kind, names = widget.metaObject(), []
    while kind is not None:
        names.append(kind.className())
        kind = kind.superClass()
    return names


def _wait(condition, seconds=_PATIENCE):
    """Let the window live until something is so, with its own loop of events."""
    loop, end = QtCore.QEventLoop(), time.monotonic() + seconds
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: loop.quit() if condition() or time.monotonic() > end else None)
    timer.start(_BEAT)
    (loop.exec if hasattr(loop, "exec") else loop.exec_)()
    timer.stop()


def _pause(seconds):
    end = time.monotonic() + seconds
    _wait(lambda: time.monotonic() >= end)


def _now():
    """The clock and the processor time of this process [s]."""
    return time.monotonic(), time.process_time()


def _measure():
    from BalloonWorkbench.gui.paint import window as paint_window

    App.newDocument("Strokes")
    player = Player()
    Gui.runCommand("BalloonWorkbench_Paint")
    window = paint_window._open[0]
    _wait(lambda: window.canvas.isVisible() and window.canvas.width() > 300)
    screen, canvas, rows = _Screen(window), window.canvas, []
    for name, *stroke in STROKES:
        _pause(_QUIET[len(rows) % len(_QUIET)] if rows else _WAY)
        if not stroke:
            window.act("clear")
            continue
        tool, colour, width, places, seconds = stroke
        window.choose(_tool(tool))
        window.extras.colour(colour)
        window.hand.set_thickness(max(1, round(width / (window.hand.tool.widening or 1.0))))
        screen.reset()
        player.play([on_screen(canvas, place) for place in places], seconds)
        _wait(player.has_played)
        _wait(lambda: screen.fitted is not None)
        row = {"stroke": name}
        for what in ("draft", "fitted"):
            shown = getattr(screen, what)
            row[what] = shown and shown[0] - player.released
            row[f"{what}_work"] = shown and shown[1] - screen.changed[1]
        rows.append(row)
        if window.card.isVisible():
            window.card.answer()
    player.close()
    window.finish()
    return rows


def _tool(name):
    from BalloonWorkbench.gui.paint.painting.tools import TOOLS

    return next(tool for tool in TOOLS if tool.name == name.lower())


def _run():
    path = Path(f"build/bench/strokes{os.environ.get('SUITE', '')}.json")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    try:
        Gui.activateWorkbench("BalloonWorkbench")
        path.write_text(json.dumps(_measure(), indent=1), encoding="utf-8")
    finally:
        if not path.exists():
            traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)


QtCore.QTimer.singleShot(0, _run)
