# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons as they are exported: two panels with a print, gores, a letter with a side band, a bag."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "core" / "web_pages"))  # for browser.py

from BalloonWorkbench.cli import main  # noqa: E402

EXAMPLES = ROOT / "resources" / "examples"
#: An L, in mm.
LETTER = {"unit": "mm", "outer": [[0, 0], [140, 0], [140, 60], [60, 60], [60, 200], [0, 200]]}
COARSE = ("--mesh-size", "30mm")


@pytest.fixture(scope="session")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The folder of a balloon's files, by its name; each is made once."""
    folder = tmp_path_factory.mktemp("exported")

    @cache
    def made(name: str) -> Path:
        drawing, options = _asked(folder)[name]
        out = folder / name
        asked = ["--out", str(out), "--glb", "--report", "html", "--png", "--only", "report"]
        assert main(["inflate", str(drawing), *asked, *options]) == 0
        return out

    return made


def _asked(folder: Path) -> dict[str, tuple[Path, tuple[str, ...]]]:
    letter, wall = folder / "letter.json", folder / "wall.jpg"
    letter.write_text(json.dumps(LETTER), encoding="utf-8")
    _photograph(wall)
    heart = EXAMPLES / "pictures" / "heart.png"
    printed = ("--width", "250mm", *COARSE, "--artwork", str(heart), "--dpi", "30")
    return {
        "printed": (heart, printed),
        "gored": (EXAMPLES / "profiles" / "sphere.json", ("--gores", "6", "--width", "250mm", *COARSE)),
        "letter": (letter, ("--band", "50mm", *COARSE)),
        "bag": (EXAMPLES / "bags" / "cube.json", COARSE),
        "on a colour": (heart, (*printed, "--ground", "#1060c0")),
        "on a photograph": (heart, (*printed, "--ground", str(wall))),
    }


def _photograph(path: Path) -> None:
    """As large as those of cameras: green above, grey below, with noise."""
    noise = np.random.default_rng(7).integers(-20, 20, (3000, 4000, 1), dtype=np.int16)
    colours = np.full((3000, 4000, 3), (40, 150, 60), np.int16)
    colours[2000:] = (130, 130, 130)
    Image.fromarray((colours + noise).astype(np.uint8)).save(path, quality=92)
