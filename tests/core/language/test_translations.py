# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the source code is translated into every language, with the same places for numbers."""

import importlib.util
import re
import string
from pathlib import Path
from types import ModuleType

import pytest

from BalloonWorkbench.core.language import sentence_forms

ROOT = Path(__file__).resolve().parents[3]


def _tool() -> ModuleType:
    spec = importlib.util.spec_from_file_location("translations", ROOT / "tools" / "translations.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


tool = _tool()


@pytest.fixture(scope="module")
def wanted() -> list:
    return tool.texts()


def places(text: str) -> list[tuple[str, str]]:
    """Name and format of every {place}; those without a name count from 0, as str.format does."""
    found, number = [], 0
    for _, name, form, _ in string.Formatter().parse(text):
        if name is None:
            continue
        found.append((name or str(number), form or ""))
        number += name == ""
    assert number in (0, len(found)), f"str.format takes numbers for all places or none: {text}"
    return sorted(set(found))


def test_extraction_sees_each_kind_of_text(wanted: list) -> None:
    """One of each kind, taken from the source by eye."""
    found = {(text.context, text.source) for text in wanted}
    assert ("BalloonWorkbench", "Nothing to improve.") in found  # translate("...")
    assert ("BalloonWorkbench_Advice", "Advice") in found  # a command
    assert ("Workbench", "Film &Balloon") in found  # a menu
    assert ("App::Property", "Thickness of the film") in found  # a tooltip
    assert ("BalloonWorkbench", "The simulation was stopped.") in found  # an error
    assert ("BalloonWorkbench", 'There is no film "{0}": choose one of {1}.') in found
    assert ("BalloonWorkbench", "{0} tiny hole was filled.") in found  # either of two
    assert ("BalloonWorkbench", "Fit to drawing") in found  # a choice
    tip = "This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}."
    assert ("BalloonWorkbench", tip) in found  # the coach


#: Places side by side of which the first one is a number, or a name without spaces, or the second one empty.
SIDE_BY_SIDE = (
    "A piece of {0} x {1} does not fit on film of {2}{3}:",
    '"{0}" is no edge of a panel:',
    "The {0} is {1}, not between {2} and {3} {4}:",
    "{0}{1} has no length.",
    "'{0}' is no JSON ({1}{2}).",
)


def test_a_sentence_is_recognised_whatever_it_is_filled_with() -> None:
    """Nothing tells where a name ends in "the bed of {1} {2}": half of a machine was translated."""
    _, forms = sentence_forms.known(tool.sentences())
    mistaken = []
    for form in forms:
        names = dict.fromkeys(re.findall(r"{(\w+)}", form.source))
        filling = {f"_{name}": f"one{number} two{number}" for number, name in enumerate(names)}
        match = form.pattern.fullmatch(sentence_forms._fill(form.source, filling))
        if match is None or match.groupdict() != filling:
            mistaken.append(form.source)
    assert len(forms) > 500
    assert not [each for each in mistaken if not each.startswith(SIDE_BY_SIDE)]


def test_sentences_are_up_to_date() -> None:
    """Run `make translations` when this fails."""
    assert (tool.FOLDER / "sentences.json").read_text(encoding="utf-8") == tool.sentences_json()


@pytest.mark.parametrize("language", tool.LANGUAGES)
def test_every_text_is_translated(language: str, wanted: list) -> None:
    done = tool.read(language)
    assert set(done) == {(text.context, text.source) for text in wanted}, "run `make translations`"
    assert not [source for (_, source), told in done.items() if not told.strip()]


@pytest.mark.parametrize("language", tool.LANGUAGES)
def test_places_agree(language: str) -> None:
    wrong = {
        source: told
        for (_, source), told in tool.read(language).items()
        if "{" in source and '{"' not in source and told and places(source) != places(told)
    }
    assert not wrong


@pytest.mark.parametrize("language", tool.LANGUAGES)
def test_menus_keep_their_key(language: str) -> None:
    """An ampersand marks the key of a menu; elsewhere it would vanish."""
    for (context, source), told in tool.read(language).items():
        if context == "Workbench" and told:
            assert source.count("&") == told.count("&")


def test_a_translation_is_no_copy() -> None:
    """Sentences differ in every language; names of programs do not."""
    for language in tool.LANGUAGES:
        same = [
            source
            for (_, source), told in tool.read(language).items()
            if told == source and len(re.findall(r"[a-z]{3,}", source)) > 4
        ]
        assert not same


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("{} of {:.1f}", [("0", ""), ("1", ".1f")]),
        ("{1:.1f}, {0}", [("0", ""), ("1", ".1f")]),
        ("{width} wide", [("width", "")]),
    ],
)
def test_places_are_compared_by_name(source: str, found: list) -> None:
    assert places(source) == found
