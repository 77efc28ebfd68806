# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing files whole or not at all."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.files.swap import PART, beside, make_folder, put_files, recover
from BalloonWorkbench.core.files.system import locked, signals_wait

#: Signs that some system does not take in the name of a file, and names that Windows keeps for itself.
_FORBIDDEN = re.compile(r"""[<>:"/\\|?*\x00-\x1f\x7f\ud800-\udfff]+""")
_KEPT = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
_LONGEST = 160  # bytes: most systems take 255, and an ending follows


def safe_name(text: str) -> str:
    """A text as the name of a file, still without its ending, that every system takes; "pattern" for none."""
    plain = _FORBIDDEN.sub("_", " ".join(text.split())).encode()[:_LONGEST]
    name = plain.decode(errors="ignore").strip(" .")
    return f"_{name}" if _KEPT.fullmatch(name) else name or "pattern"


def _nothing(_paths: tuple[Path, ...]) -> None: ...


def write_files(
    folder: str | os.PathLike[str],
    contents: Mapping[str, bytes],
    done: Callable[[tuple[Path, ...]], None] = _nothing,
) -> tuple[Path, ...]:
    """Write contents by file name into a folder, made if it is missing; all of them or none.

    Existing files of these names are replaced; their modes stay, and symbolic links to them. Another run that
    writes into this folder is waited for. What a run that was killed left is put in order before.

    Returns the paths; calls done(paths) as soon as they are there, before an interruption that came meanwhile
    takes effect. Raises ExportError, and then no file has changed and nothing new is left behind.
    """
    target = Path(folder)
    paths = tuple(target / name for name in contents)
    for name in contents:
        if not name or Path(name).name != name or name.startswith(".film-balloon"):
            raise ExportError(f"'{name}' is not a file name: leave out the folder.")
    made: list[Path] = []
    try:
        place = Path(os.path.realpath(target))
        made = _missing_folders(place.parent)
        place.parent.mkdir(parents=True, exist_ok=True)
        with locked(place.parent), signals_wait():
            recover(place)
            if os.path.lexists(place):
                _insist_on_folder(place)
                put_files(place, contents)
            else:
                make_folder(place, contents)
            made = []
            done(paths)
    except OSError as error:
        raise _refused(target, error) from error
    finally:
        _discard(made)
    return paths


def check_folder(folder: str | os.PathLike[str]) -> None:
    """Find out before the work whether files can be written there; leaves nothing.

    What a run that was killed left there is put in order. Raises ExportError.
    """
    try:
        place = Path(os.path.realpath(folder))
        nearest = next(path for path in (place, *place.parents) if os.path.lexists(path))
        _insist_on_folder(nearest)
        with locked(place.parent if place.parent.is_dir() else nearest), signals_wait():
            if place.parent.is_dir():
                recover(place)
            trial = place / PART if nearest == place else beside(nearest / place.name)
            os.mkdir(trial)
            os.rmdir(trial)
    except OSError as error:
        raise _refused(Path(folder), error) from error


def _insist_on_folder(place: Path) -> None:
    if not place.is_dir():
        raise NotADirectoryError(20, f"{place.name} is a file")


def _refused(folder: Path, error: OSError) -> ExportError:
    return ExportError(
        f"Cannot write to {folder}: {error.strerror or error}. Choose another folder, or make room there."
    )


def _discard(made: list[Path]) -> None:
    with contextlib.suppress(OSError):  # others may have put something there
        for folder in made:
            folder.rmdir()


def _missing_folders(place: Path) -> list[Path]:
    """The folders that will be made, the innermost first."""
    return [folder for folder in (place, *place.parents) if not folder.exists()]
