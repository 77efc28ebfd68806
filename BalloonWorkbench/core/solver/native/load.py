# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver: the library that is loaded, or why there is none; see c_interface.py for the calls."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import TYPE_CHECKING

from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import SolverError
from BalloonWorkbench.core.solver.native.library import (
    FOLDER,
    candidates,
    damage,
    file_name,
    to_load,
    unusable,
)

if TYPE_CHECKING:
    import ctypes

ABI_VERSION = 9
_FOLDER = FOLDER


@functools.cache
def _load() -> tuple[ctypes.CDLL | None, str | None]:
    """The library, or why there is none: what is wrong with the best one that is there."""
    why = None
    for path in candidates(_FOLDER):
        loaded, problem = _loaded(path)
        if loaded is not None:
            return loaded, None
        why = why or problem
    return None, why or f"{file_name()} has not been built."


def _loaded(path: Path) -> tuple[ctypes.CDLL | None, str | None]:
    damaged = damage(path)
    if damaged is not None:
        return None, damaged
    if packages.lacks_ctypes():
        return None, packages.NO_CTYPES
    try:
        loaded, version = _opened(to_load(path))
    except (OSError, AttributeError) as error:
        return None, f"{path.name} cannot be loaded ({error})."
    if version != ABI_VERSION:
        return None, f"{path.name} has interface {version}, but {ABI_VERSION} is needed."
    return loaded, None


def _opened(path: Path) -> tuple[ctypes.CDLL, int]:
    import ctypes

    library = ctypes.CDLL(str(path))
    version = int(library.film_abi_version())
    library.film_last_error.restype = ctypes.c_char_p
    library.film_destroy.argtypes = [ctypes.c_void_p]
    library.film_destroy.restype = None
    library.film_set_threads.argtypes = [ctypes.c_int32]
    library.film_set_threads.restype = None
    return library, version


def problem_with(path: Path) -> str | None:
    """Why this library cannot be used, or None when it can."""
    return _loaded(path)[1]


def problem_with_library() -> str | None:
    """Why the native solver cannot be used, or None when it can."""
    return _load()[1]


def unusable_library() -> str | None:
    """A sentence for the user where a library is there, but of no use; None where none was built."""
    why = problem_with_library() if any(candidates(_FOLDER)) else None
    return why and unusable(why)


def library() -> ctypes.CDLL:
    """The library. Raises SolverError where there is none."""
    loaded, why = _load()
    if loaded is None:
        raise SolverError(f"The native solver is not available: {why} Use the NumPy solver.")
    return loaded


def use_threads(count: int | None) -> None:
    """How many threads a solve takes in this process; None: as many as find work. Small meshes take one.

    Nothing where there is no native solver. The result does not depend on it, to the last bit.
    """
    loaded, _ = _load()
    if loaded is not None:
        loaded.film_set_threads(count or 0)
