# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages for those who work on the code: short, and what they name is there."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LAYERS = ("", "BalloonWorkbench")
PLACE = re.compile(r"`((?:core|app|gui|cli|native|tests|tools)/[\w./-]*\w)(?:: \w+)?[`:]")
WALKS = ("The pressure", "The seal width", "A pixel")


def page(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def section(text: str, title: str) -> str:
    return text.split(f"## {title}\n")[1].split("\n## ", maxsplit=1)[0]


@pytest.mark.parametrize("name", ["ARCHITECTURE.md", "CONTRIBUTING.md"])
def test_what_is_named_is_there(name: str) -> None:
    places = PLACE.findall(page(name))
    assert len(places) > 15
    assert not [place for place in places if not any((ROOT / layer / place).exists() for layer in LAYERS)]


def test_architecture_is_one_page() -> None:
    text = page("ARCHITECTURE.md")
    assert len(text.splitlines()) <= 80
    assert len(re.findall(r"^\| ", section(text, "Where to look"), re.MULTILINE)) - 1 <= 15


def test_the_glossary_is_short_and_each_word_stands_once() -> None:
    words = re.findall(r"^\| ([^|]+) \|", section(page("CONTRIBUTING.md"), "Words"), re.MULTILINE)[1:]
    assert len(words) <= 46
    assert len({*words}) == len(words)


@pytest.mark.parametrize("title", WALKS)
def test_a_walk_is_short_and_its_functions_are_there(title: str) -> None:
    """At most eight steps, each in another place: forward only."""
    walk = section(page("CONTRIBUTING.md"), "Three walks").split(title)[1].split("\n\n")[1]
    steps = re.findall(r"^(\d)\. (.+(?:\n   .+)*)", walk, re.MULTILINE)
    assert [int(number) for number, _ in steps] == [*range(1, len(steps) + 1)]
    assert 3 <= len(steps) <= 8
    first = [re.search(r"`((?:core|app|gui|cli|native)/[\w./]+)", text) for _, text in steps]
    files = [each[1] for each in first if each]
    assert len({*files}) == len(files) == len(steps)
    for file, name in re.findall(r"`((?:core|app|gui|cli)/[\w./]+\.py): (\w+)`", walk):
        assert re.search(rf"(def|class) {name}\b", page(f"BalloonWorkbench/{file}")), (file, name)


def test_tests_that_are_named_are_there() -> None:
    """In the Makefile, in scripts and pages, which a move would leave behind."""
    pages = [ROOT / "Makefile", ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / ".ci" / "run"]
    pages += [*ROOT.glob("tools/*.*"), *ROOT.glob("docs/*.md"), *ROOT.glob("benchmarks/**/*.py")]
    named = {path: re.findall(r"\btests/[\w/]+\.\w+", path.read_text(encoding="utf-8")) for path in pages}
    assert sum(map(len, named.values())) > 30
    assert not [(path.name, name) for path in pages for name in named[path] if not (ROOT / name).exists()]


def test_mutations_are_of_this_code() -> None:
    """What `make mutations` replaces stands in the code, and the test that must notice is there."""
    for mutation in json.loads(page("tests/mutations.json")):
        assert mutation["from"] in page(mutation["file"]), mutation["file"]
        assert (ROOT / mutation["test"].split("::")[0]).exists(), mutation["test"]
