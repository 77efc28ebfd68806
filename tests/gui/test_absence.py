# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD of its own with nothing but NumPy: the workbench loads, tells what is missing, breaks nothing."""

import json
import os
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.packages import ABSENCES

#: What FreeCAD has loaded before us.
FREECAD = {"FreeCAD", "FreeCADGui", "PySide", "PySide2", "PySide6"}
#: Rooms of ours: no engine, no panel, no painting.
AT_START = {"app", "core", "gui"} | {
    *(f"app.{room}" for room in ("border", "document", "engine", "properties", "shapes")),
    *(f"core.{room}" for room in ("files", "language", "options")),
    *(f"gui.{room}" for room in ("long_work", "panels.widgets", "window")),
}


@pytest.fixture(scope="module")
def bare(tmp_path_factory):
    """What bare_start.py saw, and all that FreeCAD printed."""
    folder = tmp_path_factory.mktemp("bare")
    document = App.newDocument("Box")
    create.balloon_from_sketch(document, sketches.rectangle(document), mesh_size=16, correct=False)
    document.saveAs(str(folder / "box.FCStd"))
    App.closeDocument(document.Name)
    (folder / "user").mkdir()
    settings = Path("tests/user.cfg").read_text(encoding="utf-8")
    # another workbench first: ours is chosen when the packages are gone
    settings = settings.replace(">BalloonWorkbench<", ">PartWorkbench<")
    (folder / "user" / "user.cfg").write_text(settings, encoding="utf-8")
    environment = {
        **os.environ,
        "BALLOON_SEEN": str(folder / "seen.json"),
        "BALLOON_DOCUMENT": str(folder / "box.FCStd"),
    }
    command = ["tools/in-freecad.sh", str(folder / "user"), "freecad", "tests/gui/bare_start.py"]
    with (folder / "printed.txt").open("wb") as printed:
        other = subprocess.Popen(
            command, env=environment, stdin=subprocess.DEVNULL, stdout=printed, stderr=subprocess.STDOUT
        )
        # this window lives on: the other one asks it for the clipboard, and waits for an answer
        hands.wait_until(lambda: other.poll() is not None, 120)
    seen = json.loads((folder / "seen.json").read_text(encoding="utf-8"))
    return seen, (folder / "printed.txt").read_text(encoding="utf-8")


def test_freecad_goes_on(bare):
    seen, printed = bare
    assert "failed" not in seen, seen["failed"]
    assert seen["active"] == "BalloonWorkbench"
    assert "Traceback" not in printed


def test_what_is_missing_is_told(bare):
    seen, printed = bare
    (told,) = seen["equipment"]
    assert "No solver works here" in told
    for name in set(ABSENCES) - {"numpy"}:
        sentence = f"The Python package {name} is missing."
        assert sentence in told
        assert sentence in printed


def test_documents_open_and_keep_what_they_show(bare):
    seen, _ = bare
    shapes = seen["shapes"]
    assert shapes["outline"] == pytest.approx(120 * 80)
    assert shapes["facets"] > 100
    assert shapes["pattern"] > 400
    assert shapes["proxies"] == ["OutlineProxy", "BalloonProxy", "PatternProxy"]
    assert seen["pattern"] == "stale: Patterns need shapely: install it with pip install shapely."


def test_what_does_not_work_says_what_to_install(bare):
    seen, _ = bare
    sketch, picture = seen["refused"]
    assert "pip install shapely" in sketch
    assert "OpenCV or SciPy" in picture
    assert "python3-scipy" in picture


def test_start_loads_the_least(bare):
    """Init.py and InitGui.py take what document objects are declared with, and nothing of others."""
    seen, _ = bare
    assert seen["loaded at start"] == []
    assert set(seen["packages"]) <= {*sys.stdlib_module_names, *FREECAD}
    assert set(seen["rooms"]) <= AT_START


def test_what_works_here_can_be_read(doc):
    Gui.runCommand("BalloonWorkbench_Equipment")
    hands.wait_until(hands.panel_is_seen)
    text = hands.find("Equipment").text()
    assert "Solver: native." in text
    assert "All packages are installed." in text
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
