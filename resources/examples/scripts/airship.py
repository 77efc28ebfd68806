# SPDX-License-Identifier: LGPL-2.1-or-later
"""An airship of six gores, with as much pressure as keeps it stiff."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("Airship")
made = BalloonWorkbench.from_profile(
    doc, FOLDER / "profiles" / "airship.json", gores=6, width="700 mm", pressure="500 Pa", mesh_size="50 mm"
)
