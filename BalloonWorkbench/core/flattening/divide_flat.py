# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels for a target that lie flat without crossing themselves: more of them where so few would."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.bags.mesh_bag import default_size, mesh_bag
from BalloonWorkbench.core.errors import AssemblyError, InputError, MeshError
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.crossings import first_crossing
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.target import Division, Target

#: So many panels more are tried, and so many times as many.
_MORE, _TIMES = 8, 1.5


@memoized(4)
def divide_flat(target: Target, count: int) -> Division:
    """So many panels for a target; more of them, with a note, where so few cross themselves.

    Raises InputError for less than 1, and where more of them cross themselves, too.
    """
    if count == 1:
        return divide(target, count)
    most = int(_TIMES * count) + _MORE
    for number in range(count, most + 1):
        # to the grid of a document, so that the last bits of an eigenvector decide nothing
        made = divide(target, number).rounded()
        if _lies_flat(made):
            break
    else:
        raise InputError(
            f"With {count} to {most} panels some would cross themselves when laid flat: give more panels."
        )
    if number == count:
        return made
    note = f"With {count} panels some would cross themselves when laid flat: the body has {number}."
    return replace(made, target=replace(made.target, notes=(*made.target.notes, note)))


def check_flat(division: Division, advice: str) -> None:
    """Raise InputError with the advice where a panel crosses itself when it is laid flat."""
    for panel in bag_of(division, flatten(division)).bag.panels:
        if first_crossing(panel.loops) is not None or signed_area(panel.outer) <= 0.0:
            raise InputError(f"Panel '{panel.name}' would cross itself when laid flat. {advice}")


def _lies_flat(division: Division) -> bool:
    """No panel crosses itself, or so nearly that it cannot be meshed."""
    try:
        bag = bag_of(division, flatten(division)).bag
        check_bag(bag)
        mesh_bag(bag, default_size(bag))
    except (AssemblyError, MeshError):
        return False
    return True
