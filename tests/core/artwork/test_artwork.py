# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork reads right on the inflated balloon, and prints at the right size and place."""

from __future__ import annotations

import io
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from drawn_shapes import NAMED
from ezdxf import bbox
from inflated import designed
from matplotlib.image import imread
from printed import COLOURS, DPI, FILM, MM, VIEW, box_of, dots_of, dotted, exactly, inflated_view, printed
from scipy.integrate import quad
from solver_cases import circle

from BalloonWorkbench.core.artwork import picture as pictures
from BalloonWorkbench.core.artwork import sample
from BalloonWorkbench.core.artwork.border import bordered
from BalloonWorkbench.core.artwork.carry import front, seen_from
from BalloonWorkbench.core.artwork.files import artwork_files
from BalloonWorkbench.core.artwork.picture import covering, of_drawing
from BalloonWorkbench.core.artwork.sheet import Print, artwork_sheets
from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.solver.inflate import inflate


@pytest.fixture(scope="module")
def heart() -> tuple:
    """A heart with dots, fitted, printed and projected again."""
    outline = NAMED["heart"]
    design = fit(outline, film("mylar"), 2000.0, mesh_size=0.012)
    pixels, places = dotted(outline)
    low, size = outline.outer.min(axis=0), np.ptp(outline.outer, axis=0)
    sheets = printed(design.inflation, design.pattern, exactly(pixels, outline))
    return outline, design, pixels, places, low, size, *sheets


def test_round_trip(heart: tuple) -> None:
    """Drawing, pattern, inflated, seen from the front: every dot within 0.5 mm of where it was drawn."""
    _outline, design, _, places, low, size, sheet, _, _ = heart
    view = inflated_view(sheet, design.inflation, low, size, VIEW)
    off = np.hypot(*(dots_of(view, VIEW, places) - places).T)
    assert len(places) > 25
    assert off.max() < 0.5 * MM
    assert off.mean() < 0.2 * MM
    lit = view[..., 3] > 0
    assert lit.mean() > 0.5
    assert (np.abs(view[lit][:, :3].astype(int) - FILM[:3]).max(axis=1) < 8).mean() > 0.6
    assert not (view[lit][:, :3] > 250).all(axis=1).any()  # no white paper on the balloon


def test_a_traced_picture_lies_in_its_place() -> None:
    disc = Outline(circle(0.1) + 0.3)
    pixels, _ = dotted(disc)
    wanted, found = exactly(pixels, disc), of_drawing(pixels, *box_of(disc.outer))
    assert np.abs(found.low - wanted.low).max() < 0.1 * MM
    assert np.abs(found.pixel / wanted.pixel - 1.0).max() < 2e-3
    assert not (found.pixels[..., :3] > 250).all(axis=2).any()
    large = np.repeat(np.repeat(pixels, 4, axis=0), 4, axis=1)  # looked at by blocks of pixels
    assert max(large.shape) > 1700
    large = large[: len(large) // 2 * 2 - 1]  # the last row makes no whole block
    found = of_drawing(large, *box_of(disc.outer))
    corner = np.array([0.0, 0.1 * MM]) + wanted.low
    assert np.abs(found.low - corner).max() < 0.06 * MM
    assert found.pixels.shape == large.shape


def test_an_unbent_picture_would_not_read_right(heart: tuple) -> None:
    """The same picture only enlarged to the pattern is millimetres off: the test above can fail."""
    _outline, design, pixels, places, low, size, _sheet, _, _ = heart
    flat = replace(
        design.inflation,
        positions=np.column_stack(
            [design.inflation.panel.rest_positions, np.zeros(len(design.inflation.positions))]
        ),
    )
    plain, _, _ = printed(flat, design.pattern, of_drawing(pixels, *box_of(design.pattern.outer)))
    view = inflated_view(plain, design.inflation, low, size, VIEW)
    middle = np.argsort(np.hypot(*(places - 0.5 * size).T))[:6]
    alike = [
        np.abs(view[int((size[1] - y) / VIEW), int(x / VIEW), :3].astype(int) - COLOURS[k % 4][:3]).max()
        for k, (x, y) in enumerate(places)
    ]
    assert max(np.delete(alike, middle)) > 60


def test_disc_follows_the_mylar_balloon() -> None:
    """A place at s from the middle of the flat film is seen where the closed form has it (Paulsen 1994):
    s = int_0^r R^2 du / sqrt(R^4 - u^4), R the rim's radius."""
    radius, stiff = 0.15, replace(custom_film(2.4e10, 0.3, 25e-6), seal_width=0.0)
    disc = Outline(circle(radius))
    inflation = inflate(triangulate(disc, size_for(disc, 900)), stiff, 300.0)
    rim = radius / 1.311028777146
    x = np.arange(-0.14, 0.1401, 0.002)
    seen = seen_from(front(inflation), x, x, np.zeros((len(x), len(x)), dtype=bool))
    far = np.hypot(*np.meshgrid(x, x))
    for r in (0.3 * rim, 0.6 * rim, 0.85 * rim):
        s, _ = quad(lambda u: rim**2 / np.sqrt(rim**4 - u**4), 0.0, r)
        ring = np.abs(far - s) < 0.0015
        assert np.hypot(*seen[ring].T).mean() == pytest.approx(r, abs=0.4 * MM)


def test_another_simulation_agrees() -> None:
    """Printed with one mesh, inflated with a finer one: the dots stay within 1 mm."""
    disc = Outline(circle(0.12))
    coarse, fine = (
        inflate(triangulate(disc, size_for(disc, count)), film("mylar"), 2000.0) for count in (500, 1300)
    )
    shown = Outline(circle(0.092))
    pixels, places = dotted(shown, pitch=25 * MM)
    low, size = box_of(shown.outer)
    sheet, _, _ = printed(coarse, disc, exactly(pixels, shown))
    view = inflated_view(sheet, fine, low, size, VIEW)
    assert np.hypot(*(dots_of(view, VIEW, places) - places).T).max() < 1.0 * MM


def test_print_goes_past_the_cut(heart: tuple) -> None:
    """All of the bleed is printed, in the colour of the shape: neither paper nor gaps; nothing beyond it."""
    *_, sheet, _, whole = heart
    from BalloonWorkbench.core.packages import shapely

    package = shapely()
    height, width = sheet.pixels.shape[:2]
    pixel = 25.4e-3 / DPI
    x, y = np.meshgrid(
        sheet.origin[0] + (np.arange(width) + 0.5) * pixel,
        sheet.origin[1] + (height - np.arange(height) - 0.5) * pixel,
    )
    cut = package.Polygon(whole.of(Role.CUT)[0].points)
    ring = package.contains_xy(cut.buffer(2.8 * MM), x, y) & ~package.contains_xy(cut.buffer(-6.0 * MM), x, y)
    assert (sheet.pixels[ring][:, 3] == 255).all()
    assert (np.abs(sheet.pixels[ring][:, :3].astype(int) - FILM[:3]).max(axis=1) < 60).mean() > 0.999
    marks = package.union_all(
        [package.LineString(mark.points).buffer(4 * MM) for mark in whole.of(Role.REGISTRATION)]
    )
    outside = ~package.contains_xy(cut.buffer(3.3 * MM), x, y) & ~package.contains_xy(marks, x, y)
    assert not sheet.pixels[outside][:, 3].any()


def test_back_is_the_mirror_image(heart: tuple) -> None:
    *_, sheet, behind, whole = heart
    assert np.array_equal(behind.pixels, sheet.pixels[:, ::-1])
    low, high = behind.pattern.bounds
    assert np.allclose([-high[0], low[1]], whole.bounds[0])
    (cut,), (other,) = whole.of(Role.CUT), behind.pattern.of(Role.CUT)
    assert np.allclose(np.sort(other.points[:, 0]), np.sort(-cut.points[:, 0]))


def test_back_may_have_its_own_picture(heart: tuple) -> None:
    """Given as seen from the front: seen from behind it is mirrored, and the front is as before."""
    outline, design, pixels, _places, _low, _size, sheet, _, _ = heart
    front_picture = exactly(pixels, outline)
    other = replace(front_picture, pixels=np.full_like(front_picture.pixels, 77))
    faces, behind, _ = printed(design.inflation, design.pattern, front_picture, behind=other)
    assert np.array_equal(faces.pixels, sheet.pixels)
    inside = behind.pixels[..., 3] > 0
    assert (behind.pixels[inside][:, 0] == 77).mean() > 0.99


def test_files(heart: tuple, tmp_path: Path) -> None:
    """PNG with its resolution, PDF in real size with both sides; the same bytes again."""
    *_, sheet, behind, _ = heart
    files, remarks = artwork_files(sheet, behind)
    assert not remarks
    assert artwork_files(sheet, behind) == (files, ())
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    read = imread(io.BytesIO(files["artwork-front.png"]))
    assert np.array_equal(np.rint(read * 255).astype(np.uint8), sheet.pixels)
    from PIL import Image

    across, up = Image.open(tmp_path / "artwork-back.png").info["dpi"]
    assert across == up == pytest.approx(DPI, abs=0.03)
    if shutil.which("pdfinfo") is None:
        pytest.skip("poppler-utils are not installed")
    told = subprocess.run(
        ["pdfinfo", tmp_path / "artwork.pdf"], capture_output=True, text=True, check=True
    ).stdout
    page = next(line for line in told.splitlines() if line.startswith("Page size")).split()
    for points, pixels in zip((page[2], page[4]), (sheet.pixels.shape[1], sheet.pixels.shape[0])):
        assert float(points) / 72.0 == pytest.approx(pixels / DPI, abs=0.01)
    assert next(line for line in told.splitlines() if line.startswith("Pages")).split()[1] == "2"
    subprocess.run(
        [
            "pdftoppm",
            "-r",
            f"{DPI:g}",
            "-f",
            "1",
            "-l",
            "1",
            "-png",
            tmp_path / "artwork.pdf",
            tmp_path / "page",
        ],
        check=True,
    )
    page_read = imread(next(tmp_path.glob("page*.png")))[..., :3]
    rows, columns = (min(a, b) for a, b in zip(page_read.shape[:2], sheet.pixels.shape[:2]))
    solid = sheet.pixels[:rows, :columns, 3] == 255
    off = np.abs(page_read[:rows, :columns][solid] - sheet.pixels[:rows, :columns][solid][:, :3] / 255.0)
    assert (off.max(axis=1) < 0.1).mean() > 0.97


def test_without_matplotlib_there_is_no_pdf(heart: tuple, monkeypatch: pytest.MonkeyPatch) -> None:
    *_, sheet, behind, _ = heart
    monkeypatch.setitem(sys.modules, "matplotlib.backends", None)
    files, (remark,) = artwork_files(sheet, behind)
    assert set(files) == {"artwork-front.png", "artwork-back.png"}
    assert "pip install matplotlib" in remark


def test_marks_are_the_same_in_the_cut_file(heart: tuple) -> None:
    """DXF and PNG: the cross is as far from the cut, and the marks are not symmetric."""
    *_, sheet, _, whole = heart
    content = machine_file(whole, machine("lightburn"))
    lines = list(ezdxf.read(io.StringIO(content.decode("cp1252"))).modelspace())
    of = {
        layer: [
            np.array([point[:2] for point in line.get_points("xy")])
            for line in lines
            if line.dxf.layer == layer
        ]
        for layer in ("REGISTRATION",)
    }
    crosses = [
        mark
        for mark in of["REGISTRATION"]
        if len(mark) == 2 and np.ptp(mark, axis=0).max() == pytest.approx(10.0)
    ]
    assert len(crosses) == 6
    middles = {tuple(np.round(cross.mean(axis=0), 2)) for cross in crosses}
    assert len(middles) == 3
    cut = next(line for line in lines if line.dxf.layer == "CUT")
    corner = np.array(bbox.extents([cut]).extmin)[:2]  # arcs reach further than their ends
    dark = (sheet.pixels[..., :3].max(axis=2) < 20) & (sheet.pixels[..., 3] == 255)
    pixel = 25.4 / DPI
    for middle in middles:
        at = np.array(middle) - corner + whole.of(Role.CUT)[0].points.min(axis=0) / MM - sheet.origin / MM
        column, row = at[0] / pixel - 0.5, len(dark) - at[1] / pixel - 0.5
        window = dark[int(row) - 18 : int(row) + 19, int(column) - 18 : int(column) + 19]
        rows, columns = np.nonzero(window)
        assert abs(rows.mean() + int(row) - 18 - row) < 0.8
        assert abs(columns.mean() + int(column) - 18 - column) < 0.8


def test_film_round_a_hole_is_printed_from_its_own_side() -> None:
    outline = NAMED["ring"]
    design = designed(outline, 600)
    pixels, _ = dotted(outline)
    sheet, _, whole = printed(design.inflation, design.pattern, of_drawing(pixels, *box_of(outline.outer)))
    (hole,) = whole.of(Role.CUT_INNER)
    middle = hole.points.mean(axis=0)
    column, row = ((middle - sheet.origin) / (25.4e-3 / DPI) - 0.5).astype(int)
    assert sheet.pixels[len(sheet.pixels) - 1 - row, column, 3] == 0
    inside = sheet.pixels[..., 3] == 255
    assert not (sheet.pixels[inside][:, :3] > 250).all(axis=1).any()


def test_any_picture_covers_the_balloon() -> None:
    pixels = np.full((40, 100, 4), 255, np.uint8)
    pixels[:, :50, 0] = 10
    picture = covering(pixels, np.array([1.0, 2.0]), np.array([0.2, 0.3]))
    low, high = picture.low, picture.low + picture.pixel * (100, 40)
    assert (low <= (1.0 + 1e-9, 2.0 + 1e-9)).all()
    assert (high >= (1.2 - 1e-9, 2.3 - 1e-9)).all()
    assert np.allclose(0.5 * (low + high), (1.1, 2.15))
    assert picture.pixel[0] == picture.pixel[1] == pytest.approx(0.3 / 40)


@pytest.mark.parametrize("name", ["heart", "ring"])
def test_without_opencv_the_same_comes_out(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """NumPy and SciPy in its place: the same colours, but for rounding and ties."""
    outline = NAMED[name]
    pixels, _ = dotted(outline, pixel=1.0 * MM)
    x, y = (
        axis.astype(np.float32)
        for axis in np.meshgrid(
            np.linspace(-3, pixels.shape[1] + 3, 200), np.linspace(-3, len(pixels) + 3, 200)
        )
    )
    pixels[:30, :40, 3] = 0
    inside = (pixels[..., :3] < 250).any(axis=2)
    with_it = sample.sampled(pixels, x, y), pictures.carried_on(pixels, inside)
    for module in (sample, pictures):
        monkeypatch.setattr(module, "opencv", lambda: None)
    without = sample.sampled(pixels, x, y), pictures.carried_on(pixels, inside)
    seen = with_it[0][..., 3] > 0
    off = np.abs(without[0].astype(int) - with_it[0])
    assert off[..., 3].max() <= 5
    assert np.percentile(off[seen], 99) <= 8
    assert (without[1] != with_it[1]).any(axis=2).mean() < 0.01


def test_senseless_values_are_refused() -> None:
    design = designed(NAMED["disc"], 300)
    own = build_pattern(design.pattern, 0.005)
    with pytest.raises(InputError, match="bleed"):
        bordered(own, -1.0 * MM)
    picture = covering(np.full((9, 9, 4), 200, np.uint8), *box_of(NAMED["disc"].outer))
    one = Print(design.inflation, bordered(own), np.zeros(2), picture)
    for dpi in (5.0, 5000.0, 2400.0):
        with pytest.raises(InputError, match=r"resolution|dots per inch"):
            artwork_sheets([one], marked(one.pattern), dpi)
