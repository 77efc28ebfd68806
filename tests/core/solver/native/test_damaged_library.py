# SPDX-License-Identifier: LGPL-2.1-or-later
"""A library that was damaged on its way is not loaded, for that ends the process; NumPy takes its place."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from solver_cases import needs_native

from BalloonWorkbench.core.solver.native import library as loading
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.solver.native.library import file_name, sum_file

ROOT = Path(__file__).parents[4]
BUILT = load._FOLDER / file_name()
PROGRAM = """
import sys
from pathlib import Path
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.native import load
for name in ("FreeCAD", "matplotlib", "ezdxf"):  # no document, picture or DXF
    sys.modules[name] = None
folders = [Path(name) for name in sys.argv.pop(1).split(":")]
for load._FOLDER in folders:
    load._load.cache_clear()
    print(load.problem_with_library())
    if len(sys.argv) == 1:
        print(backend.active_backend())
if len(sys.argv) == 1:
    sys.exit()
from BalloonWorkbench.cli import command_line as cli
sys.exit(cli.main(sys.argv[1:]))
"""

DAMAGE: dict[str, Callable[[bytes], bytes]] = {
    "half": lambda content: content[: len(content) // 2],
    "a page": lambda content: content[:4096],
    "nothing": lambda content: b"",
    "zeros at the end": lambda content: content[: len(content) // 2] + bytes(len(content) // 2),
    "zeros inside": lambda content: content[:8192] + bytes(len(content) - 16384) + content[-8192:],
    "all zeros": lambda content: bytes(len(content)),
    "another byte": lambda content: content[:40000] + bytes([content[40000] ^ 255]) + content[40001:],
}


def library(folder: Path) -> Path:
    for path in (BUILT, sum_file(BUILT)):
        shutil.copy(path, folder)
    return folder / file_name()


def started(folders: list[Path], *words: str) -> subprocess.CompletedProcess[str]:
    """A process with the library of a folder: the command line, or without words what solves in each."""
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, ":".join(map(str, folders)), *words],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    drawing = folder / "box.json"
    drawing.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}))
    return started(
        [folder], "inflate", str(drawing), "--mesh-size", "30mm", "--out", str(folder / "out"), *words
    )


@needs_native
def test_damaged_on_its_way(tmp_path: Path) -> None:
    folders = [tmp_path / case for case in DAMAGE]
    for folder, damaged in zip(folders, DAMAGE.values()):
        folder.mkdir()
        path = library(folder)
        path.write_bytes(damaged(path.read_bytes()))
    ended = started(folders)
    assert ended.returncode == 0, ended.stderr
    lines = ended.stdout.splitlines()
    assert len(lines) == 2 * len(DAMAGE)
    assert all(f"{file_name()} is damaged" in line for line in lines[::2])
    assert set(lines[1::2]) == {"numpy"}


@needs_native
def test_the_command_line_does_without_it(tmp_path: Path) -> None:
    path = library(tmp_path)
    path.write_bytes(DAMAGE["half"](path.read_bytes()))
    ended = run(tmp_path)
    assert ended.returncode == 0, ended.stderr
    told = ended.stdout + ended.stderr
    assert "solver numpy" in told
    assert told.count("Note: The native solver, which is faster, is not available") == 1
    assert f"{file_name()} is damaged" in told
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert report["backend"] == "numpy"


@needs_native
def test_without_its_sum_nobody_knows(tmp_path: Path) -> None:
    path = library(tmp_path)
    sum_file(path).unlink()
    assert "damaged" in started([tmp_path]).stdout
    ended = run(tmp_path, "--solver", "native")
    assert ended.returncode == 2
    assert ended.stderr.count("\n") == 1
    assert "damaged" in ended.stderr


@needs_native
def test_a_whole_one_is_loaded(tmp_path: Path) -> None:
    library(tmp_path)
    ended = run(tmp_path)
    assert ended.stdout.startswith("None\n")
    assert "solver native" in ended.stdout
    assert "Note: The native solver" not in ended.stdout


@needs_native
def test_the_window_tells_it_when_it_starts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(loading, "FOLDER", tmp_path)
    assert loading.damaged() == []
    path = library(tmp_path)
    assert loading.damaged() == []
    path.write_bytes(path.read_bytes()[:4096])
    (sentence,) = loading.damaged()
    assert sentence.startswith("The native solver, which is faster, is not available: ")
    assert "Install the workbench anew" in sentence


@needs_native
def test_the_build_writes_a_sum_that_others_can_check() -> None:
    digest, name = sum_file(BUILT).read_text(encoding="ascii").rstrip("\n").split("  ")
    assert name == file_name()
    assert digest == hashlib.sha256(BUILT.read_bytes()).hexdigest()
