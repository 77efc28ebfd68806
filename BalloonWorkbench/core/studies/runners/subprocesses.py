# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs in processes of this machine, one thread each."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass
from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError, Cancelled, ProgramFault
from BalloonWorkbench.core.studies.job import TIMEOUT, Finished, Job
from BalloonWorkbench.core.studies.runners.worker import WorkerProcess

_LOOK = 0.2  # s between two looks whether it was stopped


def processors() -> int:
    """How many this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # macOS, Windows
        return os.cpu_count() or 1


@dataclass(frozen=True)
class Subprocesses:
    """A runner: so many processes of this machine, 0 for one a processor; timeout [s] of a job.

    packages    folders from which the processes import, too
    is_stopped  asked now and then: whether the user wants no more
    """

    processes: int = 0
    timeout: float = TIMEOUT
    packages: tuple[str, ...] = ()
    is_stopped: Callable[[], bool] = lambda: False

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        """See `Runner`; Cancelled when it was stopped."""
        source = _Source(jobs)
        finished: queue.SimpleQueue[Finished | BalloonError | None] = queue.SimpleQueue()
        workers = [
            WorkerProcess(place, self.timeout, self.packages) for _ in range(self.processes or processors())
        ]
        threads = [
            threading.Thread(target=_drain, args=(source, worker, finished), daemon=True)
            for worker in workers
        ]
        for thread in threads:
            thread.start()
        try:
            left = len(threads)
            while left:
                try:
                    answer = finished.get(timeout=_LOOK)
                except queue.Empty:
                    if self.is_stopped():
                        raise Cancelled("The study was stopped.") from None
                    continue
                if isinstance(answer, BalloonError):
                    raise answer
                if answer is None:
                    left -= 1
                else:
                    yield answer
        finally:
            source.close()
            for worker in workers:
                worker.stop()
            for thread in threads:
                thread.join()
            for worker in workers:
                worker.close()


class _Source:
    """Jobs for several threads."""

    def __init__(self, jobs: Iterable[Job]) -> None:
        self._jobs, self._lock, self._open = iter(jobs), threading.Lock(), True

    def next(self) -> Job | None:
        """The next job; None when there is none."""
        with self._lock:
            return next(self._jobs, None) if self._open else None

    def close(self) -> None:
        """There are no more."""
        self._open = False


def _drain(
    source: _Source, worker: WorkerProcess, finished: queue.SimpleQueue[Finished | BalloonError | None]
) -> None:
    """Have a worker do all that it gets; the last that is put is None."""
    try:
        while (job := source.next()) is not None:
            finished.put(worker.work(job))
    except BalloonError as error:
        finished.put(error)
    except (OSError, ValueError, RuntimeError) as error:
        finished.put(ProgramFault(f"The study cannot go on ({error})."))
    finally:
        finished.put(None)
