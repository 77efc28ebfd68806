# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of the command line's work fails as nobody foresaw: the rest is written, one line says so."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

import pytest

from BalloonWorkbench.cli import command_line, freecad_process, settings
from BalloonWorkbench.core import job, products
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.pictures import preview
from BalloonWorkbench.core.reports import report

CORE = {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}
ALL = CORE | {"results.npz", "pattern-hpgl-plotter.plt", "assembly.pdf"}

#: What fails, and the files that cannot be without it.
PARTS: dict[str, tuple[Any, str, set[str]]] = {
    "mesh": (job, "stl_bytes", {"balloon.stl"}),
    "preview": (preview, "preview_png", {"preview.png"}),
    "patterns": (job, "machine_file", {"pattern.dxf", "pattern.svg"}),
    "all that is shown": (command_line, "makers", {"balloon.stl", "preview.png", "results.npz"}),
    "results": (job, "results_bytes", {"results.npz"}),
    "frames": (command_line, "inflation_files", {"inflation.pvd"}),
    "machines": (command_line, "checked_files", {"pattern-hpgl-plotter.plt"}),
    "prints": (products, "print_files", {"artwork-front.png"}),
    "assembly": (products, "assembly_files", {"assembly.pdf"}),
    "numbers": (job, "_numbers", {"report.json", "assembly.pdf"}),
    "advice": (job, "advise_design", {"report.json"}),
    "report": (report, "build", {"report.json"}),
    "report's text": (command_line, "report_bytes", {"report.json"}),
    "summary": (command_line, "summary", set()),
    "document": (freecad_process.FreecadProcess, "content", set()),
}
FAILURES: list[Callable[[], BaseException]] = [
    ZeroDivisionError, MemoryError, RecursionError, lambda: KeyError("x"), lambda: OSError(5, "broken"),
    lambda: ValueError("two\nlines"), lambda: UnicodeEncodeError("ascii", "é", 0, 1, "no"), AssertionError,
    lambda: SystemExit(3),
]  # fmt: skip


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    import numpy as np

    folder = tmp_path_factory.mktemp("faults")
    (folder / "box.json").write_text('{"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}')
    (folder / "grey.png").write_bytes(png_bytes(np.full((9, 9, 4), 99, np.uint8), 100.0))
    return folder


def run(place: Path, *words: str) -> int:
    command = ["inflate", str(place / "box.json"), "--mesh-size", "33mm", "--out", str(place / "out"), *words]
    return command_line.main(command)


def everything(place: Path, part: str) -> int:
    words = ["--results", "npz", "--machine", "hpgl-plotter", "--assembly", "A4"]
    if part == "frames":
        words += ["--frames", "2"]
    if part == "prints":
        words += ["--artwork", str(place / "grey.png"), "--dpi", "20"]
    return run(place, *words)


@pytest.mark.slow
@pytest.mark.parametrize("part", PARTS)
def test_the_rest_is_written(
    part: str, place: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(place / "details"))
    module, name, missing = PARTS[part]
    failure = FAILURES[list(PARTS).index(part) % len(FAILURES)]

    def fail(*_args: object, **_names: object) -> NoReturn:
        raise failure()

    monkeypatch.setattr(module, name, fail)
    if part == "document":  # it is begun in another process
        monkeypatch.delitem(sys.modules, "FreeCAD")
    for old in (place / "out").glob("*"):
        old.unlink()
    assert everything(place, part) == 70
    written = {path.name for path in (place / "out").iterdir()}
    assert written >= ALL - missing
    assert not written & missing
    printed = capsys.readouterr()
    assert printed.err.count("\n") == 1
    assert "Traceback" not in printed.out + printed.err
    details = printed.err.partition("'")[2].partition("'")[0]
    assert "Traceback" in Path(details).read_text(encoding="utf-8")
    for each in missing & {"balloon.stl", "preview.png", "results.npz", "pattern.dxf"}:
        if part != "all that is shown":
            assert f"Note: {each} was left out." in printed.out
    if "report.json" in written and part not in ("summary", "document"):
        told = json.loads((place / "out" / "report.json").read_text(encoding="utf-8"))["warnings"]
        assert any("was left out." in warning for warning in told)


def test_one_of_two_balloons(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The second cannot be designed: the first is written as if it were alone."""
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(tmp_path / "details"))
    two = {"unit": "mm", "parts": [{"outer": [[0, 0], [99, 0], [99, 99], [0, 99]]},
                                   {"outer": [[120, 0], [180, 0], [180, 60], [120, 60]]}]}  # fmt: skip
    (tmp_path / "box.json").write_text(json.dumps(two))
    design, count = job.design_outline, []

    def second_fails(*args: Any, **names: Any) -> Any:
        count.append(1)
        return design(*args, **names) if len(count) == 1 else 1 / 0

    monkeypatch.setattr(job, "design_outline", second_fails)
    assert run(tmp_path) == 70
    assert capsys.readouterr().err.count("\n") == 1
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert len(report["parts"]) == 1
    assert "Balloon 2 was left out." in report["warnings"][-1]


def test_nothing_can_be_computed(
    place: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("BALLOON_FAULT_FOLDER", str(place / "details"))
    monkeypatch.setattr(settings, "make_balloon", lambda *_a, **_n: 1 / 0)
    assert run(place) == 70
    assert capsys.readouterr().err.count("\n") == 1
