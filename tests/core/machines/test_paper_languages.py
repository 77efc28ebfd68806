# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is printed, in each language: every text translated, nothing outside its column, on one page."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from matplotlib.image import imread
from test_assembly import POPPLER, subject, told_by
from test_export_pages import PAPER, SMALL

from BalloonWorkbench.core.assembly_sheet.page import assembly_pdf
from BalloonWorkbench.core.assembly_sheet.steps import steps
from BalloonWorkbench.core.assembly_sheet.texts import broken, figures, material
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.language.speech import languages, speech
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pages import fonts
from BalloonWorkbench.core.pattern.intake.kinds import intake_kinds
from BalloonWorkbench.core.types import in_english

#: A word that every page has, and the beginning of a step that it has.
SEEN = {
    "de": ("Montageblatt", "Schwebt er?", "Die Löcher innen ausschneiden"),
    "ja": ("組み立て図", "浮く", "内側の穴を切り抜きます"),
    "fr": ("Fiche de montage", "Flottera-t-il", "Découpez les trous intérieurs"),
    "es-ES": ("Hoja de montaje", "¿Flotará?", "Recorte los agujeros interiores"),
}
MARGIN, GUTTER = 13.0, 6.0  # mm
JAPANESE = pytest.mark.skipif(not fonts.can_show("組"), reason="no Japanese font is installed")
EACH = [pytest.param(name, marks=JAPANESE if name == "ja" else ()) for name in languages()[1:]]


def text_of(path: Path) -> str:
    return " ".join(told_by("pdftotext", path, "-").replace("\u00a0", " ").split())


@pytest.fixture(scope="module", params=EACH)
def sheet(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The page with the longest steps, on the shorter paper."""
    path = tmp_path_factory.mktemp("assembly") / f"{request.param}.pdf"
    about = subject("ring", "nylon-foil", "film-valve")
    path.write_bytes(assembly_pdf(about, "Letter", speech(request.param)))
    return path, request.param


@POPPLER
def test_page_speaks_the_language(sheet: tuple[Path, str]) -> None:
    """Searchable text; nothing of the English page is left but names, numbers and units."""
    path, language = sheet
    text = text_of(path)
    for wanted in SEEN[language]:
        assert wanted.replace(" ", "") in text.replace(" ", ""), wanted
    english = "Assembly Pattern Needed Weld litres Safe Pressure Will Steps Cut Check wide mirrored"
    same = {"litres"} if language == "fr" else set()
    assert not (set(english.split()) - same) & set(re.findall(r"[A-Za-z]+", text))
    assert SEEN[language][0] in told_by("pdfinfo", path)


@POPPLER
def test_nothing_runs_over(sheet: tuple[Path, str]) -> None:
    """Every word is inside the margins, and below the drawing inside its column."""
    path, _ = sheet
    first, *others = told_by("pdftotext", "-bbox", path, "-").split("<page ")[1:]
    page = re.match(r'width="([\d.]+)" height="([\d.]+)"', first)
    assert page is not None
    width, height = map(float, page.groups())
    mm = 25.4 / 72.0
    assert len(others) == 1
    for left, y, right, low, word in words_of(others[0]):  # pictures
        assert MARGIN - 0.1 < float(left) * mm < float(right) * mm < width * mm - MARGIN + 0.1, word
        assert 0.0 < float(y) < float(low) < height, word
    words = words_of(first)
    assert len(words) > 20
    middle, half = 0.5 * width * mm, 0.5 * GUTTER
    lists = min(float(y) for _, y, _, _, word in words if re.match(r"30.?µm|30$", word))
    for left, y, right, low, word in words:
        assert float(left) * mm > MARGIN - 0.1, word
        assert float(right) * mm < width * mm - MARGIN + 0.1, word
        assert float(low) < height
        if lists < float(y) < height - 25.0 / mm:
            assert float(right) * mm < middle - half + 0.5 or float(left) * mm > middle + half - 0.5, word
    assert lists > 0.4 * height, "the drawing keeps its room"


def words_of(page: str) -> list[tuple[str, ...]]:
    corners = " ".join(f'{name}="([-\\d.]+)"' for name in ("xMin", "yMin", "xMax", "yMax"))
    return re.findall(f"<word {corners}>(.*?)</word>", page)


def test_every_text_is_translated() -> None:
    """Of all films and intakes, with and without what depends on the balloon: no text is said in English."""
    said: set[str] = set()

    def say(text: str) -> str:
        said.add(text)
        return text

    about = subject("ring", "nylon-foil", "film-valve")
    numbers, safe = about.numbers, about.numbers.safety
    tight = replace(numbers, safety=replace(safe, safe_pressure=2.0 * safe.pressure), roll=None, valve=0.001)
    lacking = replace(numbers, floating=tuple(replace(one, left=-1.0, cost=None) for one in numbers.floating))
    upward = tuple(replace(one, left=1.0) for one in numbers.floating[::-1])
    carried = replace(numbers, floating=upward, valve=0.0)
    never = replace(
        numbers, floating=tuple(replace(one, left=-1.0, from_width=None) for one in numbers.floating[1:])
    )
    assembly_pdf(about, say=say)
    for name in films():
        for kind in ("straw", "nozzle") if name == "nylon-foil" else ("straw",):
            one = subject("disc", name, kind)
            material(one.film, one.pattern, one.numbers, say)
            for each in (numbers, tight):
                steps(one.pattern, one.film, each, say)
    for kind in intake_kinds():
        one = subject("disc", intake=kind)
        steps(one.pattern, one.film, tight, say)
        material(one.film, one.pattern, tight, say)
    for each in (tight, lacking, carried, never):
        figures(about.film, each, say)
    assert len(said) > 60
    for language in languages()[1:]:
        tell = speech(language)
        same = {text for text in said if tell(text) == text}
        # words that are the same in two languages
        assert not {text for text in same if len(text.split()) > 2 and "litres" not in text}, language
        assert language != "ja" or same <= {"PTFE"}


@JAPANESE
def test_the_same_bytes_again() -> None:
    about, say = subject("disc"), speech("ja")
    assert assembly_pdf(about, say=say) == assembly_pdf(about, say=say)


def test_without_a_japanese_font_it_is_english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fonts, "_JAPANESE", ("No such font",))
    about = subject("disc")
    assert not fonts.can_show("組み立て図")
    assert assembly_pdf(about, say=speech("ja")) == assembly_pdf(about)


@JAPANESE
def test_japanese_name_on_an_english_page(tmp_path: Path) -> None:
    path = tmp_path / "page.pdf"
    path.write_bytes(assembly_pdf(replace(subject("disc"), title="おばあちゃんのハート")))
    assert "おばあちゃんのハート" in text_of(path)
    assert "Assembly sheet" in text_of(path)


@POPPLER
@pytest.mark.parametrize(
    ("language", "title", "place"),
    [
        ("de", "Schnittmuster auf mehreren Seiten", "Seite 1 von 1"),
        ("fr", "Patron sur plusieurs pages", "Page 1 sur 1"),
        ("es-ES", "Patrón en varias páginas", "Página 1 de 1"),
    ],
)
def test_pattern_on_pages(tmp_path: Path, language: str, title: str, place: str) -> None:
    file = tmp_path / "tiles.pdf"
    file.write_bytes(machine_file(SMALL, PAPER, "A4", speech(language)))
    text = text_of(file)
    assert title in text
    assert place in text
    assert "Print" not in text
    assert "%" in text


@POPPLER
@JAPANESE
def test_pattern_on_pages_in_japanese(tmp_path: Path) -> None:
    """Drawn letters: as much ink as the English ones have, in the same lines, and none of these."""
    dark = []
    for name, say in (("en", in_english), ("ja", speech("ja"))):
        file = tmp_path / f"{name}.pdf"
        file.write_bytes(machine_file(SMALL, PAPER, "A4", say))
        subprocess.run(["pdftoppm", "-r", "100", "-png", "-singlefile", file, tmp_path / name], check=True)
        dark.append(imread(tmp_path / f"{name}.png")[:160, :, :3].max(axis=2) < 0.5)
    english, japanese = dark
    for top, low in ((12.0, 19.5), (21.5, 26.0), (26.5, 31.0), (31.5, 36.0)):  # mm
        rows = slice(round(top / 0.254), round(low / 0.254))
        assert 0.3 < japanese[rows].sum() / english[rows].sum() < 3.0
    assert not re.search("[A-Za-z]{4,}", text_of(tmp_path / "ja.pdf"))


def test_pattern_on_pages_without_a_japanese_font(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fonts, "_JAPANESE", ("No such font",))
    assert machine_file(SMALL, PAPER, "A4", speech("ja")) == machine_file(SMALL, PAPER, "A4")


@pytest.mark.parametrize(
    ("text", "letters", "lines"),
    [
        ("one two three", 7, ["one two", "three"]),
        ("a self-sealing valve", 8, ["a self-", "sealing", "valve"]),
        ("as wide as 12 mm of it", 10, ["as wide as", "12\u00a0mm of", "it"]),
        ("combien ? peu", 9, ["combien\u00a0?", "peu"]),
        ("endlessword", 4, ["endl", "essw", "ord"]),
        ("溶着線に沿って、幅", 4, ["溶着線に", "沿って、", "幅"]),
        ("溶着線「首」を", 4, ["溶着線", "「首」を"]),
        ("幅 5 mm で", 6, ["幅 5\u00a0mm", "で"]),
        ("風船、。", 3, ["風", "船、。"]),
        ("", 4, [""]),
    ],
)
def test_lines_break_where_they_may(text: str, letters: int, lines: list[str]) -> None:
    assert broken(text, lambda line: len(line) <= letters) == lines
