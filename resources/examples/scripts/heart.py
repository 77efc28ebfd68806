# SPDX-License-Identifier: LGPL-2.1-or-later
"""A heart from a picture: two panels of foil, corrected until the inflated balloon looks like the picture."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("Heart")
made = BalloonWorkbench.from_picture(
    doc, FOLDER / "pictures" / "heart.png", width="300 mm", film="nylon-foil", mesh_size="12 mm"
)
