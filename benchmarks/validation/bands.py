# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters of two panels against letters with a side band, in one table."""

from __future__ import annotations

import string
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from drawn_letters import letter_outline
from validation.correction import FILM, PRESSURE, side_by_side
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.bag_design.band_fit import fit_band
from BalloonWorkbench.core.bodies.banded import SideBand
from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.errors import BalloonError

SIGNS = string.ascii_uppercase + string.digits
BAND = SideBand(0.04, 0.5)


@dataclass(frozen=True)
class Compared:
    """A letter of two panels and with a band: errors, mean of the larger dimension, thickness and volume.

    holes  how many it has; refused: why there is none of a kind, with its numbers infinite
    """

    sign: str
    holes: int
    errors: tuple[float, float]
    thicknesses: tuple[float, float]
    volumes: tuple[float, float]
    warnings: int
    refused: str = ""


def bands() -> Section:
    """Every letter both ways; letters with holes told apart."""
    letters = side_by_side(_compared, SIGNS)
    text = paragraphs(
        f"""Capitals and digits of a bold font, 0.3 m, film "mylar", {PRESSURE / 1e3:g} kPa: two panels
        against front, back and a band of {1e3 * BAND.width:g} mm. Errors are mean two-way
        distances between drawing and inflated silhouette, in per cent of the larger dimension, as designs
        report them: of the pattern meshed anew and blown up from its start."""
    )
    groups = {
        "all": letters,
        "without holes": [letter for letter in letters if not letter.holes],
        "with holes": [letter for letter in letters if letter.holes],
    }
    head = ("letters", "number", "two panels: mean", "95 %", "worst", "with a band: mean", "95 %", "worst")
    text += "\n" + table(head, [_row(name, group) for name, group in groups.items()])
    head = ("letter", "holes", "two panels", "with a band", "thickness [mm]", "times", "volume [l]", "times")
    text += "\n" + table(head, [_letter_row(letter) for letter in letters])
    refused = [f"{letter.sign}: {letter.refused}" for letter in letters if letter.refused]
    return Section("Letters with a side band", text + ("\n" + "\n".join(refused) + "\n" if refused else ""))


def _compared(sign: str) -> Compared:
    outline = letter_outline("sans bold", sign)
    holes = len(outline.holes)
    try:
        flat, banded = fit(outline, FILM, PRESSURE), fit_band(outline, BAND, FILM, PRESSURE)
    except BalloonError as refused:
        nothing = (np.inf, np.inf)
        return Compared(sign, holes, nothing, nothing, nothing, 0, str(refused))
    assert banded.residual is not None
    return Compared(
        sign,
        holes,
        (flat.residual.mean / max(outline.size), banded.residual.mean / banded.size),
        (
            2.0 * float(flat.inflation.positions[:, 2].max()),
            float(np.ptp(banded.inflation.positions[:, 2])),
        ),
        (flat.inflation.volume, banded.inflation.volume),
        len(banded.warnings),
    )


def _row(name: str, letters: Sequence[Compared]) -> list[str]:
    cells = [name, str(len(letters))]
    for kind in (0, 1):
        errors = 100.0 * np.array([letter.errors[kind] for letter in letters])
        cells += [f"{value:.3f}" for value in (errors.mean(), np.percentile(errors, 95), errors.max())]
    return cells


def _letter_row(letter: Compared) -> list[str]:
    (flat, banded), (thin, thick), (small, large) = letter.errors, letter.thicknesses, letter.volumes
    return [
        letter.sign,
        str(letter.holes),
        f"{100.0 * flat:.3f}",
        f"{100.0 * banded:.3f}",
        f"{1e3 * thin:.0f}, {1e3 * thick:.0f}",
        f"{thick / thin:.2f}",
        f"{1e3 * small:.2f}, {1e3 * large:.2f}",
        f"{large / small:.2f}",
    ]
