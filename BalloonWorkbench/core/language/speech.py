# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine says in other languages, without Qt: for the command line.

The engine speaks plain English. Its sentences, and what translators made of them, are in
resources/translations; the window shows the same ones through Qt.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES
from BalloonWorkbench.core.language import sentence_forms

if TYPE_CHECKING:  # FreeCAD's start needs the sentences, and must not load NumPy
    from BalloonWorkbench.core.types import Say

FOLDER = RESOURCES / "translations"
ENGLISH = "en"
_STEM = "BalloonWorkbench_"
#: The first of them that is set says which language a user wants of programs without a window.
_VARIABLES = ("LC_ALL", "LC_MESSAGES", "LANG")


def languages() -> list[str]:
    """The languages there are, English first: "en", "de", "es-ES" ..."""
    return [ENGLISH, *sorted(path.stem.removeprefix(_STEM) for path in FOLDER.glob(f"{_STEM}*.ts"))]


def short_names() -> list[str]:
    """What the languages are called by those who choose one: "en", "de", "es" ..."""
    return [_short(language) for language in languages()]


def language_named(name: str) -> str:
    """The language that is meant by "de", "de-AT" or "de_DE". InputError for one that is not here."""
    short = _short(name)
    known = [language for language in languages() if _short(language) == short]
    if not known:
        raise InputError(f'There is no language "{name}": choose one of {", ".join(short_names())}.')
    return known[0]


def _short(name: str) -> str:
    return name.replace("_", "-").partition("-")[0].lower()


def users_language(environment: Mapping[str, str]) -> str:
    """The language that the environment of a program asks for; English where there is none such."""
    asked = next((environment[name] for name in _VARIABLES if environment.get(name)), ENGLISH)
    try:
        return language_named(asked.partition(".")[0])
    except InputError:
        return ENGLISH


def chosen_language(name: str | None, environment: Mapping[str, str]) -> str:
    """The language that is named, else that of the environment. InputError for one that is not here."""
    return users_language(environment) if name is None else language_named(name)


@cache
def speech(language: str) -> Say:
    """A function that says a text of the engine in a language; what it does not know stays English."""
    if language == ENGLISH:
        return str
    messages = ElementTree.parse(FOLDER / f"{_STEM}{language}.ts").iter("message")
    done = {message.findtext("source", ""): message.findtext("translation", "") for message in messages}
    known = listed()
    return lambda text: sentence_forms.translated(text, known, lambda source: done.get(source) or source)


@cache
def listed() -> sentence_forms.Known:
    """The sentences that are recognised by their form."""
    return sentence_forms.known(json.loads((FOLDER / "sentences.json").read_text(encoding="utf-8")))
