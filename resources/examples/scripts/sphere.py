# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sphere of eight gores, from half an outline in a file."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("Sphere")
made = BalloonWorkbench.from_profile(
    doc, FOLDER / "profiles" / "sphere.json", height="500 mm", gores=8, pressure="1 kPa", mesh_size="30 mm"
)
