# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way of the work: a command traces, designs, draws and reports once, and hands the results over."""

from __future__ import annotations

from pathlib import Path

from counting import counted
from drawn_shapes import NAMED

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.job import Settings, files, make_balloon
from BalloonWorkbench.core.pattern import build
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.rounded import rounded_outline
from BalloonWorkbench.core.units import from_mm, to_mm

PICTURE = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures" / "heart.png"
ONCE = {"trace": 1, "design": 1, "pattern": 1, "report": 1}


def test_a_job_does_everything_once() -> None:
    with counted() as done:
        balloon = make_balloon(PICTURE, Settings(correct=False, mesh_size=0.02), width=0.2)
        files(balloon)
    assert done == ONCE


def test_what_a_document_keeps_in_mm_asks_for_the_same_pattern() -> None:
    settings = Settings(correct=False, mesh_size=0.03, goal=SizeGoal(volume=1e-3))
    design = make_balloon(PICTURE, settings).design
    kept = rounded_outline(design.pattern.map(lambda line: from_mm(to_mm(line))))
    assert make_pattern.knows(kept, settings.film.seal_width, settings.pattern)


def test_a_command_does_everything_once(tmp_path: Path) -> None:
    options = ["--width", "200mm", "--mesh-size", "20mm", "--assembly", "A4", "--out"]
    with counted() as done:
        assert command_line.main(["inflate", str(PICTURE), *options, str(tmp_path)]) == 0
    assert done == ONCE


def test_quick_patterns_are_not_counted_however_they_are_asked_for() -> None:
    with counted() as done:
        for given, named in (((None, False), {}), ((), {"fair": False}), ((), {}), ((None, True), {})):
            build.build_pattern(NAMED["disc"], 0.005, *given, **named)
    assert done == {"pattern": 2}
