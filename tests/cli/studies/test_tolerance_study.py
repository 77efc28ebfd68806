# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies of tolerances, from file to table and summary, with balloons that are made in this process."""

from __future__ import annotations

import csv
import importlib
import json
from collections.abc import Generator, Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Finished, Job
from BalloonWorkbench.core.studies.kinds.tolerance_study import FILE, tolerance_summary, write_summary
from BalloonWorkbench.core.studies.page import write_page
from BalloonWorkbench.core.studies.read_study import read_goal_study, study_of
from BalloonWorkbench.core.studies.run import run_study
from BalloonWorkbench.core.studies.study import Study

TOLERANCES = {
    "weld": {"uniform": "1mm", "per": "whole"},
    "cut": {"normal": "0.2mm"},
    "temperature": {"normal": "2K"},
}
FIXED = {"input": "disc.json", "command": "inflate", "mesh-size": "60mm", "pressure": "500Pa"}


class Here:
    """A runner in this process; `made` counts what it worked out."""

    def __init__(self) -> None:
        self.made = 0

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        folder = StudyFolder(place)
        for job in jobs:
            self.made += 1
            request = json.loads(json.dumps(job.request))  # as it reaches another process
            try:
                folder.keep(job.key, importlib.import_module(job.task).make(request))
            except BalloonError as error:
                folder.keep_failure(job.key, str(error))
                yield Finished(job.key, str(error))
            else:
                yield Finished(job.key)


def disc(folder: Path, radius: float = 150.0) -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    points = (radius * np.column_stack([np.cos(turn), np.sin(turn)])).round(3).tolist()
    (folder / "disc.json").write_text(json.dumps({"unit": "mm", "outer": points}))


def study_in(folder: Path, samples: int = 2, *, of: Any = TOLERANCES, **more: Any) -> Study:
    disc(folder)
    return study_of({"fixed": {**FIXED, **more}, "tolerances": of, "samples": samples}, folder)


def test_samples_are_rows_and_the_summary_says_what_they_mean(tmp_path: Path) -> None:
    study, runner, out = study_in(tmp_path), Here(), tmp_path / "out"
    outcome = run_study(study, out, runner)
    assert (outcome.balloons, outcome.failures) == (1 + 2 + 2 * 2 + 2, {})
    with (out / "table.csv").open(newline="", encoding="utf-8") as text:
        rows = {row["sample"]: row for row in csv.DictReader(text)}
    nominal, low, high = (float(rows[name]["volume_m3"]) for name in ("nominal", "weld 5 %", "weld 95 %"))
    assert high / nominal == pytest.approx((150.9 / 150.0) ** 3, rel=1e-3)
    assert low / nominal == pytest.approx((149.1 / 150.0) ** 3, rel=1e-3)
    assert rows["nominal"]["pressure_Pa"] == "500"
    told = tolerance_summary(study, StudyFolder(out))
    path, lines = write_summary(StudyFolder(out), told)
    data = json.loads(path.read_text())
    volume = data["measures"]["volume_m3"]
    assert volume["tornado"][0]["source"] == "weld"
    assert volume["nominal"] == pytest.approx(nominal)
    assert (data["samples"], data["seed"], path.name) == (2, 1, FILE)
    assert any("nobody can say" in line for line in lines)
    page = write_page(study, StudyFolder(out), "Disc", tolerances=told).read_text(encoding="utf-8")
    assert "Volume: what changes it most" in page
    assert page.count("<title>weld") >= 2, "a bar for each end"


def test_what_is_there_is_not_made_again_and_more_samples_are_added(tmp_path: Path) -> None:
    out = tmp_path / "out"
    cut = {"cut": TOLERANCES["cut"]}
    run_study(study_in(tmp_path, 1, of=cut), out, Here())
    more, runner = study_in(tmp_path, 2, of=cut), Here()
    run_study(more, out, runner)
    assert runner.made == 2  # the second sample, and its field by itself
    table, told = (out / "table.csv").read_bytes(), tolerance_summary(more, StudyFolder(out))
    again = Here()
    run_study(more, out, again)
    assert again.made == 0
    assert (out / "table.csv").read_bytes() == table
    run_study(more, tmp_path / "other", Here())
    assert (tmp_path / "other" / "table.csv").read_bytes() == table
    assert tolerance_summary(more, StudyFolder(tmp_path / "other")) == told


@pytest.mark.parametrize(
    ("more", "sentence"),
    [({"two-panels": "yes"}, "two equal panels"), ({"band": "50mm"}, "take a drawing")],
)
def test_balloons_that_have_no_tolerances_are_rows_with_a_sentence(
    more: dict[str, str], sentence: str, tmp_path: Path
) -> None:
    outcome = run_study(study_in(tmp_path, 1, **more), tmp_path / "out", Here())
    assert all(sentence in each for each in outcome.failures.values())
    assert len(outcome.failures) == outcome.balloons


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        ({"tolerances": TOLERANCES}, "no inputs"),
        ({"fixed": FIXED, "tolerances": TOLERANCES, "vary": {}}, "no 'vary'"),
        ({"fixed": {**FIXED, "width": ["1m", "2m"]}, "tolerances": TOLERANCES}, "single value"),
        ({"fixed": FIXED, "tolerances": TOLERANCES, "samples": 10_000_000}, "1 to 100000"),
        ({"fixed": FIXED, "tolerances": {"glue": {}}}, '"glue"'),
    ],
)
def test_a_senseless_study_is_told_in_a_sentence(data: Any, sentence: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=sentence):
        study_of(data, tmp_path)


def test_only_a_file_with_a_goal_is_a_search(tmp_path: Path) -> None:
    path = tmp_path / "study.json"
    path.write_text(json.dumps({"fixed": FIXED, "tolerances": TOLERANCES}))
    assert read_goal_study(path) is None
    path.write_text(
        json.dumps({"fixed": FIXED, "goal": {"maximize": "volume", "over": {"width": ["1m", "2m"]}}})
    )
    assert read_goal_study(path) is not None
    path.write_text(json.dumps({"fixed": FIXED, "goal": {}, "vary": {}}))
    with pytest.raises(InputError, match="no 'vary'"):
        read_goal_study(path)
