# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces as they lie, on paper: in real size on pages, with a print under their lines."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from BalloonWorkbench.core.arrangement.arrangement import LaidPieces, as_one, places_of
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.machines.writers.pdf import PrintedPicture, tiled_pdf
from BalloonWorkbench.core.results.flat_maps import FlatPicture
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import to_mm


def paper_pdf(
    laid: LaidPieces, pictures: Mapping[int, FlatPicture], paper: str, say: Say = in_english
) -> bytes:
    """The pages of "A4", "A3" or "Letter"; pictures by the number of the piece that they lie on, where the
    pattern lays it. Raises what `tiled_pdf` does."""
    made_for = machine("paper")
    drawing = draw(as_one(laid.pieces), made_for)
    printed = []
    for number, each in sorted(pictures.items()):
        (left, bottom), (right, top) = each.low, each.high
        corners = places_of(laid, number, np.array([(left, bottom), (right, bottom), (left, top)]))
        printed.append(PrintedPicture(each.pixels, to_mm(corners) - drawing.corner))
    return tiled_pdf(drawing, made_for, paper, say, printed)
