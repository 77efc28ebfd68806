# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cow Spot by Keenan Crane, a mesh: sixteen panels, left and right alike."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("Cow")
made = BalloonWorkbench.from_body(
    doc, FOLDER / "meshes" / "spot.obj", panels=16, height="300 mm", mesh_size="22 mm"
)
