# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people read: numbers with a few digits and no exponent, one word for one thing."""

from __future__ import annotations

import ast
import json
import os
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from drawn_shapes import NAMED
from test_assembly import subject
from test_house import tree
from test_translations import tool

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core import units
from BalloonWorkbench.core.advice.advise import advise
from BalloonWorkbench.core.advice.as_data import repair_text
from BalloonWorkbench.core.assembly_sheet.steps import steps
from BalloonWorkbench.core.assembly_sheet.texts import figures, material
from BalloonWorkbench.core.film.library import film

ROOT = Path(__file__).parents[2]
PICTURES = ROOT / "resources" / "examples" / "pictures"
PACKAGE = Path(units.__file__).resolve().parents[1]
#: These write numbers for programs: files of machines, macros, fingerprints, and the functions themselves.
FOR_PROGRAMS = (
    *("core/machines/writers/[dghls]*.py", "core/results/vtu.py", "core/pages/pdf.py", "core/units.py"),
    *(
        "core/rounded.py",
        "core/studies/axes.py",
        "core/studies/table.py",
        "cli/studies/command.py",
        "app/engine/solve.py",
        "app/properties/values.py",
        "app/film_sheet.py",
        "app/studies/study_table.py",
        "app/properties/material.py",
    ),
)
_FORM = re.compile(r"[^{}]*[efgEFG%]")


def numbers_formatted(tree: ast.AST) -> Iterator[int]:
    """Lines in which a number becomes text by a format of its own: f"{x:.3g}", "{:.0f} mm"."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FormattedValue) and isinstance(node.format_spec, ast.JoinedStr):
            last = node.format_spec.values[-1]
            if isinstance(last, ast.Constant) and _FORM.fullmatch(str(last.value)):
                yield node.lineno
        elif (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and re.search(r"{\w*:[.,+\d]*[efgEFG%]}", node.value)
        ):
            yield node.lineno


def test_numbers_become_text_in_one_place() -> None:
    """One rule for digits, exponents and units: core/units.py, and gui/window/user_units.py."""
    wrong = []
    for path in sorted(PACKAGE.rglob("*.py")):
        if not any(path.match(pattern) for pattern in FOR_PROGRAMS):
            name = path.relative_to(PACKAGE)
            wrong += [f"{name}:{line}" for line in sorted(set(numbers_formatted(tree(path))))]
    assert not wrong


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (1574.3, 3, "1574"),
        (297.44, 4, "297.4"),
        (0.0834, 2, "0.083"),
        (9.996, 3, "10"),
        (2.0, 3, "2"),
        (0.0, 3, "0"),
        (-0.0, 3, "0"),
        (-1e-12, 3, "0"),
        (-0.26, 3, "-0.26"),
        (4.9e9, 3, "4900000000"),
        (25e-6, 3, "0.000025"),
        (float("inf"), 3, "?"),
    ],
)
def test_numbers_have_the_digits_that_count(value: float, digits: int, text: str) -> None:
    assert units.number_text(value, digits) == text


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (units.length_text(1.574), "1574 mm"),
        (units.length_text(12.3456), "12.35 m"),
        (units.length_text(4e-6), "4 µm"),
        (units.length_text(0.0), "0 mm"),
        (units.size_text(0.3, 0.297, 0.0893), "300 x 297 x 89.3 mm"),
        (units.size_text(30.0, 9.0), "30 x 9 m"),
        (units.volume_text(1.2549e-3), "1.25 l"),
        (units.volume_text(4.7e-9), "4.7 mm³"),
        (units.volume_text(2400.0), "2400 m³"),
        (units.mass_text(9e-7), "0.9 mg"),
        (units.mass_text(0.0123), "12.3 g"),
        (units.mass_text(62.4), "62.4 kg"),
        (units.area_text(0.0931), "931 cm²"),
        (units.pressure_text(2000.0), "2 kPa"),
        (units.pressure_text(35.0), "35 Pa"),
        (units.percent_text(0.0034), "0.34 %"),
        (units.place_text(units.from_mm(units.np.array([-1e-9, 1234.56]))), "(0, 1235) mm"),
        (units.place_text(units.np.array([-0.001, 19.461])), "(0, 19.46) m"),
        (units.money_text(0.021, "EUR"), "0.02 EUR"),
        (units.money_text(0.00021, "EUR"), "0.0002 EUR"),
        (units.money_text(4486.17, "EUR"), "4486 EUR"),
    ],
)
def test_measures_have_the_unit_that_people_use(text: str, wanted: str) -> None:
    assert text == wanted


#: A number that people cannot read, or that says nothing.
ODD = {
    "exponent": re.compile(r"\d[eE][+-]?\d"),
    "no number": re.compile(r"\b(nan|inf|None)\b"),
    "nothing": re.compile(r"(?<![\d.,])-?0(\.0*)? (µm|mm|m|in|ml|l|m³|mg|g|kg|Pa|kPa|%|cm²)(?!\w)"),
    "minus nothing": re.compile(r"-0(\.0*)?(?![\d.])"),
    "five digits": re.compile(r"(?<![\w.])(?:0*\.?0*)(?=[1-9])(?:\d\.?){5,}(?![\w.])"),
}


def odd_numbers(text: str) -> list[str]:
    """What is odd about the numbers of a text, but for names of files."""
    lines = [line for line in text.splitlines() if not line.startswith("Wrote ")]
    return [f"{name}: {line}" for line in lines for name, form in ODD.items() if form.search(line)]


@pytest.mark.parametrize(
    "text",
    [
        "Weld length 1.57e+03 mm",
        "Height 0.00 mm",
        "Pattern 0 x 0 mm, 0 g",
        "-0 mm",
        "nan kPa",
        "15743 mm",
        "1.2345 g",
    ],
)
def test_odd_numbers_are_seen(text: str) -> None:
    assert odd_numbers(text)


@pytest.mark.parametrize(
    "text", ["297.4 mm", "0.0309 mg", "12.35 m at 2000 kPa, 10 %", "0.8 l", "(0, 1235) mm"]
)
def test_good_numbers_are_left_alone(text: str) -> None:
    assert not odd_numbers(text)


#: For the long version: more shapes and sizes.
SHAPES = os.environ.get("BALLOON_WORD_SHAPES", "star").split()
SIZES = os.environ.get("BALLOON_WORD_SIZES", "3mm 30m").split()


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("size", SIZES)
def test_numbers_of_tiny_and_huge_balloons(
    shape: str, size: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """All that the command line, the sheet and the advice say of them."""
    width = units.parse_length(size)
    film = ["--young", "1e8", "--poisson", "0.4", "--thickness", "1e-6" if width < 1.0 else "1e-4"]
    film += ["--pressure", f"{2.0 / width}Pa"]
    mesh = [
        "--mesh-size",
        f"{width / 16}m",
        "--seal-width",
        f"{width / 60}m",
        "--allowance",
        f"{width / 90}m",
    ]
    intake = ["--intake-width", f"{width / 30}m", "--intake-length", f"{width / 10}m"]
    words = [str(PICTURES / f"{shape}.png"), "--width", size, "--out", str(tmp_path), "--language", "en"]
    assert command_line.main(["inflate", *words, *film, *mesh, *intake]) == 0
    told = capsys.readouterr()
    assert not odd_numbers(told.out + told.err)
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert not odd_numbers("\n".join([*report["warnings"], report["maker"]["will_it_float"]]))


@pytest.mark.parametrize("scale", [1e-3, 0.03, 1.0, 30.0])
def test_numbers_of_the_sheet(scale: float) -> None:
    """The lists and steps of a sheet, as if the balloon were so many times as large."""
    about = subject("ring", "nylon-foil", "film-valve")
    numbers = about.numbers
    grown = replace(
        numbers,
        film_area=numbers.film_area * scale**2,
        roll=(0.5 * scale, 0.7 * scale),
        seam_length=numbers.seam_length * scale,
        inner=numbers.inner * scale**2,
        border=numbers.border * scale**2,
        valve=numbers.valve * scale**2,
        volume=numbers.volume * scale**3,
        floating=tuple(
            replace(
                one,
                carries=one.carries * scale**3,
                left=one.left * scale**3,
                from_width=None if one.from_width is None else one.from_width * scale,
                gas_needed=one.gas_needed * scale**3,
                cost=None if one.cost is None else one.cost * scale**3,
            )
            for one in numbers.floating
        ),
    )
    for each in (grown, replace(grown, roll=None)):
        rows = [*material(about.film, about.pattern, each), *figures(about.film, each)]
        told = [value for _, value in rows] + steps(about.pattern, about.film, each)
        told += [each.sentence(number) for number in range(len(each.floating))]
        assert not odd_numbers("\n".join(told))


@pytest.mark.slow
@pytest.mark.parametrize("scale", [0.01, 100.0])
def test_numbers_of_advice(scale: float) -> None:
    """What is predicted of all shapes that we know, 3 mm and 30 m large."""
    said = 0
    for outline in NAMED.values():
        for finding in advise(outline.map(lambda loop: loop * scale), film("mylar")).findings:
            said += 1
            assert not odd_numbers(finding.text)
            assert finding.repair is None or not odd_numbers(repair_text(finding.repair))
    assert said > 10


#: Words of the laboratory and of the house, and what makers say instead.
WORDS = {
    r"slack": "loose",
    r"taut": "tight",
    r"residuals?": "off the drawing",
    r"disc's": "a round balloon, where a shape is judged",
    r"roundness": "the air that it holds",
    r"puffiness": "the air that it holds",
    r"nothing is in the way": "ready to make",
    r"litres?": "l, from core/units.py",
    r"equilibrium": "comes to rest",
    r"Newton": "the simulation",
    r"convergen\w+|converges?": "comes to rest",
    r"coach": "advice",
}
#: What is said to those who look into the simulation, in the properties and results that are about it.
EXPERTS = ("App::Property",)


def words_in(text: str) -> list[str]:
    """Banned words of a text."""
    plain = re.sub(r"{\w*}|<pre>.*?</pre>|<code>.*?</code>|`[^`]*`|```.*?```", " ", text, flags=re.DOTALL)
    return [word for word in WORDS if re.search(rf"\b({word})\b", plain, re.IGNORECASE)]


def test_texts_have_the_words_of_makers() -> None:
    """All that is collected for translation."""
    wrong = {
        text.source: words
        for text in tool.texts()
        if text.context not in EXPERTS and (words := words_in(text.source))
    }
    assert not wrong


def test_tooltips_of_properties_have_the_words_of_makers() -> None:
    wrong = {text.source: words_in(text.source) for text in tool.texts() if text.context in EXPERTS}
    assert not {text: words for text, words in wrong.items() if set(words) - {"Newton"}}  # a count of steps


@pytest.mark.parametrize("page", sorted((ROOT / "docs" / "help").glob("*.html")), ids=lambda page: page.stem)
def test_help_has_the_words_of_makers(page: Path) -> None:
    assert not words_in(page.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ["docs/tutorial.md", "docs/freecad.md", "docs/command-line.md"])
def test_docs_have_the_words_of_makers(name: str) -> None:
    """But for lines about files of numbers, whose keys are an interface."""
    lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
    assert not {line: words_in(line) for line in lines if "`report.json`" not in line and words_in(line)}


#: A number before these is never 1, or is a limit; and verbs that end like a plural.
MANY = "pixels millimetres letters notches copies balloons pages degrees shapes dots elements groups points"
MANY += " pieces lines vertices does has was its this times belongs calls crosses eases encloses ends follows"
MANY += " bears begins bodies gores holes joins lacks leans leaves lies lifts makes needs panels reads runs"
MANY += " seams turns wants divides goes misses comes pass strips combinations rows samples gets strays takes"
MANY += " ones parts marks looks"


def test_one_is_said_in_the_singular() -> None:
    """A text with a number before a plural has a twin with the singular, or none that may be 1."""
    sources = {text.source for text in tool.texts()}
    wrong = []
    for source in sources:
        for place, noun in re.findall(r"({\w*}) (?:[a-z]+ )?([a-z]{2,}s)\b", source):
            single = source.replace(f"{noun}", noun.removesuffix("s"))
            singular = [single, single.replace(" were ", " was "), single.replace(" are ", " is ")]
            singular += [text.replace("them", "it").replace("their", "its") for text in singular]
            if noun not in MANY.split() and not any(text in sources for text in singular):
                wrong.append(f"{place} {noun}: {source}")
    assert not sorted(wrong)
