# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of the program: what nobody foresaw becomes one sentence, and a file for those who repair it.

Only borders use this: the command line, a worker, a recompute, a command, a panel, the Python API.
"""

from __future__ import annotations

import datetime
import hashlib
import os
import platform
import sys
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError, ProgramFault
from BalloonWorkbench.core.packages import ABSENCES

#: Versions of the programs around the engine, by name; who runs inside one enters it.
surroundings: dict[str, str] = {}

#: What a border in the main thread catches; KeyboardInterrupt is the user's. A thread catches everything.
UNFORESEEN = (Exception, SystemExit)

_KEPT = 20  # files in a folder; the oldest go


def own_folder() -> Path:
    """Where the details go: BALLOON_FAULT_FOLDER, else .film-balloon/faults in the home folder."""
    chosen = os.environ.get("BALLOON_FAULT_FOLDER")
    return Path(chosen) if chosen else Path.home() / ".film-balloon" / "faults"


def report_fault(error: BaseException, doing: str) -> ProgramFault:
    """What to tell the user of an error that nobody foresaw; its details are in a file then.

    doing  what the program was at, for the details: "inflating". Never raises.
    """
    if isinstance(error, ProgramFault):
        return error
    file = _written(error, doing)
    memory = isinstance(error, MemoryError)
    if memory and file is None:
        text = "There is too little memory for this: take a coarser mesh, or close other programs."
    elif memory:
        text = (
            "There is too little memory for this: take a coarser mesh, or close other programs. "
            f"Details are in '{file}'."
        )
    elif file is None:
        text = (
            "This is a fault of the program, not yours, and its details cannot be written anywhere. "
            f"Please report it: {type(error).__name__}, {doing}."
        )
    else:
        text = (
            "This is a fault of the program, not yours. "
            f"Its details are in '{file}': please report it with this file."
        )
    return ProgramFault(text, file)


def as_balloon_error(error: BaseException, doing: str) -> BalloonError:
    """The error itself where it was foreseen, else the report of a fault."""
    return error if isinstance(error, BalloonError) else report_fault(error, doing)


def _written(error: BaseException, doing: str) -> Path | None:
    """The file with the details, or None where nothing can be written.

    The same fault has the same file: one that comes back with every stroke does not push out the others.
    """
    try:
        trace = "".join(traceback.format_exception(type(error), error, error.__traceback__))
        name = f"fault-{hashlib.sha256(_places(error).encode()).hexdigest()[:8]}.txt"
        content = _without_home(f"{_heading(doing)}\n{trace}").encode("utf-8", "backslashreplace")
    except Exception:  # noqa: BLE001 - the report of a fault must not be one; the sentence remains
        return None
    for folder in _folders():
        try:
            return _write(folder, name, content)
        except OSError:
            continue
    return None


def _folders() -> Iterator[Path]:
    with suppress(RuntimeError):  # nobody knows where home is
        yield own_folder()
    with suppress(OSError):  # no temporary folder either
        yield Path(tempfile.gettempdir()) / "film-balloon-faults"
        yield Path(tempfile.mkdtemp(prefix="film-balloon-faults-"))  # that one is another user's


def _write(folder: Path, name: str, content: bytes) -> Path:
    """Write a file of this name whole, and forget the oldest ones. Raises OSError."""
    folder.mkdir(parents=True, exist_ok=True)
    handle, part = tempfile.mkstemp(prefix=".fault-", dir=folder)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
        os.replace(part, folder / name)
    except OSError:
        Path(part).unlink(missing_ok=True)
        raise
    newest = sorted(folder.glob("fault-*.txt"), key=_age)
    for old in newest[_KEPT:]:
        with suppress(OSError):
            old.unlink(missing_ok=True)
    return folder / name


def _age(path: Path) -> float:
    try:
        return -path.stat().st_mtime
    except OSError:  # another program removed it
        return 0.0


def _places(error: BaseException) -> str:
    """What two reports of the same fault have in common: kinds of error, and lines of source."""
    lines: list[str] = []
    link: BaseException | None = error
    while link is not None and len(lines) < 10_000:
        lines.append(type(link).__name__)
        lines += [
            f"{Path(frame.filename).name}:{frame.lineno}"
            for frame in traceback.extract_tb(link.__traceback__)
        ]
        link = link.__cause__ or link.__context__
    return "\n".join(dict.fromkeys(lines))


def _heading(doing: str) -> str:
    """When, where and with what: nothing of the user's but that."""
    from BalloonWorkbench.core.version import VERSION

    now = datetime.datetime.now(datetime.timezone.utc)
    versions = {"Film Balloon": VERSION, **surroundings, "Python": platform.python_version()}
    for package in ABSENCES:
        module = sys.modules.get(package)
        if module is not None:
            versions[package] = str(getattr(module, "VERSION", None) or _installed(package))
    return "\n".join(
        (
            f"Film Balloon, fault ({doing})",
            f"{now:%Y-%m-%d %H:%M} UTC, {platform.platform()}, {platform.machine()}",
            *(f"{name} {version}" for name, version in versions.items()),
            "",
        )
    )


def _installed(package: str) -> str:
    from importlib import metadata

    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "?"


def _without_home(text: str) -> str:
    """The home folder is often the user's name."""
    try:
        home = str(Path.home())
    except RuntimeError:
        return text
    return text if len(home) < 2 else text.replace(home, "~")
