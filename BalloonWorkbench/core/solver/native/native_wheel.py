# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver from the network, for a workbench that came without it: the wheel of its release.

Which wheel, how large and with which SHA-256 came with the source, in resources/native-wheels.json, which
tools/release.py writes. So what the network gives is trusted no more than the source is: another file is
refused, whoever sends it. Nothing is fetched unless the user asks for it.
"""

from __future__ import annotations

import hashlib
import http.client
import io
import shutil
import urllib.error
import urllib.request
import zipfile
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import Cancelled, ExportError, FetchError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data
from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.solver.native.library import (
    PACKAGE,
    SLOWER,
    fetched_folders,
    file_name,
    platform_name,
    sum_file,
)
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.version import VERSION

WHEELS = RESOURCES / "native-wheels.json"
_NOWHERE = ".example"  # ends names that lead nowhere, which stand for an address that is not known yet
_STOPPED = "The native solver was not fetched: stopped."
_PATIENCE = 10.0  # s without a sign from the other side
_CHUNK = 1 << 16  # bytes

#: Opens an address to be read, as urllib does.
Opener = Callable[[str], Any]


@dataclass(frozen=True)
class Wheel:
    """What would be fetched.

    address  where it is from
    size     in bytes
    sha256   of the whole file
    """

    address: str
    size: int
    sha256: str

    @property
    def host(self) -> str:
        """Who sends it."""
        return urlsplit(self.address).hostname or self.address


def wheel() -> Wheel:
    """The wheel for this platform and this version. Raises FetchError where there is none."""
    if packages.lacks_ctypes():
        raise FetchError(packages.NO_CTYPES)
    try:
        listed = read_data(WHEELS)
        known = (listed["version"], listed["interface"]) == (VERSION, load.ABI_VERSION)
        if not known or (urlsplit(listed["address"]).hostname or _NOWHERE).endswith(_NOWHERE):
            raise FetchError(f"There is no native solver to be fetched for this version yet. {SLOWER}")
        entry = listed["wheels"].get(platform_name())
        if entry is None:
            raise FetchError(f"There is no native solver for {platform_name()}. {SLOWER}")
        return Wheel(f"{listed['address']}/{entry['file']}", int(entry["size"]), str(entry["sha256"]))
    except UNUSABLE as error:
        raise FetchError(
            f"{WHEELS.name} is damaged: install the workbench anew, or go on without the native solver."
        ) from error


def slow_notes() -> list[str]:
    """Sentences for the command line where the native solver is not in use, and how to get it."""
    if load.problem_with_library() is None:
        return []
    notes = [why] if (why := load.unusable_library()) else []
    try:
        wheel()
    except FetchError:
        return notes
    return [*notes, "NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches."]


def place() -> Path:
    """The folder that it would be put into. Raises FetchError where there is none that can be written to."""
    for folder in fetched_folders(load._FOLDER):
        try:
            check_folder(folder)
        except ExportError as error:
            refused = error
        else:
            return folder
    raise FetchError(_unwritable(refused)) from refused


def open_address(address: str) -> Any:
    """What an address gives, to be read. Raises OSError, HTTPException, ValueError."""
    request = urllib.request.Request(address, headers={"User-Agent": f"FilmBalloon/{VERSION}"})
    return urllib.request.urlopen(request, timeout=_PATIENCE)


def fetch(wheel: Wheel, progress: Progress = no_progress, opener: Opener = open_address) -> Path:
    """Fetch the wheel, check it, put its library into its place and have it used from now on.

    Returns the library's path. Raises FetchError or Cancelled, and then nothing has changed.
    """
    folder = place()
    try:
        content = _checked(wheel, _received(wheel, progress, opener))
    except FetchError:
        if not progress(1.0, "fetching"):  # stopped while nothing came
            raise Cancelled(_STOPPED) from None
        raise
    library = folder / file_name()
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        files = {path.name: archive.read(f"{PACKAGE}/{path.name}") for path in (library, sum_file(library))}
    try:
        write_files(folder, files)
    except ExportError as error:
        raise FetchError(_unwritable(error)) from error
    problem = load.problem_with(library)
    if problem is not None:
        _discard(folder)
        raise FetchError(f"The native solver was fetched, but does not run here: {problem}")
    _forget_other_versions(folder.parent)
    _look_again()
    return library


def _look_again() -> None:
    """The next simulation takes the best solver that is there then."""
    load._load.cache_clear()
    backend.available.cache_clear()


def _discard(folder: Path) -> None:
    """Remove a library that is of no use, and the folders that were made for it."""
    shutil.rmtree(folder, ignore_errors=True)
    with suppress(OSError):  # others have something there
        folder.parent.rmdir()
        folder.parent.parent.rmdir()


def _forget_other_versions(current: Path) -> None:
    """Remove what was fetched for other versions beside it."""
    for folder in current.parent.iterdir():
        if folder != current and folder.name[:1].isdigit():
            shutil.rmtree(folder, ignore_errors=True)


def _received(wheel: Wheel, progress: Progress, opener: Opener) -> bytes:
    """What the other side sends, but no more than one byte too many."""
    content = bytearray()
    try:
        if not progress(0.0, "connecting"):
            raise Cancelled(_STOPPED)
        with opener(wheel.address) as stream:
            while len(content) <= wheel.size:
                chunk = stream.read1(min(_CHUNK, wheel.size + 1 - len(content)))
                if not chunk:
                    break
                content += chunk
                if not progress(min(len(content) / wheel.size, 1.0), "fetching"):
                    raise Cancelled(_STOPPED)
    except urllib.error.HTTPError as error:
        raise FetchError(
            f"{wheel.host} does not have the native solver (answer {error.code}). Try again later. {SLOWER}"
        ) from error
    except (OSError, http.client.HTTPException, ValueError) as error:
        raise FetchError(
            f"The native solver could not be fetched from {wheel.host} ({_reason(error)}). "
            f"Try again when the network is there. {SLOWER}"
        ) from error
    return bytes(content)


def _reason(error: Exception) -> str:
    """Why the network failed, in few words."""
    if isinstance(error, http.client.IncompleteRead):
        return "the connection ended too soon"
    if isinstance(error, http.client.HTTPException):
        return "the answer is not HTTP"
    cause = getattr(error, "reason", error)
    if isinstance(cause, TimeoutError):
        return "the connection timed out"
    return str(getattr(cause, "strerror", None) or cause)


def _checked(wheel: Wheel, content: bytes) -> bytes:
    """The content itself, if it is that of the release. Raises FetchError."""
    if hashlib.sha256(content).hexdigest() == wheel.sha256:
        return content
    if content.lstrip()[:1] == b"<":
        raise FetchError(
            f"A web page came instead of the native solver, as some networks send before one has signed in. "
            f"Open {wheel.host} in a browser, then try again. {SLOWER}"
        )
    if len(content) < wheel.size:
        raise FetchError(
            f"The connection to {wheel.host} ended before the whole native solver had come. "
            f"Try again. {SLOWER}"
        )
    raise FetchError(
        f"What {wheel.host} sent is not the native solver of this release: its SHA-256 is another one. "
        f"It was not kept. {SLOWER}"
    )


def _unwritable(error: ExportError) -> str:
    return f"The native solver cannot be saved. {error}"
