# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line where outputs, folders, names and packages are not as usual: a sentence, no file lost."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import pytest

from BalloonWorkbench.cli import command_line, document, freecad_process, settings
from BalloonWorkbench.core.errors import MissingPackageError

ROOT = Path(__file__).parents[2]
FILES = {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
NOBODY = 65534
as_root = pytest.mark.skipif(os.getuid() != 0, reason="only root can be somebody else")
#: The command line in a process of its own, without FreeCAD, which has its own tests below.
PROGRAM = """
import runpy, sys
for name in {hidden}:
    sys.modules[name] = None
{before}
runpy.run_module("BalloonWorkbench", run_name="__main__")
"""
#: What takes long to load, and what is written without it.
HIDDEN = ("FreeCAD", "matplotlib", "ezdxf")
FEWER = {"pattern.svg", "balloon.stl", "report.json"}


@pytest.fixture
def box(tmp_path: Path) -> Path:
    path = tmp_path / "box.json"
    path.write_text('{"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}')
    return path


def command(box: Path, out: str | bytes = "out") -> list[str | bytes]:
    return ["inflate", str(box), "--mesh-size", "33mm", "--out", out]


def run(box: Path, *words: str | bytes, before: str = "", shell: str = "", hidden=HIDDEN, **environment: str):
    """The program with words, after some Python, with redirections of the shell; in the folder of the box."""
    program = [sys.executable, "-c", PROGRAM.format(before=before, hidden=hidden), *words]
    return subprocess.run(
        ["/bin/sh", "-c", f'exec "$@" {shell}', "sh", *program],
        cwd=box.parent, env={**os.environ, "PYTHONPATH": str(ROOT), **environment}, capture_output=True,
        check=False,
    )  # fmt: skip


def told(ended) -> str:
    """The one line on stderr."""
    text = ended.stderr.decode()
    assert text.count("\n") == 1, text
    assert text.startswith("balloon: ")
    return text


def written(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_output_is_full(box: Path) -> None:
    ended = run(box, *command(box), shell=">/dev/full")
    assert ended.returncode == 74
    assert "No space left" in told(ended)
    assert "out" in told(ended)
    assert written(box.parent / "out") == FEWER


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_help_into_a_full_output(box: Path) -> None:
    ended = run(box, "--help", shell=">/dev/full")
    assert ended.returncode == 74
    assert "No space left" in told(ended)


def test_all_outputs_closed(box: Path) -> None:
    """What a library prints to a closed output must not get into a file of ours."""
    ended = run(box, *command(box), shell="<&- >&- 2>&-")
    assert ended.returncode == 0
    assert written(box.parent / "out") == FEWER
    assert json.loads((box.parent / "out" / "report.json").read_text())["schema"] >= 2


def test_a_reader_that_has_enough(box: Path) -> None:
    ended = run(box, *command(box), shell="| true")
    assert ended.stderr == b""
    assert written(box.parent / "out") == FEWER


@pytest.mark.slow
def test_letters_of_other_systems(box: Path) -> None:
    """Names that are no UTF-8, on a terminal that knows ASCII."""
    name = b"b\xff \xe2\x99\xa5.json"
    os.rename(box, os.path.join(os.fsencode(box.parent), name))
    words = ["inflate", name, "--mesh-size", "33mm", "--assembly", "A4", "--out", b"o\xff"]
    ended = run(box, *words, hidden=HIDDEN[:1], PYTHONIOENCODING="ascii", PYTHONUTF8="1")
    assert (ended.returncode, ended.stderr) == (0, b"")
    assert ended.stdout.isascii()
    found = {os.fsdecode(each) for each in os.listdir(os.fsencode(box.parent) + b"/o\xff")}
    assert found == FILES | {"assembly.pdf"}


def test_without_numpy(box: Path) -> None:
    ended = run(box, *command(box), before="sys.modules['numpy'] = None")
    assert ended.returncode == 2
    assert "pip install numpy" in told(ended)


@contextlib.contextmanager
def nobody() -> Iterator[None]:
    os.seteuid(NOBODY)
    try:
        yield
    finally:
        os.seteuid(0)


def refuse_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def work(*_args: object, **_names: object) -> NoReturn:
        pytest.fail("it was noticed after the work only")

    monkeypatch.setattr(settings, "make_balloon", work)


@pytest.mark.parametrize(
    "out", ["box.json", "box.json/out", "box.json/deep/er", "/proc/out", "loop", "x" * 300]
)
def test_a_folder_of_no_use_is_told_before_the_work(
    out: str, box: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (box.parent / "loop").symlink_to("loop")
    refuse_work(monkeypatch)
    assert command_line.main(command(box, str(box.parent / out))) == 2
    error = capsys.readouterr().err
    assert "Cannot write to" in error
    assert error.count("\n") == 1
    assert written(box.parent) == {"box.json", "loop"}


@as_root
@pytest.mark.skipif(
    not all(folder.stat().st_mode & 0o001 for folder in Path(__file__).resolve().parents),
    reason="nobody else may read this repository",
)
@pytest.mark.parametrize("out", ["", "deep/er"])
def test_a_folder_without_permission(
    out: str, box: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    refuse_work(monkeypatch)
    (box.parent / "locked").mkdir()
    with nobody():
        monkeypatch.setattr(os.path, "realpath", str)  # its parents are private, too
        code = command_line.main(command(box, str(box.parent / "locked" / out)))
    assert code == 2
    assert "Permission denied" in capsys.readouterr().err
    assert written(box.parent / "locked") == set()


@pytest.mark.parametrize("option", ["input", "--artwork", "--artwork-back", "--machine"])
def test_pipes_and_devices_are_not_waited_for(
    option: str, box: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    refuse_work(monkeypatch)
    pipe = box.parent / "pipe.json"
    os.mkfifo(pipe)
    for stream in (str(pipe), "/dev/zero"):
        words = command(box, str(box.parent / "out"))
        if option == "input":
            words[1] = stream
        else:
            words += [option, stream]
            if option == "--artwork-back":
                words += ["--artwork", str(box)]
        assert command_line.main(words) == 2
        assert "is a pipe or a device" in capsys.readouterr().err


def interrupt(number: int) -> str:
    """Python that sends a signal when the balloon is to be made, or when the files are written."""
    act = f"lambda *a, **n: os.kill(os.getpid(), {number})"
    # a shell that runs the tests in the background lets its children ignore these
    heard = "signal.signal(signal.SIGINT, signal.default_int_handler)"
    heard += "; signal.signal(signal.SIGHUP, signal.SIG_DFL)"
    return (
        f"import os, signal; {heard}; from BalloonWorkbench.cli import command_line, settings; WHERE = {act}"
    )


@pytest.mark.parametrize(
    ("number", "where"),
    [(signal.SIGINT, "settings.make_balloon"), (signal.SIGHUP, "settings.make_balloon"),
     (signal.SIGINT, "command_line.summary"), (signal.SIGTERM, "command_line.summary")],
)  # fmt: skip
def test_what_is_said_of_an_interruption_is_true(number: signal.Signals, where: str, box: Path) -> None:
    ended = run(box, *command(box), before=interrupt(number).replace("WHERE", where))
    assert ended.returncode == (130 if number == signal.SIGINT else -number)
    if where == "settings.make_balloon":
        assert "no file was written" in told(ended)
        assert not (box.parent / "out").exists()
    else:
        assert "all files were written before to out" in told(ended)
        assert written(box.parent / "out") == FEWER


@pytest.mark.slow
@as_root
@pytest.mark.parametrize("home", ["/root", None])
def test_a_user_without_a_home(home: str | None) -> None:
    """Packages that look for their settings there neither fail nor complain."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        place.chmod(0o777)
        (place / "box.json").write_text('{"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}')
        change = "import os; os.setgid(65534); os.setgroups([]); os.setuid(65534)"
        if home is None:  # nor does the system know one
            change = change.replace("65534", "54321") + "; del os.environ['HOME']"
        others = {"HOME": home or "", "PYTHONDONTWRITEBYTECODE": "1"}
        if run(place / "box.json", "--version", before=change, **others).returncode:
            pytest.skip("this copy of the project is private")
        ended = run(
            place / "box.json", *command(Path("box.json")), before=change, hidden=HIDDEN[:1], **others
        )
        assert (ended.returncode, ended.stderr) == (0, b"")
        assert written(place / "out") == FILES


#: What importing FreeCAD may do to the process.
FREECADS = {
    "aborts": "import os; os.abort()",
    "breaks off": "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)",
    "leaves": "import sys; sys.exit(100)",
    "leaves silently": "import os; os._exit(0)",
    "is broken": "raise ImportError('libFreeCADBase.so: cannot map')",
    "cannot write": "raise OSError(30, 'Read-only file system')",
    "has its own error": "raise RuntimeError({'sErrMsg': 'Cannot create directory', 'swhat': ''})",
    "lacks memory": "raise MemoryError",
    "tries for ever": "while True: pass",
}


@pytest.mark.slow
@pytest.mark.parametrize("way", FREECADS)
def test_freecad_that_does_not_work_is_a_note(
    way: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "FreeCAD.py").write_text(FREECADS[way])
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setattr(freecad_process, "_PATIENCE", 2)
    monkeypatch.setattr(freecad_process, "_SHARE", 0)
    arguments = ("box.json", None, [], None, None)
    making = freecad_process.FreecadProcess(document.__name__, "making the document", *arguments)
    with pytest.raises(MissingPackageError) as error:
        making.content()
    making.stop()
    assert str(error.value).startswith("FreeCAD ")
    assert "\n" not in str(error.value)


def test_a_thread_may_run_it(box: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Signals are the main thread's."""
    ended: list[int] = []
    thread = threading.Thread(
        target=lambda: ended.append(command_line.main(command(box, str(box.parent / "out"))))
    )
    thread.start()
    thread.join()
    assert ended == [0]
    assert written(box.parent / "out") == FILES


def test_the_folder_is_gone_when_the_files_are_written(
    box: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = box.parent / "out"
    out.mkdir()
    make = settings.make_balloon

    def and_remove(*args, **names):
        out.rmdir()
        return make(*args, **names)

    monkeypatch.setattr(settings, "make_balloon", and_remove)
    assert command_line.main(command(box, str(out))) == 0
    assert written(out) == FILES


@pytest.mark.slow
def test_numpy_works_with_one_thread_unless_the_user_says_otherwise() -> None:
    """A balloon of a study, whose process has one, is the same to the last bit."""
    begin = (
        "import os, runpy, sys\nsys.argv = ['balloon', '--version']\n"
        "try:\n    runpy.run_module('BalloonWorkbench', run_name='__main__')\n"
        "except SystemExit:\n    print(os.environ['OPENBLAS_NUM_THREADS'])\n"
    )
    for given, found in ((None, "1"), ("3", "3")):
        known = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
        known |= {} if given is None else {"OPENBLAS_NUM_THREADS": given}
        done = subprocess.run(
            [sys.executable, "-c", begin], env=known, capture_output=True, text=True, check=True
        )
        assert done.stdout.split()[-1] == found
