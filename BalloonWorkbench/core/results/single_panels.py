# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each panel of an inflated balloon by itself, as the outer side of a balloon of its own.

What is read from one panel of a mirrored balloon can so be read from all panels of any balloon.
"""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.lift import Lift


def single_panels(inflation: Inflation) -> tuple[Inflation, ...]:
    """One inflation for each panel, in its place in space, its triangles counter-clockwise from outside.

    Of a mirrored balloon the upper half, and the lower one turned over (MIRROR) where both were simulated.
    """
    assembly = inflation.assembly
    if assembly.mirror:
        if inflation.lower is None:
            return (inflation,)
        upper = replace(inflation, lower=None)
        return upper, replace(upper, positions=inflation.lower * MIRROR)
    report, lift = inflation.report, inflation.report.lift
    if lift is not None:  # what holds the balloon may be of another panel
        held = Lift(lift.gradient, lift.held[:0])
        report = replace(report, pressure=report.pressure - lift.gradient * inflation.foot, lift=held)
    singles, first_triangle = [], 0
    for number, panel in enumerate(assembly.panels):
        begin, end = assembly.offsets[number : number + 2]
        triangles = slice(first_triangle, first_triangle + len(panel.triangles))
        first_triangle = triangles.stop
        own = _turned_over(panel) if assembly.surface.turned[number] else panel
        singles.append(
            Inflation(
                Assembly.mirrored(own),
                inflation.positions[begin:end],
                inflation.directors[begin:end],
                inflation.tensions[triangles],
                inflation.volume,
                report,
            )
        )
    return tuple(singles)


def _turned_over(panel: Panel) -> Panel:
    return Panel(
        panel.rest_positions * (-1.0, 1.0),
        panel.triangles[:, ::-1].copy(),
        tuple(loop[::-1].copy() for loop in panel.loops),
        tuple(weld[::-1].copy() for weld in panel.welds),
    )
