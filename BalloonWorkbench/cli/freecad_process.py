# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work for FreeCAD from the command line, in a process of its own.

Where FreeCAD lacks a folder to write in, or memory, it ends the process that it runs in.
"""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import os
import pickle
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError, InputError, MissingPackageError, ProgramFault
from BalloonWorkbench.core.faults import report_fault
from BalloonWorkbench.core.memoize import hand_over, results

#: How the process ends: FreeCAD cannot, what it was given is wrong, an unforeseen error.
_REFUSED, _WRONG, _FAULT = 2, 3, 70
#: A numerical library that gets no memory may try for ever: seconds of processor time, or many times our own.
_PATIENCE, _SHARE = 120, 4
_NEEDS = "FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory."


def has_freecad() -> bool:
    """Whether FreeCAD can be loaded by this Python."""
    return importlib.util.find_spec("FreeCAD") is not None


class FreecadProcess:
    """FreeCAD at work on a module of ours, whose `make` gets the arguments and gives the bytes of its result.

    work  what it does, to be said where it fails, such as "making the document"
    """

    def __init__(self, module: str, work: str, *arguments: object) -> None:
        self._work = work
        package = str(Path(__file__).resolve().parents[2])
        known = os.environ.get("PYTHONPATH")
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([package, *([known] if known else [])])}
        with contextlib.suppress(OSError):
            # FreeCAD does not look for one that it can write to
            environment["TMPDIR"] = tempfile.gettempdir()
        seconds = str(_PATIENCE + int(_SHARE * time.process_time()))
        self._process = subprocess.Popen(
            [sys.executable, "-m", __name__, module, work, seconds],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment,
        )
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError), self._process.stdin as pipe:
            pipe.write(pickle.dumps((arguments, results())))

    def content(self) -> bytes:
        """The finished result.

        Raises MissingPackageError where FreeCAD does not work here, InputError and ProgramFault.
        """
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
        if status == _WRONG:
            raise InputError(last)
        raise MissingPackageError(f"FreeCAD stopped while {self._work} ({last or status}). {_NEEDS}")

    def stop(self) -> None:
        """Give up what is not finished."""
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()
        for pipe in (self._process.stdout, self._process.stderr):
            if pipe is not None:
                pipe.close()


def _limit(seconds: int) -> None:
    """End this process when it has worked so long; not on Windows."""
    with contextlib.suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_CPU, (seconds, resource.RLIM_INFINITY))


def _made(module: str, work: str, request: bytes) -> bytes:
    """The result of a module's work. MissingPackageError where FreeCAD cannot."""
    arguments, known = pickle.loads(request)
    hand_over(known)  # FreeCAD's objects ask for what the program has worked out
    try:
        importlib.import_module("FreeCAD")  # before its parts, which fail without it
        return bytes(importlib.import_module(module).make(*arguments))
    except (ImportError, OSError, RuntimeError, MemoryError) as error:  # FreeCAD's own are of these kinds
        text = _said(error)
        raise MissingPackageError(
            f"FreeCAD failed while {work} ({text or type(error).__name__}). {_NEEDS}"
        ) from error


def _said(error: BaseException) -> str:
    """The message of an error; FreeCAD's own have it in a dictionary."""
    said = error.args[0] if error.args else ""
    text = said.get("sErrMsg", "") if isinstance(said, dict) else str(error)
    return str(text).strip().partition("\n")[0]


def _main() -> int:
    module, work, seconds = sys.argv[1:]
    _limit(int(seconds))
    output = os.dup(1)
    os.dup2(2, 1)  # what FreeCAD prints is no part of the result
    try:
        content = _made(module, work, sys.stdin.buffer.read())
        with os.fdopen(output, "wb") as stream:
            stream.write(content)
    except BalloonError as error:
        sys.stderr.write(f"\n{error}\n")
        return _WRONG if isinstance(error, InputError) else _REFUSED
    except Exception as error:  # noqa: BLE001 - the other process is told by a line
        sys.stderr.write(f"\n{report_fault(error, work)}\n")
        return _FAULT
    return 0


if __name__ == "__main__":
    # FreeCAD, loaded as a part of Python, may fail where it ends: the result is complete by then
    status = _main()
    sys.stderr.flush()
    os._exit(status)
