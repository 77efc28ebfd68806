# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole study, with runners that work nothing out: its folder and its table, whatever happens meanwhile."""

from __future__ import annotations

import csv
import json
import random
import shutil
from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import PICTURE, Finished, Job
from BalloonWorkbench.core.studies.page import write_page
from BalloonWorkbench.core.studies.plan import planned
from BalloonWorkbench.core.studies.read_study import study_of
from BalloonWorkbench.core.studies.run import plan_study, run_study
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.studies.table import UNTRIED, write_table

WIDTHS = [0.1, 0.2, 0.3, 0.2, "0.1m", "x", 0.4, 0.5]  # five balloons and a row that makes no sense
FAILS = "--width=0.4"


@dataclass
class Pretending:
    """A runner that puts something into the folder, in an order of its own."""

    seed: int = 0
    kept: bool = True
    done: list[str] = field(default_factory=list)
    after: Callable[[int, Path], None] = lambda _count, _place: None

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        waiting = [*jobs]
        random.Random(self.seed).shuffle(waiting)
        folder = StudyFolder(place)
        for job in waiting:
            self.after(len(self.done), place)
            self.done.append(job.key)
            if FAILS in job.request["arguments"]:
                if self.kept:
                    folder.keep_failure(job.key, "It cannot be.")
                yield Finished(job.key, "It cannot be.", self.kept)
                continue
            width = float(job.request["arguments"][2].partition("=")[2].rstrip("m"))
            report = {"inflated": {"volume_m3": width}, "solve": {"converged": True}, "warnings": ["a, b"]}
            folder.keep(job.key, {"report.json": json.dumps(report).encode()})
            yield Finished(job.key)


@pytest.fixture
def study(tmp_path: Path) -> Study:
    (tmp_path / "a.png").write_text("a")
    return study_of({"fixed": {"input": "a.png"}, "vary": {"width": WIDTHS}}, tmp_path)


def bytes_of(out: Path) -> dict[str, bytes]:
    return {str(path.relative_to(out)): path.read_bytes() for path in out.rglob("*") if path.is_file()}


def rows_of(out: Path) -> list[dict[str, Any]]:
    with (out / "table.csv").open(newline="", encoding="utf-8") as text:
        return [*csv.DictReader(text)]


def test_a_row_for_each_row(study: Study, tmp_path: Path) -> None:
    outcome = run_study(study, tmp_path / "out", Pretending())
    assert (outcome.balloons, outcome.made, [*outcome.failures.values()]) == (5, 5, ["It cannot be."])
    rows = rows_of(tmp_path / "out")
    assert [row["row"] for row in rows] == [*"12345678"]
    assert [row["width"] for row in rows] == [str(width) for width in WIDTHS]
    assert [row["volume_m3"] for row in rows] == ["0.1", "0.2", "0.3", "0.2", "0.1", "", "", "0.5"]
    assert rows[0]["key"] == rows[4]["key"] != rows[1]["key"] == rows[3]["key"]
    assert rows[6]["failure"] == "It cannot be."
    assert "'x'" in rows[5]["failure"]
    assert rows[5]["key"] == ""
    assert (rows[0]["converged"], rows[0]["warnings"], rows[0]["lift_g"]) == ("yes", "a, b", "")


def test_the_order_of_the_work_changes_no_byte(study: Study, tmp_path: Path) -> None:
    for seed in range(3):
        run_study(study, tmp_path / str(seed), Pretending(seed))
    assert bytes_of(tmp_path / "0") == bytes_of(tmp_path / "1") == bytes_of(tmp_path / "2")


@pytest.mark.parametrize("kept", [True, False])
def test_a_study_that_was_stopped_goes_on(study: Study, tmp_path: Path, kept: bool) -> None:
    """At each place; only failures that may pass are tried again."""

    def stop(count: int, _place: Path) -> None:
        if count == stops:
            raise KeyboardInterrupt

    run_study(study, tmp_path / "whole", Pretending(kept=kept))
    done = []
    for stops in (2, 1, 0, 2, 9):
        runner = Pretending(stops, kept, after=stop)
        try:
            run_study(study, tmp_path / "out", runner)
        except KeyboardInterrupt:
            assert not (tmp_path / "out" / "table.csv").exists()
        done += runner.done
    assert bytes_of(tmp_path / "out") == bytes_of(tmp_path / "whole")
    assert len({*done}) == 5
    assert len(done) == 5 or not kept
    again = Pretending()
    assert run_study(study, tmp_path / "out", again).made == (0 if kept else 1)


def test_shares_make_the_same(study: Study, tmp_path: Path) -> None:
    run_study(study, tmp_path / "whole", Pretending())
    out = tmp_path / "out"
    for number in (2, 1, 3):
        assert run_study(study, out, Pretending(), (number, 3)).tables == ()
    with StudyFolder(out).in_use():
        write_table(study, StudyFolder(out))
    assert (out / "table.csv").read_bytes() == (tmp_path / "whole" / "table.csv").read_bytes()


@pytest.mark.parametrize("share", [(0, 3), (4, 3), (1, 0)])
def test_there_is_no_such_share(study: Study, tmp_path: Path, share: tuple[int, int]) -> None:
    with pytest.raises(InputError, match="no share"):
        run_study(study, tmp_path / "out", Pretending(), share)


def test_what_is_damaged_or_not_there_is_told(study: Study, tmp_path: Path) -> None:
    out = tmp_path / "out"
    run_study(study, out, Pretending(), (1, 2))
    folder = StudyFolder(out)
    with folder.in_use():
        write_table(study, folder)
    assert sum(row["failure"] == UNTRIED for row in rows_of(out)) == 3
    report = next(out.rglob("report.json"))
    report.write_bytes(b"{")
    run_study(study, out, Pretending())
    assert sum(str(report.parent) in row["failure"] for row in rows_of(out)) > 0
    shutil.rmtree(report.parent)
    run_study(study, out, Pretending())
    assert [row["row"] for row in rows_of(out) if row["failure"]] == ["6", "7"]


def test_two_studies_into_one_folder(study: Study, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with StudyFolder(out).in_use():
        for share in ((1, 1), (1, 2)):
            with pytest.raises(InputError, match="Another study"):
                run_study(study, out, Pretending(), share)
    with StudyFolder(out).in_use((1, 2)):
        for share in ((1, 1), (1, 2)):
            with pytest.raises(InputError, match="Another study"):
                run_study(study, out, Pretending(), share)
        run_study(study, out, Pretending(), (2, 2))
    run_study(study, out, Pretending())


def test_a_folder_that_vanishes(study: Study, tmp_path: Path) -> None:
    def remove(count: int, place: Path) -> None:
        if count == 2:
            shutil.rmtree(place)

    with pytest.raises(ExportError, match="has vanished"):
        run_study(study, tmp_path / "out", Pretending(after=remove))
    assert not (tmp_path / "out").exists()
    assert run_study(study, tmp_path / "out", Pretending()).made == 5


def test_a_disk_that_is_full_ends_the_study_and_loses_nothing(study: Study, tmp_path: Path) -> None:
    class Full(Pretending):
        def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
            yield from Pretending.run(self, [*jobs][:2], place)
            yield Finished("ab" * 32, "Cannot write: no space. Make room there.", kept=False, ends=True)
            raise AssertionError("it goes on")

    with pytest.raises(ExportError, match="no space"):
        run_study(study, tmp_path / "out", Full())
    assert run_study(study, tmp_path / "out", Pretending()).made == 3


def test_a_file_in_the_place_of_the_folder(study: Study, tmp_path: Path) -> None:
    (tmp_path / "out").write_text("")
    with pytest.raises(ExportError, match="Cannot write"):
        run_study(study, tmp_path / "out", Pretending())


def test_a_plan_works_nothing_out(study: Study, tmp_path: Path) -> None:
    plan = plan_study(study, tmp_path / "out")
    assert (plan.rows, [*plan.senseless], plan.balloons, plan.there) == (8, [6], 5, 0)
    assert not (tmp_path / "out").exists()
    run_study(study, tmp_path / "out", Pretending(), (1, 2))
    assert plan_study(study, tmp_path / "out").there == 3


def test_a_table_in_parquet(study: Study, tmp_path: Path) -> None:
    """With numbers as numbers and nothing where there is none."""
    parquet = pytest.importorskip("pyarrow.parquet")
    run_study(study, tmp_path / "out", Pretending())
    table = parquet.read_table(tmp_path / "out" / "table.parquet").to_pylist()
    rows = rows_of(tmp_path / "out")
    assert [*table[0]] == [*rows[0]]
    assert [row["volume_m3"] for row in table] == [0.1, 0.2, 0.3, 0.2, 0.1, None, None, 0.5]
    assert [row["converged"] for row in table[:6]] == [True] * 5 + [None]
    assert [row["failure"] for row in table] == [row["failure"] for row in rows]


def test_progress_is_told(study: Study, tmp_path: Path) -> None:
    seen: list[tuple[int, int]] = []
    run_study(study, tmp_path / "out", Pretending(), observe=lambda done, of, _last: seen.append((done, of)))
    assert seen == [(count, 5) for count in range(6)]


def test_a_page_shows_the_table(study: Study, tmp_path: Path) -> None:
    """With a small picture where one was kept, a chart over the width in mm, and why there is no balloon."""
    folder = StudyFolder(tmp_path / "out")
    outcome = run_study(study, folder.place, Pretending())
    kept = next(row.key for row in planned(study) if row.job is not None)
    (folder.of(kept) / PICTURE).write_bytes(b"\x89PNG")
    page = write_page(study, folder, "A <study>", outcome.failures)
    text = page.read_text(encoding="utf-8")
    assert page == folder.place / "study.html"
    assert text.count("<tr>") == 1 + len(WIDTHS) + 1  # the input is the same in all: a row of its own
    assert "data:image/png;base64,iVBORw==" in text
    assert "It cannot be." in text
    assert "volume m3 over width" in text
    assert ">width mm</text>" in text
    assert "A &lt;study&gt;" in text
    assert text.count("<circle") == len(WIDTHS) - 2  # one makes no sense, one fails
    write_page(study, folder, "A <study>", outcome.failures)
    assert page.read_text(encoding="utf-8") == text
