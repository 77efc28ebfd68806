# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces with their print on paper, drawn by poppler: each colour lies where the lines of its piece are."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from read_back import pages_of, run

from BalloonWorkbench.core.arrangement.arrangement import PiecePlace, arrangement_of, laid_pieces, places_of
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.machines.piece_pages import paper_pdf
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.pieces import FlatPiece, PatternPieces
from BalloonWorkbench.core.results.flat_maps import FlatPicture
from BalloonWorkbench.core.units import to_mm

MARGIN, DPI = 12.0, 100  # mm, of the pages
WIDTH, HEIGHT = 0.5, 0.3  # m, of a piece: more than a page, and no line amid it
#: Of the quarters of a print: above left and right, below left and right.
FOUR = np.array([(220, 30, 40), (30, 160, 60), (40, 60, 210), (230, 200, 30)])


def piece(name: str, left: float) -> FlatPiece:
    corner = np.array([left, 0.1])
    loop = corner + np.array([[0.0, 0.0], [WIDTH, 0.0], [WIDTH, HEIGHT], [0.0, HEIGHT]])
    return FlatPiece(name, Pattern((Contour(Role.CUT, loop, True),), None, 0.005, 0.0))


def quarters(flat: FlatPiece, across: int = 50) -> FlatPicture:
    """A print of four colours that lies on a piece."""
    colours = np.concatenate([FOUR, np.full((4, 1), 255)], axis=1).astype(np.uint8).reshape(2, 2, 4)
    pixels = np.repeat(np.repeat(colours, round(across * HEIGHT / WIDTH), axis=0), across, axis=1)
    return FlatPicture(pixels, *flat.pattern.bounds)


def sheets(file: Path, folder: Path) -> dict[tuple[int, int], np.ndarray]:
    """The pages (h, w, 3) by column and row, both from the upper left and from 1."""
    count, _ = pages_of(file)
    found = {}
    for page in range(2, count + 1):
        words = run("pdftotext", "-f", str(page), "-l", str(page), file, "-")
        column, row = (int(value) for value in re.search(r"column (\d+), row (\d+)", words).groups())
        found[column, row] = drawn(file, page, folder)
    return found


def drawn(file: Path, page: int, folder: Path) -> np.ndarray:
    name = folder / "page"
    run("pdftoppm", "-r", str(DPI), "-f", str(page), "-l", str(page), "-singlefile", file, name)
    content = name.with_suffix(".ppm").read_bytes()
    header = re.match(rb"P6\s(\d+) (\d+)\s255\s", content)
    width, height = int(header[1]), int(header[2])
    return np.frombuffer(content, np.uint8, offset=header.end()).reshape(height, width, 3)


def colours_at(places: np.ndarray, low: np.ndarray, rows: int, pages: dict, size: np.ndarray) -> list:
    """What each page shows at places (n, 2) mm of the drawing whose lower left corner is low: (n, *)."""
    step = size - 2.0 * MARGIN - 10.0
    shown: list[list[np.ndarray]] = [[] for _ in places]
    for (column, row), sheet in pages.items():
        at = places - low - step * [column - 1, rows - row] + MARGIN
        inside = ((at > MARGIN + 0.5) & (at < size - MARGIN - 0.5)).all(axis=1)
        for number in np.flatnonzero(inside):
            x, y = at[number] * DPI / 25.4
            shown[number].append(sheet[sheet.shape[0] - 1 - int(y), int(x)].astype(int))
    return shown


@pytest.mark.parametrize(
    ("angle", "mirrored"), [(0.0, False), (30.0, False), (90.0, True), (-110.0, True), (180.0, False)]
)
def test_a_print_lies_on_its_piece(angle: float, mirrored: bool, tmp_path: Path) -> None:
    """Moved, turned and mirrored: the middles of its quarters have their colours on all pages."""
    flat = (piece("a", 0.0), piece("b", 0.6))
    base = PatternPieces(flat, ())
    places = [PiecePlace((0.25, 0.25)), PiecePlace((0.9, 0.4), np.radians(angle), mirrored)]
    laid = laid_pieces(base, arrangement_of(base, places))
    file = tmp_path / "pieces.pdf"
    file.write_bytes(paper_pdf(laid, {number: quarters(each) for number, each in enumerate(flat)}, "A4"))
    size = np.array(pages_of(file)[1])
    pages = sheets(file, tmp_path)
    rows = max(row for _, row in pages)
    for sheet in pages.values():
        assert sheet[:, : round(6.0 * DPI / 25.4)].min() > 240  # no print where no printer prints
    corners = np.concatenate([each.pattern.contours[0].line for each in laid.pieces.pieces])
    low = to_mm(corners.min(axis=0))
    low[1] = min(low[1], _bar_below(low[1]))
    checked = 0
    for number, each in enumerate(flat):
        left, bottom = each.pattern.bounds[0]
        own = np.array(
            [(left + across * WIDTH, bottom + up * HEIGHT) for up in (0.75, 0.25) for across in (0.25, 0.75)]
        )
        there = to_mm(places_of(laid, number, own))
        for colour, shown in zip(FOUR, colours_at(there, low, rows, pages, size), strict=True):
            assert shown, "no page has the place"
            for seen in shown:
                assert np.abs(seen - colour).max() < 12
                checked += 1
    assert checked >= 8


def _bar_below(low: float) -> float:
    """Where the control bar ends, below the lowest line [mm]."""
    from BalloonWorkbench.core.machines import toolpaths

    bar = toolpaths._bar(np.array([0.0, low]))
    return float(min(curve.bounds[0][1] for curve in bar))


def test_pages_amid_a_piece_are_printed_with_it_and_left_out_without(tmp_path: Path) -> None:
    """A large piece has pages without a line, which have its print."""
    flat = piece("a", 0.0)
    wide = np.array([[0.0, 0.0], [1.2, 0.0], [1.2, 1.2], [0.0, 1.2]])
    large = replace(flat, pattern=replace(flat.pattern, contours=(Contour(Role.CUT, wide, True),)))
    laid = laid_pieces(
        PatternPieces((large,), ()), arrangement_of(PatternPieces((large,), ()), [PiecePlace((0.6, 0.6))])
    )
    plain, printed = tmp_path / "plain.pdf", tmp_path / "printed.pdf"
    plain.write_bytes(paper_pdf(laid, {}, "A4"))
    printed.write_bytes(paper_pdf(laid, {0: quarters(large)}, "A4"))
    assert pages_of(printed)[0] > pages_of(plain)[0] + 10
    assert printed.stat().st_size < 3 * plain.stat().st_size  # the picture is in it once
    assert printed.read_bytes() == paper_pdf(laid, {0: quarters(large)}, "A4")
    whole = drawn(printed, 1, tmp_path).reshape(-1, 3).astype(int)
    for colour in FOUR:  # the map of the pages shows it as well
        assert (np.abs(whole - colour).max(axis=1) < 12).sum() > 500
    with pytest.raises(ExportError, match="no paper"):
        paper_pdf(laid, {}, "B7")
