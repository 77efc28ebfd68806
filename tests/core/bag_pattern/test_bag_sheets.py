# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is told of balloons of many panels: numbers, the assembly sheet with its steps, the preview."""

from __future__ import annotations

import io
import subprocess
from functools import cache
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from inflated_bags import FILM, inflated_bag

from BalloonWorkbench.core.assembly_sheet.bag_pages import (
    BagSubject,
    bag_assembly_pdf,
    joined_before,
    step_text,
)
from BalloonWorkbench.core.assembly_sheet.steps import steps
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.bag_pattern.make import make_bag_patterns
from BalloonWorkbench.core.bags.seam_colours import seam_colour
from BalloonWorkbench.core.film.filling import Filling
from BalloonWorkbench.core.making.bag_numbers import bag_numbers
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pictures.bag_picture import bag_picture
from BalloonWorkbench.core.pictures.bag_preview import bag_preview_png


@cache
def patterns(name: str) -> BagPatterns:
    return make_bag_patterns(inflated_bag(name), FILM, PatternOptions(intake=False))


@cache
def numbers(name: str) -> Numbers:
    return bag_numbers(inflated_bag(name), patterns(name), FILM, Filling(), exact=False)


def subject(name: str) -> BagSubject:
    return BagSubject(name.capitalize(), FILM, inflated_bag(name), patterns(name), numbers(name))


def test_a_box_weighs_what_its_faces_and_edges_do() -> None:
    """Six rectangles of 300, 200 and 150 mm, each with weld and allowance all round."""
    sizes = [(0.3, 0.2), (0.3, 0.15), (0.2, 0.15)]
    grown = 2.0 * (FILM.seal_width + PatternOptions.allowance)
    inner = 2.0 * sum(x * y for x, y in sizes)
    whole = 2.0 * sum((x + grown) * (y + grown) for x, y in sizes)
    made = numbers("box")
    assert made.film_area == pytest.approx(whole, rel=1e-6)
    assert made.inner == pytest.approx(FILM.areal_density * inner, rel=1e-9)
    assert made.weight == pytest.approx(FILM.areal_density * whole, rel=1e-6)
    assert made.seam_length == pytest.approx(4.0 * (0.3 + 0.2 + 0.15), rel=1e-9)
    assert made.volume == pytest.approx(inflated_bag("box").inflation.volume)
    helium = made.floating[0]
    assert helium.left == pytest.approx(helium.carries - made.weight)
    assert made.roll is not None
    assert made.roll[0] * made.roll[1] > made.film_area


def test_steps_are_those_of_many_panels() -> None:
    drum, box = patterns("drum"), patterns("box")
    many = steps(drum.sheet, FILM, numbers("drum"), panels=drum)
    assert any("tabs" in step for step in many)
    assert not any("tabs" in step for step in steps(box.sheet, FILM, numbers("box"), panels=box))
    assert not any("two panels" in step or "both panels" in step for step in many)
    two = steps(drum.sheet, FILM, numbers("drum"))
    assert not any("same number" in step for step in two)


def test_pictures_of_steps_show_what_hangs_together() -> None:
    order = patterns("box").order
    joined = [joined_before(order, place) for place in range(len(order))]
    assert joined[0] == tuple(sorted(order[0].panels))
    assert joined[-1] == (0, 1, 2, 3, 4, 5)
    for place, step in enumerate(order):
        assert set(step.panels) <= set(joined[place])


def test_each_seam_is_told_with_both_panels() -> None:
    told_of = [step_text(subject("drum"), step) for step in patterns("drum").order]
    assert told_of[0] == "Seam 5: band to band, lying flat."
    assert told_of[1] == "Seam 1: top to band, one edge turned round the other."
    assert told_of[-1].endswith("last, with the opening.")


def test_the_assembly_sheet_has_all_seams(tmp_path: Path) -> None:
    content = bag_assembly_pdf(subject("drum"))
    assert content == bag_assembly_pdf(subject("drum"))
    file = tmp_path / "drum.pdf"
    file.write_bytes(content)
    text = subprocess.run(
        ["pdftotext", "-layout", file, "-"], capture_output=True, text=True, check=True
    ).stdout
    assert text.count("\f") == 3
    for words in ("Pattern, 3 panels", "Order of the seams", "Seam 3: band to bottom", "471.", "180°"):
        assert words in text, words


def test_both_edges_of_a_seam_have_its_colour_in_the_preview() -> None:
    content = bag_preview_png(inflated_bag("box"), patterns("box"))
    assert content == bag_preview_png(inflated_bag("box"), patterns("box"))
    pixels = matplotlib.image.imread(io.BytesIO(content))[:, :, :3]
    flat = pixels[:, 800:]
    for number in range(1, 13):
        colour = np.array([int(seam_colour(number)[k : k + 2], 16) for k in (1, 3, 5)]) / 255.0
        rows, columns = np.nonzero(np.abs(flat - colour).max(axis=2) < 0.01)
        assert len(rows) > 60
        assert max(np.ptp(rows), np.ptp(columns)) > 60, "both edges"


def test_seams_are_told_apart_by_their_colours() -> None:
    colours = [seam_colour(number) for number in range(1, 41)]
    assert len(set(colours)) == 40
    assert all(len(colour) == 7 for colour in colours)


def test_a_picture_of_some_panels_has_less_film() -> None:
    drum = inflated_bag("drum")
    whole, part = ((bag_picture(drum, 80, 80, panels=panels)[:, :, 3] > 0.9).sum() for panels in (None, (2,)))
    assert 0 < part < whole
