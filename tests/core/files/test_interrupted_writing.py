# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing a set of files is interrupted at each step that changes a disk: the former set is there, or the
new one.

BALLOON_KILLS sets how many are tried besides kills in the usual case (`make fuzz`: all).
"""

from __future__ import annotations

import os
import shutil
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.files import swap, system
from BalloonWorkbench.core.files.write import check_folder, write_files

COUNT = int(os.environ.get("BALLOON_KILLS", "30"))
OLD = {"one": b"old 1", "two": b"old 2" * 9, "three": b"old 3"}
NEW = {"one": b"new 1" * 5000, "two": b"new 2", "three": b"new 3", "four": b"new 4"}
NEVER = 1 << 30

_CHANGES = {"os.rename", "os.remove", "os.mkdir", "os.rmdir", "os.link", "os.symlink", "os.chmod", "os.chown"}
_CHANGES |= {"os.truncate", "ctypes.dlsym"}


def _changes_disk(event: str, arguments: Sequence[Any]) -> bool:
    if event == "open":
        return bool(int(arguments[2] or 0) & (os.O_WRONLY | os.O_RDWR | os.O_CREAT))
    return event in _CHANGES


def kill() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def terminate() -> None:
    os.kill(os.getpid(), signal.SIGTERM)


def interrupt() -> None:
    os.kill(os.getpid(), signal.SIGINT)


def no_memory() -> None:
    raise MemoryError


def no_space() -> None:
    raise OSError(28, "No space left on device")


FAULTS: tuple[Callable[[], None], ...] = (kill, terminate, interrupt, no_memory, no_space)


def attempted(place: Path, fault: Callable[[], None], at: int) -> int:
    """Write the new set in a process of its own, with a fault at its nth change of the disk; how it ended.

    Without a fault: how many changes there were, as a negative number.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child:
        os.close(writing)
        told = os.read(reading, 100)
        os.close(reading)
        _, status = os.waitpid(child, 0)
        return -int(told) if told else os.waitstatus_to_exitcode(status)
    steps, ended = 0, 3

    def hook(event: str, arguments: Sequence[Any]) -> None:
        nonlocal steps
        if _changes_disk(event, arguments):
            steps += 1
            if steps == at:
                fault()

    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        sys.addaudithook(hook)
        write_files(place, NEW)
        if at == NEVER:
            os.write(writing, str(steps).encode())
        ended = 0
    except BaseException as error:
        error.args = ()
        ended = 1
        raise
    finally:
        os._exit(ended)


def seen(place: Path) -> dict[str, bytes]:
    return {name: (place / name).read_bytes() for name in NEW if (place / name).is_file()}


def hidden(base: Path) -> list[Path]:
    return [path for path in base.rglob("*") if path.name.startswith(".")]


def new_folder(base: Path) -> dict[str, bytes]:
    return {}


def used_folder(base: Path) -> dict[str, bytes]:
    """A former set, one file of it private, one a link to another folder; a file of the user's."""
    place = base / "out"
    place.mkdir()
    (base / "elsewhere").mkdir()
    for name, content in OLD.items():
        (place / name).write_bytes(content)
    (place / "two").chmod(0o640)
    os.replace(place / "three", base / "elsewhere" / "three.dat")
    (place / "three").symlink_to(Path("..", "elsewhere", "three.dat"))
    (place / "notes").write_bytes(b"mine")
    return OLD


def folder_in_folder(base: Path) -> dict[str, bytes]:
    former = used_folder(base)
    (base / "out" / "more").mkdir()
    (base / "out" / "more" / "mine").write_bytes(b"mine")
    return former


CASES = {
    "new folder": (new_folder, "", ""),
    "used folder": (used_folder, "", ""),
    "folder in the folder": (folder_in_folder, "", "promise"),
    "no exchange": (used_folder, "no exchange", "promise"),
    "no links": (used_folder, "no links", "promise"),
}


def interruptions(base: Path, patch: pytest.MonkeyPatch) -> Iterator[tuple[str, Callable[[], None], int]]:
    every = []
    for name in CASES:
        with Prepared(base / f"count {name}", name, patch) as (place, _):
            steps = -attempted(place, no_space, NEVER)
        assert steps > 10
        every += [(name, fault, at) for fault in FAULTS for at in range(1, steps + 1)]
    usual = [each for each in every if each[:2] == ("used folder", kill)]
    yield from usual
    others = [each for each in every if each not in usual]
    stride = max(1.0, len(others) / COUNT)
    yield from (others[int(number * stride)] for number in range(min(COUNT, len(others))))


class Prepared:
    """A folder to write into, and what was there, on a disk that has its limits."""

    def __init__(self, base: Path, name: str, patch: pytest.MonkeyPatch) -> None:
        self.base, (self.make, self.limit, _) = base, CASES[name]
        self.patch = patch.context()

    def __enter__(self) -> tuple[Path, dict[str, bytes]]:
        self.base.mkdir()
        former = self.make(self.base)
        patch = self.patch.__enter__()
        if self.limit == "no exchange":
            patch.setattr(swap, "exchange", lambda *_: False)
        if self.limit == "no links":
            patch.setattr(os, "link", self._refuse)
        patch.setattr(os, "fsync", lambda _: None)  # only a power failure would tell
        return self.base / "out", former

    def _refuse(self, *_args: object, **_names: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    def __exit__(self, *error: object) -> None:
        self.patch.__exit__(*error)
        shutil.rmtree(self.base)


@pytest.mark.slow
def test_the_former_set_or_the_new_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """At once where two folders can be exchanged, and after any failure; else as soon as we look again."""
    for number, (name, fault, at) in enumerate(interruptions(tmp_path, monkeypatch)):
        where = f"{name}, {fault.__name__} at {at}"
        base = tmp_path / str(number)
        with Prepared(base, name, monkeypatch) as (place, former):
            ended = attempted(place, fault, at)
            assert ended == -signal.SIGKILL or fault is not kill, where
            if fault is not kill:
                assert seen(place) in (former, NEW), where
                assert ended != 0 or seen(place) == NEW, where
            elif CASES[name][2] != "promise":
                assert seen(place) in (former, NEW), where
            check_folder(place)
            assert seen(place) in (former, NEW), where
            assert not hidden(base), where
            if former:
                assert (place / "notes").read_bytes() == b"mine", where
                assert (place / "two").stat().st_mode & 0o777 == 0o640, where
                assert (place / "three").is_symlink(), where
                assert not (base / "elsewhere" / "three.dat").is_symlink(), where
            if name == "folder in the folder":
                assert (place / "more" / "mine").read_bytes() == b"mine", where


@pytest.mark.slow
def test_a_failure_leaves_nothing_hidden(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What cannot be removed at that very moment is for the next run: that is rare."""
    with Prepared(tmp_path / "count", "used folder", monkeypatch) as (place, _):
        steps = -attempted(place, no_space, NEVER)
    left = 0
    for at in range(1, steps + 1):
        base = tmp_path / str(at)
        with Prepared(base, "used folder", monkeypatch) as (place, _):
            attempted(place, no_space, at)
            left += bool(hidden(base))
    assert left < 0.4 * steps


def test_two_runs_at_once(tmp_path: Path) -> None:
    """They take turns: each ends well, and the last set is whole."""
    sets = [{name: letter * 2000 + name.encode() for name in NEW} for letter in (b"a", b"b")]
    children = []
    for contents in sets:
        child = os.fork()
        if not child:
            try:
                for _ in range(10):
                    write_files(tmp_path / "out", contents)
                os._exit(0)
            finally:
                os._exit(1)
        children.append(child)
    assert [os.waitpid(child, 0)[1] for child in children] == [0, 0]
    assert seen(tmp_path / "out") in sets
    assert not hidden(tmp_path)


@pytest.mark.skipif(sys.platform != "linux", reason="renameat2 is Linux's")
def test_folders_are_exchanged_here(tmp_path: Path) -> None:
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / name).touch()
    assert system.exchange(tmp_path / "one", tmp_path / "other")
    assert os.listdir(tmp_path / "one") == ["other"]
    assert not system.exchange(tmp_path / "one", tmp_path / "missing")
