# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many pictures a second the tab of flat pieces shows; runs in FreeCAD's window.

A balloon of 60 gores: the view is pulled, a gore is dragged and an edge is picked, with mouse events each of
which is waited for until it is on the screen. Times in ms are written to
build/bench/pulls$SUITE.json.

tools/in-window.sh build/bench/freecad benchmarks/speed/pattern_pulls.py
"""

import json
import os
import statistics
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore

sys.path[:0] = ["tests/gui", "tools"]

import brush  # noqa: E402 - its folder has just become known
import hands  # noqa: E402

GORES, _STEPS = 60, 80
_KEPT = Path("build/bench/gores.FCStd")
Kind, Qt = QtCore.QEvent, QtCore.Qt


def _balloon():
    if _KEPT.exists():
        return App.openDocument(str(_KEPT))
    from BalloonWorkbench.app.document import create

    doc = App.newDocument("Gores")
    create.balloon_from_profile(
        doc, None, values={"gores": GORES, "gore_length": "1500 mm", "mesh_size": "20 mm"}
    )
    _KEPT.parent.mkdir(parents=True, exist_ok=True)
    doc.saveAs(str(_KEPT))
    return doc


class _Paints(QtCore.QObject):
    """Counts how often a widget is painted."""

    def __init__(self, widget):
        super().__init__(widget)
        self.count = 0
        widget.installEventFilter(self)

    def eventFilter(self, _widget, event):  # noqa: N802 - Qt calls it so
        self.count += event.type() == Kind.Paint
        return False


def _on_screen(view, paints) -> None:
    """What has changed is painted, and the X server has it."""
    app, before, end = hands.QtWidgets.QApplication.instance(), paints.count, time.perf_counter() + 1.0
    while paints.count == before and time.perf_counter() < end:
        app.processEvents()
    app.primaryScreen().grabWindow(view.viewport().winId(), 0, 0, 1, 1)


def _dragged(view, paints, start, button) -> list[float]:
    """Milliseconds of each step of a drag round a circle."""
    import math

    port, times = view.viewport(), []
    brush.mouse_at(port, Kind.MouseButtonPress, start, button, button)
    for step in range(1, _STEPS + 1):
        angle = 2.0 * math.pi * step / _STEPS
        at = start + QtCore.QPointF(150.0 * math.sin(angle), 150.0 * (1.0 - math.cos(angle)))
        begun = time.perf_counter()
        brush.mouse_at(port, Kind.MouseMove, at, Qt.NoButton, button)
        _on_screen(view, paints)
        times.append(1e3 * (time.perf_counter() - begun))
    brush.mouse_at(port, Kind.MouseButtonRelease, start, button, Qt.NoButton)
    hands.wait(0.3)
    return times


def _figures(times) -> dict[str, float]:
    middle = statistics.median(times)
    return {
        "median": round(middle, 1),
        "longest": round(max(times), 1),
        "pictures": round(1e3 * len(times) / sum(times), 1),
    }


def _measure() -> dict:
    from BalloonWorkbench.gui.pattern_view import tab as tabs

    Gui.activateWorkbench("BalloonWorkbench")
    doc = _balloon()
    hands.wait(1.0)
    tab = tabs.open_tab(doc.Pattern)
    hands.wait_until(lambda: tab.isVisible() and tab.view.pieces is not None, 60)
    hands.wait(1.0)
    view = tab.view
    points = sum(len(line.points) for piece in view.pieces.pieces for line in piece.pattern.contours)
    paints = _Paints(view.viewport())
    measured = {"size": [view.width(), view.height()], "points": points}
    hands.screenshot("pattern-pulls")
    beside = QtCore.QPointF(5.0, 5.0)
    _dragged(view, paints, beside, Qt.MiddleButton)
    for look in ("Film", "Tension"):
        begun = time.perf_counter()
        tab.looks.list.setCurrentIndex(tab.looks.list.findData(look))
        measured[f"{look} to be seen"] = round(1e3 * (time.perf_counter() - begun), 1)
        for name, zoom in (("whole", 1.0), ("twice as large", 2.0), ("eight times", 8.0)):
            view.fit()
            hands.wait(0.3)
            film = QtCore.QPointF(view.place_of(np.array(view.laid.places[30].middle)))
            view.zoom_by(zoom, film)
            hands.wait(0.3)
            measured[f"{look}, pull, {name}"] = _figures(_dragged(view, paints, film, Qt.MiddleButton))
            measured[f"{look}, piece, {name}"] = _figures(_dragged(view, paints, film, Qt.LeftButton))
    view.fit()
    edge = view.pieces.edges[70]
    begun = time.perf_counter()
    tab.pick(70)
    _on_screen(view, paints)
    measured["first pick"] = round(1e3 * (time.perf_counter() - begun), 1)
    begun = time.perf_counter()
    tab.pick(31)
    _on_screen(view, paints)
    measured["pick"] = round(1e3 * (time.perf_counter() - begun), 1)
    begun = time.perf_counter()
    view.pieces.nearest_edge(edge.line[len(edge.line) // 2])
    measured["nearest edge"] = round(1e3 * (time.perf_counter() - begun), 1)
    times = []
    for step in range(8):
        begun = time.perf_counter()
        view.zoom_by(1.25 if step < 4 else 0.8)
        _on_screen(view, paints)
        times.append(1e3 * (time.perf_counter() - begun))
    measured["zoom"] = _figures(times)
    return measured


def _run() -> None:
    path = Path(f"build/bench/pulls{os.environ.get('SUITE', '')}.json")
    path.unlink(missing_ok=True)
    try:
        path.write_text(json.dumps(_measure(), indent=1), encoding="utf-8")
    finally:
        if not path.exists():
            traceback.print_exc()
        sys.stdout.flush()
        os._exit(0)


QtCore.QTimer.singleShot(0, _run)
