# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts of docs/examples.md: each has a picture there, and runs; all of them in `make validation`."""

import os
import re
import sys
from pathlib import Path

import FreeCAD as App
import pytest

from BalloonWorkbench.app.border import status

sys.path.append(str(Path(__file__).resolve().parents[3] / "tools"))

import page_code

SCRIPTS = {path.stem: path for path in (page_code.EXAMPLES / "scripts").glob("*.py")}
RUN = sorted(SCRIPTS) if os.environ.get("BALLOON_SCRIPTS") == "all" else ["ring", "pouch"]


def test_each_is_on_the_page_with_a_picture():
    text = (page_code.DOCS / "examples.md").read_text(encoding="utf-8")
    assert len(SCRIPTS) == 12
    for name, path in SCRIPTS.items():
        says = re.search(r'"""(.+)"""', path.read_text(encoding="utf-8"))[1]
        assert f"{says} `{name}.py`\n\n![" in text
        assert f"](images/example-{name}.png)" in text
    pictures = {path.stem.removeprefix("example-"): path for path in page_code.IMAGES.glob("example-*")}
    assert pictures.keys() == SCRIPTS.keys()
    assert all(path.stat().st_size < 80_000 for path in pictures.values())


@pytest.mark.slow
@pytest.mark.parametrize("name", RUN)
def test_it_makes_its_balloon(name):
    """Coarsely; as it is written it takes the correction that its picture shows."""
    known, code = {}, SCRIPTS[name].read_text(encoding="utf-8")
    assert page_code.coarse(code) != code
    page_code.run(page_code.coarse(code), SCRIPTS[name].name, known)
    assert [obj.Status for obj in known["made"]] == [status.READY] * 3
    assert known["made"].balloon.Volume.Value > 0
    assert len(known["made"].pattern.Shape.Edges) > 10
    App.closeDocument(known["doc"].Name)
