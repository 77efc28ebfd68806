# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench costs while FreeCAD starts."""

import builtins
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import FreeCADGui as Gui

_OURS = "BalloonWorkbench"


def milliseconds():
    """Processor time of Init.py and InitGui.py with nothing of ours loaded before; the least of three."""
    with _once_more():
        return min(_once() for _ in range(3))


def imported():
    """Rooms of ours whose modules are loaded then, and what is imported of others, there before or not."""
    names, load = set(), builtins.__import__

    def watched(name, *given, **named):
        names.add(name)
        return load(name, *given, **named)

    builtins.__import__ = watched
    try:
        with _once_more():
            _once()
    finally:
        builtins.__import__ = load
    ours = [
        name
        for name, module in sys.modules.items()
        if name.partition(".")[0] == _OURS and not hasattr(module, "__path__")
    ]
    rooms = {name.rpartition(".")[0].partition(".")[2] for name in ours}
    return rooms, {name.partition(".")[0] for name in names} - {_OURS}


@contextmanager
def _once_more():
    add, Gui.addWorkbench = Gui.addWorkbench, lambda workbench: None  # FreeCAD takes none twice
    try:
        yield
    finally:
        Gui.addWorkbench = add


def _once():
    for name in [name for name in sys.modules if name.partition(".")[0] == _OURS]:
        del sys.modules[name]
    began = time.process_time()
    for name in ("Init.py", "InitGui.py"):
        exec(compile(Path(name).read_text(encoding="utf-8"), name, "exec"), {})
    return 1e3 * (time.process_time() - began)
