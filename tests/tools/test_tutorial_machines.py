# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/tutorial-machines.md: its commands run one after the other, its files and numbers are there."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

import pytest
from quick import no_document, rough_pictures  # noqa: F401 - fixtures

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.film.start_values import separating_layers
from BalloonWorkbench.core.nesting import nest
from BalloonWorkbench.core.units import to_mm_per_minute

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

from tutorial_pictures import IMAGES, INPUTS, PAGE, commands

ROOT = PAGE.parents[1]
TEXT = PAGE.read_text(encoding="utf-8")
COARSE = ("--mesh-size", "40mm", "--only", "pattern", "--dpi", "40")


@pytest.mark.slow
def test_each_command_runs_and_makes_its_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Coarsely, laid out in rows, and without the correction of `design`: others try the searches."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(nest, "PACKAGE", "no_such_package")
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))
    for name in INPUTS:
        shutil.copy(ROOT / "resources" / "examples" / name, tmp_path)
        assert f"`{Path(name).name}`" in TEXT
    run = commands()
    assert len(run) == len(re.findall("python -m BalloonWorkbench", TEXT)) == 7
    for arguments in run:
        quick = ["inflate", *arguments[1:], *COARSE] if arguments[0] == "design" else arguments
        assert main(quick) == 0, arguments
    named = set(re.findall(r"`((?:card|fish|star|laser-card|airship)/[\w.-]+)`", TEXT))
    assert len(named) >= 10
    assert not [name for name in named if not (tmp_path / name).is_file()]
    assert {path.stem for path in (tmp_path / "machines").iterdir()} == {"tip-pe", "laser-pe"}
    welded = (tmp_path / "fish" / "pattern-tip-pe.gcode").read_text(encoding="utf-8")
    assert "M104 S250" in welded
    assert "F200" in welded


def test_its_numbers_are_those_of_the_films() -> None:
    known, foil = film("pe").start_values, film("nylon-foil").start_values
    assert known.tip_temperature is not None
    assert known.tip_speed is not None
    assert foil.bar_temperature is not None
    heat = known.tip_temperature.most - 273.15
    slow, fast = (to_mm_per_minute(end) for end in (known.tip_speed.least, known.tip_speed.most))
    assert f"the start values are {heat:.0f} °C and {slow:.0f} to {fast:.0f} mm/min" in TEXT
    low, high = (end - 273.15 for end in (foil.bar_temperature.least, foil.bar_temperature.most))
    assert f"{low:.0f} to {high:.0f} °C for half a second to two" in TEXT
    paper, ptfe = (bears - 273.15 for bears in separating_layers().values())
    assert f"Never above {ptfe:.0f} °C" in TEXT
    assert f"Baking paper bears {paper:.0f} °C" in TEXT


def test_its_pictures_are_there_and_small() -> None:
    pictures = re.findall(r"\]\(images/([\w.-]+)\)", TEXT)
    assert len(pictures) == 6
    assert {path.name for path in IMAGES.glob("tutorial-machines-*")} == set(pictures)
    assert all((IMAGES / name).stat().st_size < 80_000 for name in pictures)
