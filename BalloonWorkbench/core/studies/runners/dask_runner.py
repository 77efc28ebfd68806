# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs on workers of Dask: on this machine, over SSH, in SLURM, in Kubernetes, or of any scheduler."""

from __future__ import annotations

import contextlib
import itertools
import logging
from collections.abc import Generator, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.studies.job import CLUSTERS, KUBERNETES, LOCAL, SLURM, SSH, TIMEOUT, Finished, Job
from BalloonWorkbench.core.studies.key import program
from BalloonWorkbench.core.studies.runners.dask_chunks import Chunk, work_chunk
from BalloonWorkbench.core.studies.runners.subprocesses import processors

_MOST = 20  # jobs of a chunk; the first ones are smaller, so that all workers have some
_AHEAD = 2  # chunks of a worker's thread that wait at the scheduler
_DEATHS = 10  # of workers over the same chunk, each of which Dask counts four times
_CONNECTING = 15.0  # s
#: Of a cluster of this machine: one job a process, no web page, no word on what the study tells itself.
_QUIET = {"threads_per_worker": 1, "dashboard_address": ":0", "silence_logs": logging.CRITICAL}


@dataclass(frozen=True)
class DaskRunner:
    """A runner on a scheduler's workers, or on a cluster that is made for the study and ends with it.

    scheduler  its address; empty: make a cluster
    kind       of the cluster, one of CLUSTERS
    workers    of the cluster; 0 for one a processor, or as the settings say
    settings   what the class of the cluster takes: distributed's LocalCluster and SSHCluster, dask_jobqueue's
               SLURMCluster, dask_kubernetes' KubeCluster
    timeout    [s] of a job
    patience   [s] until the first worker is there
    """

    scheduler: str = ""
    kind: str = LOCAL
    workers: int = 0
    settings: Mapping[str, Any] = field(default_factory=dict)
    timeout: float = TIMEOUT
    patience: float = 600.0

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        """See `Runner`. Raises InputError, MissingPackageError."""
        distributed = _package("distributed", "dask distributed")
        logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is told by the rows
        with contextlib.ExitStack() as held:
            address: Any = self.scheduler
            if not address:
                address = self._cluster(distributed)
                held.callback(_close, address)
            try:
                client = distributed.Client(address, timeout=_CONNECTING)
                held.callback(_close, client)
                client.wait_for_workers(1, self.patience)
            except (OSError, ValueError) as error:  # TimeoutError is an OSError
                raise InputError(
                    f"No worker of Dask can be reached at '{self.scheduler or self.kind}' ({error}): start a"
                    " scheduler and workers, and give its address."
                ) from None
            yield from _Work(distributed, client, place, self.timeout).run(jobs)

    def _cluster(self, distributed: Any) -> Any:
        """A cluster that is made; to be closed. Raises InputError, MissingPackageError."""
        settings, workers = dict(self.settings), self.workers
        try:
            if self.kind == LOCAL:
                here = {"n_workers": workers or processors()}
                return distributed.LocalCluster(**(_QUIET | here | settings))
            if self.kind == SSH:
                return distributed.SSHCluster(**settings)
            if self.kind == SLURM:
                cluster = _package("dask_jobqueue", "dask-jobqueue").SLURMCluster(**settings)
            elif self.kind == KUBERNETES:
                cluster = _package("dask_kubernetes.operator", "dask-kubernetes").KubeCluster(**settings)
            else:
                raise InputError(f"'{self.kind}' is no cluster: write one of {', '.join(CLUSTERS)}.")
            if workers:
                cluster.scale(workers)
        except (TypeError, ValueError, OSError, RuntimeError) as error:
            reason = str(error).strip() or type(error).__name__
            raise InputError(
                f"The cluster cannot be made ({reason}): check the file that --cluster names."
            ) from None
        except ImportError as error:  # SSH needs asyncssh
            raise MissingPackageError(f"A package for this cluster is missing: {error}") from None
        return cluster


def _close(dask: Any) -> None:
    """Close a client or a cluster: one that is slow to end costs no study, whose balloons are on disk."""
    with contextlib.suppress(OSError):  # TimeoutError is one
        dask.close()


def _package(name: str, install: str) -> Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise MissingPackageError(
            f"Studies on Dask need {name.partition('.')[0]}: install it with pip install {install}, or leave"
            f" --dask and --scheduler out ({error})."
        ) from None


class _Work:
    """Chunks at a scheduler, a few ahead of its workers."""

    def __init__(self, distributed: Any, client: Any, place: Path, timeout: float) -> None:
        self._distributed, self._client = distributed, client
        self._place, self._timeout = place, timeout
        self._deaths: dict[str, int] = {}

    def run(self, jobs: Iterable[Job]) -> Generator[Finished, None, None]:
        chunks = self._chunks(iter(jobs))
        running = self._distributed.as_completed()
        chunk_of: dict[Any, Chunk] = {}

        def submit(chunk: Chunk) -> None:
            future = self._client.submit(work_chunk, chunk, pure=False)
            chunk_of[future] = chunk
            running.add(future)

        for chunk in itertools.islice(chunks, _AHEAD * self._threads()):
            submit(chunk)
        for future in running:
            chunk = chunk_of.pop(future)
            if (done := self._result(future, chunk)) is None:
                submit(chunk)
                continue
            future.release()  # a worker that dies does not do it again
            while len(chunk_of) < _AHEAD * self._threads() and (more := next(chunks, None)) is not None:
                submit(more)
            yield from done

    def _chunks(self, jobs: Iterator[Job]) -> Iterator[Chunk]:
        sent = 0
        while True:
            size = min(_MOST, 1 + sent // (4 * self._threads()))
            few = tuple(itertools.islice(jobs, size))
            if not few:
                return
            sent += len(few)
            yield Chunk(few, str(self._place), program(), self._timeout)

    def _threads(self) -> int:
        return max(1, sum(self._client.nthreads().values()))

    def _result(self, future: Any, chunk: Chunk) -> list[Finished] | None:
        """What became of a chunk; None where it is to be sent again. Raises InputError."""
        if future.status == "finished":
            done = future.result()
            if isinstance(done, str):
                raise InputError(done)
            return list(done)
        if future.status == "error":
            error = future.exception()
            if isinstance(error, self._distributed.KilledWorker):
                first = chunk.jobs[0].key
                deaths = self._deaths[first] = self._deaths.get(first, 0) + 1
                if deaths < _DEATHS:
                    return None
                sentence = "Its workers were killed again and again: take a coarser mesh, or start it again."
                return [Finished(job.key, sentence, kept=False) for job in chunk.jobs]
            if isinstance(error, ImportError):
                raise InputError(f"A worker does not have this program ({error}): install it everywhere.")
            raise InputError(f"A worker of Dask failed ({type(error).__name__}: {error}).")
        raise InputError("The scheduler of Dask went away: start it and the study again; nothing is lost.")
