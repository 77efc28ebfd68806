# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's own settings that an assembly sheet repeats: of what welds, and of what cuts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.tool import lacking, settings_text
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import percent_text, speed_text

#: Where the settings of a weld are from: the user's machine, sources on the film, or nowhere yet.
OWN, START, CARD = "own", "start", "card"


@dataclass(frozen=True)
class WorkSettings:
    """Titles of machines with their settings, "" where there are none."""

    weld_machine: str = ""
    weld: str = ""
    cut_machine: str = ""
    cut: str = ""


NO_SETTINGS = WorkSettings()


def work_settings(machines: Sequence[Machine], say: Say = in_english) -> WorkSettings:
    """Those of the first machine that welds, and of the first that cuts, whose settings are all known."""
    welds = [(say(each.title), _of_tool(each, say)) for each in machines if each.tool and each.tool.is_hot]
    cuts = [
        (say(each.title), _of_cut(each, say)) for each in machines if not (each.tool and each.tool.is_hot)
    ]
    none = ("", "")
    weld = next((pair for pair in welds if pair[1]), none)
    return WorkSettings(*weld, *next((pair for pair in cuts if pair[1]), none))


def _of_tool(machine: Machine, say: Say) -> str:
    tool = machine.tool
    return "" if tool is None or lacking(tool, machine.version) else settings_text(tool, say)


def _of_cut(machine: Machine, say: Say) -> str:
    """Of a tool, or of the layer on which a LightBurn project cuts."""
    if machine.tool is not None:
        return _of_tool(machine, say)
    line = machine.layers.get(Role.CUT)
    if line is None or line.laser is None:
        return ""
    laser = line.laser
    return f"{say('speed')} {speed_text(laser.speed)}, {say('power')} {percent_text(laser.max_power)}"
