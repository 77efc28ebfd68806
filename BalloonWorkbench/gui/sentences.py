# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine says, in the user's language.

The engine speaks plain English and knows no Qt. Its sentences are listed, with {places} for what it puts
in; here they are recognised by their form, translated, and filled again.
"""

from __future__ import annotations

import json
import re
from functools import cache
from typing import NamedTuple

from BalloonWorkbench.gui.qt import TRANSLATIONS, translate

_PLACE = re.compile(r"{(\w+)}")


class _Form(NamedTuple):
    """A sentence with places, and how to recognise it."""

    source: str
    letters: int
    pattern: re.Pattern[str]


def tell(text: str) -> str:
    """A text of the engine in the user's language; one that is not known stays as it is."""
    if "\n" in text:
        return "\n".join(map(tell, text.split("\n")))
    plain, forms = _known()
    if text in plain:
        return translate(text)
    for form in forms:
        found = form.pattern.fullmatch(text)
        if found:
            told = {name: tell(value) for name, value in found.groupdict().items()}
            return _fill(translate(form.source), told)
    return text


def _fill(sentence: str, told: dict[str, str]) -> str:
    return _PLACE.sub(lambda place: told[f"_{place[1]}"], sentence)


@cache
def _known() -> tuple[frozenset[str], tuple[_Form, ...]]:
    """Sentences without places, and those with, the longest first: the shortest fit almost anything."""
    listed = json.loads((TRANSLATIONS / "sentences.json").read_text(encoding="utf-8"))
    plain = frozenset(source for source in listed if not _PLACE.search(source))
    forms = [_form(source) for source in listed if source not in plain]
    return plain, tuple(sorted(forms, key=lambda form: (-form.letters, form.source)))


def _form(source: str) -> _Form:
    pieces = _PLACE.split(source)  # text, name, text, name ... text
    pattern = re.escape(pieces[0])
    seen: set[str] = set()
    for name, after in zip(pieces[1::2], pieces[2::2]):
        pattern += f"(?P=_{name})" if name in seen else f"(?P<_{name}>.+?)"
        pattern += re.escape(after)
        seen.add(name)
    return _Form(source, sum(map(len, pieces[::2])), re.compile(pattern))
