# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which library is loaded, on pretended systems too."""

from __future__ import annotations

import hashlib
import platform
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from solver_cases import PRESSURE, film, needs_native, panel

from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.native import library, load

BUILT = load._FOLDER / "libfilm_solver.so"


@pytest.fixture(autouse=True)
def _load_anew(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    monkeypatch.setattr(load, "_FOLDER", tmp_path / "lib")
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "data"))
    load._load.cache_clear()
    backend.available.cache_clear()
    yield
    load._load.cache_clear()
    backend.available.cache_clear()


def pretend(monkeypatch: pytest.MonkeyPatch, system: str, machine: str) -> None:
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(platform, "machine", lambda: machine)


def put(folder: Path, name: str, content: bytes = b"") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    if content:
        (folder / name).write_bytes(content)
    else:
        shutil.copy(BUILT, folder / name)
    digest = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    library.sum_file(folder / name).write_text(f"{digest}  {name}\n", encoding="ascii")
    return folder / name


@pytest.mark.parametrize(
    ("system", "machine", "place"),
    [
        ("linux", "x86_64", "linux-x86_64/libfilm_solver.so"),
        ("linux", "aarch64", "linux-aarch64/libfilm_solver.so"),
        ("win32", "AMD64", "windows-x86_64/film_solver.dll"),
        ("darwin", "x86_64", "macos-x86_64/libfilm_solver.dylib"),
        ("darwin", "arm64", "macos-aarch64/libfilm_solver.dylib"),
    ],
)
def test_each_platform_has_its_own(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, system: str, machine: str, place: str
) -> None:
    every = ("linux-x86_64", "linux-aarch64", "windows-x86_64", "macos-x86_64", "macos-aarch64")
    for folder in every:
        for name in ("libfilm_solver.so", "film_solver.dll", "libfilm_solver.dylib"):
            put(tmp_path / "lib" / folder, name, b"x")
    pretend(monkeypatch, system, machine)
    assert [
        path.relative_to(tmp_path / "lib").as_posix() for path in library.candidates(tmp_path / "lib")
    ] == [place]


@needs_native
def test_one_that_does_not_load_gives_way_to_the_next(tmp_path: Path) -> None:
    put(tmp_path / "lib", "libfilm_solver.so", b"not for this machine")
    assert "cannot be loaded" in str(load.problem_with_library())
    put(tmp_path / "lib" / library.platform_name(), "libfilm_solver.so")
    load._load.cache_clear()
    assert load.problem_with_library() is None


@needs_native
def test_the_package_serves_where_the_workbench_has_none(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    put(tmp_path / "site" / library.PACKAGE, "libfilm_solver.so")
    assert load.problem_with_library() == "libfilm_solver.so has not been built."
    monkeypatch.syspath_prepend(str(tmp_path / "site"))
    load._load.cache_clear()
    assert load.problem_with_library() is None


@needs_native
def test_on_windows_the_workbench_can_be_deleted_while_it_is_used(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    put(tmp_path / "lib" / "windows-x86_64", "film_solver.dll")
    with monkeypatch.context() as there:
        pretend(there, "win32", "AMD64")
        assert load.problem_with_library() is None
    (copy,) = (tmp_path / "data").rglob("film_solver.dll")
    used = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines() if ".dll" in line}
    assert used == {str(copy)}
    shutil.rmtree(tmp_path / "lib")
    assert inflate(panel("disc", 100), film(100), PRESSURE).report.backend == "native"


def test_the_copy_is_made_once_and_replaced_by_another_release(tmp_path: Path) -> None:
    data = tmp_path / "data"
    first = library.copied(put(tmp_path / "lib", "film_solver.dll", b"first"), data)
    made = first.stat().st_mtime_ns
    assert library.copied(tmp_path / "lib" / "film_solver.dll", data) == first
    assert first.stat().st_mtime_ns == made
    first.write_bytes(b"damaged")
    assert library.copied(tmp_path / "lib" / "film_solver.dll", data).read_bytes() == b"first"
    second = library.copied(put(tmp_path / "lib", "film_solver.dll", b"second"), data)
    assert [path for path in data.rglob("*") if path.is_file()] == [second]


def test_where_no_copy_can_be_made_the_library_itself_is_used(tmp_path: Path) -> None:
    (tmp_path / "data").write_text("no folder")
    path = put(tmp_path / "lib", "film_solver.dll", b"first")
    assert library.copied(path, tmp_path / "data" / "native") == path
