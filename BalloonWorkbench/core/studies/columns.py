# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a study: each input and option of `design` and `inflate`, as core/options declares it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.option import Kind, Option
from BalloonWorkbench.core.options.table import options
from BalloonWorkbench.core.options.typed import KINDS, NONE
from BalloonWorkbench.core.studies.key import content_hash

INPUT, COMMAND = "input", "command"
DESIGN, INFLATE = "design", "inflate"
#: Several values in one cell.
SEPARATOR = ";"
YES, NO = ("yes", "true", "on", "1"), ("no", "false", "off", "0", NONE)


@dataclass(frozen=True)
class Value:
    """A value of a column.

    arguments  on the command line
    meaning    what the balloon depends on, of what JSON can hold: numbers in SI units, the hash of a file;
               None for what is so without the argument too
    """

    arguments: tuple[str, ...] = ()
    meaning: Any = None


@dataclass(frozen=True)
class Column:
    """A column: the name of an option without its dashes, or input, or command."""

    name: str
    option: Option | None = None

    @property
    def is_number(self) -> bool:
        """Its values are numbers with or without a unit."""
        kind = self.option and self.option.kind
        return kind not in (None, Kind.FLAG, Kind.CHOICE, Kind.TEXT, Kind.FILE)

    @property
    def is_whole(self) -> bool:
        """Its values are whole numbers."""
        return self.option is not None and self.option.kind is Kind.COUNT

    def read(self, written: Any, folder: Path) -> Value:
        """A value as it was written in a table or in JSON; nothing and "" are no value.

        folder: from which files are looked for. Raises InputError.
        """
        if written is None or written == "":
            return Value()
        if isinstance(written, (dict, list, tuple)) and not self._is_many:
            raise InputError(f"'{written}' is no single value for {self.name}.")
        try:
            return self._read(written, folder)
        except (ValueError, OverflowError):
            raise InputError(f"'{written}' is no value for {self.name}.") from None

    def number(self, written: Any) -> float | None:
        """A value in SI units where it is a number; None for none, and for other columns."""
        value = self.read(written, Path()).meaning if self.is_number else None
        return float(value) if isinstance(value, (int, float)) else None

    @property
    def _is_many(self) -> bool:
        return self.option is not None and isinstance(self.option.default, tuple)

    def _read(self, written: Any, folder: Path) -> Value:
        if self.option is None:
            return self._of_study(str(written), folder)
        if isinstance(self.option.default, bool) and self.option.kind is not Kind.COUNT:
            return self._flag(self.option, written)
        flag, texts = self.option.flag_name, [text_of(written)]
        if self._is_many:
            several = written if isinstance(written, (list, tuple)) else str(written).split(SEPARATOR)
            texts = [text_of(each).strip() for each in several]
        elif self.option.switch and texts[0].lower() in YES:
            return Value((flag,), True)
        paths = [_file(self.option, text, folder) for text in texts]
        arguments = tuple(
            f"{flag}={path or text}" for text, path in zip(texts, paths, strict=True) if text != ""
        )
        meanings = [
            self._meaning(self.option, text) if path is None else content_hash(path)
            for text, path in zip(texts, paths, strict=True)
        ]
        return Value(arguments, meanings if self._is_many else meanings[0])

    def _of_study(self, text: str, folder: Path) -> Value:
        if self.name == INPUT:
            path = Path.cwd() / folder / text
            return Value((str(path),), [path.name, content_hash(path)])
        if text not in (DESIGN, INFLATE):
            raise InputError(f"'{text}' is no command of a study: write {DESIGN} or {INFLATE}.")
        return Value((text,), text)

    @staticmethod
    def _flag(option: Option, written: Any) -> Value:
        text = str(written).strip().lower()
        if text in YES:
            return Value((option.flag_name,), True)
        if text in NO:
            return Value()
        raise InputError(f"'{written}' is neither yes nor no: write one of them for {_name(option)}.")

    @staticmethod
    def _meaning(option: Option, text: str) -> Any:
        if option.kind is Kind.CHOICE and not option.metavar:
            known = [title for title in option.titles if title is not None]
            if text not in known and not (option.switch and text == NONE):
                raise InputError(f"'{text}' is none of {', '.join(map(str, known))} for {_name(option)}.")
        elif option.kind is not Kind.CHOICE and not (option.switch and text == NONE):
            read = KINDS[option.kind][1]
            value = read(text, plain=option.plain) if option.plain else read(text)
            if isinstance(value, (int, float)) and not abs(value) < float("inf"):
                raise InputError(f"'{text}' is no number for {_name(option)}.")
            return None if value == option.default and not option.switch else value
        return None if text == option.default else text


def text_of(written: Any) -> str:
    """A value as it is typed: 250 for 250.0."""
    if isinstance(written, float) and written.is_integer() and abs(written) < 1e15:
        return str(int(written))
    return str(written).strip()


def _name(option: Option) -> str:
    return option.flag_name.lstrip("-")


def _file(option: Option, text: str, folder: Path) -> Path | None:
    """The file that a value names, where it does."""
    path = Path.cwd() / folder / text
    if option.kind is Kind.FILE:
        return path
    named = option.kind is Kind.CHOICE and option.metavar and text.lower().endswith(".json")
    return path if named else None


@cache
def columns() -> Mapping[str, Column]:
    """All columns by name."""
    named = {_name(option): Column(_name(option), option) for option in options() if option.flag_name}
    return {name: Column(name) for name in (INPUT, COMMAND)} | named


def column_named(text: str) -> Column:
    """The column that is meant, also with dashes before it, underscores or capitals. Raises InputError."""
    name = str(text).strip().lstrip("-").replace("_", "-").replace(" ", "-").lower()
    known = columns()
    if name in known:
        return known[name]
    near = get_close_matches(name, known, 3, 0.5)
    advice = (
        f"the nearest are {', '.join(near)}" if near else "the columns are the options of the command line"
    )
    raise InputError(f"There is no column '{text}': {advice}.")
