# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's users expect of every command besides a name: keys, a status tip, and What's this."""

from __future__ import annotations

from BalloonWorkbench.gui.commands import help_pages
from BalloonWorkbench.gui.window import borders

#: B for balloon, then a letter that FreeCAD's own workbenches leave free.
_KEYS = {
    "Paint": "B, D",
    "FromPicture": "B, I",
    "FromSketch": "B, K",
    "Advice": "B, A",
    "ColourMap": "B, M",
    "Animate": "B, V",
    "Artwork": "B, R",
    "Nest": "B, L",
    "ExportPattern": "B, E",
    "AssemblySheet": "B, H",
}


def documented(name: str, command, page: str = ""):
    """The command, with a page of docs/help: that of its own name, or another one."""
    own, short = command.GetResources(), name.split("_")[1]
    own["StatusTip"] = own["ToolTip"]
    own["WhatsThis"] = help_pages.explain(name, page or short)
    if short in _KEYS:
        own["Accel"] = _KEYS[short]
    command.GetResources = lambda: own
    if hasattr(command, "Activated"):  # a submenu has none
        command.Activated = borders.command(name, command.Activated)
    command.IsActive = borders.offered(name, command.IsActive)
    return command
