# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences with {places} for what a program puts in: recognised by their form, translated, filled again."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import NamedTuple

_PLACE = re.compile(r"{(\w+)}")


class Form(NamedTuple):
    """A sentence with places, and how to recognise it."""

    source: str
    letters: int
    pattern: re.Pattern[str]


#: Sentences without places, and those with, the longest first: the shortest fit almost anything.
Known = tuple[frozenset[str], tuple[Form, ...]]


def known(listed: Iterable[str]) -> Known:
    """What can be recognised, from sentences with {0}, {name}."""
    listed = list(listed)
    plain = frozenset(source for source in listed if not _PLACE.search(source))
    forms = [_form(source) for source in listed if source not in plain]
    return plain, tuple(sorted(forms, key=lambda form: (-form.letters, form.source)))


def translated(text: str, sentences: Known, translate: Callable[[str], str]) -> str:
    """A text in another language, with what it was filled with; one that is not known stays as it is."""
    if "\n" in text:
        return "\n".join(translated(line, sentences, translate) for line in text.split("\n"))
    plain, forms = sentences
    if text in plain:
        return translate(text)
    for form in forms:
        match = form.pattern.fullmatch(text)
        if match:
            filling = {
                name: translated(value, sentences, translate) for name, value in match.groupdict().items()
            }
            return _fill(translate(form.source), filling)
    return text


def _fill(sentence: str, filling: dict[str, str]) -> str:
    return _PLACE.sub(lambda place: filling[f"_{place[1]}"], sentence)


def _form(source: str) -> Form:
    pieces = _PLACE.split(source)  # text, name, text, name ... text
    pattern = re.escape(pieces[0])
    seen: set[str] = set()
    for name, after in zip(pieces[1::2], pieces[2::2]):
        pattern += f"(?P=_{name})" if name in seen else f"(?P<_{name}>.+?)"
        pattern += re.escape(after)
        seen.add(name)
    return Form(source, sum(map(len, pieces[::2])), re.compile(pattern))
