# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction, method against method, judged by balloons that none of them has seen."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial

import numpy as np
from cold_balloons import worse_balloon
from drawn_letters import letter_outline
from drawn_shapes import doughnut, generated, ring
from validation.correction import FILM, PRESSURE, Corrected, edge, grown, pictures, seconds_of, side_by_side
from validation.least_squares import to_the_end
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction.fit import VERTICES, Method, fit
from BalloonWorkbench.core.correction.mixing import AndersonMixing
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.types import Floats

USED, LEAST_SQUARES = "the one used", "the one used, then least squares"
METHODS = {
    USED: Method(),
    "without memory": Method(update_rule=partial(AndersonMixing, depth=0)),
    "smoothing 1 throughout": Method(broad=1.0),
    "smoothing 2 throughout": Method(smoothing=2.0, broad=1.0),
}
NAMES = (*METHODS, LEAST_SQUARES)
PICTURES, FONTS = ("bear", "fish", "star"), ("sans bold", "serif bold")
CLEAR = 0.2  # of an error: a smaller difference is as much the meshes' as the method's

Refused = tuple[str, str]  # a drawing, and why


def drawings() -> list[tuple[str, Outline]]:
    """Pictures, generated outlines, rings and letters."""
    made = [(f"generated {seed}", generated(seed)) for seed in (5, 2)]
    rings = [("ring 0.4", ring(0.4)), ("doughnut", doughnut())]
    letters = [(f"{font} {sign}", letter_outline(font, sign)) for font in FONTS for sign in "GN"]
    return [one for one in pictures() if one[0] in PICTURES] + made + rings + letters


def methods(compared: Iterable[tuple[str, Outline]] | None = None) -> Section:
    """The methods on the same drawings, and what their figures say of them."""
    results = side_by_side(_by_all, list(compared or drawings()))
    done = [one for one in results if not isinstance(one, tuple)]
    refused = [
        f"{name} is refused: {why}" for name, why in (one for one in results if isinstance(one, tuple))
    ]
    intro = f"""The same drawings by several methods, film "mylar", {PRESSURE / 1e3:g} kPa, about {VERTICES}
    vertices. The method that is used goes from a coarse mesh and a broad smoothing to a fine one, mixes its
    steps with what the last ones taught, and blows up its pattern anew as a proof. Others leave one of that
    away: steps without memory; the usual smoothing of one mesh size, or one of two, from beginning to end.
    The last one sets out from the pattern of the one used and goes on by damped least squares with the exact
    derivatives of the balloon at rest by its flat film (`benchmarks/validation/least_squares.py`).

    Errors and cost are those of the correction's own section: reported is what a method says of itself, made
    is the balloon of its pattern, which no method has seen."""
    rows = [
        (one.name, method, _percent(one.reported), _percent(one.found), f"{one.cost:.1f}")
        for by_all in done
        for method, one in zip(NAMES, by_all)
    ]
    singly = table(("drawing", "method", "reported", "made", "cost"), rows)
    parts = (paragraphs(intro), _summary(done), paragraphs(_verdict(done)), *refused, singly)
    return Section("Pattern correction: method against method", "\n".join(parts))


def _by_all(named: tuple[str, Outline]) -> list[Corrected] | Refused:
    """One drawing by each of NAMES."""
    name, outline = named
    try:
        once = seconds_of(lambda: inflate(triangulate(grown(outline), edge(outline)), FILM, PRESSURE))[1]
        found = []
        for method in METHODS.values():
            design, seconds = seconds_of(lambda: fit(outline, FILM, PRESSURE, method=method))  # noqa: B023
            found.append(_judged(name, design, seconds, once))
        used = found[0]
        last, seconds = seconds_of(lambda: to_the_end(used.design, FILM, PRESSURE, VERTICES))
        design = replace(used.design, pattern=last.seam_map.outline, residual=last.misfit.residual)
        return [*found, _judged(name, design, used.seconds + seconds, once)]
    except BalloonError as error:
        return name, str(error)


def _judged(name: str, design: Design, seconds: float, once: float) -> Corrected:
    return Corrected(name, design, *worse_balloon(design, FILM, PRESSURE), seconds, seconds / once)


def _figures(done: list[list[Corrected]], what: str) -> Floats:
    """Figures (drawings, methods)."""
    return np.array([[getattr(one, what) for one in by_all] for by_all in done])


def _summary(done: list[list[Corrected]]) -> str:
    reported, made, cost = (_figures(done, what) for what in ("reported", "found", "cost"))
    rows = []
    for number, method in enumerate(NAMES):
        better, worse = _changed(done, number)
        counts = (str(len(better)), str(len(worse))) if number else ("", "")
        own = made[:, number]
        errors = np.median(reported[:, number]), np.median(own), own.mean(), own.max()
        rows.append((method, *map(_percent, errors), *counts, f"{np.median(cost[:, number]):.1f}"))
    head = ("method", "reported, median", "made, median", "mean", "worst", "better for", "worse for", "cost")
    return table(head, rows)


def _verdict(done: list[list[Corrected]]) -> str:
    """What the figures say, in sentences."""
    reported, made, cost = (
        np.median(values / values[:, :1], axis=0)
        for values in (_figures(done, what) for what in ("reported", "found", "cost"))
    )
    said = [
        f"""Over all {len(done)} drawings, the cost as a median; a method is better or worse than the one used
        where what is made differs by more than {100 * CLEAR:.0f} %."""
    ]
    for number, method in enumerate(NAMES[1:], start=1):
        better, worse = (", ".join(names) or "none" for names in _changed(done, number))
        said.append(
            f"""{method.capitalize()}: {made[number]:.2f} times the error of the one used, in the median, at
            {cost[number]:.2f} times its cost; better for {better}; worse for {worse}."""
        )
    errors = _figures(done, "found")
    best, safest = NAMES[np.argmin(errors.mean(axis=0))], NAMES[np.argmin(errors.max(axis=0))]
    said.append(f"The smallest error in the mean: {best}; in the worst case: {safest}.")
    suits = "more than" if reported[-1] < made[-1] else "no more than"
    least = f"""Least squares leaves {reported[-1]:.2f} of the error that is reported, and {made[-1]:.2f} of
    that which is made: what it adds to the pattern suits its own mesh {suits} the film."""
    return " ".join(said) + "\n\n" + least


def _changed(done: list[list[Corrected]], number: int) -> tuple[list[str], list[str]]:
    """Drawings for which a method makes a clearly better balloon, and a worse one, than the one used."""
    pairs = [(by_all[number], by_all[0]) for by_all in done]
    better = [one.name for one, used in pairs if one.found < (1.0 - CLEAR) * used.found]
    return better, [one.name for one, used in pairs if one.found > used.found / (1.0 - CLEAR)]


def _percent(share: float) -> str:
    return f"{100 * share:.3f} %"
