# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies on Dask: its workers as threads of this process, and jobs that work nothing out."""

from __future__ import annotations

import json
import sys
import types
from pathlib import Path
from typing import Any

import pytest

distributed = pytest.importorskip("distributed")

from BalloonWorkbench.core.errors import InputError, MissingPackageError  # noqa: E402
from BalloonWorkbench.core.studies.folder import StudyFolder  # noqa: E402
from BalloonWorkbench.core.studies.job import Finished, Job  # noqa: E402
from BalloonWorkbench.core.studies.runners import dask_chunks, dask_runner  # noqa: E402
from BalloonWorkbench.core.studies.runners.dask_runner import DaskRunner  # noqa: E402

THREADS = {"processes": False, "n_workers": 2}


class Beside:
    """In the place of the process beside a worker."""

    started: list[Path] = []  # noqa: RUF012 - for all of them

    def __init__(self, place: Path, timeout: float) -> None:
        self._folder = StudyFolder(place)
        self.started.append(place)

    def work(self, job: Job) -> Finished:
        if job.request["number"] == 3:
            return Finished(job.key, "It cannot be.", kept=False)
        self._folder.keep(job.key, {"report.json": json.dumps(dict(job.request)).encode()})
        return Finished(job.key)


JOBS = [Job(f"{number:064x}", {"number": number}) for number in range(60)]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> StudyFolder:
    monkeypatch.setattr(dask_chunks, "WorkerProcess", Beside)
    Beside.started.clear()
    return StudyFolder(tmp_path / "out")


def run(folder: StudyFolder, **settings: Any) -> list[Finished]:
    with folder.in_use():
        return [*DaskRunner(settings=THREADS, **settings).run(iter(JOBS), folder.place)]


def test_each_job_once(folder: StudyFolder) -> None:
    folder_before = [job.key for job in JOBS if folder.has(job.key)]
    ended = run(folder)
    assert not folder_before
    assert sorted(finished.key for finished in ended) == [job.key for job in JOBS]
    assert [finished.key for finished in ended if finished.sentence] == [JOBS[3].key]
    assert all(folder.has(job.key) for job in JOBS if job is not JOBS[3])
    assert len(Beside.started) <= 2  # each thread keeps its process


deaths = {"left": 0}  # here, because a function takes along what it needs when it goes to a worker


def killed(chunk: dask_chunks.Chunk) -> Any:
    """Work on chunks, which kills the worker so many times first."""
    if JOBS[7] in chunk.jobs and deaths["left"] > 0:
        deaths["left"] -= 1
        raise distributed.KilledWorker("chunk", types.SimpleNamespace(address="tcp://x"), 4)
    return dask_chunks.work_chunk(chunk)


def test_a_chunk_whose_worker_was_killed_is_sent_again(
    folder: StudyFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dask_runner, "work_chunk", killed)
    monkeypatch.setitem(deaths, "left", 3)
    assert [finished.key for finished in run(folder) if finished.sentence] == [JOBS[3].key]
    assert folder.has(JOBS[7].key)


def test_a_chunk_that_kills_every_worker_is_told(
    folder: StudyFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dask_runner, "work_chunk", killed)
    monkeypatch.setitem(deaths, "left", 10_000)
    ended = {finished.key: finished for finished in run(folder)}
    assert len(ended) == len(JOBS)
    assert "killed again and again" in ended[JOBS[7].key].sentence
    assert not ended[JOBS[7].key].kept


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (("program", lambda: "0.0.0 numpy"), "has version 0.0.0 numpy"),
        (("StudyFolder", lambda _place: StudyFolder("/nowhere")), "does not see the folder"),
    ],
)
def test_workers_that_cannot(
    folder: StudyFolder, monkeypatch: pytest.MonkeyPatch, change: tuple[str, Any], sentence: str
) -> None:
    monkeypatch.setattr(dask_chunks, *change)
    with pytest.raises(InputError, match=sentence):
        run(folder)


def test_a_program_that_the_workers_lack(folder: StudyFolder, monkeypatch: pytest.MonkeyPatch) -> None:
    def work(_chunk: object) -> None:
        raise ModuleNotFoundError("No module named 'BalloonWorkbench'")

    monkeypatch.setattr(dask_runner, "work_chunk", work)
    with pytest.raises(InputError, match="install it everywhere"):
        run(folder)


def test_a_scheduler_that_is_not_there(folder: StudyFolder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dask_runner, "_CONNECTING", 0.5)
    for address in ("tcp://127.0.0.1:9", "nonsense", "tcp://nowhere.invalid:8786"):
        with pytest.raises(InputError, match="No worker of Dask can be reached"):
            run(folder, scheduler=address)


def test_a_scheduler_without_workers(folder: StudyFolder) -> None:
    with (
        distributed.LocalCluster(n_workers=0, processes=False, dashboard_address=":0") as cluster,
        pytest.raises(InputError, match="No worker of Dask can be reached"),
    ):
        run(folder, scheduler=cluster.scheduler_address, patience=0.2)


def test_a_scheduler_by_its_address(folder: StudyFolder) -> None:
    with distributed.LocalCluster(
        n_workers=1, processes=False, dashboard_address=":0", protocol="tcp://"
    ) as cluster:
        assert len(run(folder, scheduler=cluster.scheduler_address)) == len(JOBS)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "module", "name"),
    [
        ("slurm", "dask_jobqueue", "SLURMCluster"),
        ("kubernetes", "dask_kubernetes.operator", "KubeCluster"),
    ],
)
def test_clusters_are_made_by_their_own_packages(
    folder: StudyFolder, monkeypatch: pytest.MonkeyPatch, kind: str, module: str, name: str
) -> None:
    asked: list[Any] = []

    def make(**settings: Any) -> Any:
        asked.append(settings)
        cluster = distributed.LocalCluster(n_workers=1, processes=False, dashboard_address=":0")
        cluster.scale = asked.append
        return cluster

    monkeypatch.setitem(sys.modules, module.partition(".")[0], types.ModuleType("package"))
    monkeypatch.setitem(sys.modules, module, types.SimpleNamespace(**{name: make}))
    with folder.in_use():
        runner = DaskRunner(kind=kind, workers=8, settings={"queue": "long"})
        assert len([*runner.run(JOBS, folder.place)]) == len(JOBS)
    assert asked[:2] == [{"queue": "long"}, 8]


def test_the_job_script_that_slurm_gets() -> None:
    """By dask-jobqueue itself, from the settings of docs/studies.md."""
    jobqueue = pytest.importorskip("dask_jobqueue")
    settings = {"queue": "long", "cores": 4, "processes": 4, "memory": "8GB", "walltime": "01:00:00"}
    script = jobqueue.SLURMCluster.job_cls(
        "tcp://10.0.0.1:8786", name="w", config_name="slurm", protocol="tcp://", **settings
    ).job_script()
    assert "#SBATCH -p long" in script
    assert "#SBATCH --cpus-per-task=4" in script
    assert "--nworkers 4" in script


@pytest.mark.parametrize("kind", ["local", "slurm"])
def test_settings_that_a_cluster_does_not_take(folder: StudyFolder, kind: str) -> None:
    with folder.in_use(), pytest.raises(InputError, match="cluster cannot be made"):
        next(DaskRunner(kind=kind, settings={"colour": "red"}).run(JOBS, folder.place))


def test_packages_that_are_missing(folder: StudyFolder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "dask_kubernetes", None)
    for kind, package in (("kubernetes", "dask-kubernetes"), ("local", "distributed")):
        if kind == "local":
            monkeypatch.setitem(sys.modules, "distributed", None)
        with folder.in_use(), pytest.raises(MissingPackageError, match=rf"pip install .*{package}"):
            next(DaskRunner(kind=kind).run(JOBS, folder.place))
