# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of What's this: the same in each language, with the names that the window shows."""

from __future__ import annotations

import re
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest

from BalloonWorkbench.core.language.speech import FOLDER, languages

HELP = Path(__file__).resolve().parents[2] / "docs" / "help"
PAGES = sorted(path.name for path in HELP.glob("*.html"))
EMPTY = {"meta", "link", "img"}


class Page(HTMLParser):
    """Tags in their order, texts by tag, files by their full names."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.files: list[Path] = []
        self.texts: dict[str, list[str]] = {}
        self.language = ""
        self._open: list[str] = []
        self._path = path
        self.feed(path.read_text(encoding="utf-8"))
        assert not self._open, f"{path}: {self._open} is not closed"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        if tag not in EMPTY:
            self._open.append(tag)
            self.texts.setdefault(tag, []).append("")
        for name, value in attrs:
            if name in ("src", "href"):
                self.files.append((self._path.parent / str(value)).resolve())
            if (tag, name) == ("html", "lang"):
                self.language = str(value)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag, f"{self._path}: {tag}"

    def handle_data(self, data: str) -> None:
        for tag in self._open:
            self.texts[tag][-1] += data


def messages(language: str) -> dict[tuple[str, str], str]:
    """Translations by context and source, without the keys of menus."""
    found = {}
    path = FOLDER / f"BalloonWorkbench_{language}.ts"
    for context in ElementTree.parse(path).iter("context"):
        for message in context.iter("message"):
            told = re.sub(r"\(&.\)|&", "", message.findtext("translation", ""))
            found[context.findtext("name", ""), message.findtext("source", "")] = told
    return found


def test_pages_are_known() -> None:
    assert len(PAGES) >= 12
    folders = {path.name for path in HELP.iterdir() if path.is_dir()}
    assert folders == set(languages()[1:])


@pytest.mark.parametrize("language", languages()[1:])
def test_same_pages(language: str) -> None:
    assert sorted(path.name for path in (HELP / language).iterdir()) == PAGES


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("language", languages()[1:])
def test_same_structure(language: str, name: str) -> None:
    """Headings, paragraphs, lists, links, pictures, keys and code; no paragraph was left in English."""
    english, page = Page(HELP / name), Page(HELP / language / name)
    assert page.language == language
    assert Counter(page.tags) == Counter(english.tags)
    assert page.files == english.files
    assert all(path.is_file() for path in page.files)
    for tag in ("pre", "code", "kbd"):
        assert page.texts.get(tag) == english.texts.get(tag)
    for tag in ("p", "h2"):
        assert not set(page.texts.get(tag, [])) & set(english.texts.get(tag, []))


@pytest.mark.slow
@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("language", languages()[1:])
def test_names_are_those_of_the_window(language: str, name: str) -> None:
    """The title is the command's name; what is bold stands so on a button, a field or a menu."""
    page, said = Page(HELP / language / name), messages(language)
    english = Page(HELP / name)
    title = said[f"BalloonWorkbench_{Path(name).stem}", english.texts["title"][0]]
    assert page.texts["title"] == [title]
    assert page.texts["h1"][0].strip() == title
    for source, told in zip(english.texts["b"], page.texts["b"], strict=True):
        known = {told for (_, text), told in said.items() if text.replace("&", "") == source}
        assert told in known, f"{source} is {known} in the window, not {told}"


@pytest.mark.parametrize("language", languages()[1:])
def test_quoted_commands_are_those_of_the_window(language: str) -> None:
    """„Schnittmuster ausgeben“ and the like."""
    said = set(messages(language).values())
    for name in PAGES:
        text = " ".join(Page(HELP / language / name).texts["p"])
        for quoted in re.findall(r"„(.*?)“|« (.*?) »|«(.*?)»|「(.*?)」", text):
            assert "".join(quoted) in said
