# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data files: ours, and those that users put beside them, which may hold anything or be no files at all."""

from __future__ import annotations

import json
import math
import re
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

from BalloonWorkbench.core.errors import BalloonError

RESOURCES = Path(__file__).resolve().parents[3] / "resources"
_LARGEST = 1_000_000  # bytes

#: What Python says of a text that is no number.
_NO_NUMBER = re.compile(
    r"(?:could not convert string to float|invalid literal for int\(\) with base 10): (.*)"
)
#: And of a name that is none of an enumeration.
_NO_NAME = re.compile(r"(.*) is not a valid \w+")
#: What reading a file of other content raises; KeyError is what it lacks.
UNUSABLE = (OSError, ValueError, TypeError, AttributeError, ArithmeticError, LookupError)


class _NoData(ValueError):
    """Says in words for people why a file is of no use."""


def reason_of(error: Exception) -> Exception:
    """Why a data file is of no use, for people: what Python says of kinds of values is for programmers."""
    if isinstance(error, (BalloonError, OSError, _NoData)):
        return error
    if isinstance(error, UnicodeError):
        return _NoData("it is no text in UTF-8")
    if isinstance(error, json.JSONDecodeError):
        return _NoData(f"a comma, quote or bracket is missing or too much in line {error.lineno}")
    number = _NO_NUMBER.match(str(error))
    if number:
        return _NoData(f"{number[1]} is no number")
    name = _NO_NAME.match(str(error))
    if name:
        return _NoData(f"{name[1]} is none of the names that are known")
    return _NoData("one of its values is of another kind than it must be")


def read_data(path: Path) -> Any:
    """What a JSON file holds, with numbers that can be computed with.

    Raises OSError or ValueError, which say what is wrong.
    """
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise _NoData("it is no file")
    if status.st_size > _LARGEST:
        raise _NoData("it is too large")
    return parse_data(path.read_text(encoding="utf-8"))


def parse_data(text: str) -> Any:
    """What JSON says, with numbers that can be computed with. Raises ValueError."""
    try:
        return json.loads(text, parse_constant=_refuse, parse_float=_real, parse_int=_integer)
    except RecursionError:
        raise _NoData("it is nested too deeply") from None


def data_files(folder: Callable[[], Path]) -> list[Path]:
    """The data files of a folder by name; none where it cannot be found or looked into."""
    try:
        return sorted(folder().glob("*.json"))
    except (OSError, RuntimeError):  # RuntimeError: nobody knows where home is
        return []


def _real(text: str) -> float:
    value = float(text)
    return value if math.isfinite(value) else _refuse(text)


def _integer(text: str) -> int:
    _real(text)
    return int(text)


def _refuse(text: str) -> NoReturn:
    raise _NoData(f"{text[:20]} is too large a number, or none")
