# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the native library is: beside the workbench (built, released or fetched), or in its own package.

A library is loaded only if the sum in the file beside it is its own: the system maps a damaged one
into memory, and then ends the process.

On Windows a library that is in use cannot be deleted, and an addon is updated by deleting its folder; so a
copy is loaded, from the user's data folder, named by what is in it.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import platform
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

#: Of the workbench's own libraries.
FOLDER = Path(__file__).resolve().parents[3] / "native" / "lib"
#: A Python package with the library of this platform alone.
PACKAGE = "film_balloon_native"
#: What it costs to go on without one, for all who say so.
SLOWER = "NumPy computes the same, 20 to 30 times slower."
_NAMES = {"win32": "film_solver.dll", "darwin": "libfilm_solver.dylib"}
_SYSTEMS = {"win32": "windows", "darwin": "macos", "linux": "linux"}
_MACHINES = {"amd64": "x86_64", "x64": "x86_64", "arm64": "aarch64"}


def file_name() -> str:
    """The library's file name on this system."""
    return _NAMES.get(sys.platform, "libfilm_solver.so")


def platform_name() -> str:
    """Name of the folder with the released library of this platform, such as linux-x86_64."""
    machine = platform.machine().lower()
    return f"{_SYSTEMS.get(sys.platform, sys.platform)}-{_MACHINES.get(machine, machine)}"


def fetched_folders(folder: Path) -> list[Path]:
    """Where a library that was fetched for this version goes: with the workbench's own, else in the home.

    That of another version is not looked at: it may know the interface, and compute something else.
    """
    from BalloonWorkbench.core.version import VERSION

    bases = [folder]
    with suppress(RuntimeError):  # nobody knows where home is
        bases.append(Path.home() / ".film-balloon" / "native")
    return [base / str(VERSION) / platform_name() for base in bases]


def candidates(folder: Path) -> Iterator[Path]:
    """The libraries that are there, best first: built here, released with the workbench, fetched, installed.

    folder  of the workbench's own libraries
    """
    places = [folder, folder / platform_name(), *fetched_folders(folder)]
    package = importlib.util.find_spec(PACKAGE)
    places += map(Path, (package and package.submodule_search_locations) or ())
    for place in places:
        path = place / file_name()
        if path.is_file():
            yield path


def sum_file(path: Path) -> Path:
    """The file with the SHA-256 sum of a library, as sha256sum writes and checks it."""
    return path.with_name(f"{path.name}.sha256")


def damage(path: Path) -> str | None:
    """What is wrong with the content of a library, or None."""
    try:
        intended = sum_file(path).read_bytes().split(maxsplit=1)[:1]
        content = path.read_bytes()
    except OSError as error:
        return f"{path.name} is damaged or incomplete ({error.strerror}). Install the workbench anew."
    if intended != [hashlib.sha256(content).hexdigest().encode()]:
        return f"{path.name} is damaged or incomplete. Install the workbench anew."
    return None


def unusable(why: str) -> str:
    """What a user is told of a library that is there, but of no use."""
    return f"The native solver, which is faster, is not available: {why}"


def is_lacking() -> bool:
    """Whether there is no library that could be loaded; loads none."""
    return None not in map(damage, candidates(FOLDER))


def damaged() -> list[str]:
    """A sentence where all libraries that are there are damaged; loads none of them."""
    problems = [damage(path) for path in candidates(FOLDER)]
    return [] if None in problems else [unusable(str(why)) for why in problems[:1]]


def to_load(path: Path) -> Path:
    """The file to load for a library: itself, or on Windows a copy of it that no update needs to delete."""
    return copied(path, _data_folder()) if sys.platform == "win32" else path


def copied(path: Path, folder: Path) -> Path:
    """A copy of a file under `folder`, made unless it is there; the file itself where it cannot be made.

    Copies of other contents are removed, but those that another FreeCAD uses.
    """
    try:
        content = path.read_bytes()
        home = folder / hashlib.sha256(content).hexdigest()[:16]
        target = home / path.name
        if not (target.is_file() and target.read_bytes() == content):
            home.mkdir(parents=True, exist_ok=True)
            number, part = tempfile.mkstemp(dir=home)
            with os.fdopen(number, "wb") as file:
                file.write(content)
            os.replace(part, target)
        for other in folder.iterdir():
            if other != home:
                shutil.rmtree(other, ignore_errors=True)
    except OSError:
        return path
    return target


def _data_folder() -> Path:
    local = os.environ.get("LOCALAPPDATA")
    return (Path(local) if local else Path.home() / "AppData" / "Local") / "FilmBalloon" / "native"
