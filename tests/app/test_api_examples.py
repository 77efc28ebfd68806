# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/api.md: each public function has an example, which runs, in the order of the page."""

import ast
import sys
from pathlib import Path

import FreeCAD as App
import pytest
from drawn_pictures import png
from photographs import photograph

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.core.as_made.comparison import with_rim
from BalloonWorkbench.core.design.silhouette import silhouette

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

import page_code

BLOCKS = page_code.blocks("api.md")
FIRST = next(number for number, code in enumerate(BLOCKS) if 'newDocument("Examples")' in code)
RUN = BLOCKS[FIRST:]
#: Of many panels; to fit arcs to all of them takes longer than the balloons.
MANY = 'mesh_size="40 mm"'
FILES = {
    "fish.dxf",
    "fish.stl",
    "fish.pdf",
    "fish.html",
    "fish.png",
    "remnant.json",
    "card/test-card.gcode",
    "as-made/compare.json",
}


def called(code):
    """The functions of BalloonWorkbench that code calls."""
    return [
        node.func.attr
        for node in ast.walk(ast.parse(code))
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and getattr(node.func.value, "id", "") == "BalloonWorkbench"
    ]


def photographed(made, path):
    """The balloon with weld and allowance, 1 % larger than it was simulated, 0.4 mm a pixel."""
    inflation, own = film_result.stored(made.balloon)
    rim = own.seal_width + made.pattern.Allowance.Value / 1000.0
    loop = 1.01 * with_rim(silhouette(inflation), rim).outer
    path.write_bytes(png(photograph([loop], pixel=0.0004, size=(700, 560), turn=20.0, noise=3.0)))


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The folder in which all examples ran, and the names that they left; machines and films of their own."""
    folder, known = tmp_path_factory.mktemp("examples"), {}
    for name in ("pictures/fish.png", "profiles/sphere.json"):
        source = page_code.EXAMPLES / name
        (folder / source.name).write_bytes(source.read_bytes())
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("BALLOON_MACHINES", str(folder / "machines"))
        patch.setattr(film, "own_folder", lambda: folder / "films")
        for number, code in enumerate(RUN):
            if "photo.png" in code:
                photographed(known["fish"], folder / "photo.png")
            page_code.run(code.replace(MANY, f"{MANY}, arcs=False"), f"api.md, example {number}", known)
    yield folder, known
    App.closeDocument(known["doc"].Name)


def test_every_function_has_an_example_that_runs():
    run = {name for code in RUN for name in called(code)}
    assert not {*BalloonWorkbench._API} - run, "functions without an example in docs/api.md"


def test_no_block_calls_what_is_not_there():
    """Also the excerpts before, which need objects of yours and are not run."""
    assert {name for code in BLOCKS for name in called(code)} == {*BalloonWorkbench._API}


def test_the_examples_make_what_they_say(written):
    folder, known = written
    made = [known[name] for name in ("fish", "cushion", "ball", "crate", "box")]
    assert [obj.Status for each in made for obj in each] == [status.READY] * 15
    assert known["same"] == known["fish"]
    assert known["fish"].pattern.IntakeAutoPlace == "Low"
    assert known["fish"].pattern.Allowance.Value == 4.0
    assert len(BalloonWorkbench.panels(known["ball"])) >= 4
    assert (known["study"].Finished, known["study"].Failed) == (1, 0)
    assert not [name for name in FILES if not (folder / name).is_file()]
    assert [path.stem for path in (folder / "machines").iterdir()] == ["laser-pe"]
    assert len([*(folder / "films").iterdir()]) == 1
    assert len(known["moves"]) == 1
    width = known["fish"].balloon.InflatedWidth.Value
    assert 0.001 * width < 1000 * known["compared"].comparison.residual.mean < 0.01 * width
