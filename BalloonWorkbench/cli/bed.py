# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern from the command line that is larger than the bed of a machine."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from BalloonWorkbench.cli.options import typed
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.job import Balloon
from BalloonWorkbench.core.machines.bed import fits, scale_to_fit
from BalloonWorkbench.core.machines.contour.tabs import leaves_tabs, with_tabs
from BalloonWorkbench.core.machines.machine import Machine, complete, holding, machine
from BalloonWorkbench.core.options.making import REFUSE, SCALE, TabOptions, ToolOptions
from BalloonWorkbench.core.options.option import unusual
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.units import length_text

if TYPE_CHECKING:
    from BalloonWorkbench.core.bag_job import FinishedBags

Size = tuple[float | None, float | None]


def machines_of(options: argparse.Namespace) -> list[Machine]:
    """The machines that were asked for, each with the bed and the tool that were given; InputError."""
    if not options.machine and (options.bed is not None or options.oversize != REFUSE):
        raise InputError("A bed is that of a machine: give --machine too.")
    wishes = typed(options, ToolOptions)
    if unusual(wishes) and not any(machine(name).tool for name in options.machine):
        raise InputError(
            "A tool is that of a machine that reads G-code: give --machine gcode-grbl or another."
        )
    decided = ("target_volume", "target_lift", "gas_volume")
    if options.oversize == SCALE and any(getattr(options, name) is not None for name in decided):
        raise InputError(
            "A volume or a lift decides the size, so the balloon cannot be scaled to fit: leave out"
            " --oversize scale, or what you give of --target-volume, --target-lift and --gas-volume."
        )
    tabs = typed(options, TabOptions)
    if tabs.tabs_below is not None and not tabs.tabs:
        raise InputError("--tabs-below is about tabs: give their width too, such as --tabs 0.4mm.")
    known = [holding(machine(name, options.bed), wishes) for name in options.machine]
    if unusual(tabs) and not any(leaves_tabs(each) for each in known):
        raise InputError("Tabs are left by a machine that cuts: give --machine too, and one that does.")
    # what nobody else knows is asked for before the work
    return [complete(with_tabs(each, tabs)) for each in known]


def scaled_to_fit(
    first: Balloon | FinishedBags,
    machines: Sequence[Machine],
    size: Size,
    design: Callable[[Size, float], Balloon | FinishedBags],
) -> tuple[Balloon | FinishedBags, Size, list[str]]:
    """A balloon that fits the beds, the size of its drawing, and a line for the user where it is smaller.

    size, design  width and height that were asked for, and what makes a balloon of others, so many times as
                  large
    """
    if size == (None, None):
        size = first.width, None
    balloon, used = first, size

    def make(scale: float) -> Pattern:
        nonlocal balloon, used
        width, height = size
        used = width and scale * width, height and scale * height
        balloon = design(used, scale)
        return balloon.sheet

    scale = scale_to_fit(first.sheet, machines, make)
    if scale == 1.0:
        return first, size, []
    before, after = (length_text(each.width) for each in (first, balloon))
    from BalloonWorkbench.core.bag_job import FinishedBags
    from BalloonWorkbench.core.bags.bag import Bag

    if isinstance(balloon, FinishedBags) and isinstance(balloon.sources[0], Bag):
        return balloon, used, [f"Scaled to fit: the balloon is {after} wide instead of {before}."]
    return balloon, used, [f"Scaled to fit: the drawing is {after} wide instead of {before}."]


def ways_on(balloon: Balloon | FinishedBags, machines: Sequence[Machine]) -> list[str]:
    """A line for the user about patterns that a bed is too small for."""
    sheet = balloon.sheet
    if all(fits(sheet.of_stock(stock), each) for stock in sheet.stocks for each in machines):
        return []
    return [
        "--oversize scale makes the balloon smaller until it fits, --oversize split writes several files"
        " between which the film is moved, --oversize write writes the file anyway, --bed tells how large the"
        " bed is."
    ]
