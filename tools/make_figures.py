# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the figures of docs/how-it-works.md: python tools/make_figures.py, from runs of the program."""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
matplotlib.use("Agg")

from matplotlib import pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

from BalloonWorkbench.core.correction.fit import fit, inflate_outline  # noqa: E402
from BalloonWorkbench.core.film.library import film  # noqa: E402
from BalloonWorkbench.core.mesh.sizing import size_for  # noqa: E402
from BalloonWorkbench.core.mesh.triangulate import triangulate  # noqa: E402
from BalloonWorkbench.core.outline.outline import Outline  # noqa: E402
from BalloonWorkbench.core.readers.read import read_drawing  # noqa: E402
from BalloonWorkbench.core.results.film_state import State, film_state  # noqa: E402
from BalloonWorkbench.core.solver.inflate import inflate  # noqa: E402

IMAGES = ROOT / "docs" / "images"
PICTURES = ROOT / "resources" / "examples" / "pictures"
PRESSURE = 2000.0
FILM = film("mylar")
#: Colours that people with any colour vision tell apart.
TAUT, WRINKLED, SLACK, LINE = "#0072b2", "#e69f00", "#999999", "#d55e00"


def state(name: str) -> None:
    """Where the film of a balloon is taut, wrinkled and slack, and along what it is wrinkled."""
    drawing, _ = read_drawing(PICTURES / "fish.png", width=0.3)
    design = fit(drawing.parts[0], FILM, PRESSURE)
    balloon, found = design.inflation, film_state(design.inflation, FILM)
    corners = 1e3 * balloon.positions[balloon.panel.triangles][:, :, :2]
    figure, axes = plt.subplots(figsize=(7.0, 4.2))
    colours = np.array([SLACK, WRINKLED, TAUT])[found.state]
    axes.add_collection(PolyCollection(corners, facecolors=colours, edgecolors="none", alpha=0.55))
    middles, along = corners.mean(axis=1), found.direction[:, :2]
    shown = np.flatnonzero(found.state == State.WRINKLED)[::3]
    lines = middles[shown, None] + 3.0 * along[shown, None] * np.array([-1.0, 1.0])[:, None]
    axes.add_collection(LineCollection(lines, colors="#222222", linewidths=0.5))
    for text, colour, share in (
        ("taut", TAUT, found.shares()[State.TAUT]),
        ("wrinkled, lines along the tension", WRINKLED, found.shares()[State.WRINKLED]),
        ("slack", SLACK, found.shares()[State.SLACK]),
    ):
        axes.fill([], [], color=colour, alpha=0.55, label=f"{text}: {100.0 * share:.0f} %")
    axes.legend(loc="upper left", frameon=False, fontsize=8, bbox_to_anchor=(0.0, 1.12))
    _save(figure, axes, name)


def mylar(name: str) -> None:
    """Two discs: the simulated profile beside the closed form for film that does not stretch."""
    turn = np.linspace(0.0, 2.0 * np.pi, 240, endpoint=False)
    disc = Outline(0.1 * np.column_stack([np.cos(turn), np.sin(turn)]))
    balloon = inflate(triangulate(disc, size_for(disc, 1500)), FILM, PRESSURE)
    radii, heights = 1e3 * np.hypot(*balloon.positions[:, :2].T), 1e3 * balloon.positions[:, 2]
    rim = 100.0 / 1.3110287771461  # flat radius over the lemniscate's quarter
    # z' = -r^2 / sqrt(a^4 - r^4), integrated over the angle of r = a sin(angle)
    angle = np.linspace(0.0, 0.5 * np.pi, 400)
    slope = rim * np.sin(angle) ** 2 / np.sqrt(1.0 + np.sin(angle) ** 2)
    steps = 0.5 * (slope[1:] + slope[:-1]) * np.diff(angle)
    fallen = np.concatenate([[0.0], np.cumsum(steps)])
    figure, axes = plt.subplots(figsize=(7.0, 3.2))
    axes.plot(radii, heights, ".", color=TAUT, markersize=2.5, label="simulation, every vertex")
    axes.plot(
        rim * np.sin(angle),
        fallen[-1] - fallen,
        color=LINE,
        linewidth=1.2,
        label="closed form (Paulsen 1994)",
    )
    axes.set_xlabel("distance from the axis, mm")
    axes.set_ylabel("height, mm")
    axes.legend(loc="lower left", frameon=False, fontsize=8)
    _save(figure, axes, name, frame=True)


def correction(name: str) -> None:
    """A fish cut as it is drawn, and cut as the correction says: both inflated, over the drawing."""
    drawing, _ = read_drawing(PICTURES / "fish.png", width=0.3)
    target = drawing.parts[0]
    plain, fitted = inflate_outline(target, FILM, PRESSURE), fit(target, FILM, PRESSURE)
    figure, both = plt.subplots(1, 2, figsize=(9.0, 3.4))
    for axes, pattern, seen, title in (
        (both[0], target, plain.silhouette, "cut as drawn"),
        (both[1], fitted.pattern, fitted.silhouette, "cut as corrected"),
    ):
        for outline, style in (
            (target, {"color": "#000000", "linewidth": 1.0, "label": "drawing"}),
            (pattern, {"color": TAUT, "linewidth": 1.0, "linestyle": "--", "label": "pattern"}),
            (seen, {"color": LINE, "linewidth": 2.4, "alpha": 0.6, "label": "balloon from above"}),
        ):
            for number, loop in enumerate(outline.loops):
                closed = 1e3 * np.concatenate([loop, loop[:1]])
                axes.plot(*closed.T, **{**style, "label": style["label"] if number == 0 else None})
        axes.set_title(title, fontsize=9)
        axes.set_aspect("equal")
        axes.axis("off")
    handles, labels = both[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=3, frameon=False, fontsize=8)
    _save(figure, None, name)


def _save(figure: plt.Figure, axes: plt.Axes | None, name: str, frame: bool = False) -> None:
    if axes is not None:
        axes.set_aspect("equal")
        axes.autoscale_view()
        if not frame:
            axes.axis("off")
    figure.tight_layout()
    figure.savefig(IMAGES / name, dpi=90, metadata={"Software": ""})
    plt.close(figure)


if __name__ == "__main__":
    state("how-film.png")
    mylar("how-mylar.png")
    correction("how-correction.png")
