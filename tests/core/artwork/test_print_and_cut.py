# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print, marks and cut agree within 0.1 mm for each machine, found in a picture by `print_and_cut.py`."""

from __future__ import annotations

import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED
from inflated import designed
from print_and_cut import (
    Lines,
    disagreement,
    lines_of,
    mapped,
    marks_of,
    matched,
    off_border,
    photographed,
    seen,
)
from printed import box_of

from BalloonWorkbench.core.artwork.border import bordered
from BalloonWorkbench.core.artwork.files import artwork_pdf
from BalloonWorkbench.core.artwork.picture import covering
from BalloonWorkbench.core.artwork.sheet import Print, Sheet, artwork_sheets
from BalloonWorkbench.core.machines.machine import machine, machines
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.pattern.build import build_pattern

#: Machines that look for marks themselves, and one of those that are told where they are.
LOOKING = sorted(name for name, known in machines().items() if known.marks.style not in ("crosses", "none"))
AGREED = 0.1  # mm
needs_poppler = pytest.mark.skipif(shutil.which("pdftoppm") is None, reason="poppler-utils are not installed")


@cache
def heart() -> Print:
    """A grey heart without bleed, 75 mm wide: the border of the print is the cut."""
    design = designed(NAMED["heart"].map(lambda loop: 0.25 * loop), 250)
    own = bordered(build_pattern(design.pattern, 0.005), 0.0)
    picture = covering(np.full((9, 9, 4), (170, 170, 170, 255), np.uint8), *box_of(design.pattern.outer))
    return Print(design.inflation, own, np.zeros(2), picture)


@cache
def printed_for(name: str, dpi: float = 300.0) -> tuple[Sheet, Sheet]:
    """Front and back of it with a machine's marks."""
    marks = machine(name).marks
    return artwork_sheets([heart()], marked(heart().pattern, marks), dpi, marks)


def read(sheet: Sheet, name: str) -> tuple[Lines, list[np.ndarray]]:
    """The lines of the machine's file, and those of its marks."""
    made_for = machine(name)
    lines = lines_of(machine_file(sheet.pattern, made_for), made_for.file_name)
    layer = next(line.name for role, line in made_for.layers.items() if role.value == "REGISTRATION")
    return lines, lines[layer]


@needs_poppler
@pytest.mark.parametrize("name", [*LOOKING, "lightburn"])
def test_cut_and_print_agree(name: str, tmp_path: Path) -> None:
    """Also that it can fail: with one mark of the file off by 0.3 mm they do not."""
    sheet, _ = printed_for(name)
    (tmp_path / "page.pdf").write_bytes(artwork_pdf([sheet]))
    picture = photographed(tmp_path / "page.pdf")
    lines, marks = read(sheet, name)
    drawn = marks_of(marks)
    assert len(drawn) == {"silhouette": 3, "crosses": 3, "dots": 5}.get(machine(name).marks.style, 4)
    if name == "lightburn":  # two targets far apart, as its users choose them
        kept = np.argsort(np.hypot(*(drawn - drawn.mean(axis=0)).T))[-2:]
        found = matched(drawn, seen(picture))[kept]
        drawn = drawn[kept]
        cut = lines["CUT"][0]
        assert off_border(mapped(cut, drawn, found), picture).max() < AGREED
        drawn[0] += (0.21, -0.21)
        assert off_border(mapped(cut, drawn, found), picture).max() > AGREED
        return
    assert disagreement(lines, drawn, picture) < AGREED
    wrong = drawn.copy()
    wrong[0] += (0.21, -0.21)
    assert disagreement(lines, wrong, picture) > AGREED
