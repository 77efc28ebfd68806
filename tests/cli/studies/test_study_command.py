# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command study, with processes of its own: what it makes is what design and inflate make."""

from __future__ import annotations

import csv
import itertools
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Finished, Job
from BalloonWorkbench.core.studies.runners.subprocesses import Subprocesses

ROOT = Path(__file__).resolve().parents[3]
CUBE = ROOT / "resources" / "examples" / "bags" / "cube.json"
COARSE = "80mm"


def rows_of(out: Path) -> list[dict[str, str]]:
    with (out / "table.csv").open(newline="", encoding="utf-8") as text:
        return [*csv.DictReader(text)]


def written(place: Path, **study: Any) -> Path:
    path = place / "study.json"
    path.write_text(json.dumps(study))
    return path


@pytest.mark.slow
def test_a_study_makes_what_the_command_makes(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """Failures of the simulation and of a row are rows; the number, the report and the files are the same."""
    table = tmp_path / "study.csv"
    table.write_text(
        f"input,command,mesh-size,pressure\n{CUBE},inflate,{COARSE},2kPa\n{CUBE},inflate,{COARSE},-3\n"
        f"nothing.json,inflate,{COARSE},2kPa\n{CUBE},design,{COARSE},2kPa\n"
    )
    out = tmp_path / "out"
    assert command_line.main(["study", str(table), "--out", str(out), "--jobs", "1", "--keep", "files"]) == 0
    assert "Balloons: 3, worked out now: 3, of these failed: 2" in capfd.readouterr().out
    rows = rows_of(out)
    assert [bool(row["failure"]) for row in rows] == [False, True, True, True]
    words = ["pressure must be positive", "nothing.json", "use inflate instead"]
    assert all(word in row["failure"] for word, row in zip(words, rows[1:], strict=True))

    single = tmp_path / "single"
    assert command_line.main(["inflate", str(CUBE), f"--mesh-size={COARSE}", "--out", str(single)]) == 0
    kept = StudyFolder(out).of(rows[0]["key"])
    names = {path.name for path in kept.iterdir()} - {"balloon.FCStd"}  # tests make none in their own process
    assert names == {path.name for path in single.iterdir()}
    for name in ("pattern.dxf", "balloon.stl"):
        assert (kept / name).read_bytes() == (single / name).read_bytes()
    one, other = (json.loads((place / "report.json").read_text()) for place in (kept, single))
    assert one["inflated"] == other["inflated"]
    assert float(rows[0]["volume_m3"]) == pytest.approx(other["inflated"]["volume_m3"], rel=1e-11)


TASK = """
import os, signal, time
from BalloonWorkbench.core.errors import InputError
def make(request):
    what = request["what"]
    if what == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    if what == "hang":
        time.sleep(600)
    if what == "exit":
        os._exit(3)
    if what == "fault":
        1 / 0
    if what == "print":
        os.write(1, b"this is no answer\\n")
    if what == "refuse":
        raise InputError("It makes no sense.")
    return {"report.json": str(os.getpid()).encode()}
"""


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "a_task_of_tests.py").write_text(TASK)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(tmp_path / "faults"))
    (tmp_path / "out").mkdir()
    return tmp_path / "out"


def worked(place: Path, *what: str, timeout: float = 60.0) -> dict[str, Finished]:
    jobs = {f"{number:02d}" * 32: each for number, each in enumerate(what)}
    with StudyFolder(place).in_use():
        runner = Subprocesses(1, timeout)
        ended = runner.run((Job(key, {"what": each}, "a_task_of_tests") for key, each in jobs.items()), place)
        return {jobs[finished.key]: finished for finished in ended}


@pytest.mark.slow
def test_what_ends_a_process_ends_one_job(place: Path) -> None:
    ended = worked(place, "print", "crash", "exit", "fault", "refuse", "fine", "hang", "last", timeout=8.0)
    sentences = {what: finished.sentence for what, finished in ended.items()}
    assert {what for what, sentence in sentences.items() if not sentence} == {"print", "fine", "last"}
    assert "SIGSEGV" in sentences["crash"]
    assert "ended with 3" in sentences["exit"]
    assert "fault of the program" in sentences["fault"]
    assert "longer than 8 s" in sentences["hang"]
    assert [what for what, finished in ended.items() if finished.kept and finished.sentence] == ["refuse"]
    folder = StudyFolder(place)
    assert folder.failure(ended["refuse"].key) == "It makes no sense."
    # a process does one job after the other: those between two deaths have the same one
    pids = {
        what: (folder.of(ended[what].key) / "report.json").read_text() for what in ("print", "fine", "last")
    }
    assert len({*pids.values()}) == 3


def test_a_folder_that_cannot_be_written_to_ends_the_study(place: Path) -> None:
    (place / "balloons").write_text("in the way")
    (ended,) = worked(place, "fine").values()
    assert ended.ends
    assert "Cannot write" in ended.sentence


def test_ctrl_c_keeps_what_was_made(tmp_path: Path) -> None:
    """Told by one line; the processes beside it are gone."""
    study = written(tmp_path, vary={"input": str(CUBE), "command": ["inflate"], "pressure": [2000, 2100]})
    command = [sys.executable, "-m", "BalloonWorkbench", "study", str(study), "--out", str(tmp_path / "out")]
    heard = "signal.signal(signal.SIGINT, signal.default_int_handler)"
    start = f"import signal, runpy, sys; {heard}; sys.argv = {command[2:]!r}; runpy.run_module(sys.argv[0], "
    start += "run_name='__main__')"
    running = subprocess.Popen(
        [sys.executable, "-c", start], cwd=ROOT, stderr=subprocess.PIPE, start_new_session=True
    )
    until = time.monotonic() + 300.0
    while not (beside := children(running.pid)) and time.monotonic() < until:
        time.sleep(0.05)
    os.killpg(running.pid, signal.SIGINT)
    errors = running.communicate()[1].decode()
    assert running.returncode == 130
    assert errors == "balloon: stopped; the balloons that were made stay, and the same command goes on.\n"
    assert not [*filter(alive, beside)]


@pytest.mark.slow
def test_no_process_is_left_when_a_study_is_killed(tmp_path: Path) -> None:
    """It goes on afterwards; each balloon is in the table."""
    study = written(
        tmp_path,
        fixed={"input": str(CUBE), "command": "inflate", "mesh-size": COARSE},
        vary={"pressure": {"linspace": [1000, 3000, 3]}},
    )
    out = tmp_path / "out"
    command = [sys.executable, "-m", "BalloonWorkbench", "study", str(study), "--out", str(out), "--jobs=2"]
    running = subprocess.Popen(command, cwd=ROOT)
    until = time.monotonic() + 300.0
    while len(beside := children(running.pid)) < 2 and time.monotonic() < until:
        time.sleep(0.01)
    running.send_signal(signal.SIGKILL)
    running.wait()
    while any(map(alive, beside)) and time.monotonic() < until:
        time.sleep(0.05)
    assert not [*filter(alive, beside)]
    assert subprocess.run(command, cwd=ROOT, check=False).returncode == 0
    assert [row["failure"] for row in rows_of(out)] == ["", "", ""]


def children(pid: int) -> list[int]:
    """Also those that its threads started."""
    listed = [path.read_text().split() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    return [int(each) for each in itertools.chain(*listed)]


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return "Z" not in Path(f"/proc/{pid}/stat").read_text().split()[2]


@pytest.mark.parametrize("share", ["0/3", "4/3", "3", "a/b", "1/0"])
def test_a_shard_that_is_none(share: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert command_line.main(["study", "s.csv", "--out", str(tmp_path), "--shard", share]) == 2
    assert "--shard" in capfd.readouterr().err


def test_rows_that_make_no_sense_are_told_with_the_result(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    study = tmp_path / "s.csv"
    study.write_text("input,width\nmissing.svg,1m\n,1m\n")
    assert command_line.main(["study", str(study), "--out", str(tmp_path / "out")]) == 0
    told = capfd.readouterr().out
    assert "Rows: 2, of these make no sense: 2" in told
    assert "Row 1: " in told
    assert "missing.svg" in told
    assert "Row 2: The row has no input" in told


def test_a_dry_run_leaves_nothing(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    study = written(tmp_path, vary={"input": str(CUBE), "width": ["1m", "x"]})
    assert command_line.main(["study", str(study), "--out", str(tmp_path / "out"), "--dry-run"]) == 0
    assert "Rows: 2, of these make no sense: 1" in capfd.readouterr().out
    assert not (tmp_path / "out").exists()
