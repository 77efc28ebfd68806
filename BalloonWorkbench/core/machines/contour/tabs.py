# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs: short stretches of a cut that are left out, so that what it goes round stays in the film.

Two at least on each cut, and one in 100 mm; each on the straightest stretch near its even place, where no
corner and no notch is. The beam or cutter takes half its width more at both ends of a gap, so that a gap in
the line is as much wider than the tab.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import extent, gaps
from BalloonWorkbench.core.machines.contour.start_point import CLEAR, places_along, turning
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.order import CUTS
from BalloonWorkbench.core.options.making import TabOptions
from BalloonWorkbench.core.pattern.pattern import Contour
from BalloonWorkbench.core.types import Bools, Floats
from BalloonWorkbench.core.units import from_mm, length_text, to_mm

#: So many tabs hold a piece; a longer cut has one in each so long stretch of it [mm].
LEAST, _EVERY = 2, 100.0
#: Where a line turns by more within a tab and the clear way on both sides, there is none [rad].
_BENT = 0.5
#: From how many even divisions of a cut the best is taken.
_PHASES = 4
#: How far its turning counts besides, as for a start [mm].
_REACHES = (5.0, 10.0, 20.0)
#: Less turning is none [digits of rad].
_DIGITS = 2
#: A joint that is as near is taken for an end of a piece [mm].
_SNAP = 0.002
#: Widths that are tabs [m].
_NARROWEST, _WIDEST = from_mm(0.05), from_mm(10.0)


def with_tabs(machine: Machine, wishes: TabOptions) -> Machine:
    """The machine that leaves tabs as the user wishes; paper is cut by hand, and a hot tool cuts nothing.

    Raises InputError for a width that makes no sense.
    """
    if wishes.tabs and not _NARROWEST <= wishes.tabs <= _WIDEST:
        raise InputError(
            f"A tab must be {length_text(_NARROWEST)} to {length_text(_WIDEST)} wide, not"
            f" {length_text(wishes.tabs)}; 0 makes none."
        )
    return replace(machine, tabs=wishes) if leaves_tabs(machine) else machine


def leaves_tabs(machine: Machine) -> bool:
    """Whether a machine can leave any."""
    return machine.format != "pdf" and any(role in machine.layers for role in CUTS)


def is_held(contour: Contour, machine: Machine) -> bool:
    """Whether a contour is a cut that gets tabs."""
    below = machine.tabs.tabs_below
    return (
        machine.tabs.tabs > 0.0
        and contour.closed
        and contour.role in CUTS
        and (below is None or extent(contour.points) <= below)
    )


def gap_of(machine: Machine) -> float:
    """How much of a cut is left out for a tab [mm]."""
    return to_mm(machine.tabs.tabs + machine.kerf)


def held(curve: Curve, gap: float, ends: Floats) -> list[Curve]:
    """The pieces of a closed cut [mm] between its tabs, one after the other; itself where none has room."""
    middles = tab_places(curve, gap, ends)
    if not len(middles):
        return [curve]
    begins = middles + 0.5 * gap
    ways = np.append(middles[1:], middles[0] + curve.length) - 0.5 * gap
    rest, joint = curve.jointed(float(begins[0] % curve.length), _SNAP)
    rest, pieces = rest.begun_at(joint), list[Curve]()
    for begin, end in zip((begins - begins[0]).tolist(), (ways - begins[0]).tolist()):
        rest, first = rest.jointed(begin, _SNAP)
        rest, last = rest.jointed(end, _SNAP)
        pieces.append(rest.stretch(first, last))
    return pieces


def tab_places(curve: Curve, gap: float, ends: Floats) -> Floats:
    """Where along a closed cut [mm] tabs have their middles, rising: none at corners and bends, nor at the
    ends (n, 2) of other lines. Fewer than two where there is no room for more."""
    whole = curve.length
    count = max(LEAST, int(np.ceil(whole / _EVERY)))
    share = whole / count
    if gap > 0.25 * share:
        return np.empty(0)
    places = places_along(curve)
    near, *far = turning(curve, ends, places, (0.5 * gap + CLEAR, *_REACHES))
    rows = np.round([near, *far], _DIGITS)
    tried: list[list[int]] = []
    for phase in range(_PHASES):
        middles = (np.arange(count) + phase / _PHASES) * share
        off = np.abs((places - middles[:, None] + 0.5 * whole) % whole - 0.5 * whole)
        tried += [_chosen(rows, off, near < _BENT, reach * share) for reach in (0.25, 0.5)]
    best = max(tried, key=lambda each: (len(each), -float(rows[0, each].sum()), -float(rows[1, each].sum())))
    return np.sort(places[best])


def _chosen(rows: Floats, off: Floats, fits: Bools, reach: float) -> list[int]:
    """For each stretch the place that turns least, and of these the nearest to its middle.

    rows  turning (k, n) at places, the first key first; off (m, n) how far they are from the middles of m
          stretches, at most reach; a stretch without a place that fits has none, nor has one too near others
    """
    count, chosen = rows.shape[1], list[int]()
    numbers = np.arange(count, dtype=np.float64)
    apart = count / (4.0 * len(off))
    for each in off:
        free = fits & (each <= reach)
        for other in {*chosen[:1], *chosen[-1:]}:
            free &= gaps(numbers, numbers[other], count) >= apart
        places = np.flatnonzero(free)
        if len(places):
            keys = [*rows[:, places], np.round(each[places], _DIGITS)]
            chosen.append(int(places[np.lexsort(keys[::-1])[0]]))
    return chosen
