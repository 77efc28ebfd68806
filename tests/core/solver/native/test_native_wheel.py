# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver from the network: whatever happens on the way, it comes whole or nothing changes."""

from __future__ import annotations

import errno
import os
import platform
import socket
import sys
import urllib.error
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from solver_cases import PRESSURE, film, needs_native, panel
from wheel_server import FAULTS, NAME, server, wheel_list, wheel_of

from BalloonWorkbench.cli import main
from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import BalloonError, Cancelled, FetchError
from BalloonWorkbench.core.files import swap
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.native import library, load, native_wheel

BUILT = load._FOLDER / library.file_name()
pytestmark = needs_native


@pytest.fixture(autouse=True)
def clone(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Path]:
    """A workbench without a library, and a home of its own; returns the folder of its libraries."""
    folder = tmp_path / "addon" / "lib"
    folder.parent.mkdir()
    (tmp_path / "home").mkdir()
    monkeypatch.setattr(load, "_FOLDER", folder)
    monkeypatch.setattr(library, "FOLDER", folder)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    for name in ("http_proxy", "https_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"):
        monkeypatch.delenv(name, raising=False)
    native_wheel._look_again()
    yield folder
    native_wheel._look_again()


@pytest.fixture(scope="module")
def wheel() -> bytes:
    return wheel_of(BUILT)


@pytest.fixture
def released(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, wheel: bytes) -> Callable[..., None]:
    """Has the source know a wheel at an address."""

    def know(address: str, content: bytes = wheel) -> None:
        path = wheel_list(tmp_path / "native-wheels.json", address, content)
        monkeypatch.setattr(native_wheel, "WHEELS", path)

    know("http://127.0.0.1:9/releases")
    return know


def tree(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def refused(tmp_path: Path, *options: Any) -> str:
    """The one sentence of a fetch that fails and changes nothing."""
    before = tree(tmp_path)
    with pytest.raises(BalloonError) as caught:
        native_wheel.fetch(native_wheel.wheel(), *options)
    assert tree(tmp_path) == before
    assert load.problem_with_library() is not None
    assert backend.active_backend() == "numpy"
    text = str(caught.value)
    assert "\n" not in text
    assert text.endswith(".")
    return text


def test_it_comes_whole_and_is_used_at_once(clone: Path, released: Any, wheel: bytes) -> None:
    assert load.problem_with_library() == f"{library.file_name()} has not been built."
    assert library.is_lacking()
    seen: list[float] = []
    with server(wheel) as address:
        released(address)
        offered = native_wheel.wheel()
        path = native_wheel.fetch(offered, lambda part, text: not seen.append(part))
    assert offered.address == f"{address}/{NAME}"
    assert offered.size == len(wheel)
    assert offered.host == "127.0.0.1"
    assert path.read_bytes() == BUILT.read_bytes()
    assert {each.name for each in clone.rglob("*") if each.is_file()} == {path.name, f"{path.name}.sha256"}
    assert not library.is_lacking()
    assert inflate(panel("disc", 100), film(100), PRESSURE).report.backend == "native"
    assert seen == sorted(seen)
    assert (seen[0], seen[-1]) == (0.0, 1.0)


@pytest.mark.parametrize("fault", FAULTS)
def test_whatever_comes_instead_is_refused(
    fault: str, tmp_path: Path, released: Any, wheel: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(native_wheel, "_PATIENCE", 0.2)
    with server(wheel, fault) as address:
        released(address)
        text = refused(tmp_path)
    assert FAULTS[fault][1] in text
    assert library.SLOWER in text


def _raises(error: Exception) -> Callable[[str], Any]:
    def opener(address: str) -> Any:
        raise error

    return opener


@pytest.mark.parametrize(
    "error",
    [
        urllib.error.URLError(socket.gaierror(-2, "Name or service not known")),
        urllib.error.URLError(OSError(errno.ENETUNREACH, "Network is unreachable")),
        urllib.error.URLError("unknown url type: https"),
        ConnectionResetError(errno.ECONNRESET, "Connection reset by peer"),
        TimeoutError(),
        UnicodeError("label empty or too long"),
        ValueError("unknown url type"),
    ],
)  # fmt: skip
def test_without_a_network(error: Exception, tmp_path: Path, released: Any) -> None:
    text = refused(tmp_path, lambda part, text: True, _raises(error))
    assert text.startswith("The native solver could not be fetched from 127.0.0.1 (")
    assert "()" not in text
    assert "Errno" not in text


def test_nobody_listens(tmp_path: Path, released: Any) -> None:
    assert "(Connection refused)" in refused(tmp_path)


@pytest.mark.parametrize("after", [0.0, 0.01, 1.0])
def test_stopped(after: float, tmp_path: Path, released: Any, wheel: bytes) -> None:
    with server(wheel) as address, pytest.raises(Cancelled):
        released(address)
        native_wheel.fetch(native_wheel.wheel(), lambda part, text: part < after)
    assert tree(tmp_path / "addon") == tree(tmp_path / "home") == set()


def test_stopped_while_nothing_comes(released: Any, wheel: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(native_wheel, "_PATIENCE", 0.2)
    answers = iter([True, True])  # connecting, the first bytes; then the user has pressed Stop
    with server(wheel, "stuck") as address, pytest.raises(Cancelled):
        released(address)
        native_wheel.fetch(native_wheel.wheel(), lambda part, text: next(answers, False))


def test_where_the_addon_cannot_be_written_to_the_home_takes_it(
    clone: Path, tmp_path: Path, released: Any, wheel: bytes
) -> None:
    clone.write_text("in the way of a folder, as nothing else stops root")
    with server(wheel) as address:
        released(address)
        path = native_wheel.fetch(native_wheel.wheel())
    assert path.is_relative_to(tmp_path / "home" / ".film-balloon" / "native")
    assert load.problem_with_library() is None


def test_where_nothing_can_be_written(clone: Path, tmp_path: Path, released: Any) -> None:
    clone.write_text("in the way")
    (tmp_path / "home" / ".film-balloon").write_text("in the way")
    text = refused(tmp_path)
    assert text.startswith("The native solver cannot be saved. Cannot write to ")


def test_a_full_disk(tmp_path: Path, released: Any, wheel: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        def __getattr__(self, name: str) -> Any:
            return self._full if name == "fsync" else getattr(os, name)

        def _full(self, handle: int) -> None:
            raise OSError(errno.ENOSPC, "No space left on device")

    with server(wheel) as address:
        released(address)
        monkeypatch.setattr(swap, "os", Full())
        assert "No space left on device" in refused(tmp_path)


def test_one_that_does_not_load_here_is_not_kept(tmp_path: Path, released: Any) -> None:
    """As on a Linux with another C library."""
    other = tmp_path / library.file_name()
    other.write_bytes(b"\x7fELF for another system" * 500)
    wheel = wheel_of(other)
    with server(wheel) as address:
        released(address, wheel)
        assert "does not run here: " in refused(tmp_path)


def test_a_damaged_release_gives_way_to_what_is_fetched(clone: Path, released: Any, wheel: bytes) -> None:
    beside = clone / library.platform_name() / library.file_name()
    beside.parent.mkdir(parents=True)
    beside.write_bytes(b"damaged")
    assert library.is_lacking()
    with server(wheel) as address:
        released(address)
        native_wheel.fetch(native_wheel.wheel())
    assert load.problem_with_library() is None


def test_what_was_fetched_for_another_version_is_not_used_and_goes(
    clone: Path, released: Any, wheel: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    with server(wheel) as address:
        released(address)
        native_wheel.fetch(native_wheel.wheel())
        (stale,) = clone.iterdir()
        stale.rename(clone / "0.0.9")
        native_wheel._look_again()
        assert library.is_lacking()
        assert load.problem_with_library() is not None
        path = native_wheel.fetch(native_wheel.wheel())
    assert list(clone.iterdir()) == [path.parents[1]]


@pytest.mark.parametrize(
    ("system", "machine", "name"),
    [
        ("linux", "armv7l", "linux-armv7l"),
        ("win32", "ARM64", "windows-aarch64"),
        ("freebsd14", "amd64", "freebsd14-x86_64"),
    ],
)
def test_a_platform_without_one(
    system: str, machine: str, name: str, released: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(platform, "machine", lambda: machine)
    with pytest.raises(FetchError) as caught:
        native_wheel.wheel()
    assert str(caught.value) == f"There is no native solver for {name}. {library.SLOWER}"


def test_another_interface_is_not_offered(released: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(load, "ABI_VERSION", 999)
    with pytest.raises(FetchError, match="for this version yet"):
        native_wheel.wheel()


@pytest.mark.parametrize("address", ["/releases/download", "https://film-balloon.example/releases/download"])
def test_without_an_address_nothing_is_offered(address: str, released: Any) -> None:
    released(address)
    with pytest.raises(FetchError, match="for this version yet"):
        native_wheel.wheel()


@pytest.mark.parametrize("content", [b"", b"{}", b"[]", b'{"wheels": 3}', b"\xff\xfe"])
def test_a_damaged_list(content: bytes, released: Any) -> None:
    native_wheel.WHEELS.write_bytes(content)
    with pytest.raises(FetchError, match="is damaged: install the workbench anew"):
        native_wheel.wheel()


def test_without_ctypes_none_would_help(released: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(packages, "lacks_ctypes", lambda: True)
    with pytest.raises(FetchError, match="no working ctypes"):
        native_wheel.wheel()


def test_on_the_command_line(
    clone: Path, released: Any, wheel: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["fetch-solver"]) == 2
    told = capsys.readouterr()
    assert told.err.count("\n") == 1
    assert "Connection refused" in told.err
    with server(wheel) as address:
        released(address)
        assert native_wheel.slow_notes() == [
            "NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches."
        ]
        assert main(["fetch-solver"]) == 0
    before, after = capsys.readouterr().out.splitlines()
    assert before.startswith(f"Fetching {address}/{NAME} (")
    assert native_wheel.wheel().sha256 in before
    assert str(clone) in before
    assert after == "The native solver is in use now."
    assert main(["fetch-solver"]) == 0
    assert capsys.readouterr().out == "The native solver is here already.\n"
    assert native_wheel.slow_notes() == []
