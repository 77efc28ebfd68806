# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly sheet: two pages, read back by other people's programs."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED
from inflated import designed
from matplotlib.image import imread

from BalloonWorkbench.core.assembly_sheet.page import PAGES, SheetSubject, assembly_pdf
from BalloonWorkbench.core.assembly_sheet.steps import FILE, steps, work_pictures
from BalloonWorkbench.core.assembly_sheet.work_figures import FIGURES
from BalloonWorkbench.core.assembly_sheet.work_settings import WorkSettings
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.files.data_file import read_data
from BalloonWorkbench.core.film.filling import Filling
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.making.numbers import maker_numbers
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.intake.kinds import intake_kind, intake_kinds
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.units import water_column_text

DPI = 150
POPPLER = pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler-utils are not installed")


@cache
def subject(shape: str = "heart", film_name: str = "nylon-foil", intake: str = "straw") -> SheetSubject:
    design, made_of = designed(NAMED[shape], 300), film(film_name)
    wanted = PatternOptions(intake=intake != "none", intake_kind="straw" if intake == "none" else intake)
    pattern = make_pattern(design.pattern, made_of.seal_width, wanted)
    numbers = maker_numbers(design.inflation, made_of, design.pattern, pattern, 0.3, Filling())
    return SheetSubject("Grandma's heart $1", made_of, design.inflation, pattern, numbers)


def told_by(program: str, *arguments: str | Path) -> str:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


@pytest.fixture(scope="module", params=PAGES)
def page(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    path = tmp_path_factory.mktemp("assembly") / f"{request.param}.pdf"
    path.write_bytes(assembly_pdf(subject(), request.param))
    return path, request.param


@POPPLER
def test_two_pages_of_the_paper(page: tuple[Path, str]) -> None:
    path, paper = page
    lines = dict(line.split(":", 1) for line in told_by("pdfinfo", path).splitlines() if ":" in line)
    assert lines["Pages"].strip() == "2"
    assert lines["Title"].strip() == "Grandma's heart $1: Assembly sheet"
    assert "CreationDate" not in lines
    width, _, height, *_ = lines["Page size"].split()
    found = float(width) * 25.4 / 72.0, float(height) * 25.4 / 72.0
    assert found == pytest.approx(PAGES[paper], abs=0.2)


@POPPLER
def test_text_is_text(page: tuple[Path, str]) -> None:
    """Everything that a maker reads can be searched for: sizes, material, numbers, steps in their order."""
    path, _ = page
    text = " ".join(told_by("pdftotext", path, "-").replace("\u00a0", " ").split())
    about = subject()
    width, height = (1000.0 * size for size in about.pattern.size)
    for wanted in (
        "Grandma's heart $1",
        f"{width:.4g} mm",
        f"{height:.4g} mm",
        "Aluminised nylon/PE foil",
        "30 µm, 31.5 g/m²",
        "of a roll 500 mm wide",
        "Straw neck, 10 mm",
        "Will it float?",
        "mm on paper =",
        "Pattern drawn 1 :",
    ):
        assert wanted in text, wanted
    # columns are read one after the other or row by row: each step begins somewhere
    for step in steps(about.pattern, about.film, about.numbers):
        assert " ".join(step.split()[:4]) in text, step


@POPPLER
def test_bar_and_drawing_are_to_scale(page: tuple[Path, str], tmp_path: Path) -> None:
    """Measured in the picture of the page: the bar is 50 mm; the drawn weld has the size that is told."""
    path, _ = page
    subprocess.run(["pdftoppm", "-r", str(DPI), "-l", "1", "-png", path, tmp_path / "page"], check=True)
    shown = imread(next(tmp_path.glob("page*.png")))[..., :3]
    pixel = 25.4 / DPI
    strip = shown[int(-18.0 / pixel) : int(-10.0 / pixel), : int(70.0 / pixel)]
    columns = np.flatnonzero((strip.max(axis=2) < 0.35).any(axis=0))
    columns = columns[columns * pixel < 13.0 + 51.0]
    assert (columns.max() + 1 - columns.min()) * pixel == pytest.approx(50.0, abs=0.6)
    text = told_by("pdftotext", path, "-")
    scale = float(text.split("Pattern drawn 1 : ")[1].split()[0])
    left = shown[: int(170.0 / pixel), : int(120.0 / pixel)]
    magenta = (left[..., 0] > 0.8) & (left[..., 1] < 0.4) & (left[..., 2] > 0.8)
    rows, columns = np.nonzero(magenta)
    rows, columns = rows[rows < rows.max() - 8], columns[rows < rows.max() - 8]  # not the legend
    seal = np.concatenate([line.points for line in subject().pattern.contours if line.role.value == "SEAL"])
    assert np.ptp(columns) * pixel * scale == pytest.approx(1000.0 * np.ptp(seal[:, 0]), rel=0.02)


def test_the_same_bytes_again(page: tuple[Path, str]) -> None:
    path, paper = page
    assert assembly_pdf(subject(), paper.lower()) == path.read_bytes()


@pytest.mark.parametrize("name", [*intake_kinds(), "none"])
def test_each_intake_has_its_step(name: str) -> None:
    about = subject("ring" if name == "none" else "disc", intake=name)
    work = steps(about.pattern, about.film, about.numbers)
    notes = [number for number, step in enumerate(work) if name != "none" and intake_kind(name).note in step]
    weld = next(number for number, step in enumerate(work) if step.startswith("Weld along"))
    assert len(notes) == (name not in ("none", "film-valve"))  # which has steps of its own
    if notes:
        assert (notes[0] < weld) == (name == "nozzle")
    assert ("all the way round" in work[weld]) == (name in ("none", "nozzle"))
    assert any("holes inside" in step for step in work) == (name == "none")


def test_the_valve_is_welded_in_an_order_that_keeps_it_open() -> None:
    """Ink, strips to each other, tacked to one panel, the panels, round the balloon, then across the neck."""
    about = subject("disc", "nylon-foil", "film-valve")
    work = steps(about.pattern, about.film, about.numbers)
    begins = (
        "Lay both valve strips",
        "Lay the strips into the neck of one panel",
        "Lay the panels on each other",
        "Weld along the dashed line",
        "Weld across the neck",
        "Fill through a tube",
    )
    places = [[k for k, step in enumerate(work) if step.startswith(begin)] for begin in begins]
    assert [len(each) for each in places] == [1] * len(begins)
    assert places == sorted(places)
    assert "heat-resistant ink" in work[places[0][0]]
    assert "this panel only" in work[places[1][0]]
    straw = subject("disc", "nylon-foil")
    assert not [step for step in steps(straw.pattern, straw.film, straw.numbers) if "valve" in step]


def test_the_valve_is_drawn(tmp_path: Path) -> None:
    """Strips in their neck, with the order of the work and the film that they are cut from."""
    for kind in ("film-valve", "straw"):
        path = tmp_path / f"{kind}.pdf"
        path.write_bytes(assembly_pdf(subject("disc", "nylon-foil", kind)))
        told = told_by("pdftotext", "-layout", path, "-")
        for text in ("Valve, on one panel", "Tacked to one panel", "Welded across, last", "thin PE film"):
            assert (text in told) == (kind == "film-valve"), text


@pytest.mark.parametrize(
    ("film_name", "settings", "told"),
    [
        (
            "nylon-foil",
            WorkSettings(),
            "Start values, not tried on your film and tool: bar or iron 108C–118C",
        ),
        ("mylar", WorkSettings(), "Make a test card"),
        ("mylar", WorkSettings("Tip", "feed 300 mm/min"), "To weld, your settings of Tip: feed 300 mm/min."),
        (
            "pe",
            WorkSettings("Tip", "feed 300 mm/min", "Laser", "power 35 %"),
            "your settings of Laser: power",
        ),
        ("pvc", WorkSettings("Tip", "feed 300 mm/min"), ""),
    ],
)
def test_settings_of_the_user_come_first_then_start_values(
    film_name: str, settings: WorkSettings, told: str
) -> None:
    """The weld is told once; of a film that is not welded by heat nothing is."""
    about = subject("disc", film_name)
    work = steps(about.pattern, about.film, about.numbers, settings=settings)
    begins = ("To weld, your settings", "Start values", "Nobody states a temperature")
    assert len([step for step in work if step.startswith(begins)]) == (film_name != "pvc")
    assert any(told in step for step in work)
    cut = [number for number, step in enumerate(work) if step.startswith("To cut, your settings")]
    assert len(cut) == bool(settings.cut)
    assert all(number < next(k for k, step in enumerate(work) if "Cut two panels" in step) for number in cut)


#: Figures of the work by the intake; of a nozzle in the film nothing hangs.
ORDER = {
    "straw": ["outline", "leak", "tube", "neck", "opened", "hang"],
    "one-way-tail": ["outline", "leak", "tube", "deflate", "hang"],
    "film-valve": ["outline", "across", "leak", "tube", "deflate", "hang"],
    "nozzle": ["outline", "leak", "tube"],
}


@pytest.mark.parametrize("intake", ORDER)
def test_figures_come_in_the_order_of_the_work(intake: str) -> None:
    """What is told is at most what film and weld bear; what lifts is tied to what is heavier."""
    about = subject("disc", "pe", intake)
    shown = work_pictures(about.pattern, about.film, about.numbers)
    assert [figure for figure, _ in shown] == ORDER[intake]
    safe = about.numbers.safety
    assert safe.safe_pressure is not None
    column = water_column_text(min(safe.safe_pressure, safe.pressure))
    assert sum(f"at most {column} of water" in text for _, text in shown) == 2
    light = replace(about.numbers.floating[0], left=0.0123)
    floating = replace(about.numbers, floating=(light, *about.numbers.floating[1:]))
    told = dict(work_pictures(about.pattern, about.film, floating))
    assert ("ribbon" in told) == (intake != "nozzle")
    assert "heavier than the 12.3 g that helium lifts" in told.get(
        "ribbon", "heavier than the 12.3 g that helium lifts"
    )


def test_each_picture_of_the_work_has_a_figure_and_a_source() -> None:
    entries = read_data(FILE)["pictures"]
    assert {entry["figure"] for entry in entries} == set(FIGURES)
    assert all(len(entry["source"]) > 10 for entry in entries)


def test_paper_is_not_brushed_with_water() -> None:
    about = subject("disc", "kraft-paper")
    shown = work_pictures(about.pattern, about.film, about.numbers)
    assert "leak" not in [figure for figure, _ in shown]


@POPPLER
def test_figures_stay_in_their_cells(page: tuple[Path, str], tmp_path: Path) -> None:
    """Nothing in the margins, and a white gap between both columns, and rows, of figures and texts."""
    path, paper = page
    subprocess.run(["pdftoppm", "-r", "60", "-f", "2", "-png", path, tmp_path / "page"], check=True)
    dark = imread(next(tmp_path.glob("page*.png")))[..., :3].min(axis=2) < 0.9
    pixel, (width, height) = 25.4 / 60.0, PAGES[paper]
    top, low = int(32.0 / pixel), int((height - 12.0) / pixel)
    assert not dark[:, : int(12.0 / pixel)].any()
    assert not dark[:, int((width - 12.0) / pixel) :].any()
    assert not dark[low:].any()
    cell = 0.5 * (width - 26.0)
    gap = slice(int((13.0 + cell - 4.0) / pixel), int((13.0 + cell - 0.5) / pixel))
    assert not dark[top:low, gap].any()
    row = (height - 46.0) / 3.0
    for number in (1, 2):
        assert not dark[int((height - (height - 33.0 - number * row) - 2.0) / pixel)].any()
    # the seal of the first figure is thick and red, that of the second one thin
    red = imread(next(tmp_path.glob("page*.png")))[top : int((33.0 + row) / pixel)]
    strong = (red[..., 0] > 0.6) & (red[..., 1] < 0.4)
    half = int((13.0 + cell) / pixel)
    assert strong[:, :half].sum() > 3 * strong[:, half:].sum() > 0


def test_unknown_paper_is_refused() -> None:
    with pytest.raises(ExportError, match="A4 or Letter"):
        assembly_pdf(subject(), "A0")
