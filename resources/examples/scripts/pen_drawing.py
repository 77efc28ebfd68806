# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dog from the lines of a pen: they are closed, and filled inside."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("PenDrawing")
made = BalloonWorkbench.from_picture(
    doc, FOLDER / "pictures" / "line-dog.png", width="400 mm", drawn_as="Pen drawing", mesh_size="12 mm"
)
