# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process that works out jobs one after the other: what it imports is paid for once.

It reads a job a line and writes what became of it a line, both JSON: see cli/studies/worker.py. It ends by
itself when its input is closed, as when the program that started it is killed.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any

from BalloonWorkbench.core.errors import Cancelled, ProgramFault
from BalloonWorkbench.core.studies.job import TIMEOUT, Finished, Job
from BalloonWorkbench.core.studies.key import program
from BalloonWorkbench.core.units import number_text

MODULE = "BalloonWorkbench.cli.studies.worker"
#: Balloons that are worked out beside each other share the processors; each has one thread.
_ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "BALLOON_THREADS")
_PACKAGE = Path(__file__).resolve().parents[4]
_PATIENCE = 300.0  # s, until a process has begun


def python() -> str:
    """The Python that runs beside this program; FreeCAD's own one where this is FreeCAD."""
    if Path(sys.executable or "").name.lower().startswith("python"):
        return sys.executable
    for place in (Path(sys.prefix), Path(sys.prefix, "bin"), Path(sys.executable or "").parent):
        for name in ("python3", "python", "python.exe"):
            if (place / name).is_file():
                return str(place / name)
    return shutil.which("python3") or "python3"


class WorkerProcess:
    """One such process; started when it gets its first job, and again after it died."""

    def __init__(self, place: Path, timeout: float = TIMEOUT, packages: tuple[str, ...] = ()) -> None:
        self._place, self._timeout, self._packages = place, timeout, packages
        self._process: subprocess.Popen[bytes] | None = None
        self._errors: IO[bytes] | None = None
        self._late = self._stopped = False
        self._starting = threading.Lock()

    def work(self, job: Job) -> Finished:
        """Work out a job; what ends its process ends the job alone. Raises ProgramFault where none starts."""
        process = self._started()
        line = json.dumps({"key": job.key, "task": job.task, "request": dict(job.request)})
        answer = self._answer(process, line, self._timeout)
        if answer is None:
            return Finished(job.key, self._died(), kept=False)
        return Finished(job.key, str(answer["sentence"]), bool(answer["kept"]), bool(answer["ends"]))

    def stop(self) -> None:
        """End the process for good, whatever it is at. May be called from another thread."""
        with self._starting:
            self._stopped = True
        self._kill()

    def _kill(self) -> None:
        process = self._process
        if process is not None:
            with contextlib.suppress(OSError):
                process.kill()
            process.wait()

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is not None and self._process.poll() is None:
            return self._process
        self._close()
        paths = [str(_PACKAGE), os.environ.get("PYTHONPATH", ""), *self._packages]
        environment = {**os.environ, **dict.fromkeys(_ONE_THREAD, "1")}
        environment["PYTHONPATH"] = os.pathsep.join(filter(None, paths))
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - let go with the process
        try:
            with self._starting:
                if self._stopped:
                    raise Cancelled("The study was stopped.")
                self._process = process = subprocess.Popen(
                    [python(), "-m", MODULE, str(self._place)],
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=self._errors,
                    env=environment,
                )
        except OSError as error:
            raise ProgramFault(f"No process can be started beside this one ({error}).") from None
        answer = self._answer(process, None, _PATIENCE)
        if answer is None:
            raise ProgramFault(f"A process beside this one does not start: {self._died()}")
        if answer["program"] != program():
            self._kill()
            raise ProgramFault(
                f"A process beside this one is of version {answer['program']}, not of {program()}: install"
                " one of them anew."
            )
        return process

    def _answer(
        self, process: subprocess.Popen[bytes], line: str | None, patience: float
    ) -> Mapping[str, Any] | None:
        """What the process says to a line; None when it dies over it, or takes too long and is killed."""
        assert process.stdin is not None
        assert process.stdout is not None
        self._late = False
        timer = threading.Timer(patience, self._give_up)
        timer.daemon = True
        timer.start()
        try:
            if line is not None:
                process.stdin.write(line.encode() + b"\n")
                process.stdin.flush()
            answer = json.loads(process.stdout.readline())
        except (OSError, ValueError):
            return None
        finally:
            timer.cancel()
        return answer if isinstance(answer, dict) else None

    def _give_up(self) -> None:
        self._late = True
        self._kill()

    def _died(self) -> str:
        """A sentence on how the process ended."""
        assert self._process is not None
        self._kill()
        if self._late:
            limit = number_text(self._timeout)
            return f"It took longer than {limit} s: take a coarser mesh, or raise --timeout."
        status = self._process.returncode
        if status < 0:
            name = signal.Signals(-status).name
            more = " It may have lacked memory: take a coarser mesh." if name == "SIGKILL" else ""
            return f"Its process was ended by {name}.{more}"
        return f"Its process ended with {status} ({self._last_line() or 'without a word'})."

    def _last_line(self) -> str:
        if self._errors is None:
            return ""
        self._errors.seek(0)
        lines = self._errors.read().decode("utf-8", "replace").split("\n")
        return next((line.strip()[:200] for line in reversed(lines) if line.strip()), "")

    def _close(self) -> None:
        """Let go what a process that ended left."""
        if self._process is not None:
            for pipe in (self._process.stdin, self._process.stdout):
                if pipe is not None:
                    with contextlib.suppress(OSError):
                        pipe.close()
            self._process = None
        if self._errors is not None:
            self._errors.close()
            self._errors = None

    def close(self) -> None:
        """End it, and let everything go."""
        self.stop()
        self._close()
