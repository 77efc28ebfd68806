# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern as objects of FreeCAD's workbench Path (CAM since 1.0), with the moves of its G-code."""

from __future__ import annotations

from BalloonWorkbench.app import host
from BalloonWorkbench.app.engine.cut_sheet import sheet
from BalloonWorkbench.app.engine.export import check_for
from BalloonWorkbench.core.errors import ExportError

#: What a post processor says itself: units, modes, the end.
_SAID = ("G17", "G21", "G40", "G49", "G54", "G64", "G90", "G91.1", "G94", "M2")


def tool_paths(pattern_obj, machine_name: str, bed: str | None = None, oversize: str = "refuse") -> list:
    """New objects with a Path, one for each film, for a machine that reads G-code; else as `export_for`.

    Raises ExportError, and makes none, when the machine cannot make the pattern, or this FreeCAD has no such
    workbench.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.machines.machine import machine
    from BalloonWorkbench.core.machines.preflight import ERROR
    from BalloonWorkbench.core.machines.toolpaths import draw
    from BalloonWorkbench.core.machines.writers.moves import moves

    made_for, pattern = machine(machine_name, bed), sheet(pattern_obj)
    for finding in check_for(pattern_obj, machine_name, bed, oversize):
        if finding.severity == ERROR:
            raise ExportError(finding.text)

    def steps(_progress) -> dict:
        parts = {stock: pattern.of_stock(stock) for stock in pattern.stocks}
        return {stock: moves(draw(part, made_for), made_for) for stock, part in parts.items()}

    made = []
    for stock, told in hooks.run_blocking("Making tool paths", steps).items():
        path = host.path_of([(step.name, step.words) for step in told if step.name not in ("", *_SAID)])
        obj = pattern_obj.Document.addObject("Path::Feature", "ToolPaths")
        obj.Label = f"{made_for.name} {stock}".strip()
        obj.Path = path
        made.append(obj)
    return made
