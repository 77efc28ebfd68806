# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of the machine a study uses, what kills cost it, and that nothing changes its table."""

from __future__ import annotations

import hashlib
import json
import math
import os
import random
import resource
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli.studies import row
from BalloonWorkbench.core.memoize import forget
from BalloonWorkbench.core.studies.page import PAGE
from BalloonWorkbench.core.studies.plan import distinct
from BalloonWorkbench.core.studies.read_study import read_study
from BalloonWorkbench.core.studies.run import run_study
from BalloonWorkbench.core.studies.runners.dask_runner import DaskRunner
from BalloonWorkbench.core.studies.runners.subprocesses import Subprocesses, processors
from BalloonWorkbench.core.studies.study import Study

ROOT = Path(__file__).resolve().parents[2]
_SETTINGS = 10  # of each drawing
_KILLS = 5
_EVERY = 20.0  # s, a worker is killed


def measure(place: Path, balloons: int) -> dict[str, Any]:
    """Run a study in several ways; what that took, in parts of the work itself. place: an empty folder."""
    path = _study(place, max(1, balloons // _SETTINGS))
    study = read_study(path)
    work = _work(study)
    plain = _timed(lambda: run_study(study, place / "plain", Subprocesses()))
    table = (place / "plain" / "table.csv").read_bytes()
    starts = _killed(path, place / "killed", balloons)
    dask = _timed(lambda: run_study(study, place / "dask", DaskRunner()))
    with _killing() as kills:
        struck = _timed(lambda: run_study(study, place / "struck", DaskRunner()))
    return {
        "balloons": balloons,
        "processors": processors(),
        "work_s": work,
        "share_of_processor_time": work / plain["processor_s"],
        "share_of_ideal_throughput": work / processors() / plain["seconds"],
        "starts_after_kills": starts,
        "same_bytes_after_kills": _sum(place / "killed") == _sum(place / "plain"),
        "same_table_on_dask": (place / "dask" / "table.csv").read_bytes() == table,
        "dask_share_of_ideal_throughput": work / processors() / dask["seconds"],
        "workers_killed": kills,
        "same_table_after_kills_of_workers": (place / "struck" / "table.csv").read_bytes() == table,
        "cost_of_killed_workers": struck["seconds"] / dask["seconds"] - 1.0,
    }


def _study(place: Path, drawings: int) -> Path:
    """Stars of different points in ten settings each."""
    chance = random.Random(1)
    for number in range(drawings):
        points = 2 * (3 + number % 7)
        outer = []
        for k in range(points):
            radius = 100.0 * (1.0 if k % 2 else chance.uniform(0.6, 0.9))
            angle = 2.0 * math.pi * k / points
            outer.append([radius * math.cos(angle), radius * math.sin(angle)])
        (place / f"star-{number:04d}.json").write_text(json.dumps({"unit": "mm", "outer": outer}))
    path = place / "study.json"
    vary = {
        "input": {"glob": "star-*.json"},
        "width": ["200mm", "300mm"],
        "pressure": {"linspace": ["1kPa", "3kPa", _SETTINGS // 2]},
    }
    path.write_text(json.dumps({"fixed": {"command": "inflate", "mesh-size": "10mm"}, "vary": vary}))
    return path


def _work(study: Study) -> float:
    """Processor time of the balloons alone [s], each worked out from nothing in this process."""
    jobs = [*distinct(study)]
    row.make(jobs[0].request)  # what is imported is paid for
    begun = time.process_time()
    for job in jobs:
        forget()
        row.make(job.request)
    return time.process_time() - begun


def _timed(act: Callable[[], Any]) -> dict[str, float]:
    """Seconds, and processor time of this process and all those that it started and that ended."""
    begun, used = time.monotonic(), _used()
    act()
    return {"seconds": time.monotonic() - begun, "processor_s": _used() - used}


def _used() -> float:
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(each.ru_utime + each.ru_stime for each in both)


def _killed(path: Path, out: Path, balloons: int) -> int:
    """How often a study was started until it was whole, five times of them killed."""
    command = [sys.executable, "-m", "BalloonWorkbench", "study", str(path), "--out", str(out)]
    for number in range(1, _KILLS + 1):
        running = subprocess.Popen(command, cwd=ROOT, start_new_session=True, stdout=subprocess.DEVNULL)
        while running.poll() is None and _made(out) < number * balloons // (_KILLS + 1):
            time.sleep(0.02)
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return _KILLS + 1


def _made(out: Path) -> int:
    """How many balloons are there; folders come and go while they are counted."""
    return sum("report.json" in files for _, _, files in os.walk(out))


@contextmanager
def _killing() -> Iterator[list[int]]:
    """Kill one of the worker processes of this process every 20 s; the list has those that were."""
    kills: list[int] = []
    ended = threading.Event()

    def strike() -> None:
        while not ended.wait(_EVERY):
            if workers := _workers():
                kills.append(random.choice(workers))
                os.kill(kills[-1], signal.SIGKILL)

    thread = threading.Thread(target=strike)
    thread.start()
    try:
        yield kills
    finally:
        ended.set()
        thread.join()


def _workers() -> list[int]:
    """Dask's worker processes: those of multiprocessing that this process started."""
    pids = []
    for task in Path("/proc/self/task").glob("*/children"):
        for pid in map(int, task.read_text().split()):
            if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes():
                pids.append(pid)
    return pids


def _sum(out: Path) -> str:
    """Of all that a study left, but for the marks of its lock, and the page that the command alone writes."""
    digest = hashlib.sha256()
    for path in sorted(out.rglob("*")):
        if path.is_file() and not path.name.startswith(".film-balloon") and path.name != PAGE:
            digest.update(str(path.relative_to(out)).encode() + path.read_bytes())
    return digest.hexdigest()
