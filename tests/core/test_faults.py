# SPDX-License-Identifier: LGPL-2.1-or-later
"""What nobody foresaw becomes one sentence, and a file with the details."""

from __future__ import annotations

import platform
import re
import tempfile
from pathlib import Path

import pytest

from BalloonWorkbench import __version__
from BalloonWorkbench.core import faults
from BalloonWorkbench.core.errors import BalloonError, InputError, ProgramFault
from BalloonWorkbench.core.faults import as_balloon_error, report_fault


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(tmp_path / "new" / "faults"))
    return tmp_path / "new" / "faults"


def raised(error: BaseException) -> BaseException:
    try:
        raise error
    except type(error) as caught:
        return caught


def at_line(number: int) -> BaseException:
    """An error of a place of its own."""
    try:
        exec(compile("\n" * number + "1 / 0", f"place{number}.py", "exec"))
    except ZeroDivisionError as error:
        return error
    raise AssertionError


def test_the_sentence_names_the_file_and_the_file_tells_all(folder: Path) -> None:
    fault = report_fault(raised(ZeroDivisionError("no such luck")), "inflating")
    assert isinstance(fault, BalloonError)
    assert fault.file is not None
    assert fault.file.parent == folder
    assert str(fault).startswith("This is a fault of the program, not yours.")
    assert f"'{fault.file}'" in str(fault)
    assert "\n" not in str(fault)
    told = fault.file.read_text(encoding="utf-8")
    for part in ("inflating", "no such luck", "in raised", __version__, platform.python_version(), "numpy"):
        assert part in told


def test_the_details_do_not_name_the_user(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", "/home/jane.doe")
    fault = report_fault(raised(OSError("/home/jane.doe/plans/secret.png is gone")), "reading")
    assert fault.file is not None
    told = fault.file.read_text(encoding="utf-8")
    assert "jane.doe" not in told
    assert "~/plans/secret.png" in told


def test_the_same_fault_has_one_file_and_there_are_never_many(folder: Path) -> None:
    files = {report_fault(at_line(1), "inflating").file for _ in range(5)}
    assert len(files) == 1
    for number in range(30):
        report_fault(at_line(number), "inflating")
    assert len(list(folder.iterdir())) == faults._KEPT


def test_a_folder_of_no_use_is_left_for_another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(tmp_path / "file" / "faults"))
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    fault = report_fault(raised(KeyError("x")), "inflating")
    assert fault.file is not None
    assert fault.file.is_relative_to(tmp_path / "film-balloon-faults")
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "file"))
    fault = report_fault(raised(KeyError("x")), "inflating")
    assert fault.file is None
    assert re.search(r"cannot be written.*KeyError, inflating", str(fault))


def test_too_little_memory_is_no_riddle(folder: Path) -> None:
    fault = report_fault(raised(MemoryError()), "inflating")
    assert "coarser mesh" in str(fault)
    assert str(fault.file) in str(fault)
    assert "fault of the program" not in str(fault)


def test_what_was_foreseen_stays_what_it_is(folder: Path) -> None:
    mistake = InputError("Give a width.")
    assert as_balloon_error(mistake, "reading") is mistake
    fault = report_fault(raised(SystemExit(3)), "reading")
    assert report_fault(fault, "again") is fault
    assert isinstance(as_balloon_error(raised(RecursionError()), "reading"), ProgramFault)
    assert len(list(folder.iterdir())) == 2


def test_a_message_that_cannot_be_printed_does_no_harm(folder: Path) -> None:
    class Mute(Exception):
        def __str__(self) -> str:
            raise ValueError

    assert isinstance(report_fault(raised(Mute()), "reading"), ProgramFault)
    assert isinstance(report_fault(raised(ValueError("\udcff")), "reading"), ProgramFault)
