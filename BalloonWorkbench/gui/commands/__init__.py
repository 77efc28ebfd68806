# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, in the order of the work."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.gui.commands import examples, help_pages
from BalloonWorkbench.gui.commands.advice import Advice
from BalloonWorkbench.gui.commands.animate import Animate
from BalloonWorkbench.gui.commands.artwork import Artwork
from BalloonWorkbench.gui.commands.assembly_sheet import AssemblySheet
from BalloonWorkbench.gui.commands.colour_map import ColourMap
from BalloonWorkbench.gui.commands.documented import documented
from BalloonWorkbench.gui.commands.equipment import Equipment
from BalloonWorkbench.gui.commands.export_pattern import ExportPattern
from BalloonWorkbench.gui.commands.from_picture import FromPicture
from BalloonWorkbench.gui.commands.from_sketch import FromSketch
from BalloonWorkbench.gui.commands.nest import Nest
from BalloonWorkbench.gui.commands.paint import Paint

_COMMANDS = {
    "BalloonWorkbench_Paint": Paint,
    "BalloonWorkbench_FromPicture": FromPicture,
    "BalloonWorkbench_FromSketch": FromSketch,
    "BalloonWorkbench_Advice": Advice,
    "BalloonWorkbench_ColourMap": ColourMap,
    "BalloonWorkbench_Animate": Animate,
    "BalloonWorkbench_Artwork": Artwork,
    "BalloonWorkbench_Nest": Nest,
    "BalloonWorkbench_ExportPattern": ExportPattern,
    "BalloonWorkbench_AssemblySheet": AssemblySheet,
}

#: In the menu only.
_RARE = {"BalloonWorkbench_Examples": examples.Examples, "BalloonWorkbench_Equipment": Equipment}


def register() -> tuple[list[str], list[str]]:
    """Make the commands known to FreeCAD; returns the names for the toolbar and those for the menu."""
    examples.register()
    help_pages.follow_language()
    for name, command in (_COMMANDS | _RARE).items():
        Gui.addCommand(name, documented(name, command()))
    return list(_COMMANDS), [*_COMMANDS, "Separator", *_RARE]
