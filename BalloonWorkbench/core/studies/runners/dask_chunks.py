# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker of Dask does: a few jobs, each in the process beside it that all of its jobs share."""

from __future__ import annotations

import queue
import socket
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Finished, Job
from BalloonWorkbench.core.studies.key import program
from BalloonWorkbench.core.studies.runners.worker import WorkerProcess

_idle: dict[tuple[str, float], queue.SimpleQueue[WorkerProcess]] = {}


@dataclass(frozen=True)
class Chunk:
    """Jobs that are worked out together, for whom, and with which program; timeout [s] of each."""

    jobs: tuple[Job, ...]
    place: str
    program: str
    timeout: float


def work_chunk(chunk: Chunk) -> Sequence[Finished] | str:
    """What became of the jobs; a sentence where this machine cannot do them.

    What another worker did before it died is not done again.
    """
    where = f"The worker on {socket.gethostname()}"
    try:
        if program() != chunk.program:
            return f"{where} has version {program()}, not {chunk.program}: install the same one everywhere."
        folder = StudyFolder(chunk.place)
        if not folder.is_there():
            return f"{where} does not see the folder '{chunk.place}': choose one that all machines share."
        idle = _idle.setdefault((chunk.place, chunk.timeout), queue.SimpleQueue())
        try:
            process = idle.get_nowait()
        except queue.Empty:
            process = WorkerProcess(Path(chunk.place), chunk.timeout)
        done = [Finished(job.key) if folder.has(job.key) else process.work(job) for job in chunk.jobs]
        idle.put(process)
        return [_as_kept(finished, folder) for finished in done]
    except BalloonError as error:
        return f"{where} cannot work: {error}"


def _as_kept(finished: Finished, folder: StudyFolder) -> Finished:
    """With the sentence of a failure that another worker kept."""
    sentence = finished.sentence or folder.failure(finished.key)
    return Finished(finished.key, sentence, finished.kept, finished.ends)
