# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stars with a print, two of them laid out closely on a roll of film."""

from pathlib import Path

import FreeCAD as App

import BalloonWorkbench

FOLDER = Path(BalloonWorkbench.__file__).resolve().parents[1] / "resources" / "examples"
doc = App.newDocument("PrintedStars")
picture = FOLDER / "pictures" / "star.png"
made = BalloonWorkbench.from_picture(doc, picture, width="180 mm", film="nylon-foil", mesh_size="12 mm")
BalloonWorkbench.artwork(made.pattern, picture=str(picture), bleed="3 mm", resolution=60)
sheet = BalloonWorkbench.nest([made.pattern], film_width="600 mm", balloons=2)
