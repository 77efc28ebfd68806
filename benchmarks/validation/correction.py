# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction over the example pictures and generated outlines."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from drawn_shapes import generated
from validation import figures
from validation.gauss_newton import GaussNewton
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction import iterate
from BalloonWorkbench.core.correction.fit import Method, fit
from BalloonWorkbench.core.correction.mixing import AndersonMixing, RuleOfGain
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.vectors import alignment
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures"
PRESSURE = 2000.0
GENERATED = 40
VERTICES = 2000
SHOWN = 6
GROWTH = 1.28  # of a drawing to its pattern, about
COMPARED = ("bear", "star", "generated 5, smooth", "generated 2, spiky")
RULES: dict[str, RuleOfGain] = {
    "Anderson mixing": AndersonMixing,
    "plain fixed point": partial(AndersonMixing, depth=0),
    "Gauss-Newton": lambda gain: GaussNewton(film("mylar"), PRESSURE),
}
_KINDS = ("smooth", "star", "spiky", "thin", "with holes")


def correction(images: Path) -> Section:
    """Error, passes and cost of every outline, the worst ones as pictures; meshes and methods compared."""
    rows, done, refused = [], [], 0
    outlines = dict(_outlines())
    for name, outline in outlines.items():
        edge = _edge(outline, VERTICES)
        try:
            with _simulating() as once:
                cold = _seconds(lambda: _balloon(outline, edge))[1]  # noqa: B023
            with _simulating() as often:
                design, seconds = _seconds(lambda: fit(outline, film("mylar"), PRESSURE, mesh_size=edge))  # noqa: B023
        except BalloonError as error:
            refused += 1
            rows.append((name, f"refused: {error}", *[""] * 7))
            continue
        size, error = max(outline.size), design.residual
        alone = sum(often) / sum(once)
        done.append((error.mean / size, seconds, name, design, seconds / cold, alone))
        rows.append(
            (
                name,
                f"{100 * error.mean / size:.3f} %",
                f"{100 * error.p95 / size:.2f} %",
                f"{100 * error.max / size:.2f} %",
                str(len(design.unreached)),
                str(design.passes),
                f"{seconds:.1f}",
                f"{seconds / cold:.1f}",
                f"{alone:.1f}",
            )
        )
    means, seconds, ratios, alone = np.array([(one[0], one[1], one[4], one[5]) for one in done]).T
    passes = np.array([one[3].passes for one in done])
    worst = sorted(done, key=lambda one: -one[0])[:SHOWN]
    figures.designs(
        [(f"{one[2]}: {100 * one[0]:.2f} %", one[3]) for one in worst],
        images / "validation-correction.svg",
    )
    reached = sum(one[3].reached for one in done)
    text = paragraphs(
        f"""The pattern of a balloon of 0.3 m that shall look like the drawing, film "mylar",
        {PRESSURE / 1e3:g} kPa, about {VERTICES} vertices: the example pictures, and {GENERATED} generated
        outlines. Errors are two-way distances between drawing and inflated silhouette, in per cent of the
        larger dimension: the mean, the 95th percentile and the greatest. Stretches are the places where more
        than 1 % is left. The last columns are the processor time of the whole correction by that of one cold
        inflation of the drawing at the size of its pattern: meshed and simulated, and by simulation alone.

        Median of the mean errors {100 * np.median(means):.3f} %, worst {100 * means.max():.3f} %; median
        of the passes {np.median(passes):.0f}, most {passes.max()}; median {np.median(seconds):.1f}
        processor seconds, most {seconds.max():.1f}; median {np.median(ratios):.1f} cold inflations, most
        {ratios.max():.1f}, by simulation alone {np.median(alone):.1f} and {alone.max():.1f};
        {reached} of {len(rows)} reached (mean below 1 %), {refused} refused."""
    )
    head = ("outline", "mean", "95 %", "greatest", "stretches", "passes", "processor s", "cold", "simulated")
    text += "\n" + table(head, rows)
    text += "\n" + paragraphs("The worst ones: drawing grey, inflated silhouette red, pattern blue.")
    text += "\n![The worst corrections](images/validation-correction.svg)\n"
    return Section("Pattern correction", text + _meshes(outlines) + _methods(outlines))


def _meshes(outlines: dict[str, Outline]) -> str:
    """The same drawing on few and on many vertices."""
    rows = []
    for name, outline in list(outlines.items())[:-GENERATED]:
        few, many = (fit(outline, film("mylar"), PRESSURE, mesh_size=_edge(outline, n)) for n in (600, 5000))
        rotation, shift = alignment(few.pattern.outer, many.pattern.outer, np.ones(len(few.pattern.outer)))
        laid = few.pattern.map(lambda loop: loop @ rotation.T + shift)  # noqa: B023
        pattern = residual(laid, many.pattern).mean / max(many.pattern.size)
        shown = residual(few.silhouette, many.silhouette).mean / max(outline.size)
        counts = [str(len(design.inflation.panel.rest_positions)) for design in (few, many)]
        marked = " and ".join(str(len(design.unreached)) for design in (few, many))
        rows.append((name, " and ".join(counts), f"{100 * pattern:.2f} %", f"{100 * shown:.2f} %", marked))
    intro = """The same drawing on few and on many vertices: mean two-way distance of the two patterns, laid
    on each other, and of the two silhouettes, each in per cent of its larger dimension; and the stretches
    that are marked as not reached on either mesh."""
    head = ("drawing", "vertices", "patterns", "silhouettes", "stretches")
    return "\n" + paragraphs(intro) + "\n" + table(head, rows)


def _methods(outlines: dict[str, Outline]) -> str:
    """Anderson mixing, which is used, beside the plain fixed point and Gauss-Newton."""
    rows = []
    for name in COMPARED:
        outline = outlines[name]
        for method, rule in RULES.items():
            design, seconds = _seconds(
                lambda: fit(
                    outline,  # noqa: B023
                    film("mylar"),
                    PRESSURE,
                    mesh_size=_edge(outline, 600),  # noqa: B023
                    method=Method(symmetric=False, update_rule=rule),  # noqa: B023
                )
            )
            error, size = design.residual, max(outline.size)
            cells = f"{100 * error.mean / size:.3f} %", f"{100 * error.p95 / size:.2f} %"
            rows.append((name, method, *cells, str(design.passes), f"{seconds:.2f}"))
    intro = """Three ways to the next pattern, about 600 vertices: Anderson mixing, which is used; the plain
    fixed point, the same without memory; Gauss-Newton with the sensitivities of the simulation
    (`benchmarks/validation/gauss_newton.py`), whose processor time is that of unoptimised Python."""
    head = ("drawing", "method", "mean", "95 %", "passes", "processor s")
    return "\n" + paragraphs(intro) + "\n" + table(head, rows)


@contextmanager
def _simulating() -> Iterator[list[float]]:
    """Processor seconds of each simulation meanwhile."""
    spent: list[float] = []

    def counted(*arguments: Any, **options: Any) -> Any:
        result, seconds = _seconds(lambda: inflate(*arguments, **options))
        spent.append(seconds)
        return result

    iterate.inflate = counted  # type: ignore[attr-defined]
    try:
        yield spent
    finally:
        iterate.inflate = inflate  # type: ignore[attr-defined]


def _edge(outline: Outline, vertices: int) -> float:
    return size_for(outline.map(lambda loop: GROWTH * loop), vertices)


def _balloon(outline: Outline, edge: float) -> object:
    panel = triangulate(outline.map(lambda loop: GROWTH * loop), edge)
    return iterate.inflate(panel, film("mylar"), PRESSURE)  # type: ignore[attr-defined]


def _seconds(work: Callable[[], Any]) -> tuple[Any, float]:
    began = time.process_time()
    result = work()
    return result, time.process_time() - began


def _outlines() -> list[tuple[str, Outline]]:
    pictures = [(path.stem, read_picture(path, 0.3, None)) for path in sorted(PICTURES.glob("*.png"))]
    made = [(f"generated {seed}, {_KINDS[seed % 5]}", generated(seed)) for seed in range(GENERATED)]
    return pictures + made
