# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the validation page; the same numbers give the same bytes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np

from BalloonWorkbench.core.advice.findings import Advice
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

if TYPE_CHECKING:
    from validation.correction import Corrected

mpl.use("Agg")
mpl.rcParams.update({"svg.hashsalt": "balloon", "font.family": "DejaVu Sans", "font.size": 9.0})

_MARKS = "osD^vP*Xh"


def _save(figure: Any, path: Path) -> None:
    from matplotlib import pyplot

    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None, "Creator": None}, bbox_inches="tight")
    pyplot.close(figure)


def convergence(curves: dict[str, tuple[Floats, Floats]], path: Path) -> None:
    """Errors against mesh sizes, both logarithmic, with the slopes 1 and 2 for comparison."""
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6.4, 4.4))
    for mark, (name, (sizes, errors)) in zip(_MARKS, curves.items()):
        axes.loglog(sizes, 100.0 * errors, marker=mark, label=name)
    sizes = np.concatenate([curve[0] for curve in curves.values()])
    ends = np.array([sizes.min(), sizes.max()])
    top = 100.0 * max(float(curve[1].max()) for curve in curves.values())
    for slope, style in ((1, "--"), (2, ":")):
        axes.loglog(
            ends, 1.3 * top * (ends / ends[1]) ** slope, "0.6", linestyle=style, label=f"order {slope}"
        )
    axes.set_xlabel("mesh size h")
    axes.set_ylabel("error of V, %")
    axes.grid(visible=True, which="both", color="0.92")
    axes.legend(fontsize=8)
    _save(figure, path)


def work(curves: dict[str, tuple[Floats, Floats, Floats]], path: Path) -> None:
    """Newton steps and factorisations against the number of vertices."""
    from matplotlib import pyplot

    figure, both = pyplot.subplots(1, 2, figsize=(9.0, 3.8), sharey=True)
    for column, (axes, title) in enumerate(zip(both, ("Newton steps", "factorisations")), 1):
        for mark, (name, curve) in zip(_MARKS, curves.items()):
            axes.semilogx(curve[0], curve[column], marker=mark, label=name)
        axes.set_title(title, fontsize=9)
        axes.set_xlabel("vertices")
        axes.set_ylim(bottom=0.0)
        axes.grid(visible=True, which="both", color="0.92")
    both[1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))
    _save(figure, path)


def cold_balloons(results: Sequence[Corrected], path: Path) -> None:
    """Drawing (grey), silhouette of the balloon that is made (red) and pattern (blue), three in a row."""
    from matplotlib import pyplot

    rows = -(-len(results) // 3)
    figure, grid = pyplot.subplots(rows, 3, figsize=(9.0, 3.1 * rows), squeeze=False)
    for axes in grid.flat:
        axes.set_axis_off()
        axes.set_aspect("equal")
    for axes, one in zip(grid.flat, results):
        for loop in one.design.target.loops:
            axes.fill(*loop.T, color="0.85", zorder=0)
        for hole in one.design.target.holes:
            axes.fill(*hole.T, color="white", zorder=0.5)
        for outline, colour in ((one.design.pattern, "tab:blue"), (one.silhouette, "tab:red")):
            for loop in outline.loops:
                closed = np.vstack([loop, loop[:1]])
                axes.plot(*closed.T, color=colour, linewidth=0.9)
        axes.set_title(f"{one.name}: {100 * one.found:.2f} %", fontsize=8)
    _save(figure, path)


def advice(named: Sequence[tuple[str, Outline, Advice]], path: Path) -> None:
    """Outlines over the thickness to be expected, with the places of the findings, four in a row."""
    from matplotlib import pyplot

    colours = {"hint": "tab:blue", "warning": "tab:orange", "serious": "tab:red"}
    rows = -(-len(named) // 4)
    figure, grid = pyplot.subplots(rows, 4, figsize=(10.0, 2.6 * rows), squeeze=False)
    for axes in grid.flat:
        axes.set_axis_off()
        axes.set_aspect("equal")
    for axes, (title, outline, said) in zip(grid.flat, named):
        found = said.map
        axes.tricontourf(*found.points.T, found.triangles, found.thickness, levels=10, cmap="Greys")
        for loop in outline.loops:
            axes.plot(*np.vstack([loop, loop[:1]]).T, color="0.3", linewidth=0.6)
        for finding in said.findings:
            colour = colours[finding.severity.value]
            axes.plot(*finding.place, marker="o", markersize=9, markerfacecolor="none", color=colour)
            for line in finding.extent:
                axes.plot(*line.T, color=colour, linewidth=1.4)
        axes.set_title(title, fontsize=8)
    _save(figure, path)


def bodies(named: Sequence[tuple[str, Sequence[tuple[Floats, Any, Floats]]]], path: Path) -> None:
    """Bodies in columns, one balloon below the other: points (n, 3), triangles, distances [%], as colours."""
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    figure = pyplot.figure(figsize=(2.1 * len(named), 4.6))
    for column, (name, balloons) in enumerate(named):
        most = max(float(np.quantile(np.abs(off), 0.95)) for _, _, off in balloons)
        for row, (points, triangles, off) in enumerate(balloons):
            axes: Any = figure.add_subplot(2, len(named), row * len(named) + column + 1, projection="3d")
            shown = Poly3DCollection(points[triangles], rasterized=True)
            shown.set_facecolor(mpl.colormaps["coolwarm"](0.5 + 0.5 * off[triangles].mean(axis=1) / most))
            axes.add_collection3d(shown)
            low, high = points.min(axis=0), points.max(axis=0)
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            axes.set_box_aspect(high - low, zoom=1.25)
            axes.set_axis_off()
            if row == 0:
                axes.set_title(f"{name}\n±{most:.2g} %", fontsize=8)
    figure.savefig(path, dpi=56, metadata={"Software": None}, bbox_inches="tight")
    pyplot.close(figure)
