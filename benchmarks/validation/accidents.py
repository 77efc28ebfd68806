# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether accidents decide: slightly other drawings, other meshes, another order of points."""

from __future__ import annotations

from itertools import starmap

import numpy as np
from cold_balloons import laid_on, worse_balloon
from drawn_letters import letter_outline
from drawn_shapes import generated, ring
from validation.correction import FILM, PRESSURE, edge, pictures, side_by_side
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.correction.fit import VERTICES, fit
from BalloonWorkbench.core.design.compare import residual
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Floats

GENERATED = 20
LETTERS = (("sans bold", "S"), ("sans bold", "A"), ("serif bold", "N"), ("sans bold", "O"))
MESHES = (600, 1000, 3000, 5000)
OTHERWISE = 1e-3  # of the larger dimension, by which a drawing is drawn otherwise
ERROR, PATTERN = 5e-4, 2e-3  # changes that are asked for, of the larger dimension


def accidents() -> Section:
    """How much the balloon's error and the pattern change."""
    outlines = _outlines()
    results = side_by_side(_changes, outlines)
    names = ["drawing", "order of points", *(f"{count} vertices" for count in MESHES)]
    errors, patterns = (
        np.array([found[part] for found in results]) for part in (0, 1)
    )  # (outline, accident)
    rows = [
        (
            name,
            f"{100 * np.median(error):.3f}",
            f"{100 * np.percentile(error, 95):.3f}",
            f"{np.count_nonzero(error <= ERROR)} of {len(error)}",
            f"{100 * np.median(pattern):.3f}",
            f"{100 * np.percentile(pattern, 95):.3f}",
            f"{np.count_nonzero(pattern <= PATTERN)} of {len(pattern)}",
        )
        for name, error, pattern in zip(names, errors.T, patterns.T, strict=True)
    ]
    worst = [
        f"{outlines[place][0]}, {names[number]}: {100 * errors[place, number]:.2f} %"
        for place, number in zip(*np.nonzero(errors > ERROR))
    ]
    text = paragraphs(
        f"""{len(outlines)} outlines (pictures, generated ones, letters, rings), each corrected again: drawn
        otherwise by {100 * OTHERWISE:g} % of the larger dimension in smooth waves; with its points numbered
        from another one on; on other meshes than the usual {VERTICES} vertices. Changes of the mean error of
        the balloon that is blown up anew, and mean distances of the patterns, laid on each other: in per cent
        of the larger dimension; asked for are {100 * ERROR:g} % and {100 * PATTERN:g} %."""
    )
    head = ("accident", "error: median", "95 %", "within", "pattern: median", "95 %", "within")
    text += "\n" + table(head, rows)
    text += "\n" + paragraphs(f"Errors that change by more: {'; '.join(worst) or 'none'}.")
    return Section("Accidents", text)


def _changes(named: tuple[str, Outline]) -> tuple[list[float], list[float]]:
    """Changes of the error and of the pattern, one for each accident."""
    outline = named[1]
    size, (error, pattern) = max(outline.size), _made(outline, None)
    cases = [(drawn_otherwise(outline), None), (renumbered(outline), None)]
    cases += [(outline, edge(outline, count)) for count in MESHES]
    made = list(starmap(_made, cases))
    return (
        [abs(other - error) for other, _ in made],
        [residual(pattern, laid_on(other, pattern)).mean / size for _, other in made],
    )


def _made(outline: Outline, mesh_size: float | None) -> tuple[float, Outline]:
    design = fit(outline, FILM, PRESSURE, mesh_size=mesh_size)
    return worse_balloon(design, FILM, PRESSURE)[1].mean / max(outline.size), design.pattern


def drawn_otherwise(outline: Outline, seed: int = 1) -> Outline:
    """An outline moved by a smooth field of the plane whose root mean square is OTHERWISE of its size."""
    random, size = np.random.default_rng(seed), max(outline.size)
    waves, phases = random.normal(size=(8, 2, 2)) * 2.0 * np.pi / size, random.uniform(0.0, 6.3, (8, 2))

    def moved(loop: Floats) -> Floats:
        field = np.sin(np.einsum("wdi,ni->nwd", waves, loop) + phases).sum(axis=1) / 2.0
        return loop + OTHERWISE * size / np.sqrt(2.0) * field

    return outline.map(moved)


def renumbered(outline: Outline) -> Outline:
    """The same loops, each beginning a third of the way round."""
    return outline.map(lambda loop: np.roll(loop, len(loop) // 3, axis=0))


def _outlines() -> list[tuple[str, Outline]]:
    made = [(f"generated {seed}", generated(seed)) for seed in range(GENERATED)]
    letters = [(f"{font} {sign}", letter_outline(font, sign)) for font, sign in LETTERS]
    return [*pictures(), *made, *letters, ("ring 0.4", ring(0.4))]
