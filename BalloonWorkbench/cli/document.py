# SPDX-License-Identifier: LGPL-2.1-or-later
"""balloon.FCStd from the command line, made by FreeCAD in a process of its own.

Where FreeCAD lacks a folder to write in, or memory, it ends the process that it runs in.
"""

from __future__ import annotations

import contextlib
import importlib.util
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli.console import readable
from BalloonWorkbench.core.errors import BalloonError, MissingPackageError, ProgramFault
from BalloonWorkbench.core.faults import report_fault

NAME = "balloon.FCStd"
_REFUSED, _FAULT = 2, 70
#: A numerical library that gets no memory may try for ever: seconds of processor time, or many times our own.
_PATIENCE, _SHARE = 120, 4
_NEEDS = "FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory."


class Document:
    """A document that is being made."""

    def __init__(self, request: bytes) -> None:
        package = str(Path(__file__).resolve().parents[2])
        known = os.environ.get("PYTHONPATH")
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([package, *([known] if known else [])])}
        with contextlib.suppress(OSError):
            environment["TMPDIR"] = (
                tempfile.gettempdir()
            )  # FreeCAD does not look for one that it can write to
        self._process = subprocess.Popen(
            [sys.executable, "-m", __name__, str(_PATIENCE + int(_SHARE * time.process_time()))],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment,
        )
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError), self._process.stdin as pipe:
            pipe.write(request)

    def content(self) -> bytes:
        """The finished document. MissingPackageError where FreeCAD does not work here, ProgramFault."""
        self._process.stdin = None  # closed
        content, errors = self._process.communicate()
        status = self._process.returncode
        if status == 0 and content:
            return content
        lines = errors.decode("utf-8", "replace").split("\n")
        last = next((line.strip() for line in reversed(lines) if line.strip()), "")
        if status == _FAULT:
            raise ProgramFault(last)
        if status == _REFUSED:
            raise MissingPackageError(last)
        raise MissingPackageError(
            f"FreeCAD stopped before the document was done ({last or status}). {_NEEDS}"
        )

    def stop(self) -> None:
        """Give up what is not finished."""
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()
        for pipe in (self._process.stdout, self._process.stderr):
            if pipe is not None:
                pipe.close()


@contextmanager
def document(
    drawing: str, settings: Any, designs: Any, width: float | None, height: float | None
) -> Iterator[Document | None]:
    """The document of balloons, begun at once, to be waited for at the end; None without FreeCAD.

    width, height  of the drawing [m], as they were asked for
    """
    if importlib.util.find_spec("FreeCAD") is None:
        yield None
        return
    begun = Document(pickle.dumps((drawing, settings, designs, width, height)))
    try:
        yield begun
    finally:
        begun.stop()


def _make(request: bytes) -> bytes:
    """In the other process: the content of the document. MissingPackageError where FreeCAD cannot."""
    drawing, settings, designs, width, height = pickle.loads(request)
    try:
        from BalloonWorkbench.app.document.fcstd import fcstd_bytes

        with tempfile.TemporaryDirectory() as folder:
            return bytes(fcstd_bytes(_named(drawing, folder), settings, designs, width=width, height=height))
    except (ImportError, OSError, RuntimeError, MemoryError) as error:  # FreeCAD's own are of these kinds
        text = _said(error)
        raise MissingPackageError(
            f"FreeCAD cannot make the document ({text or type(error).__name__}). {_NEEDS}"
        ) from error


def _said(error: BaseException) -> str:
    """The message of an error; FreeCAD's own have it in a dictionary."""
    said = error.args[0] if error.args else ""
    text = said.get("sErrMsg", "") if isinstance(said, dict) else str(error)
    return str(text).strip().partition("\n")[0]


def _named(drawing: str, folder: str) -> str:
    """The drawing under a name that FreeCAD can write down: itself, or a copy."""
    name = readable(drawing)
    return drawing if name == drawing else shutil.copy(drawing, Path(folder, Path(name).name))


def _limit(seconds: int) -> None:
    """End this process when it has worked so long; not on Windows."""
    with contextlib.suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_CPU, (seconds, resource.RLIM_INFINITY))


def _main() -> int:
    _limit(int(sys.argv[1]))
    output = os.dup(1)
    os.dup2(2, 1)  # what FreeCAD prints is no part of the document
    try:
        content = _make(sys.stdin.buffer.read())
        with os.fdopen(output, "wb") as stream:
            stream.write(content)
    except BalloonError as error:
        sys.stderr.write(f"\n{error}\n")
        return _REFUSED
    except Exception as error:  # noqa: BLE001 - the other process is told by a line
        sys.stderr.write(f"\n{report_fault(error, 'making the document')}\n")
        return _FAULT
    return 0


if __name__ == "__main__":
    # FreeCAD, loaded as a part of Python, may fail where it ends: the document is complete by then
    status = _main()
    sys.stderr.flush()
    os._exit(status)
