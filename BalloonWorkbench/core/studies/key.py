# SPDX-License-Identifier: LGPL-2.1-or-later
"""By what a balloon of a study is known: SHA-256 of the input's content, the values and the program."""

from __future__ import annotations

import hashlib
import json
import stat
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.solver.backend import active_backend
from BalloonWorkbench.core.version import VERSION

_BLOCK = 1 << 20  # bytes


@cache
def program() -> str:
    """What decides a result beside the values: the version, and by which solver numbers are worked out."""
    return f"{VERSION} {active_backend()}"


def key_of(meaning: Mapping[str, Any]) -> str:
    """The key of a result: SHA-256, in hexadecimal, of all that decides it and of the program.

    meaning  of what JSON can hold; names with None count as not given
    """
    decisive = {name: value for name, value in meaning.items() if value is not None}
    text = json.dumps([program(), decisive], sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()


def content_hash(path: Path) -> str:
    """SHA-256 of a file's content, in hexadecimal, read once while its size and date stay. InputError."""
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise InputError(f"'{path}' is no file: name one.")
        return _content_hash(path, status.st_size, status.st_mtime_ns)
    except FileNotFoundError:
        raise InputError(f"There is no file '{path}'. Check the name and the folder.") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"'{path}' cannot be read ({reason}). Check the name and its access.") from None


@cache
def _content_hash(path: Path, _size: int, _date: int) -> str:
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while block := file.read(_BLOCK):
            digest.update(block)
    return digest.hexdigest()
