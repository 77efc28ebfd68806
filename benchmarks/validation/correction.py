# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction of pictures, generated outlines, letters and rings, judged by balloons blown up anew."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from cold_balloons import worse_balloon
from drawn_letters import FONTS, SIGNS, letter_outline
from drawn_shapes import doughnut, generated, ring, snail, spiral
from validation import figures
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction.fit import VERTICES, fit
from BalloonWorkbench.core.design.design import Design, Residual
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

PICTURES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures"
FILM = film("mylar")
PRESSURE = 2000.0
GENERATED = 200
RINGS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
GROWTH = 1.28  # of a drawing to its pattern, about
FAR = 1e-3  # mean error, of the larger dimension, that is named
WORST = 6
SHOWN = {
    "O": ("sans bold", "O"),
    "doughnut": None,
    "S": ("sans bold", "S"),
    "G": ("serif bold", "G"),
    "snail": None,
    "spiral": None,
}


Given, Result = TypeVar("Given"), TypeVar("Result")


@dataclass(frozen=True)
class Corrected:
    """One outline: its design, the balloon of its pattern blown up anew, and what the design took.

    cost  processor seconds of the correction by those of one balloon of the grown drawing
    """

    name: str
    design: Design
    silhouette: Outline
    cold: Residual
    seconds: float
    cost: float

    @property
    def reported(self) -> float:
        """The mean error that the design promises, of its larger dimension."""
        return self.design.residual.mean / max(self.design.target.size)

    @property
    def found(self) -> float:
        """The same of the balloon that was blown up anew."""
        return self.cold.mean / max(self.design.target.size)


def correction(images: Path) -> Section:
    """What is reported against what is made, set by set; the worst ones and some shapes as pictures."""
    sets = {name: corrected(outlines) for name, outlines in _sets().items()}
    done = [one for results in sets.values() for one in results if isinstance(one, Corrected)]
    worst = sorted(done, key=lambda one: -one.found)[:WORST]
    figures.cold_balloons(worst, images / "validation-correction.svg")
    named = {one.name: one for one in done}
    shown = [named[" ".join(letter) if letter else name] for name, letter in SHOWN.items()]
    figures.cold_balloons(shown, images / "validation-cold.svg")
    cost = np.array([one.cost for one in done])
    text = paragraphs(
        f"""The pattern of a balloon of 0.3 m that shall look like the drawing, film "mylar",
        {PRESSURE / 1e3:g} kPa, about {VERTICES} vertices. Errors are mean two-way distances between drawing
        and inflated silhouette, in per cent of the larger dimension. Reported is what the design says of
        itself. Made is the balloon of the pattern as it is cut, meshed anew by other code with other sizes
        (`tests/core/cold_balloons.py`), blown up from the flat film and at rest:
        the worse of two. Cost is the processor time of the whole correction by that of one such balloon.

        {len(done)} outlines, made: {_spread([100 * one.found for one in done])}; cost: median
        {np.median(cost):.1f}, most {cost.max():.0f} balloons."""
    )
    head = (
        *("outlines", "number", "reported: median", "95 %", "worst", "made: median", "mean", "95 %", "worst"),
        *("above 0.1 %", "passes, most", "cost, most"),
    )
    text += "\n" + table(head, [_row(name, results) for name, results in sets.items()])
    text += "\n" + _named(sets)
    text += "\n" + paragraphs("Six shapes: drawing grey, the balloon that is made red, pattern blue.")
    text += "\n![Corrected patterns and their balloons](images/validation-cold.svg)\n"
    text += "\n" + paragraphs("The worst ones of all.")
    text += "\n![The worst corrections](images/validation-correction.svg)\n"
    return Section("Pattern correction", text)


def corrected(outlines: Iterable[tuple[str, Outline]]) -> list[Corrected | tuple[str, str]]:
    """Each outline corrected, side by side on the processors, or its name and why it was refused."""
    return side_by_side(_corrected, outlines)


def side_by_side(work: Callable[[Given], Result], given: Iterable[Given]) -> list[Result]:
    """What some work gives for each, on all processors."""
    with ProcessPoolExecutor(os.cpu_count(), get_context("spawn")) as pool:
        return list(pool.map(work, given))


def _corrected(named: tuple[str, Outline]) -> Corrected | tuple[str, str]:
    name, outline = named
    try:
        cold = seconds_of(lambda: inflate(triangulate(grown(outline), edge(outline)), FILM, PRESSURE))[1]
        design, seconds = seconds_of(lambda: fit(outline, FILM, PRESSURE))
        silhouette, error = worse_balloon(design, FILM, PRESSURE)
    except BalloonError as refused:
        return name, str(refused)
    return Corrected(name, design, silhouette, error, seconds, seconds / cold)


def grown(outline: Outline) -> Outline:
    """A drawing at about the size of its pattern."""
    return outline.map(lambda loop: GROWTH * loop)


def edge(outline: Outline, vertices: int = VERTICES) -> float:
    """Mesh size for so many vertices in the pattern of a drawing [m]."""
    return size_for(grown(outline), vertices)


def seconds_of(work: Callable[[], Any]) -> tuple[Any, float]:
    """What some work gives, and its processor seconds."""
    began = time.process_time()
    result = work()
    return result, time.process_time() - began


def pictures() -> list[tuple[str, Outline]]:
    """The example pictures."""
    return [(path.stem, read_picture(path, 0.3, None)) for path in sorted(PICTURES.glob("*.png"))]


def _sets() -> dict[str, list[tuple[str, Outline]]]:
    return {
        "example pictures": pictures(),
        "generated outlines": [(f"generated {seed}", generated(seed)) for seed in range(GENERATED)],
        **{font: [(f"{font} {sign}", letter_outline(font, sign)) for sign in SIGNS] for font in FONTS},
        "rings": [(f"ring {share:g}", ring(share)) for share in RINGS],
        "doughnut, snail, spiral": [("doughnut", doughnut()), ("snail", snail()), ("spiral", spiral())],
    }


def _row(name: str, results: Sequence[Corrected | tuple[str, str]]) -> tuple[str, ...]:
    done = [one for one in results if isinstance(one, Corrected)]
    reported = 100 * np.array([one.reported for one in done])
    found = 100 * np.array([one.found for one in done])
    passes, cost = ([one.design.passes for one in done], [one.cost for one in done])
    told = np.median(reported), np.percentile(reported, 95), reported.max()
    made = np.median(found), found.mean(), np.percentile(found, 95), found.max()
    return (
        name,
        str(len(results)),
        *(f"{value:.3f}" for value in (*told, *made)),
        str(np.count_nonzero(found > 100 * FAR)),
        f"{np.median(passes):.0f}, {max(passes)}",
        f"{np.median(cost):.1f}, {max(cost):.0f}",
    )


def _named(sets: dict[str, list[Corrected | tuple[str, str]]]) -> str:
    """Those above 0.1 % by name, and those that were refused."""
    results = [one for found in sets.values() for one in found]
    far = [one for one in results if isinstance(one, Corrected) and one.found > FAR]
    lines = [
        f"{one.name} {100 * one.found:.2f} % (reported {100 * one.reported:.2f} %)"
        for one in sorted(far, key=lambda one: -one.found)
    ]
    text = f"Above 0.1 %: {', '.join(lines) or 'none'}."
    refused = [one for one in results if not isinstance(one, Corrected)]
    if refused:
        text += " Refused: " + "; ".join(f"{name}: {why}" for name, why in refused)
    return paragraphs(text)


def _spread(values: Sequence[float]) -> str:
    return (
        f"median {np.median(values):.3f} %, mean {np.mean(values):.3f} %, 95 % of them within"
        f" {np.percentile(values, 95):.3f} %, worst {max(values):.3f} %"
    )
