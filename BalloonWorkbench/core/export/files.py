# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing files whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from BalloonWorkbench.core.errors import ExportError


def write_files(folder: str | os.PathLike[str], contents: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Write contents by file name into a folder, made if it is missing; all of them or none.

    Existing files of these names are replaced. Returns the paths. Raises ExportError, and then no file
    has changed and nothing new is left behind.
    """
    place = Path(folder)
    made: list[Path] = []
    waiting: dict[Path, Path] = {}
    try:
        made = _missing_folders(place)
        place.mkdir(parents=True, exist_ok=True)
        for name, content in contents.items():
            if Path(name).name != name:
                raise ExportError(f"'{name}' is not a file name: leave out the folder.")
            handle, temporary = tempfile.mkstemp(prefix=".", suffix=f"-{name}", dir=place)
            waiting[place / name] = Path(temporary)
            with os.fdopen(handle, "wb") as stream:
                stream.write(content)
                stream.flush()
                os.fsync(stream.fileno())
            Path(temporary).chmod(_ordinary_mode())
        _replace_all(waiting)
    except OSError as error:
        _discard(waiting, made)
        raise ExportError(
            f"Cannot write to {place}: {error.strerror or error}. Choose another folder, or make room there."
        ) from error
    except ExportError:
        _discard(waiting, made)
        raise
    return tuple(waiting)


def _replace_all(waiting: Mapping[Path, Path]) -> None:
    """Rename the temporary files; where one fails, the former files come back."""
    for target in waiting:
        if target.is_dir():
            raise IsADirectoryError(21, f"{target.name} is a folder")
    former: dict[Path, bytes | None] = {}
    try:
        for target, temporary in waiting.items():
            kept = target.read_bytes() if target.exists() else None
            temporary.replace(target)
            former[target] = kept
    except OSError:
        for target, content in former.items():
            if content is None:
                target.unlink(missing_ok=True)
            else:
                target.write_bytes(content)
        raise


def _discard(waiting: Mapping[Path, Path], made: list[Path]) -> None:
    for temporary in waiting.values():
        temporary.unlink(missing_ok=True)
    for folder in made:
        if folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()


def _missing_folders(place: Path) -> list[Path]:
    """The folders that will be made, the innermost first."""
    return [folder for folder in (place, *place.parents) if not folder.exists()]


def _ordinary_mode() -> int:
    """What a file made in the ordinary way may do: mkstemp's are private."""
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
