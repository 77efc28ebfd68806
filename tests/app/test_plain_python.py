# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD as a module of plain Python, with nothing but its libraries on the path: all our shapes come."""

import subprocess
import sys
from pathlib import Path

import pytest

LIBRARIES = [path.parent for path in Path("/usr/lib").glob("freecad*/lib/FreeCAD.so")]
CODE = """
import sys
sys.path[:0] = sys.argv[1].split(":")
import FreeCAD
sys.path[:] = [folder for folder in sys.path if not folder.rstrip("/").endswith("Mod")]
import Part, sketches
from BalloonWorkbench.app import artwork, film_sheet; from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.nesting import nest
nest.PACKAGE = "no_such_package"
doc = FreeCAD.newDocument("Plain")
sketch = sketches.rectangle(doc, 120, 80)
sketch.addGeometry(Part.LineSegment(FreeCAD.Vector(40, 40, 0), FreeCAD.Vector(80, 40, 0)), False)
doc.recompute()
parts = create.balloon_from_sketch(doc, sketch, ["Edge1", "Edge2", "Edge3", "Edge4", "Edge5"], correct=False)
sheet, printed = film_sheet.make(doc, [parts.pattern]), artwork.make(parts.pattern, sys.argv[2])
doc.recompute()
made = (*parts, sheet, printed)
print("made:", [obj.Status for obj in made], [obj.Shape.ShapeType for obj in (parts.outline, *made[2:])])
"""


def test_every_shape_is_made_in_plain_python():
    if not LIBRARIES:
        pytest.skip("FreeCAD's libraries lie elsewhere")
    packages = [folder for folder in sys.path if folder.endswith("-packages")]
    folders = [*map(str, LIBRARIES), str(Path.cwd()), str(Path("tests/app").resolve()), *packages]
    ended = subprocess.run(
        [
            "/usr/bin/python3",
            "-c",
            CODE,
            ":".join(folders),
            str(Path("resources/examples/pictures/heart.png").resolve()),
        ],
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert f"made: {['up to date'] * 5} {['Compound'] * 4}" in ended.stdout, (
        ended.returncode,
        ended.stderr[-2000:],
    )
