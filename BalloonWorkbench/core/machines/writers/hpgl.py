# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as HPGL: plotter units of 0.025 mm, a pen for each role, polylines."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import Toolpaths

_UNITS = 40  # per millimetre
#: How far a polyline may be off an arc: less than a plotter unit [mm].
_CHORD = 0.005
#: Points of one command: old plotters hold a line of some hundred characters at a time.
_POINTS = 50


def drawing_hpgl(drawing: Toolpaths, machine: Machine) -> bytes:
    """The file's content; the same bytes for the same drawing."""
    commands = ["IN", "PA"]
    pen = None
    for path in drawing.paths:
        path_pen = machine.layers[path.role].pen
        if path_pen != pen:
            commands.append(f"SP{path_pen}")
            pen = path_pen
        points = ring(path.curve.flattened(_CHORD), path.curve.closed)
        steps = np.rint(points * _UNITS).astype(int)
        steps = steps[np.append(True, np.any(np.diff(steps, axis=0) != 0, axis=1))]
        commands.append(f"PU{steps[0, 0]},{steps[0, 1]}")
        for begin in range(1, len(steps), _POINTS):
            commands.append("PD" + ",".join(f"{x},{y}" for x, y in steps[begin : begin + _POINTS].tolist()))
    commands += ["PU0,0", "SP0"]
    return (";\n".join(commands) + ";\n").encode("ascii")
