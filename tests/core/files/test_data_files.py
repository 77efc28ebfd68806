# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever lies among the data files, ours or the user's: its own error, and the rest goes on."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.advice import rules
from BalloonWorkbench.core.assembly_sheet import steps
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film import filling, library, start_values
from BalloonWorkbench.core.machines import machine
from BalloonWorkbench.core.making import trade_figures
from BalloonWorkbench.core.nesting.remnant import read_remnants
from BalloonWorkbench.core.pattern.intake import kinds

ROOT = Path(__file__).parents[3]
RESOURCES = ROOT / "resources"


def put(content: bytes) -> Callable[[Path], object]:
    return lambda path: path.write_bytes(content)


#: What may lie at the place of a file.
ODD: dict[str, Callable[[Path], object]] = {
    "broken": put(b"{"),
    "empty": put(b""),
    "not utf-8": put(b"\xff\xfe{}"),
    "list": put(b"[]"),
    "number": put(b"1"),
    "text": put(b'"text"'),
    "null": put(b"null"),
    "deep": put(b"[" * 200_000),
    "deep object": put(b'{"a":' * 100_000),
    "long number": put(b"1" * 100_000),
    "dangling link": lambda path: path.symlink_to("nowhere"),
    "link to itself": lambda path: path.symlink_to(path.name),
    "folder": lambda path: path.mkdir(),
    "pipe": os.mkfifo,
    "endless": lambda path: path.symlink_to("/dev/zero"),
}
#: What may stand in the place of a value.
VALUES: list[Any] = [None, True, "", "text", [], {}, -1, 0, 10**400, float("nan"), [[]], {"a": 1}]
TEXTS = ["1e400", "-1e400", "Infinity", "NaN", "1" * 5000]


def single(module: Any, name: str, read: Callable[[], object]) -> Callable[[Path], None]:
    """A reader of a file of which there is one."""

    def at(path: Path) -> None:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(module, name, path)
            read()

    return at


READERS: dict[str, tuple[Path, Callable[[Path], object]]] = {
    "machine": (RESOURCES / "machines" / "hpgl-plotter.json", machine.read_machine),
    "film": (RESOURCES / "films" / "mylar.json", library.read_film),
    "intake": (RESOURCES / "intakes" / "film-valve.json", kinds.read_kind),
    "remnant": (ROOT / "tests" / "resources" / "remnant.json", read_remnants),
    "making": (
        RESOURCES / "making.json",
        single(trade_figures, "FILE", trade_figures.making.__wrapped__),
    ),
    "gases": (RESOURCES / "gases.json", single(filling, "FILE", filling._library.__wrapped__)),
    "steps": (steps.FILE, single(steps, "FILE", partial(steps._entries.__wrapped__, "steps"))),
    "pictures": (steps.FILE, single(steps, "FILE", partial(steps._entries.__wrapped__, "pictures"))),
    "layers": (start_values.FILE, single(start_values, "FILE", start_values.separating_layers.__wrapped__)),
    "rules": (rules.FILE, single(rules, "FILE", rules.rules.__wrapped__)),
}


#: What Python says to programmers.
PYTHON = re.compile(
    r"could not convert|invalid literal|unhashable|indices|NoneType|subscript|attribute|object is not|"
    r"char \d|argument|codec|unpack|must be real|update sequence|not supported|inhomogeneous|operand|"
    r"not a valid"
)


def tried(path: Path, read: Callable[[Path], object]) -> None:
    """Read a file: an InputError of one line that names it, or nothing."""
    try:
        read(path)
    except InputError as error:
        assert path.name in str(error)
        assert "\n" not in str(error)
        assert "Install it anew" in str(error) or not PYTHON.search(str(error))


@pytest.mark.parametrize("kind", READERS)
def test_what_is_no_such_file_is_told(kind: str, tmp_path: Path) -> None:
    origin, read = READERS[kind]
    for name, make in ODD.items():
        path = tmp_path / name / origin.name
        path.parent.mkdir()
        make(path)
        with pytest.raises(InputError):
            read(path)
        tried(path, read)


def places(data: Any) -> Iterator[tuple[Any, Any]]:
    """Every value of a file, as what holds it and its key."""
    for key in data if isinstance(data, dict) else range(len(data)):
        yield data, key
        if isinstance(data[key], (dict, list)):
            yield from places(data[key])


@pytest.mark.parametrize("kind", READERS)
def test_any_value_may_be_wrong(kind: str, tmp_path: Path) -> None:
    """Each value of a good file is exchanged, left out, or a number that is none."""
    origin, read = READERS[kind]
    path = tmp_path / origin.name
    data = json.loads(origin.read_text(encoding="utf-8"))
    for number, (holder, key) in enumerate(list(places(data))):
        value = holder[key]
        for other in [VALUES[(number + step) % len(VALUES)] for step in range(4)]:
            holder[key] = other
            path.write_text(json.dumps(data), encoding="utf-8")
            tried(path, read)
        holder[key] = "@"
        text = json.dumps(data).replace('"@"', TEXTS[number % len(TEXTS)])
        path.write_text(text, encoding="utf-8")
        tried(path, read)
        if type(value) in (int, float):
            with pytest.raises(InputError):
                read(path)
        holder[key] = value


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's machines: one that is good, and everything else."""
    folder = tmp_path / "own"
    folder.mkdir()
    good = json.loads((machine.FOLDER / "hpgl-plotter.json").read_text(encoding="utf-8"))
    (folder / "mine.json").write_text(json.dumps({**good, "name": "mine"}), encoding="utf-8")
    for name, make in ODD.items():
        make(folder / f"{name}.json")
    (folder / "any-dxf.json").write_text("{", encoding="utf-8")
    (folder / "lightburn.json").write_text("{", encoding="utf-8")
    monkeypatch.setenv("BALLOON_MACHINES", str(folder))
    return folder


@pytest.mark.usefixtures("own")
def test_one_bad_file_disables_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        command_line.main(["design", "--help"])
    assert ended.value.code == 0
    printed = capsys.readouterr()
    assert "mine" in printed.out
    assert printed.err.count("is left out") == len(ODD) + 2
    box = tmp_path / "box.json"
    box.write_text('{"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}')
    command = ["inflate", str(box), "--mesh-size", "33mm", "--out", str(tmp_path / "out"), "--machine"]
    assert command_line.main([*command, "mine"]) == 0
    assert (tmp_path / "out" / "pattern-mine.plt").is_file()
    assert command_line.main([*command, "lightburn"]) == 2  # not ours in its place
    assert "lightburn.json is of no use" in capsys.readouterr().err.splitlines()[-1]
    assert machine.machines()["lightburn"].title


@pytest.mark.parametrize("home", ["/nowhere", "/dev/null", "", None, "file"])
def test_any_home(home: str | None, tmp_path: Path) -> None:
    """No such folder, a device, an empty name, none at all; a user whom the system does not know."""
    (tmp_path / "file").touch()
    environment = {
        name: value for name, value in os.environ.items() if name not in ("HOME", "BALLOON_MACHINES")
    }
    if home is not None:
        environment["HOME"] = str(tmp_path / "file") if home == "file" else home
    program = (
        "import pathlib, sys\n"
        "def unknown(*_): raise RuntimeError('Could not determine home directory.')\n"
        "if sys.argv[1]: pathlib.Path.home = unknown\n"
        "from BalloonWorkbench.cli import main\nmain(['design', '--help'])"
    )
    ended = subprocess.run(
        [sys.executable, "-c", program, "x" if home is None else ""],
        cwd=ROOT, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert "lightburn" in ended.stdout
