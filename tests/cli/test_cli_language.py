# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line in the user's language: all that is told, the assembly sheet, mistakes."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from test_cli import BAD, bad_inputs
from test_translations import tool

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.language import sentence_forms
from BalloonWorkbench.core.language.speech import languages, speech, users_language
from BalloonWorkbench.core.nesting import nest as nesting

PICTURES = Path(__file__).parents[2] / "resources" / "examples" / "pictures"
_PLACE = re.compile(r"({\w+})")
#: What stays as it is in all languages: units, names of options, files, films and machines.
SAME = re.compile(
    r"\d[\d.]* ?x |(?<![a-z])(?:µm|mm|cm|m|ml|l|mg|g|kg|k?Pa|dpi|EUR|in)(?:[²³])?(?![a-z])|--?[a-z-]+|'[^']*'"
    r'|"[^"]*"|/[^ ]*|\([^()]*, 20\d\d[^()]*\)|SOLVER native|[\w-]+\.(?:json|png|dxf|svg|pdf|plt)'
)


def loud(text: str) -> str:
    """A language of its own: English in capitals, so that what was not translated is seen."""
    return "".join(piece if _PLACE.fullmatch(piece) else piece.upper() for piece in _PLACE.split(text))


@pytest.fixture
def capitals(monkeypatch: pytest.MonkeyPatch) -> None:
    """The command line in that language, with the texts that the source has now."""
    known = sentence_forms.known(tool.sentences())
    monkeypatch.setattr(
        command_line, "speech", lambda _name: lambda text: sentence_forms.translated(text, known, loud)
    )


def left_in_english(text: str) -> list[str]:
    """Lines with words that were not translated."""
    lines = [line.removeprefix("balloon: ") for line in text.splitlines() if not line.startswith("WROTE ")]
    typed = re.compile("|".join(sorted(films(), key=len, reverse=True)))
    return [line for line in lines if re.search("[a-z]{2,}", SAME.sub("", typed.sub("", line)))]


@pytest.mark.slow
def test_all_that_is_told_is_translated(
    capitals: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A balloon with advice, a machine, a layout, a print, and a pressure that is too much for it."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")  # rows: quick
    picture = str(PICTURES / "fish.png")
    words = ["inflate", picture, "--width", "300mm", "--mesh-size", "25mm", "--out", str(tmp_path)]
    options = "--material nylon-foil --pressure 20kPa --intake film-valve --drawn-as pen --nest 500mm"
    words += options.split()
    words += ["--artwork", picture, "--dpi", "40", "--machine", "inkscape"]
    words += ["--assembly", "A4", "--frames", "2"]
    assert command_line.main(words) == 0
    told = capsys.readouterr()
    assert told.out.count("\n") > 15
    for wanted in ("BALLOON: ", "SAFE PRESSURE: ", "LESS THAN ITS", "WILL IT FLOAT? ", "ADVICE", "WROTE "):
        assert wanted in told.out, wanted
    assert not left_in_english(told.out + told.err)


@pytest.mark.parametrize("case", sorted(set(BAD) - {"not an option"}))
def test_mistakes_are_translated(
    case: str, capitals: None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words, _ = bad_inputs(tmp_path)[case]
    assert command_line.main(["inflate", *words, "--out", str(tmp_path / "out")]) == 2
    assert not left_in_english(capsys.readouterr().err)


def test_what_no_language_has_is_seen() -> None:
    assert left_in_english("BALLOON: 3 mm, not translated")


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "de_DE.UTF-8"}, "de"),
        ({"LANG": "de_DE.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "es_MX", "LC_ALL": ""}, "es-ES"),
        ({"LC_MESSAGES": "fr", "LANG": "de"}, "fr"),
        ({"LANG": "pl_PL.UTF-8"}, "en"),
    ],
)
def test_language_of_the_environment(environment: dict[str, str], language: str) -> None:
    assert users_language(environment) == language


def test_the_option_goes_before_the_environment(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    told = {}
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    for name in ("", "en", "fr", "es", "ja_JP"):
        option = ["--language", name] if name else []
        assert command_line.main(["inflate", "nowhere.png", "--out", str(tmp_path), *option]) == 2
        told[name] = capsys.readouterr().err
    assert told[""].startswith("balloon: Es gibt keine Datei")
    assert told["en"].startswith("balloon: There is no file")
    assert len(set(told.values())) == len(told)


def test_a_language_that_is_not_there_is_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command_line.main(["inflate", "x.png", "--out", str(tmp_path), "--language", "xx"]) == 2
    text = capsys.readouterr().err
    assert text.count("\n") == 1
    assert '"xx"' in text
    assert "en, de, es, fr, ja" in text


def test_every_language_says_each_sentence_of_the_window() -> None:
    """The same files as Qt's: nothing is looked up that is not there."""
    for language in languages()[1:]:
        assert speech(language)("The simulation was stopped.") != "The simulation was stopped."
        assert speech(language)("A remark of a user") == "A remark of a user"


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler-utils are not installed")
def test_the_sheet_speaks_it_and_the_report_does_not(tmp_path: Path) -> None:
    path = tmp_path / "square.json"
    path.write_text('{"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}')
    words = ["inflate", str(path), "--mesh-size", "25mm", "--out", str(tmp_path), "--assembly", "A4"]
    assert command_line.main([*words, "--tiled", "A4", "--language", "de"]) == 0
    for name, wanted in (("assembly.pdf", "Montageblatt"), ("pattern-a4.pdf", "Seite 1 von")):
        told = subprocess.run(["pdftotext", tmp_path / name, "-"], capture_output=True, check=True)
        assert wanted in told.stdout.decode()
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert "lifts" in report["maker"]["will_it_float"]
