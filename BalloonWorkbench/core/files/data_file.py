# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data files: ours, and those that users put beside them, which may hold anything or be no files at all."""

from __future__ import annotations

import json
import math
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

RESOURCES = Path(__file__).resolve().parents[3] / "resources"
_LARGEST = 1_000_000  # bytes

#: What reading a file of other content raises; KeyError is what it lacks.
UNUSABLE = (OSError, ValueError, TypeError, AttributeError, ArithmeticError, LookupError)


def read_data(path: Path) -> Any:
    """What a JSON file holds, with numbers that can be computed with.

    Raises OSError or ValueError, which say what is wrong.
    """
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise ValueError("it is no file")
    if status.st_size > _LARGEST:
        raise ValueError("it is too large")
    return parse_data(path.read_text(encoding="utf-8"))


def parse_data(text: str) -> Any:
    """What JSON says, with numbers that can be computed with. Raises ValueError."""
    try:
        return json.loads(text, parse_constant=_refuse, parse_float=_real, parse_int=_integer)
    except RecursionError:
        raise ValueError("it is nested too deeply") from None


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
    raise ValueError(f"{text[:20]} is too large a number, or none")
