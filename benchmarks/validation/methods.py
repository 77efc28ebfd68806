# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction, method against method, judged by balloons that none of them has seen."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from cold_balloons import VERTICES as COLD_VERTICES
from cold_balloons import cold_balloon
from drawn_letters import letter_outline
from drawn_shapes import generated, ring
from validation.correction import PICTURES, PRESSURE
from validation.least_squares import to_the_end
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction.fit import VERTICES, Method, fit
from BalloonWorkbench.core.correction.mixing import AndersonMixing
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.tracing.picture import read_picture

FILM = film("mylar")
USED, LEAST_SQUARES = "the one used", "the one used, then least squares"
FONTS = ("sans bold", "serif bold")
METHODS = {
    USED: Method(),
    "without memory": Method(update_rule=partial(AndersonMixing, depth=0)),
    "smoothing 1 throughout": Method(broad=1.0),
    "smoothing 2 throughout": Method(smoothing=2.0, broad=1.0),
}
_NAMES = (*METHODS, LEAST_SQUARES)
CLEAR = 0.2  # of a cold error: a smaller difference is as much the meshes' as the method's


@dataclass(frozen=True)
class _Found:
    """What a method came to: errors as shares of the drawing's larger dimension.

    reported     by the correction itself
    cold, worst  mean and greatest of a balloon of the pattern that was blown up anew on other meshes
    cost         processor time in cold inflations
    """

    drawing: str
    method: str
    reported: float
    cold: float
    worst: float
    cost: float


def drawings() -> dict[str, Outline]:
    """Pictures, generated outlines, rings and letters."""
    found = {name: read_picture(PICTURES / f"{name}.png", 0.3, None) for name in ("bear", "fish", "star")}
    found |= {"generated 5 (smooth)": generated(5), "generated 2 (spiky)": generated(2)}
    found |= {f"ring {share:g}": ring(share) for share in (0.4, 0.6)}
    return found | {f"{sign} {font}": letter_outline(font, sign) for font in FONTS for sign in "GN"}


def methods(compared: Mapping[str, Outline] | None = None) -> Section:
    """The methods on the same drawings, and what their figures say of them."""
    found: list[_Found] = []
    refused = []
    for name, outline in (compared or drawings()).items():
        try:
            found += list(_of_drawing(name, outline))
        except BalloonError as error:
            refused.append((name, f"refused: {error}", *[""] * 4))
    rows = [
        (one.drawing, one.method, *map(_percent, (one.reported, one.cold, one.worst)), f"{one.cost:.1f}")
        for one in found
    ]
    meshes = " and ".join(map(str, COLD_VERTICES))
    intro = f"""The same drawings by several methods, film "mylar", {PRESSURE / 1e3:g} kPa, about {VERTICES}
    vertices. The method that is used goes from a coarse mesh and a broad smoothing to a fine one, mixes its
    steps with what the last ones taught, and blows up its pattern anew as a proof. Others leave one of that
    away: steps without memory; the usual smoothing of one mesh size, or one of two, from beginning to end.
    The last one sets out from the pattern of the one used and goes on by damped least squares with the exact
    derivatives of the balloon at rest by its flat film (`benchmarks/validation/least_squares.py`).

    Errors are mean distances between drawing and inflated silhouette in per cent of the larger dimension: the
    one that the method reports, and that of a cold balloon, which no method has seen: the pattern as it is
    cut, meshed anew with {meshes} vertices and blown up from the flat film, the worse one of the two. The
    cost is processor time in cold inflations of the pattern."""
    head = ("drawing", "method", "reported", "cold", "greatest, cold", "cost")
    parts = [paragraphs(intro), _summary(found), paragraphs(_verdict(found)), table(head, rows + refused)]
    return Section("Pattern correction: method against method", "\n".join(parts))


def _of_drawing(name: str, outline: Outline) -> Iterator[_Found]:
    """All methods on one drawing."""
    first, once, spent = None, 1.0, 0.0
    for text, method in METHODS.items():
        began = time.process_time()
        design = fit(outline, FILM, PRESSURE, method=method)
        seconds = time.process_time() - began
        if first is None:
            first, once, spent = design, _cold_seconds(design.pattern), seconds
        yield _judged(name, text, design, seconds / once)
    assert first is not None
    began = time.process_time()
    last = to_the_end(first, FILM, PRESSURE, VERTICES)
    spent += time.process_time() - began
    end = replace(first, pattern=last.seam_map.outline, residual=last.misfit.residual)
    yield _judged(name, LEAST_SQUARES, end, spent / once)


def _judged(name: str, method: str, design: Design, cost: float) -> _Found:
    size = max(design.target.size)
    balloons = (cold_balloon(design.target, design.pattern, FILM, PRESSURE, count) for count in COLD_VERTICES)
    cold = max((error for _, error in balloons), key=lambda error: error.mean)
    return _Found(name, method, design.residual.mean / size, cold.mean / size, cold.max / size, cost)


def _cold_seconds(pattern: Outline) -> float:
    began = time.process_time()
    inflate(triangulate(pattern, size_for(pattern, VERTICES)), FILM, PRESSURE)
    return time.process_time() - began


def _all(found: list[_Found], method: str, what: str) -> list[float]:
    return [getattr(one, what) for one in found if one.method == method]


def _summary(found: list[_Found]) -> str:
    rows = []
    for method in _NAMES:
        cold = _all(found, method, "cold")
        better, worse = _changed(found, method)
        counts = ("", "") if method == USED else (str(len(better)), str(len(worse)))
        errors = np.median(_all(found, method, "reported")), np.median(cold), max(cold)
        cost = f"{np.median(_all(found, method, 'cost')):.1f}"
        rows.append((method, *map(_percent, errors), *counts, cost))
    head = ("method", "reported, median", "cold, median", "cold, worst", "better for", "worse for", "cost")
    return table(head, rows)


def _verdict(found: list[_Found]) -> str:
    """What the figures say, in sentences."""
    said = [
        f"""Medians, and the worst one, over all drawings; a method is better or worse than the one used where
        the cold errors differ by more than {100 * CLEAR:.0f} %."""
    ]
    for method in _NAMES[1:]:
        better, worse = _changed(found, method)
        cold, cost = (_ratio(found, method, what) for what in ("cold", "cost"))
        said.append(
            f"""{method.capitalize()}: {cold:.2f} times the cold error of the one used, in the median, at
            {cost:.2f} times its cost; better for {_listed(better)}; worse for {_listed(worse)}."""
        )
    median = min(_NAMES, key=lambda method: np.median(_all(found, method, "cold")))
    worst = min(_NAMES, key=lambda method: max(_all(found, method, "cold")))
    said.append(f"The smallest cold error in the median: {median}; in the worst case: {worst}.")
    reported, cold = (_ratio(found, LEAST_SQUARES, what) for what in ("reported", "cold"))
    suits = "more than" if reported < cold else "no more than"
    said.append(
        f"""Least squares leaves {reported:.2f} of the error that the one used reports, and {cold:.2f} of that
        of the cold balloon: what it adds to the pattern suits its own mesh {suits} the film."""
    )
    return "\n\n".join([" ".join(said[:-1]), said[-1]])


def _changed(found: list[_Found], method: str) -> tuple[list[str], list[str]]:
    """Drawings for which the cold error is clearly better, and worse, than by the method used."""
    pairs = list(_beside_the_used(found, method))
    better = [one.drawing for one, used in pairs if one.cold < (1.0 - CLEAR) * used.cold]
    return better, [one.drawing for one, used in pairs if one.cold > used.cold / (1.0 - CLEAR)]


def _ratio(found: list[_Found], method: str, what: str) -> float:
    """Median ratio to the method used."""
    pairs = _beside_the_used(found, method)
    return float(np.median([getattr(one, what) / getattr(used, what) for one, used in pairs]))


def _beside_the_used(found: list[_Found], method: str) -> Iterator[tuple[_Found, _Found]]:
    used = {one.drawing: one for one in found if one.method == USED}
    return ((one, used[one.drawing]) for one in found if one.method == method)


def _listed(names: Iterable[str]) -> str:
    return ", ".join(names) or "none"


def _percent(share: float) -> str:
    return f"{100 * share:.3f} %"
