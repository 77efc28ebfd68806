# SPDX-License-Identifier: LGPL-2.1-or-later
"""PDF files of patterns, read and drawn by poppler: lines within 0.05 mm, sizes, pages that fit together."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from read_back import NEAR, apart, compare, page_lines, pages_of, run, wanted

from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import drawing_file, machine_file
from BalloonWorkbench.core.machines.toolpaths import BAR, draw
from BalloonWorkbench.core.machines.writers.pdf import PAPERS
from BalloonWorkbench.core.pattern.build import build_pattern

PAPER = machine("paper")
PATTERNS = {name: build_pattern(NAMED[name], 0.005) for name in ("heart", "holes")}
SMALL = build_pattern(NAMED["heart"].map(lambda loop: 0.4 * loop), 0.005)
MARGIN, OVERLAP, STROKE = 12.0, 10.0, 0.25  # mm
DPI = 1200
LAYERS = {look.rgb: look.name for look in PAPER.layers.values()}


def ink(file: Path, page: int, folder: Path) -> np.ndarray:
    """How bright a page is, drawn by poppler: rows from the top."""
    name, number = folder / "page", str(page)
    run("pdftoppm", "-r", str(DPI), "-f", number, "-l", number, "-singlefile", "-gray", file, name)
    content = name.with_suffix(".pgm").read_bytes()
    header = re.match(rb"P5\s(\d+) (\d+)\s255\s", content)
    width, height = int(header[1]), int(header[2])
    return np.frombuffer(content, np.uint8, offset=header.end()).reshape(height, width)


@pytest.mark.parametrize("name", PATTERNS)
def test_the_lines_of_the_page(name: str, tmp_path: Path) -> None:
    pattern = PATTERNS[name]
    file = tmp_path / "pattern.pdf"
    file.write_bytes(machine_file(pattern, PAPER))
    assert b"/PrintScaling /None" in file.read_bytes()  # printers must not fit the page
    found, _ = page_lines(file, 1, tmp_path)
    moved = [(LAYERS[rgb], shapely.transform(each, lambda at: at - MARGIN)) for rgb, each in found]
    compare(moved, pattern, PAPER)


def test_the_ink_has_the_real_size(tmp_path: Path) -> None:
    drawing = draw(SMALL, PAPER)
    file = tmp_path / "pattern.pdf"
    file.write_bytes(drawing_file(drawing, PAPER))
    size = np.array([drawing.width, drawing.height])
    assert pages_of(file)[1] == pytest.approx(size + 2.0 * MARGIN, abs=0.01)
    dark = ink(file, 1, tmp_path) < 240
    # half a stroke beyond the lines, but not below: there the ticks of the control bar end
    for axis, more in ((0, STROKE), (1, 0.5 * STROKE)):
        at = np.flatnonzero(dark.any(axis=axis))
        assert (at[-1] + 1 - at[0]) * 25.4 / DPI == pytest.approx(size[axis] + more, abs=NEAR)
    # the control bar is the lowest line
    low = np.flatnonzero(dark.any(axis=1))[-1] - round(2.0 * DPI / 25.4)
    bar = np.flatnonzero(dark[low])
    assert (bar[-1] + 1 - bar[0]) * 25.4 / DPI == pytest.approx(BAR + STROKE, abs=NEAR)


@pytest.mark.parametrize("paper", ["A4", "Letter"])
def test_tiles_glued_together_are_the_pattern(paper: str, tmp_path: Path) -> None:
    """Pages laid on each other by their overlap show all lines, each in its place, and no others."""
    pattern = PATTERNS["heart"]
    drawing = draw(pattern, PAPER)
    file = tmp_path / "tiles.pdf"
    file.write_bytes(drawing_file(drawing, PAPER, paper))
    count, size = pages_of(file)
    assert sorted(size) == pytest.approx(sorted(PAPERS[paper.upper()]), abs=0.05)
    step = size - 2.0 * MARGIN - OVERLAP
    rows = int(np.ceil((drawing.height - OVERLAP) / step[1]))
    glued: dict[str, list[shapely.Geometry]] = {}
    for page in range(2, count + 1):
        words = run("pdftotext", "-f", str(page), "-l", str(page), file, "-")
        column, row = (int(value) for value in re.search(r"column (\d+), row (\d+)", words).groups())
        place = step * [column - 1, rows - row] - MARGIN
        found, window = page_lines(file, page, tmp_path)
        assert shapely.box(*(MARGIN + np.zeros(2)), *(size - MARGIN)).buffer(0.01).covers(window)
        for rgb, each in found:
            if rgb in LAYERS and LAYERS[rgb] != "ENGRAVE":  # black are the crop marks
                seen = shapely.transform(each.intersection(window), lambda at, place=place: at + place)
                glued.setdefault(LAYERS[rgb], []).append(seen)
    for layer in ("CUT", "SEAL"):
        whole = shapely.union_all([each for name, each in wanted(pattern, PAPER) if name == layer])
        assert apart(shapely.union_all(glued[layer]), whole) < NEAR
    bar = shapely.union_all(glued["REGISTRATION"])
    assert bar.bounds[2] - bar.bounds[0] == pytest.approx(BAR, abs=0.01)


def test_crop_marks_are_an_overlap_apart(tmp_path: Path) -> None:
    """Four crosses on each page; the right and the upper ones are the neighbours' left and lower ones."""
    file = tmp_path / "tiles.pdf"
    file.write_bytes(machine_file(PATTERNS["heart"], PAPER, "A4"))
    size = pages_of(file)[1]
    for page in (2, 3):
        found, _ = page_lines(file, page, tmp_path)
        arms = [each for rgb, each in found if rgb == "#000000"]
        assert len(arms) == 8
        for x in (MARGIN, size[0] - MARGIN - OVERLAP):
            for y in (MARGIN, size[1] - MARGIN - OVERLAP):
                for arm in ([(x - 5.0, y), (x + 5.0, y)], [(x, y - 5.0), (x, y + 5.0)]):
                    assert min(apart(each, shapely.LineString(arm)) for each in arms) < NEAR


def test_first_page_measures_what_it_says(tmp_path: Path) -> None:
    """Millimetres and inches of the same pattern, and the bar of 100 mm with a tick across each end."""
    drawing = draw(PATTERNS["heart"], PAPER)
    file = tmp_path / "tiles.pdf"
    file.write_bytes(drawing_file(drawing, PAPER, "A4"))
    lines = run("pdftotext", "-f", "1", "-l", "1", "-layout", file, "-").splitlines()
    told = next(line for line in lines if " mm (" in line)
    across, up, wide, high = map(float, re.findall(r"[\d.]+", told)[:4])
    assert (across, up) == pytest.approx((drawing.width, drawing.height), abs=0.06)
    assert (wide, high) == pytest.approx((drawing.width / 25.4, drawing.height / 25.4), abs=0.006)
    mm = DPI / 25.4
    dark = ink(file, 1, tmp_path)[round(44.0 * mm) : round(52.0 * mm)] < 200
    bar = np.flatnonzero(dark[round(4.0 * mm)])
    assert (bar[-1] + 1 - bar[0]) / mm == pytest.approx(BAR + STROKE, abs=NEAR)
    assert bar[0] / mm == pytest.approx(MARGIN - 0.5 * STROKE, abs=NEAR)
    for column in (bar[0], bar[-1]):
        tick = np.flatnonzero(dark[:, column]) / mm
        assert np.ptp(tick) == pytest.approx(4.0, abs=NEAR)
        assert tick.mean() == pytest.approx(4.0, abs=NEAR)
