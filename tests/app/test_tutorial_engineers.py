# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/tutorial-engineers.md: its code runs from top to bottom, its words and pictures are there."""

import math
import re
import sys
from pathlib import Path

import FreeCAD as App
import pytest

from BalloonWorkbench.app.border import status

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

import page_code

PAGE = "tutorial-engineers.md"
TEXT = (page_code.DOCS / PAGE).read_text(encoding="utf-8")
#: What is FreeCAD's own, in bold: menus, and the field of its property editor.
FREECADS = {
    "View",
    "Panels",
    "Python console",
    "Macro",
    "Macro recording",
    "Spreadsheet",
    "Sketcher",
    "Properties",
}
FREECADS |= {"OK"}
NINE = '["160 mm", "180 mm", "200 mm"], "Gores": [4, 6, 8]'
ONE = '["200 mm"], "Gores": [4]'
TAKEN = 5  # the block that takes the float of a row


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The folder in which all blocks ran, and what was there after each of them."""
    folder, known, after = tmp_path_factory.mktemp("float"), {"__name__": "float"}, []
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        for number, code in enumerate(page_code.blocks(PAGE)):
            page_code.run(page_code.coarse(code.replace(NINE, ONE)), f"{PAGE}, block {number}", known)
            balloon = known["doc"].getObject("Balloon")
            wide = known["sketch"].Shape.BoundBox.XMax if "sketch" in known else None
            after.append((wide, balloon and balloon.Volume.Value))
    yield folder, known, after
    App.closeDocument(known["doc"].Name)


def test_all_follows_the_cells(written):
    """A capsule, by its formula."""
    _, known, after = written
    assert [round(width) for width, _ in after[1:]] == [80, 80, 100, 100, 100, 100, 60]
    for radius, height, volume in ((80, 400, after[2][1]), (100, 400, after[3][1]), (60, 500, after[7][1])):
        capsule = math.pi * radius**2 * (height - 2 * radius + 4 / 3 * radius)
        assert 0.8 * capsule < volume < capsule
    assert [obj.Status for obj in known["made"]] == [status.READY] * 3


def test_the_study_takes_a_float_that_holds_enough(written):
    _, known, after = written
    study = known["study"]
    assert (study.Rows, study.Finished, study.Failed, known["least"]) == (1, 1, 0, 2)
    volume = study.Table.get(f"{known['heading']['volume_m3']}2")
    assert volume >= 0.009
    assert after[TAKEN][1] * 1e-9 == pytest.approx(volume, rel=1e-5)
    assert known["made"].outline.Gores == 4


def test_both_files_are_written(written):
    folder, _, _ = written
    sizes = {path.name: path.stat().st_size for path in folder.glob("*.dxf")}
    assert {*sizes} == {"float.dxf", "float 120 mm x 500 mm.dxf"}
    assert min(sizes.values()) > 5000


@pytest.mark.parametrize("sizes", ['"0 mm", "500 mm"', '"300 mm", "200 mm"'])
def test_the_macro_refuses_what_cannot_be_made(written, sizes):
    """Nothing is written, and the balloon before stays; why the sketch fails is up to FreeCAD's solver."""
    folder, known, _ = written
    macro, files = page_code.blocks(PAGE)[-1].replace('"120 mm", "500 mm"', sizes), {*folder.iterdir()}
    volume = known["made"].balloon.Volume
    with pytest.raises(SystemExit, match="GoredBody is not ready: "):
        page_code.run(macro, "float.FCMacro", {})
    assert {*folder.iterdir()} == files
    assert known["made"].balloon.Volume == volume


def test_what_is_in_bold_is_in_the_window():
    """Each is FreeCAD's, a text of ours, or a property."""
    ours = "".join(
        path.read_text(encoding="utf-8")
        for layer in ("app", "gui")
        for path in (page_code.ROOT / "BalloonWorkbench" / layer).rglob("*.py")
    )
    bold = {word for each in re.findall(r"\*\*([^*]+)\*\*", TEXT) for word in each.split(" > ")}
    assert len(bold) > 12
    assert not [
        word for word in bold - FREECADS if f'"{word}"' not in ours.replace("&", "").replace('..."', '"')
    ]


def test_its_pictures_are_there_and_small():
    pictures = re.findall(r"\]\(images/([\w.-]+)\)", TEXT)
    assert {path.name for path in page_code.IMAGES.glob("tutorial-engineers-*")} == set(pictures)
    assert all((page_code.IMAGES / name).stat().st_size < 80_000 for name in pictures)
