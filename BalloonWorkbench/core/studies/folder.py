# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study: a folder a balloon by its key, whole or not there; one study at a time."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.files.data_file import UNUSABLE, parse_data
from BalloonWorkbench.core.files.write import check_folder, write_files

BALLOONS, REPORT, FAILURE = "balloons", "report.json", "failure.json"
_LOCK = ".film-balloon-study"


class StudyFolder:
    """Results by key, in `balloons/ab/abcdef.../`: report.json, or failure.json of what failed."""

    def __init__(self, place: str | os.PathLike[str]) -> None:
        self.place = Path(os.path.abspath(place))

    def of(self, key: str) -> Path:
        """The folder of a balloon."""
        return self.place / BALLOONS / key[:2] / key

    def has(self, key: str) -> bool:
        """Its result is there, or that it cannot be made."""
        place = self.of(key)
        return os.path.isfile(place / REPORT) or os.path.isfile(place / FAILURE)

    def report(self, key: str) -> dict[str, Any] | None:
        """Its report; None where there is none that can be read."""
        return _read(self.of(key) / REPORT)

    def failure(self, key: str) -> str:
        """Why it cannot be made; empty where it can, or was not tried."""
        return str((_read(self.of(key) / FAILURE) or {}).get("sentence", ""))

    def keep(self, key: str, contents: Mapping[str, bytes]) -> None:
        """Put the files of a balloon into its folder, all or none. Raises ExportError."""
        if not self.is_there():
            raise self.vanished()
        write_files(self.of(key), contents)

    def keep_failure(self, key: str, sentence: str) -> None:
        """Keep that a balloon cannot be made, and why. Raises ExportError."""
        text = json.dumps({"sentence": sentence}, indent=2, ensure_ascii=False) + "\n"
        self.keep(key, {FAILURE: text.encode(errors="backslashreplace")})

    def is_there(self) -> bool:
        """It is the folder of a study that runs."""
        return (self.place / _LOCK).is_file()

    def vanished(self) -> ExportError:
        """What to raise where it is not."""
        return ExportError(
            f"The folder '{self.place}' has vanished: bring it back or choose another one, and start the"
            " study again."
        )

    @contextlib.contextmanager
    def in_use(self, share: tuple[int, int] = (1, 1)) -> Iterator[None]:
        """Make it, and keep other studies out; shares (i, n) of one study may run beside each other.

        Raises InputError where another study runs in it, ExportError where it cannot be written to. Nothing
        is held when a study is killed. Where the system has no locks of files, none is kept out.
        """
        check_folder(self.place)
        try:
            self.place.mkdir(parents=True, exist_ok=True)
            with contextlib.ExitStack() as held:
                held.enter_context(_locked(self.place / _LOCK, alone=share[1] == 1))
                if share[1] > 1:
                    name = f"{_LOCK}-{share[0]}-of-{share[1]}"
                    held.enter_context(_locked(self.place / name, alone=True))
                yield
        except BlockingIOError:
            raise InputError(
                f"Another study is running in '{self.place}': wait for it, or choose another folder."
            ) from None


@contextlib.contextmanager
def _locked(path: Path, alone: bool) -> Iterator[None]:
    """Hold a lock. Raises BlockingIOError where another one holds it."""
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            import fcntl

            fcntl.flock(handle, (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB)
        except ImportError:  # Windows
            pass
        except BlockingIOError:
            raise
        except OSError:  # some network disks
            pass
        yield
    finally:
        os.close(handle)


def _read(path: Path) -> dict[str, Any] | None:
    try:
        data = parse_data(path.read_text(encoding="utf-8"))
    except UNUSABLE:
        return None
    return data if isinstance(data, dict) else None
