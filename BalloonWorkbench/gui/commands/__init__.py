# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, in the order of the work; what they open is in the other rooms."""

from __future__ import annotations

from BalloonWorkbench.gui.commands import command, examples
from BalloonWorkbench.gui.commands.create import (
    FromBody,
    FromPanels,
    FromPicture,
    FromProfile,
    FromSketch,
    Paint,
)
from BalloonWorkbench.gui.commands.equipment import Equipment
from BalloonWorkbench.gui.commands.making import (
    ArtworkCommand,
    AssemblySheet,
    ExportPattern,
    Machines,
    Nest,
    TestCard,
)
from BalloonWorkbench.gui.commands.results import (
    AdviceCommand,
    Animate,
    ColourMapCommand,
    CompareCommand,
    EditOutline,
    ExportForWeb,
    PatternViewCommand,
    StudyCommand,
)

_COMMANDS = {
    "BalloonWorkbench_Paint": Paint,
    "BalloonWorkbench_FromPicture": FromPicture,
    "BalloonWorkbench_FromSketch": FromSketch,
    "BalloonWorkbench_FromProfile": FromProfile,
    "BalloonWorkbench_FromBody": FromBody,
    "BalloonWorkbench_FromPanels": FromPanels,
    "BalloonWorkbench_EditOutline": EditOutline,
    "BalloonWorkbench_Advice": AdviceCommand,
    "BalloonWorkbench_PatternView": PatternViewCommand,
    "BalloonWorkbench_ColourMap": ColourMapCommand,
    "BalloonWorkbench_Animate": Animate,
    "BalloonWorkbench_Study": StudyCommand,
    "BalloonWorkbench_Artwork": ArtworkCommand,
    "BalloonWorkbench_Nest": Nest,
    "BalloonWorkbench_ExportPattern": ExportPattern,
    "BalloonWorkbench_AssemblySheet": AssemblySheet,
    "BalloonWorkbench_ExportForWeb": ExportForWeb,
    "BalloonWorkbench_Compare": CompareCommand,
}

#: In the menu only.
_RARE = {
    "BalloonWorkbench_Machines": Machines,
    "BalloonWorkbench_TestCard": TestCard,
    "BalloonWorkbench_Examples": examples.Examples,
    "BalloonWorkbench_Equipment": Equipment,
}


def register() -> tuple[list[str], list[str]]:
    """Make the commands known to FreeCAD; returns the names for the toolbar and those for the menu."""
    examples.register()
    command.follow_language()
    for name, kind in (_COMMANDS | _RARE).items():
        command.add(name, kind())
    return list(_COMMANDS), [*_COMMANDS, "Separator", *_RARE]
