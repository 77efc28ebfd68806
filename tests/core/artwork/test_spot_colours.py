# SPDX-License-Identifier: LGPL-2.1-or-later
"""A print shop's PDF: cuts are stroked in the spot colour CutContour, over the print, as poppler sees it."""

from __future__ import annotations

import re
import shutil
import subprocess
import zlib
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED
from inflated import designed
from matplotlib.image import imread
from printed import MM, box_of

from BalloonWorkbench.core.artwork.border import bordered
from BalloonWorkbench.core.artwork.files import artwork_files
from BalloonWorkbench.core.artwork.picture import covering
from BalloonWorkbench.core.artwork.sheet import Print, artwork_sheets
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Role

SHOP = machine("print-and-cut-pdf")
pytestmark = pytest.mark.skipif(shutil.which("pdftops") is None, reason="poppler-utils are not installed")


@pytest.fixture(scope="module")
def files() -> tuple:
    """The files of a green ring, and its front: print, cut and hole."""
    design = designed(NAMED["ring"].map(lambda loop: 0.3 * loop), 300)
    own = bordered(build_pattern(design.pattern, 0.005))
    picture = covering(np.full((9, 9, 4), (40, 160, 60, 255), np.uint8), *box_of(design.pattern.outer))
    one = Print(design.inflation, own, np.zeros(2), picture)
    front, back = artwork_sheets([one], marked(own, SHOP.marks), 150.0, SHOP.marks)
    made, remarks = artwork_files(front, back, [SHOP])
    assert not remarks
    assert artwork_files(front, back, [SHOP])[0] == made
    return made, front


def separations(pdf: Path) -> str:
    """The page as PostScript in which each spot colour keeps its name."""
    command = ["pdftops", "-level3sep", "-rasterize", "never", "-f", "1", "-l", "1", str(pdf), "-"]
    return subprocess.run(command, capture_output=True, check=True).stdout.decode("latin-1")


def test_the_cut_is_a_separation(files: tuple, tmp_path: Path) -> None:
    """Its lines, in points from the lower left corner, are those of the pattern; the plain PDF has none."""
    made, front = files
    for name in ("artwork-print-and-cut-pdf.pdf", "artwork.pdf"):
        (tmp_path / name).write_bytes(made[name])
    text = separations(tmp_path / "artwork-print-and-cut-pdf.pdf")
    assert re.search(r"%%DocumentCustomColors:.*\(CutContour\)", text)
    assert re.search(r"0 1 0 0 \(CutContour\)", text)
    assert re.search(r"true OP\n(.*\n){0,2}1 0 1 0 0 \(CutContour\) CK", text)  # overprinting
    assert "CutContour" not in separations(tmp_path / "artwork.pdf")
    (tmp_path / "pattern.pdf").write_bytes(machine_file(front.pattern, SHOP))
    assert "(CutContour)" in separations(
        tmp_path / "pattern.pdf"
    )  # also of a pattern that nothing is printed on
    drawn = [
        np.array([[float(x), float(y)] for x, y in re.findall(r"([\d.]+) ([\d.]+) [ml]\b", line)])
        for line in page_of(made["artwork-print-and-cut-pdf.pdf"]).splitlines()
        if "/CutContour CS 1 SCN" in line
    ]
    cuts = [*front.pattern.of(Role.CUT), *front.pattern.of(Role.CUT_INNER), *front.pattern.of(Role.NOTCH)]
    assert len(drawn) == len(cuts) >= 2
    for cut in cuts:
        low, high = (np.array([at(cut.points, axis=0) for at in (np.min, np.max)]) - front.origin) / MM
        boxes = [np.array([line.min(axis=0), line.max(axis=0)]) * 25.4 / 72 for line in drawn]
        assert min(np.abs(box - (low, high)).max() for box in boxes) < 0.05


def page_of(pdf: bytes) -> str:
    """The commands of the first page."""
    streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL)
    texts = [zlib.decompress(stream) for stream in streams if stream[:1] == b"x"]
    return next(text for text in texts if b" cm" in text[:200]).decode("latin-1")


def test_it_prints_over_what_lies_under_it(files: tuple, tmp_path: Path) -> None:
    """No fill and no picture after it; the picture is whole beneath, as the plain page shows it."""
    made, _ = files
    commands = page_of(made["artwork-print-and-cut-pdf.pdf"])
    first = commands.index("/CutContour CS")
    assert " Do" not in commands[first:]
    assert not re.search(r"\b(f|B|b)\*?\n", commands[first:])
    pages = []
    for name in ("artwork-print-and-cut-pdf.pdf", "artwork.pdf"):
        (tmp_path / name).write_bytes(made[name])
        stem = tmp_path / name.removesuffix(".pdf")
        command = ["pdftoppm", "-r", "150", "-singlefile", "-png", tmp_path / name, stem]
        subprocess.run(command, check=True)
        pages.append(imread(stem.with_suffix(".png"))[..., :3])
    with_cut, plain = pages
    other = np.abs(with_cut - plain).max(axis=2) > 0.02
    assert 0.001 < other.mean() < 0.02  # the lines alone
    magenta = (with_cut[..., 0] > 0.6) & (with_cut[..., 1] < 0.5) & (with_cut[..., 2] > 0.4)
    assert (magenta & other).sum() > 0.3 * other.sum()
    green = np.abs(plain - np.array([40, 160, 60]) / 255).max(axis=2) < 0.05
    assert (green & other).sum() > 0.8 * other.sum()  # bleed on both sides of the line
